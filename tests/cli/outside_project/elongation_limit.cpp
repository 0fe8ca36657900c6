// Bonds break once they have grown by a length.
#include "bond_damage_model.hpp"
#include "bond_family.hpp"
#include "plugins.hpp"

namespace {

class ElongationLimit : public pd::BondDamageModel {
 public:
  struct Fields : BondDamageModel::Fields {
    pd::FieldHandle x = reads(pd::fields::modelCoordinates()), y = reads(pd::fields::coordinates());
  };
  static void declareParameters(pd::ParameterDeclarations& declare) {
    declare.text("Damage Model", "Name of this model.");
    declare.real("Limit", "m", "Growth of a bond at which it breaks.").positive().required();
  }
  explicit ElongationLimit(const Teuchos::ParameterList& params) : BondDamageModel(params) {
    pd::ParameterDeclarations declarations;
    declareParameters(declarations);
    limit_ = declarations.complete(params, "damage model Elongation Limit").get<double>("Limit");
  }
  std::string Name() const override { return "Elongation Limit"; }
  const Fields& fields() const override { return fields_; }

  void worsen(double, const pd::Call& call, PeridigmNS::DataManager& data) const override {
    const double *x = fields_.x.of(data), *y = fields_.y.of(data);
    double* bondDamage = fields_.bondDamage.of(data);
    pd::forEachBond(call, [&](int i, int j, std::size_t bond) {
      const double growth = pd::ReferenceBond(y, i, j).length - pd::ReferenceBond(x, i, j).length;
      if (growth > limit_) bondDamage[bond] = 1.0;
    });
    pd::countBrokenBonds(call, bondDamage, fields_.damage.of(data));
  }

 private:
  Fields fields_;
  double limit_;
};

PD_REGISTER_DAMAGE_MODEL(ElongationLimit, "Elongation Limit", "Bonds break once they have grown by a length.")

}  // namespace
