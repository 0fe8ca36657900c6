// Several materials, and several damage models, as one.
#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <map>

#include "Peridigm_DegreesOfFreedomManager.hpp"
#include "bond_family.hpp"
#include "damage_run.hpp"
#include "linear_bonds.hpp"
#include "material_run.hpp"
#include "plugins.hpp"
#include "separate_rates.hpp"

namespace pdtest {
namespace {

using namespace PeridigmNS;

constexpr double thickness = 0.2;

Teuchos::ParameterList plate(const char* model) {
  Teuchos::ParameterList list;
  list.set<std::string>("Material Model", model);
  list.set("Plane Stress", true);
  list.set("Thickness", thickness);
  return list;
}

Teuchos::ParameterList elastic(double youngsModulus = 10.0) {
  Teuchos::ParameterList list = plate("PDHE");
  list.set("Density", 2.0);
  list.set("Young's Modulus", youngsModulus);
  list.set("Poisson's Ratio", 0.2);
  return list;
}

Teuchos::ParameterList diffusive(double diffusivity, const char* field = "Concentration") {
  Teuchos::ParameterList list = plate("PDHE");
  list.set("Diffusivity", diffusivity);
  list.set<std::string>("Diffusing Field", field);
  return list;
}

Teuchos::ParameterList dissolving() {
  Teuchos::ParameterList list = plate("Corrosion Dissolution");
  list.set("Diffusivity", 2.0);
  list.set("Solid Concentration", 1.0);
  list.set("Saturation Concentration", 0.4);
  list.set("Charge Number", 2.0);
  list.set<std::string>("Current Density", "1.0e5");
  return list;
}

/// `parts` named A, B, ...
Teuchos::ParameterList combined(const char* partsKey, const std::vector<Teuchos::ParameterList>& parts) {
  Teuchos::ParameterList list;
  Teuchos::Array<std::string> names;
  for (const Teuchos::ParameterList& part : parts) {
    names.push_back(std::string(1, static_cast<char>('A' + names.size())));
    list.sublist(names.back()) = part;
  }
  list.set(partsKey, names);
  return list;
}

Sample material(const std::vector<Teuchos::ParameterList>& parts) {
  if (parts.size() == 1) return {"Alone", parts.front().get<std::string>("Material Model"), 2, parts.front()};
  return {"Together", "Combined", 2, combined("Materials", parts)};
}

Results evaluated(const std::vector<Teuchos::ParameterList>& parts, bool isDamaged) {
  Layout layout;
  layout.isDamaged = isDamaged;
  return MaterialRun(material(parts), layout).evaluate();
}

Results times(double factor, Results results) {
  for (auto& [label, values] : results)
    for (double& value : values) value *= factor;
  return results;
}

std::string refusal(const std::vector<Teuchos::ParameterList>& parts) {
  try {
    pd::MaterialRegistry::self().create("Combined", parametersOf(material(parts)));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(CompositeMaterial, ForcesAndFluxesOfPartsAreThoseOfOneMaterialThatHasBoth) {
  Teuchos::ParameterList both = elastic();
  both.set("Diffusivity", 3.0);
  for (const bool isDamaged : {false, true})
    EXPECT_EQ(relativeDifference(evaluated({both}, isDamaged), evaluated({elastic(), diffusive(3.0)}, isDamaged)), 0.0);
}

TEST(CompositeMaterial, WhatPartsAddToOneFieldAddsUp) {
  EXPECT_LT(relativeDifference(evaluated({diffusive(5.0)}, false), evaluated({diffusive(2.0), diffusive(3.0)}, false)),
            1e-14);
  for (const bool isDamaged : {false, true})
    EXPECT_LT(
        relativeDifference(times(2.0, evaluated({elastic()}, isDamaged)), evaluated({elastic(), elastic()}, isDamaged)),
        1e-14);
}

TEST(CompositeMaterial, ARateThatIsAskedForAloneLeavesOthersAlone) {
  MaterialRun run(material({diffusive(2.0), diffusive(3.0, "Hydrogen")}), {});
  const Results all = run.evaluate();
  const auto& separate = dynamic_cast<const pd::SeparateRates&>(run.material());
  const auto list = run.body().block().getNeighborhoodData();
  const pd::Call call{list->NumOwnedPoints(), list->OwnedIDs(), list->NeighborhoodList()};
  double *ions = run.body().field("Concentration_Flux_Divergence"),
         *hydrogen = run.body().field("Hydrogen_Flux_Divergence");
  const int n = run.body().nPoints();
  std::fill_n(ions, n, 17.0);
  std::fill_n(hydrogen, n, 17.0);
  const int rate = FieldManager::self().getFieldId("Hydrogen_Flux_Divergence");
  separate.prepareRate(rate, 0.1, call, *run.body().block().getDataManager());
  separate.computeRate(rate, 0.1, call, *run.body().block().getDataManager());
  for (int i = 0; i < n; ++i) {
    EXPECT_EQ(ions[i], 17.0);
    EXPECT_EQ(hydrogen[i], all.at("Hydrogen_Flux_Divergence")[static_cast<std::size_t>(i)]);
  }
}

TEST(CompositeMaterial, HasTheDensityAndTheModuliOfThePartsThatBearLoad) {
  const auto make = [](const Teuchos::ParameterList& list, const char* model) {
    return pd::MaterialRegistry::self().create(model, list);
  };
  const auto steel = make(parametersOf(material({elastic()})), "PDHE");
  const auto whole = make(parametersOf(material({dissolving(), elastic()})), "Combined");
  EXPECT_EQ(whole->Density(), 2.0);
  EXPECT_EQ(whole->BulkModulus(), steel->BulkModulus());
  EXPECT_EQ(whole->ShearModulus(), steel->ShearModulus());
  const auto two = make(parametersOf(material({elastic(), elastic(30.0)})), "Combined");
  EXPECT_DOUBLE_EQ(two->BulkModulus(), 4.0 * steel->BulkModulus());
  EXPECT_THROW(make(parametersOf(material({dissolving(), diffusive(1.0)})), "Combined")->Density(),
               std::invalid_argument);
}

TEST(CompositeMaterial, BondsGetAStateWhereWhatDissolvesBearsLoad) {
  const auto hasBondDamage = [](const std::vector<Teuchos::ParameterList>& parts) {
    const auto made = pd::MaterialRegistry::self().create("Combined", parametersOf(material(parts)));
    const std::vector<int> ids = made->FieldIds();
    return std::count(ids.begin(), ids.end(), pd::fields::bondDamage().id()) == 1;
  };
  EXPECT_TRUE(hasBondDamage({elastic(), dissolving()}));
  EXPECT_FALSE(hasBondDamage({elastic(), diffusive(1.0)}));
  EXPECT_FALSE(hasBondDamage({diffusive(1.0, "Hydrogen"), dissolving()}));
}

TEST(CompositeMaterial, NamesThePartsThatKeepItFromBeingSprings) {
  const auto obstacle = [](const std::vector<Teuchos::ParameterList>& parts) {
    const auto made = pd::MaterialRegistry::self().create("Combined", parametersOf(material(parts)));
    return dynamic_cast<const pd::LinearBonds&>(*made).springsObstacle();
  };
  EXPECT_EQ(obstacle({elastic(), diffusive(3.0)}), "");
  EXPECT_EQ(obstacle({elastic(), diffusive(3.0), elastic()}),
            "its materials \"A\", \"C\" all carry load, not one alone");
  EXPECT_EQ(obstacle({diffusive(3.0), diffusive(2.0)}), "none of its materials carries load");
}

TEST(CompositeMaterial, RefusesPartsThatDoNotGoTogether) {
  Teuchos::ParameterList solid;
  solid.set<std::string>("Material Model", "Elastic");
  solid.set("Density", 2.0);
  solid.set("Bulk Modulus", 3.0);
  solid.set("Shear Modulus", 2.0);
  Teuchos::ParameterList heavy = elastic(), unknown = elastic(), nested = elastic(), nothing;
  heavy.set("Density", 3.0);
  unknown.set<std::string>("Material Model", "Steal");
  nested.set<std::string>("Material Model", "Combined");
  const struct {
    std::vector<Teuchos::ParameterList> parts;
    const char* message;
  } cases[] = {
      {{solid, solid}, "\"A\" and \"B\" both write the field \"Weighted_Volume\""},
      {{dissolving(), dissolving()}, "both write the field \"Saturation_Concentration\""},
      {{elastic(), heavy}, "\"A\" and \"B\" differ in Density"},
      {{elastic(), unknown}, "part \"B\": unknown Material Model \"Steal\""},
      {{elastic(), nested}, "parts have no parts"},
      {{elastic(), nothing}, "part \"B\" needs a list of its own under its name, with a \"Material Model\""},
  };
  for (const auto& [parts, message] : cases)
    EXPECT_NE(refusal(parts).find(message), std::string::npos) << message << "\n" << refusal(parts);
}

/// rate of a: 2 (a_j - a_i) + 3 x (b_j - b_i); rate of b: 5 (b_j - b_i) + 7 (a_j - a_i).y, summed over bonds.
class TwoUnknowns : public Material, public pd::FieldUser {
 public:
  struct Fields : pd::FieldTable {
    pd::FieldHandle volume = reads(pd::fields::volume()), a, b, rateOfA, rateOfB;
    Fields() {
      using namespace pd::fields;
      const auto rate = [](pd::FieldDescription field, const char* of) {
        field.rateOf = of;
        return field;
      };
      a = reads(steppedVector("Test_A", "1", "A vector."));
      b = reads(steppedScalar("Test_B", "1", "A scalar."));
      rateOfA = adds(rate(steppedVector("Test_A_Flux_Divergence", "1/s", "Its rate."), "Test_A"));
      rateOfB = adds(rate(steppedScalar("Test_B_Flux_Divergence", "1/s", "Its rate."), "Test_B"));
    }
  };
  static void declareParameters(pd::ParameterDeclarations& declare) {
    declare.real("Finite Difference Probe Length", "1", "Of the tangent.").required();
  }
  explicit TwoUnknowns(const Teuchos::ParameterList& list) : Material(list) {}
  std::string Name() const override { return "Test Two Unknowns"; }
  double Density() const override { return 1.0; }
  double BulkModulus() const override { return 0.0; }
  double ShearModulus() const override { return 0.0; }
  const Fields& fields() const override { return fields_; }
  std::vector<int> FieldIds() const override { return fields_.ids(); }
  void computeFluxDivergence(const double, const int n, const int* owned, const int* list,
                             DataManager& data) const override {
    const double *a = fields_.a.of(data), *b = fields_.b.of(data);
    double *rateOfA = fields_.rateOfA.of(data), *rateOfB = fields_.rateOfB.of(data);
    std::fill_n(rateOfA, 3 * fields_.b.length(data), 0.0);
    std::fill_n(rateOfB, fields_.b.length(data), 0.0);
    pd::forEachBond({n, owned, list}, [&](int i, int j, std::size_t) {
      for (int d = 0; d < 3; ++d) rateOfA[3 * i + d] += 2.0 * (a[3 * j + d] - a[3 * i + d]);
      rateOfA[3 * i] += 3.0 * (b[j] - b[i]);
      rateOfB[i] += 5.0 * (b[j] - b[i]) + 7.0 * (a[3 * j + 1] - a[3 * i + 1]);
    });
  }

 private:
  Fields fields_;
};
PD_REGISTER_MATERIAL(TwoUnknowns, "Test Two Unknowns", "A vector and a scalar that act on each other.")

class Entries : public SerialMatrix {
 public:
  void addValue(int row, int column, double value) override { values[{row, column}] += value; }
  void addValues(int n, const int* ids, const double* const* block) override {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) addValue(ids[i], ids[j], block[i][j]);
  }
  void addBlockDiagonalValues(int, const int*, const double* const*) override { FAIL(); }
  void putScalar(double) override { FAIL(); }
  double at(int row, int column) const {
    const auto found = values.find({row, column});
    return found == values.end() ? 0.0 : found->second;
  }
  std::map<std::pair<int, int>, double> values;
};

TEST(FiniteDifferenceTangent, IsThatOfAnyListOfUnknowns) {
  auto& unknowns = DegreesOfFreedomManager::self();
  BodyOptions options;
  options.isBare = true;
  SmallBody body({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}}, options);  // a row of two bonds
  Teuchos::ParameterList list;
  list.set("Finite Difference Probe Length", 0.25);
  const auto material = pd::MaterialRegistry::self().create("Test Two Unknowns", list);
  body.allocate(material->FieldIds());
  const auto points = body.block().getNeighborhoodData();
  const auto tangent = [&] {
    Entries entries;
    material->computeJacobian(0.1, points->NumOwnedPoints(), points->OwnedIDs(), points->NeighborhoodList(),
                              *body.block().getDataManager(), entries);
    return entries;
  };
  // B first, A behind it: rows and columns are 4 a point.
  unknowns.setUnknowns({{"Test_B", 1}, {"Test_A", 3}});
  const Entries both = tangent();
  EXPECT_EQ(both.at(0, 0), -5.0);  // one bond
  EXPECT_EQ(both.at(4, 4), -10.0);
  EXPECT_EQ(both.at(4, 0), 5.0);
  EXPECT_EQ(both.at(4, 2), 7.0);  // by y of A
  EXPECT_EQ(both.at(4, 6), -14.0);
  EXPECT_EQ(both.at(5, 0), 3.0);
  EXPECT_EQ(both.at(5, 4), -6.0);
  for (int d = 1; d < 4; ++d) {
    EXPECT_EQ(both.at(4 + d, 4 + d), -4.0);
    EXPECT_EQ(both.at(4 + d, 8 + d), 2.0);
    EXPECT_EQ(both.at(d, 8 + d), 0.0);
  }
  unknowns.setUnknowns({{"Test_B", 1}});
  const Entries scalar = tangent();
  EXPECT_EQ(scalar.at(1, 1), -10.0);
  EXPECT_EQ(scalar.at(1, 2), 5.0);
  unknowns.setUnknowns({{"Displacement", 3}, {"Temperature", 1}});
  for (const auto& [place, value] : tangent().values) EXPECT_EQ(value, 0.0);
  EXPECT_TRUE(unknowns.displacementTreatedAsUnknown() && unknowns.temperatureTreatedAsUnknown());
  EXPECT_EQ(unknowns.temperatureDofOffset(), 3);
  EXPECT_EQ(unknowns.totalNumberOfDegreesOfFreedom(), 4);
  unknowns.setUnknowns({{"Displacement", 3}});
}

Teuchos::ParameterList stretchLimit(double stretch) {
  Teuchos::ParameterList list;
  list.set<std::string>("Damage Model", "Critical Stretch");
  list.set("Critical Stretch", stretch);
  return list;
}

Teuchos::ParameterList compressionLimit(double stretch) {
  Teuchos::ParameterList list = stretchLimit(10.0);
  list.set("Critical Compressive Stretch", stretch);
  return list;
}

Teuchos::ParameterList model(const char* name) {
  Teuchos::ParameterList list;
  list.set<std::string>("Damage Model", name);
  return list;
}

/// Knows of nobody else, as Peridigm's own models: bonds along x break, Damage is written anew.
class AlongX : public DamageModel {
 public:
  static void declareParameters(pd::ParameterDeclarations& declare) { declare.text("Damage Model", "Name."); }
  explicit AlongX(const Teuchos::ParameterList& list) : DamageModel(list) {}
  std::string Name() const override { return "Test Along X"; }
  std::vector<int> FieldIds() const override {
    return {pd::fields::modelCoordinates().id(), pd::fields::bondDamage().id(), pd::fields::damage().id()};
  }
  void computeDamage(const double, const int n, const int* owned, const int* list, DataManager& data) const override {
    const auto x = data.getData(pd::fields::modelCoordinates().id(), PeridigmField::STEP_NONE);
    const auto broken = data.getData(pd::fields::bondDamage().id(), PeridigmField::STEP_NP1);
    const auto damage = data.getData(pd::fields::damage().id(), PeridigmField::STEP_NP1);
    int bond = 0;
    for (int p = 0; p < n; ++p) {
      const int count = *list++;
      double sum = 0.0;
      for (int k = 0; k < count; ++k, ++bond, ++list) {
        const bool isAlong = std::abs((*x)[3 * *list + 1] - (*x)[3 * owned[p] + 1]) < 0.1;
        (*broken)[bond] = isAlong ? 1.0 : 0.0;
        sum += (*broken)[bond];
      }
      (*damage)[owned[p]] = sum / count;
    }
  }
};
PD_REGISTER_DAMAGE_MODEL(AlongX, "Test Along X", "Bonds along x.")

Sample damageModels(const std::vector<Teuchos::ParameterList>& parts) {
  if (parts.size() == 1) return {"Alone", parts.front().get<std::string>("Damage Model"), 2, parts.front()};
  return {"Together", "Combined", 2, combined("Damage Models", parts)};
}

DamageState pulled(const std::vector<Teuchos::ParameterList>& parts, BondSteps steps) {
  Layout layout;
  layout.bondSteps = steps;
  DamageRun run(damageModels(parts), layout);
  run.step(pull(2, 0.6));
  run.evaluate(pull(2, 1.8));
  return run.state();
}

TEST(CompositeDamageModel, ABondBreaksWhereAnyOfItsModelsBreaksIt) {
  const std::vector<Teuchos::ParameterList> limits = {stretchLimit(0.04), compressionLimit(0.03),
                                                      model("Test Along X")};
  for (const auto& [first, second] : {std::make_pair(0, 1), std::make_pair(0, 2), std::make_pair(2, 1)})
    for (const BondSteps steps : {BondSteps::Shared, BondSteps::Copied, BondSteps::Swapped}) {
      const auto& a = limits[static_cast<std::size_t>(first)];
      const auto& b = limits[static_cast<std::size_t>(second)];
      const DamageState ofA = pulled({a}, steps), ofB = pulled({b}, steps), ofBoth = pulled({a, b}, steps);
      int nByOne = 0;
      std::vector<double> broken(ofBoth.damage.size()), all(ofBoth.damage.size());
      for (const auto& [ends, damage] : ofBoth.bonds) {
        EXPECT_EQ(damage, std::max(ofA.bonds.at(ends), ofB.bonds.at(ends)));
        nByOne += ofA.bonds.at(ends) != ofB.bonds.at(ends) ? 1 : 0;
        broken[static_cast<std::size_t>(ends.first)] += damage;
        all[static_cast<std::size_t>(ends.first)] += 1.0;
      }
      EXPECT_GT(nByOne, 10);
      for (std::size_t i = 0; second != 2 && first != 2 && i < all.size(); ++i)
        EXPECT_NEAR(ofBoth.damage[i], broken[i] / all[i], 1e-15);
    }
}

TEST(CompositeDamageModel, TellsLiquidFromSolidThatHasLostItsBonds) {
  const std::vector<std::vector<Teuchos::ParameterList>> orders = {{model("Dissolution"), stretchLimit(1e-3)},
                                                                   {stretchLimit(1e-3), model("Dissolution")}};
  for (const auto& parts : orders)
    for (const BondSteps steps : {BondSteps::Shared, BondSteps::Copied, BondSteps::Swapped}) {
      Layout layout;
      layout.bondSteps = steps;
      DamageRun run(damageModels(parts), layout);
      SmallBody& body = run.body();
      const auto isLiquid = [](int id) { return id % 9 == 4; };
      for (int i = 0; i < body.nPoints(); ++i) {
        body.field("Solid_Concentration")[i] = 1.0;
        body.field("Saturation_Concentration")[i] = 0.2;
        body.field("Concentration")[i] = 1.0;
      }
      run.evaluate(pull(2, 0.0));
      const DamageState whole = run.state();
      run.updateState();
      for (int i = 0; i < body.nPoints(); ++i) body.field("Concentration")[i] = isLiquid(body.globalId(i)) ? 0.2 : 0.5;
      run.evaluate(pull(2, 0.0));
      const DamageState dissolved = run.state();
      run.updateState();
      for (const auto& [ends, damage] : dissolved.bonds)
        EXPECT_EQ(damage, isLiquid(ends.first) || isLiquid(ends.second) ? 1.0 : whole.bonds.at(ends));
      // Now all bonds that are pulled apart or held break, which some points do not outlive, as solid.
      const Motion tear = [](int id, const Point& x) { return Point{x[0] * (1.0 + id), 3.0 * x[1], 0.0}; };
      run.step(tear);
      run.evaluate(tear);
      const DamageState torn = run.state();
      for (std::size_t i = 0; i < torn.damage.size(); ++i) {
        if (isLiquid(static_cast<int>(i))) {
          EXPECT_EQ(torn.damage[i], 1.0);
        } else {
          EXPECT_LT(torn.damage[i], 1.0);
          EXPECT_GT(torn.damage[i], 0.9);
        }
      }
    }
}

TEST(CompositeDamageModel, LeavesPointsAloneThatDoNotDissolve) {
  DamageRun run(damageModels({model("Dissolution"), stretchLimit(0.04)}), {});  // no saturation concentration anywhere
  run.step(pull(2, 0.6));
  run.evaluate(pull(2, 1.8));
  EXPECT_TRUE(run.state() == pulled({stretchLimit(0.04)}, BondSteps::Shared));
}

TEST(CompositeDamageModel, RefusesTwoWritersOfOneField) {
  Teuchos::ParameterList random = model("Dissolution");
  random.set<std::string>("Rule", "Stochastic");
  try {
    pd::DamageModelRegistry::self().create("Combined", combined("Damage Models", {random, random}));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("\"A\" and \"B\" both write the field \"Loose\""), std::string::npos);
  }
}

}  // namespace
}  // namespace pdtest
