// Damage of a dissolving metal, by which its points turn from solid to liquid.
#include <algorithm>
#include <cstdint>
#include <optional>

#include "Peridigm_DamageModel.hpp"
#include "Peridigm_DataManager.hpp"
#include "Peridigm_Field.hpp"
#include "field_views.hpp"
#include "plugins.hpp"
#include "random_bond_breaking.hpp"

namespace pd {

using PeridigmNS::DataManager;
using PeridigmNS::FieldManager;
namespace Field = PeridigmNS::PeridigmField;

namespace {

Teuchos::ParameterList completed(const Teuchos::ParameterList& params);

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
class Dissolution : public PeridigmNS::DamageModel {
 public:
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

  explicit Dissolution(const Teuchos::ParameterList& given) : DamageModel(given) {
    const Teuchos::ParameterList params = completed(given);
    if (params.get<std::string>("Rule") == "Stochastic")
      bonds_.emplace(static_cast<std::uint32_t>(params.get<int>("Random Seed")));
    FieldManager& fields = FieldManager::self();
    damageId_ = fields.getFieldId(Field::ELEMENT, Field::SCALAR, Field::TWO_STEP, "Damage");
    concentrationId_ = fields.getFieldId(Field::NODE, Field::SCALAR, Field::TWO_STEP, "Concentration");
    solidId_ = fields.getFieldId(Field::NODE, Field::SCALAR, Field::CONSTANT, "Solid_Concentration");
    saturationId_ = fields.getFieldId(Field::NODE, Field::SCALAR, Field::CONSTANT, "Saturation_Concentration");
  }
  std::string Name() const override { return "Dissolution"; }
  std::vector<int> FieldIds() const override {
    std::vector<int> ids = {damageId_, concentrationId_, solidId_, saturationId_};
    if (bonds_) {
      const std::vector<int> more = bonds_->fieldIds();
      ids.insert(ids.end(), more.begin(), more.end());
    }
    return ids;
  }
  /// A bond looks at both of its ends.
  std::vector<int> FieldIdsForSynchronizationAfterInitialize() const override {
    return bonds_ ? std::vector<int>{concentrationId_, solidId_, saturationId_} : std::vector<int>{};
  }

  void initialize(const double, const int, const int*, const int*, DataManager&) const override {
    if (bonds_) bonds_->forget();
  }
  void computeDamage(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                     DataManager& dataManager) const override {
    double* damage = view(dataManager, damageId_, Field::STEP_NP1);
    const double* concentration = view(dataManager, concentrationId_, Field::STEP_NP1);
    const double* solid = view(dataManager, solidId_, Field::STEP_NONE);
    const double* saturation = view(dataManager, saturationId_, Field::STEP_NONE);
    const auto expected = [&](int i) {
      return damage[i] >= 1.0 ? 1.0 : expectedDamage(concentration[i], solid[i], saturation[i]);
    };
    if (!bonds_) {
      for (int p = 0; p < numOwnedPoints; ++p) damage[ownedIDs[p]] = expected(ownedIDs[p]);
      return;
    }
    const int nPoints = dataManager.getData(damageId_, Field::STEP_NP1)->MyLength();
    std::vector<double> ofAll(static_cast<std::size_t>(nPoints));
    for (int i = 0; i < nPoints; ++i) ofAll[static_cast<std::size_t>(i)] = expected(i);
    bonds_->update({numOwnedPoints, ownedIDs, neighborhoodList}, ofAll, dataManager);
  }

 private:
  int damageId_, concentrationId_, solidId_, saturationId_;
  std::optional<RandomBondBreaking> bonds_;
};

namespace {

Teuchos::ParameterList completed(const Teuchos::ParameterList& params) {
  ParameterDeclarations declarations;
  Dissolution::declareParameters(declarations);
  return declarations.complete(params, "damage model Dissolution");
}

}  // namespace

PD_REGISTER_DAMAGE_MODEL(Dissolution, "Dissolution", "Solid points turn liquid at the saturation concentration.")

}  // namespace pd
