// A damage model with a history of its own, small enough to know its answers by hand. Include it in one source of a
// test.
#ifndef PD_TESTS_LIFE_DAMAGE_HPP
#define PD_TESTS_LIFE_DAMAGE_HPP

#include "bond_damage_model.hpp"
#include "bond_family.hpp"
#include "plugins.hpp"
#include "step_listener.hpp"

namespace pdtest {

/// Each step takes Loss |s|^2 of a bond's life, whatever its length; a bond without life is broken. Counts accepted
/// steps.
class Life : public pd::BondDamageModel, public pd::StepListener {
 public:
  struct Fields : BondDamageModel::Fields {
    pd::FieldHandle x = reads(pd::fields::modelCoordinates()), y = reads(pd::fields::coordinates());
    pd::FieldHandle life = writes(pd::fields::bondScalar("Test_Lost_Life", "1", "Share of the life that is gone."));
    pd::FieldHandle steps = writes(pd::fields::pointScalar("Test_Accepted_Steps", "1", "How many."));
  };
  static void declareParameters(pd::ParameterDeclarations& declare) {
    declare.text("Damage Model", "Name of this model.");
    declare.real("Loss", "1", "Of a step at a stretch of 1.").required();
  }
  explicit Life(const Teuchos::ParameterList& list) : BondDamageModel(list), loss_(list.get<double>("Loss")) {}

  std::string Name() const override { return "Test Life"; }
  const Fields& fields() const override { return fields_; }
  void worsen(double dt, const pd::Call& call, PeridigmNS::DataManager& data) const override {
    watch_.look(*this, call, data, fields_.life.before(data), dt);
    const double *x = fields_.x.of(data), *y = fields_.y.of(data), *before = lifeToStartFrom(data);
    double *life = fields_.life.of(data), *bondDamage = fields_.bondDamage.of(data);
    pd::forEachBond(call, [&](int i, int j, std::size_t bond) {
      const double length = pd::ReferenceBond(x, i, j).length;
      const double stretch = pd::ReferenceBond(y, i, j).length / length - 1.0;
      life[bond] = before[bond] + loss_ * stretch * stretch;
      if (life[bond] >= 1.0) bondDamage[bond] = 1.0;
    });
    pd::countBrokenBonds(call, bondDamage, fields_.damage.of(data));
  }
  void stepAccepted(const pd::Call& call, PeridigmNS::DataManager& data, double, double) const override {
    for (int p = 0; p < call.nOwned; ++p) fields_.steps.of(data)[call.ownedIds[p]] += 1.0;
  }

 protected:
  virtual const double* lifeToStartFrom(PeridigmNS::DataManager& data) const { return fields_.life.before(data); }
  Fields fields_;

 private:
  double loss_;
  mutable pd::StepWatch watch_;
};
PD_REGISTER_DAMAGE_MODEL(Life, "Test Life", "Bonds that tire.")

}  // namespace pdtest

#endif
