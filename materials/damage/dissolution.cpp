// Damage of a dissolving metal, by which its points turn from solid to liquid.
#include <algorithm>
#include <cstdint>
#include <optional>

#include "dissolving_bonds.hpp"
#include "plugins.hpp"
#include "step_listener.hpp"

namespace pd {

using PeridigmNS::DataManager;

namespace {

/// d_c, below 1 of what still has metal to give. Rounding must not keep a point solid that has given all it can.
double expectedDamage(double concentration, double solid, double saturation) {
  if (saturation == 0.0 || (concentration >= solid && solid > saturation)) return 0.0;  // the former: nothing dissolves
  const double left = (concentration - saturation) / std::max(solid - saturation, saturation);
  return solid == 0.0 || left <= 1e-12 ? 1.0 : std::clamp(1.0 - left, 0.0, mostDamagedSolid);
}

}  // namespace

/// Damage is the expected d_c = (C_solid - C)/(C_solid - C_sat), or where bonds have a state, the share of broken ones;
/// and 1 (liquid, for good) from C_sat on. Bonds of liquid points are broken: they carry no load. Jafarzadeh, Zhao,
/// Shakouri & Bobaru, Electrochim. Acta 401 (2022) 139512, eqs. 3 to 5 and 10.
class Dissolution : public BondDamageModel, public StepListener {
 public:
  struct Fields : BondDamageModel::Fields {
    FieldHandle concentration, solid, saturation;
    Fields(const DissolvingBonds& bonds, bool isRandom, const std::string& label) : BondDamageModel::Fields(isRandom) {
      // Bonds look at both of their ends.
      concentration = reads(pd::fields::ionConcentration(label), Ghosts::AfterInitialize);
      solid = reads(pd::fields::solidConcentration(), Ghosts::AfterInitialize);
      saturation = reads(pd::fields::saturationConcentration(), Ghosts::AfterInitialize);
      include(bonds.fields());
    }
  };

  static void declareParameters(ParameterDeclarations& declare) {
    declare.text("Damage Model", "Name of this model.");
    declare
        .text("Rule",
              "What Damage of a solid point is: the share of its metal that has dissolved, or that of its bonds that "
              "are broken, which then break at random as metal dissolves at either end. A point that has lost all "
              "bonds dissolves before those around it. In a block whose bonds have a state (it carries load) Damage is "
              "the share of broken bonds by either rule; those of dissolved points break.")
        .oneOf({"Deterministic", "Stochastic"})
        .defaultTo("Deterministic")
        .from("Jafarzadeh, Zhao, Shakouri & Bobaru, Electrochim. Acta 401 (2022) 139512");
    declare.text("Concentration Field", "Label of the metal ions' concentration, as of the material.")
        .defaultTo("Concentration");
    declare.integer("Random Seed", "Of the rule Stochastic: each gives another sequence of broken bonds.")
        .defaultTo(0)
        .atLeast(0);
  }

  explicit Dissolution(const Teuchos::ParameterList& given)
      : Dissolution(given, completed<Dissolution>(given, "damage model Dissolution")) {}

  static FieldTable describeFields() { return Fields(DissolvingBonds(0), true, "Concentration"); }

  std::string Name() const override { return "Dissolution"; }
  const Fields& fields() const override { return fields_; }
  bool marksLiquid() const override { return true; }

  void initialize(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  DataManager& dataManager) const override {
    bonds_.forget();
    if (!isRandom_) BondDamageModel::initialize(dt, numOwnedPoints, ownedIDs, neighborhoodList, dataManager);
  }
  void stepTakenBack() const override { bonds_.lookAtAllAgain(); }
  void worsen(double, const Call& call, DataManager& dataManager) const override {
    double* damage = fields_.damage.of(dataManager);
    const double* concentration = fields_.concentration.of(dataManager);
    const double* solid = fields_.solid.of(dataManager);
    const double* saturation = fields_.saturation.of(dataManager);
    const auto expected = [&](int i) {
      return damage[i] >= 1.0 && saturation[i] > 0.0 ? 1.0 : expectedDamage(concentration[i], solid[i], saturation[i]);
    };
    if (!fields_.bondDamage.isIn(dataManager)) {
      for (int p = 0; p < call.nOwned; ++p) damage[call.ownedIds[p]] = expected(call.ownedIds[p]);
      return;
    }
    std::vector<double> ofAll(static_cast<std::size_t>(fields_.damage.length(dataManager)));
    for (std::size_t i = 0; i < ofAll.size(); ++i) {
      const double share = expected(static_cast<int>(i));
      ofAll[i] = isRandom_ || share >= 1.0 ? share : 0.0;
    }
    bonds_.update(call, ofAll, dataManager);
  }

 private:
  Dissolution(const Teuchos::ParameterList& given, const Teuchos::ParameterList& params)  // completed
      : BondDamageModel(given),
        isRandom_(params.get<std::string>("Rule") == "Stochastic"),
        bonds_(isRandom_ ? std::make_optional(static_cast<std::uint32_t>(params.get<int>("Random Seed")))
                         : std::nullopt),
        fields_(bonds_, isRandom_, params.get<std::string>("Concentration Field")) {}

  bool isRandom_;
  DissolvingBonds bonds_;
  Fields fields_;
};

PD_REGISTER_DAMAGE_MODEL(Dissolution, "Dissolution", "Solid points turn liquid at the saturation concentration.")

}  // namespace pd
