// Springs along the bonds: the pairwise force density c s e of Silling & Askari, Comput. Struct. 83 (2005) 1526.
#include <algorithm>
#include <cmath>

#include "Peridigm_Material.hpp"
#include "bond_family.hpp"
#include "plugins.hpp"

namespace {

class Springs : public PeridigmNS::Material, public pd::FieldUser {
 public:
  struct Fields : pd::FieldTable {
    pd::FieldHandle x = reads(pd::fields::modelCoordinates()), y = reads(pd::fields::coordinates());
    pd::FieldHandle volume = reads(pd::fields::volume()), force = adds(pd::fields::forceDensity());
    pd::FieldHandle bondDamage = readsIfThere(pd::fields::bondDamage());
  };
  static void declareParameters(pd::ParameterDeclarations& declare) {
    declare.text("Material Model", "Name of this model.");
    declare.real("Density", "kg/m3", "Mass per volume.").positive().required();
    declare.real("Micromodulus", "N/m6", "c: force per stretch and per volume of either end.").positive().required();
    declare.real("Finite Difference Probe Length", "m", "Step of the tangent, for solvers that ask for it.").positive();
  }
  explicit Springs(const Teuchos::ParameterList& given) : Material(given) {
    pd::ParameterDeclarations declarations;
    declareParameters(declarations);
    const Teuchos::ParameterList list = declarations.complete(given, "material Springs");
    density_ = list.get<double>("Density");
    micromodulus_ = list.get<double>("Micromodulus");
    if (list.isParameter("Horizon")) horizon_ = list.get<double>("Horizon");  // from the host, but for checks of decks
  }
  std::string Name() const override { return "Springs"; }
  double Density() const override { return density_; }
  double BulkModulus() const override { return M_PI * micromodulus_ * std::pow(horizon_, 4) / 18.0; }
  double ShearModulus() const override { return 0.6 * BulkModulus(); }  // Poisson's ratio 1/4
  const pd::FieldTable& fields() const override { return fields_; }
  std::vector<int> FieldIds() const override { return fields_.ids(); }

  /// A bond is visited from both of its ends, also where the other one belongs to another block or rank: each visit
  /// adds half of the force to one end and takes it from the other. The host sums what is added at ghosts.
  void computeForce(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                    PeridigmNS::DataManager& data) const override {
    const double *x = fields_.x.of(data), *y = fields_.y.of(data), *volume = fields_.volume.of(data);
    const double* bondDamage = fields_.bondDamage.ifIn(data);
    double* force = fields_.force.of(data);
    std::fill_n(force, fields_.force.length(data), 0.0);
    pd::forEachBond({numOwnedPoints, ownedIDs, neighborhoodList}, [&](int i, int j, std::size_t bond) {
      const double length = pd::ReferenceBond(x, i, j).length;
      const pd::ReferenceBond now(y, i, j);
      const double whole = bondDamage == nullptr ? 1.0 : 1.0 - bondDamage[bond];
      const double half = 0.5 * whole * micromodulus_ * (now.length / length - 1.0);
      for (std::size_t d = 0; d < 3; ++d) {
        force[3 * i + d] += half * now.xi[d] / now.length * volume[j];
        force[3 * j + d] -= half * now.xi[d] / now.length * volume[i];
      }
    });
  }

 private:
  Fields fields_;
  double density_, micromodulus_, horizon_ = 0.0;
};

PD_REGISTER_MATERIAL(Springs, "Springs", "Springs along the bonds.")

}  // namespace
