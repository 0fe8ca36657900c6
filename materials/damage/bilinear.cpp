// Bonds that soften before they break: cracks grow nearer to the fracture energy than with bonds that break at once.
#include <cmath>

#include "bond_damage_model.hpp"
#include "bond_family.hpp"
#include "plugins.hpp"
#include "stretch_parameters.hpp"

namespace pd {

/// The force of a bond rises in proportion to its stretch up to s_0, and falls linearly from there to zero at s_1. The
/// energy under it is that of a bond which breaks at the critical stretch s_c where s_0 s_1 = s_c^2:
/// s_0 = s_c/sqrt(r), s_1 = s_c sqrt(r). Bond_Damage d is the part of the stiffness that is gone, so that the force is
/// (1 - d) k s, by the largest stretch so far; unloading goes back to the origin.
class Bilinear : public BondDamageModel {
 public:
  struct Fields : BondDamageModel::Fields {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle coordinates = reads(pd::fields::coordinates());
  };
  static void declareParameters(ParameterDeclarations& declare) {
    declareCriticalStretch(declare);
    declare
        .real("Softening Ratio", "1",
              "r = s_1/s_0: stretch at which a bond is broken over that at which it begins to soften. The larger, the "
              "less do "
              "points hold a crack up, and the earlier is there damage: from the critical stretch over sqrt(r).")
        .atLeast(1.0)
        .defaultTo(3.0);
    declare
        .integer(
            "Damage Levels",
            "Damage of a bond rises in so many equal steps: static solvers find another equilibrium after each rise.")
        .atLeast(1)
        .defaultTo(64);
  }
  explicit Bilinear(const Teuchos::ParameterList& given) : BondDamageModel(given) {
    const Teuchos::ParameterList params = completed<Bilinear>(given, "damage model Bilinear");
    const double critical = criticalStretchFrom(params), root = std::sqrt(params.get<double>("Softening Ratio"));
    first_ = critical / root;
    last_ = critical * root;
    levels_ = params.get<int>("Damage Levels");
  }
  std::string Name() const override { return "Bilinear"; }
  const Fields& fields() const override { return fields_; }

  void worsen(double, const Call& call, PeridigmNS::DataManager& data) const override {
    const double *x = fields_.modelCoordinates.of(data), *y = fields_.coordinates.of(data);
    const double* noFailure = fields_.noFailure.ifIn(data);
    double* bondDamage = fields_.bondDamage.of(data);
    bool hasChanged = false;
    forEachBond(call, [&](int i, int j, std::size_t bond) {
      if (bondDamage[bond] >= 1.0) return;
      if (noFailure != nullptr && (noFailure[i] != 0.0 || noFailure[j] != 0.0)) return;
      const double damage = damageAt(ReferenceBond(y, i, j).length / ReferenceBond(x, i, j).length - 1.0);
      if (damage <= bondDamage[bond]) return;
      bondDamage[bond] = damage;
      hasChanged = true;
    });
    if (hasChanged) countBrokenBonds(call, bondDamage, fields_.damage.of(data));
  }

 private:
  double damageAt(double stretch) const {
    if (stretch <= first_) return 0.0;
    if (stretch >= last_) return 1.0;
    const double damage = 1.0 - first_ / stretch * (last_ - stretch) / (last_ - first_);
    return std::floor(damage * levels_) / levels_;
  }

  Fields fields_;
  double first_, last_;
  int levels_;
};

PD_REGISTER_DAMAGE_MODEL(Bilinear, "Bilinear", "Bonds soften linearly with their stretch before they break.")

}  // namespace pd
