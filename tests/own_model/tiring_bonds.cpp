// Bonds that tire: a stretch s takes A |s|^m of a bond's life in a second, and a bond without life is broken.
#include <cmath>

#include "bond_damage_model.hpp"
#include "bond_family.hpp"
#include "plugins.hpp"

namespace {

class TiringBonds : public pd::BondDamageModel {
 public:
  struct Fields : BondDamageModel::Fields {
    pd::FieldHandle x = reads(pd::fields::modelCoordinates()), y = reads(pd::fields::coordinates());
    pd::FieldHandle lostLife = writes(pd::fields::bondScalar("Lost_Life", "1", "Share of a bond's life that is gone."));
  };
  static void declareParameters(pd::ParameterDeclarations& declare) {
    declare.text("Damage Model", "Name of this model.");
    declare.real("Rate", "1/s", "A: life that a second at a stretch of 1 would take.").positive().required();
    declare.real("Exponent", "1", "m: power of the stretch.").atLeast(1.0).defaultTo(2.0);
  }
  explicit TiringBonds(const Teuchos::ParameterList& given) : BondDamageModel(given) {
    pd::ParameterDeclarations declarations;
    declareParameters(declarations);
    const Teuchos::ParameterList list = declarations.complete(given, "damage model Tiring Bonds");
    rate_ = list.get<double>("Rate");
    exponent_ = list.get<double>("Exponent");
  }
  std::string Name() const override { return "Tiring Bonds"; }
  const Fields& fields() const override { return fields_; }

  /// NP1 from N and dt: a host may call this many times in a step, and the life of a step is lost once.
  void worsen(double dt, const pd::Call& call, PeridigmNS::DataManager& data) const override {
    const double *x = fields_.x.of(data), *y = fields_.y.of(data), *lostBefore = fields_.lostLife.before(data);
    const double* noFailure = fields_.noFailure.ifIn(data);
    double *lost = fields_.lostLife.of(data), *bondDamage = fields_.bondDamage.of(data);
    pd::forEachBond(call, [&](int i, int j, std::size_t bond) {
      const double length = pd::ReferenceBond(x, i, j).length;
      const double stretch = pd::ReferenceBond(y, i, j).length / length - 1.0;
      lost[bond] = lostBefore[bond] + rate_ * std::pow(std::abs(stretch), exponent_) * dt;
      const bool isSafe = noFailure != nullptr && (noFailure[i] != 0.0 || noFailure[j] != 0.0);
      if (lost[bond] >= 1.0 && !isSafe) bondDamage[bond] = 1.0;
    });
    pd::countBrokenBonds(call, bondDamage, fields_.damage.of(data));
  }

 private:
  Fields fields_;
  double rate_, exponent_;
};

PD_REGISTER_DAMAGE_MODEL(TiringBonds, "Tiring Bonds", "Bonds lose life by their stretch, and break without it.")

}  // namespace
