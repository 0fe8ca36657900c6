// Damage of a dissolving metal, by which its points turn from solid to liquid.
#include <algorithm>

#include "Peridigm_DamageModel.hpp"
#include "Peridigm_DataManager.hpp"
#include "Peridigm_Field.hpp"
#include "field_views.hpp"
#include "plugins.hpp"

namespace pd {

using PeridigmNS::DataManager;
using PeridigmNS::FieldManager;
namespace Field = PeridigmNS::PeridigmField;

/// d = (C_solid - C)/(C_solid - C_sat), and 1 (liquid, for good) from C_sat on.
/// Jafarzadeh, Zhao, Shakouri & Bobaru, Electrochim. Acta 401 (2022) 139512, eq. 5.
class Dissolution : public PeridigmNS::DamageModel {
 public:
  static void declareParameters(ParameterDeclarations& declare) { declare.text("Damage Model", "Name of this model."); }
  explicit Dissolution(const Teuchos::ParameterList& params) : DamageModel(params) {
    ParameterDeclarations declarations;
    declareParameters(declarations);
    declarations.complete(params, "damage model Dissolution");
    FieldManager& fields = FieldManager::self();
    damageId_ = fields.getFieldId(Field::ELEMENT, Field::SCALAR, Field::TWO_STEP, "Damage");
    concentrationId_ = fields.getFieldId(Field::NODE, Field::SCALAR, Field::TWO_STEP, "Concentration");
    solidId_ = fields.getFieldId(Field::NODE, Field::SCALAR, Field::CONSTANT, "Solid_Concentration");
    saturationId_ = fields.getFieldId(Field::NODE, Field::SCALAR, Field::CONSTANT, "Saturation_Concentration");
  }
  std::string Name() const override { return "Dissolution"; }
  std::vector<int> FieldIds() const override { return {damageId_, concentrationId_, solidId_, saturationId_}; }

  void initialize(const double, const int, const int*, const int*, DataManager&) const override {}
  void computeDamage(const double, const int numOwnedPoints, const int* ownedIDs, const int*,
                     DataManager& dataManager) const override {
    double* damage = view(dataManager, damageId_, Field::STEP_NP1);
    const double* concentration = view(dataManager, concentrationId_, Field::STEP_NP1);
    const double* solid = view(dataManager, solidId_, Field::STEP_NONE);
    const double* saturation = view(dataManager, saturationId_, Field::STEP_NONE);
    for (int p = 0; p < numOwnedPoints; ++p) {
      const int i = ownedIDs[p];
      if (damage[i] >= 1.0) continue;
      // Rounding must not keep a point solid that has given all it can.
      const double left = (concentration[i] - saturation[i]) / std::max(solid[i] - saturation[i], saturation[i]);
      damage[i] = solid[i] == 0.0 || left <= 1e-12 ? 1.0 : std::clamp(1.0 - left, 0.0, 1.0 - 1e-12);
    }
  }

 private:
  int damageId_, concentrationId_, solidId_, saturationId_;
};

PD_REGISTER_DAMAGE_MODEL(Dissolution, "Dissolution", "Solid points turn liquid at the saturation concentration.")

}  // namespace pd
