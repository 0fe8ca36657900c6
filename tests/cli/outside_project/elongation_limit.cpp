// Bonds break once they have grown by a length.
#include "Peridigm_DamageModel.hpp"
#include "Peridigm_Field.hpp"
#include "bond_family.hpp"
#include "field_views.hpp"
#include "plugins.hpp"

namespace {

namespace Field = PeridigmNS::PeridigmField;

class ElongationLimit : public PeridigmNS::DamageModel {
 public:
  static void declareParameters(pd::ParameterDeclarations& declare) {
    declare.text("Damage Model", "Name of this model.");
    declare.real("Limit", "m", "Growth of a bond at which it breaks.").positive().required();
  }
  explicit ElongationLimit(const Teuchos::ParameterList& params) : DamageModel(params), limit_(limitIn(params)) {
    auto& fields = PeridigmNS::FieldManager::self();
    xId_ = fields.getFieldId(Field::NODE, Field::VECTOR, Field::CONSTANT, "Model_Coordinates");
    yId_ = fields.getFieldId(Field::NODE, Field::VECTOR, Field::TWO_STEP, "Coordinates");
    damageId_ = fields.getFieldId(Field::ELEMENT, Field::SCALAR, Field::TWO_STEP, "Damage");
    bondDamageId_ = fields.getFieldId(Field::BOND, Field::SCALAR, Field::TWO_STEP, "Bond_Damage");
  }
  std::string Name() const override { return "Elongation Limit"; }
  std::vector<int> FieldIds() const override { return {xId_, yId_, damageId_, bondDamageId_}; }

  void computeDamage(const double, const int nOwned, const int* ownedIds, const int* neighborhoodList,
                     PeridigmNS::DataManager& data) const override {
    const double *x = pd::view(data, xId_, Field::STEP_NONE), *y = pd::view(data, yId_, Field::STEP_NP1);
    const double* oldBondDamage = pd::view(data, bondDamageId_, Field::STEP_N);
    double *bondDamage = pd::view(data, bondDamageId_, Field::STEP_NP1),
           *damage = pd::view(data, damageId_, Field::STEP_NP1);
    const int* entry = neighborhoodList;
    for (int p = 0; p < nOwned; ++p) {
      const int point = ownedIds[p], nNeighbors = *entry++;
      double nBroken = 0.0;
      for (int k = 0; k < nNeighbors; ++k, ++bondDamage, ++oldBondDamage) {
        const int neighbor = *entry++;
        const double growth =
            pd::ReferenceBond(y, point, neighbor).length - pd::ReferenceBond(x, point, neighbor).length;
        *bondDamage = growth > limit_ ? 1.0 : *oldBondDamage;
        nBroken += *bondDamage;
      }
      damage[point] = nNeighbors > 0 ? nBroken / nNeighbors : 0.0;
    }
  }

 private:
  static double limitIn(const Teuchos::ParameterList& given) {
    pd::ParameterDeclarations declarations;
    declareParameters(declarations);
    return declarations.complete(given, "damage model Elongation Limit").get<double>("Limit");
  }

  double limit_;
  int xId_, yId_, damageId_, bondDamageId_;
};

PD_REGISTER_DAMAGE_MODEL(ElongationLimit, "Elongation Limit", "Bonds break once they have grown by a length.")

}  // namespace
