// Damage of a dissolving metal, by which its points turn from solid to liquid.
#include <algorithm>
#include <cstdint>
#include <optional>

#include "Peridigm_DamageModel.hpp"
#include "fields.hpp"
#include "plugins.hpp"
#include "random_bond_breaking.hpp"
#include "step_listener.hpp"

namespace pd {

using PeridigmNS::DataManager;

namespace {

/// d_c, below 1 of what still has metal to give. Rounding must not keep a point solid that has given all it can.
double expectedDamage(double concentration, double solid, double saturation) {
  if (concentration >= solid && solid > saturation) return 0.0;
  const double left = (concentration - saturation) / std::max(solid - saturation, saturation);
  return solid == 0.0 || left <= 1e-12 ? 1.0 : std::clamp(1.0 - left, 0.0, mostDamagedSolid);
}

}  // namespace

/// Damage is the expected d_c = (C_solid - C)/(C_solid - C_sat), or the share of bonds that break at random in
/// accordance with it; and 1 (liquid, for good) from C_sat on. Jafarzadeh, Zhao, Shakouri & Bobaru, Electrochim. Acta
/// 401 (2022) 139512, eqs. 3 to 5 and 10.
class Dissolution : public PeridigmNS::DamageModel, public FieldUser, public StepListener {
 public:
  struct Fields : FieldTable {
    FieldHandle damage = worsens(pd::fields::damage());
    FieldHandle concentration, solid, saturation;
    /// `bonds`: null without random bonds, which look at both of their ends.
    explicit Fields(const RandomBondBreaking* bonds) {
      const Ghosts ghosts = bonds != nullptr ? Ghosts::AfterInitialize : Ghosts::None;
      concentration = reads(pd::fields::ionConcentration(), ghosts);
      solid = reads(pd::fields::solidConcentration(), ghosts);
      saturation = reads(pd::fields::saturationConcentration(), ghosts);
      if (bonds != nullptr) include(bonds->fields());
    }
  };

  static void declareParameters(ParameterDeclarations& declare) {
    declare.text("Damage Model", "Name of this model.");
    declare
        .text("Rule",
              "What Damage of a solid point is: the share of its metal that has dissolved, or that of its bonds that "
              "are broken, which then break at random as metal dissolves at either end. A point that has lost all "
              "bonds dissolves before those around it.")
        .oneOf({"Deterministic", "Stochastic"})
        .defaultTo("Deterministic")
        .from("Jafarzadeh, Zhao, Shakouri & Bobaru, Electrochim. Acta 401 (2022) 139512");
    declare.integer("Random Seed", "Of the rule Stochastic: each gives another sequence of broken bonds.")
        .defaultTo(0)
        .atLeast(0);
  }

  explicit Dissolution(const Teuchos::ParameterList& given)
      : DamageModel(given),
        bonds_(bondsOf(completed<Dissolution>(given, "damage model Dissolution"))),
        fields_(bonds_ ? &*bonds_ : nullptr) {}

  static FieldTable describeFields() {
    const RandomBondBreaking bonds(0);
    return Fields(&bonds);
  }

  std::string Name() const override { return "Dissolution"; }
  const Fields& fields() const override { return fields_; }
  std::vector<int> FieldIds() const override { return fields_.ids(); }
  std::vector<int> FieldIdsForSynchronizationAfterInitialize() const override {
    return fields_.ids(Ghosts::AfterInitialize);
  }

  void initialize(const double, const int, const int*, const int*, DataManager&) const override {
    if (bonds_) bonds_->forget();
  }
  void stepTakenBack() const override {
    if (bonds_) bonds_->lookAtAllAgain();
  }
  void computeDamage(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                     DataManager& dataManager) const override {
    double* damage = fields_.damage.of(dataManager);
    const double* concentration = fields_.concentration.of(dataManager);
    const double* solid = fields_.solid.of(dataManager);
    const double* saturation = fields_.saturation.of(dataManager);
    const auto expected = [&](int i) {
      return damage[i] >= 1.0 ? 1.0 : expectedDamage(concentration[i], solid[i], saturation[i]);
    };
    if (!bonds_) {
      for (int p = 0; p < numOwnedPoints; ++p) damage[ownedIDs[p]] = expected(ownedIDs[p]);
      return;
    }
    const int nPoints = fields_.damage.length(dataManager);
    std::vector<double> ofAll(static_cast<std::size_t>(nPoints));
    for (int i = 0; i < nPoints; ++i) ofAll[static_cast<std::size_t>(i)] = expected(i);
    bonds_->update({numOwnedPoints, ownedIDs, neighborhoodList}, ofAll, dataManager);
  }

 private:
  static std::optional<RandomBondBreaking> bondsOf(const Teuchos::ParameterList& params) {
    if (params.get<std::string>("Rule") != "Stochastic") return std::nullopt;
    return RandomBondBreaking(static_cast<std::uint32_t>(params.get<int>("Random Seed")));
  }

  std::optional<RandomBondBreaking> bonds_;
  Fields fields_;
};

PD_REGISTER_DAMAGE_MODEL(Dissolution, "Dissolution", "Solid points turn liquid at the saturation concentration.")

}  // namespace pd
