// A preconditioner for the equations of a flow, where a factor would take too much memory.
#ifndef PD_FLOW_PRECONDITIONER_HPP
#define PD_FLOW_PRECONDITIONER_HPP

#include <memory>
#include <vector>

#include "../../linear/row_inverse.hpp"
#include "flow_equations.hpp"

namespace pd {

/// Of the matrix [A G; D -tau S] of FlowEquations the inverse of [A' G; 0 M'], that is first the pressure, then the
/// velocity (Elman, Silvester & Wathen, Finite Elements and Fast Iterative Solvers, 2014, ch. 4 and 9).
///
/// M', for the Schur complement -tau S - D A^-1 G. Without convection it is near 1/mu. Convection, C, adds to its
/// inverse, since G and A all but commute: -D A^-1 G is about lap^2 (D A G)^-1, whose inverse is mu - lap^-1 D C G
/// lap^-1 (after the least-squares commutator, with the viscous part in closed form, which knows of walls what that
/// does not). Where D sees walls that move this may do harm: the caller tries.
///
/// A'^-1 is multigrid for the Laplacian (and convection, upwind) over the nearest neighbours alone, and a part of the
/// identity besides. The nonlocal Laplacian is that of neighbours for long waves, and goes no higher than its diagonal
/// a for short ones, where that of neighbours goes to its own diagonal a': its inverse is very nearly the local one and
/// 1/a - 1/a' of the identity. On a cubic lattice with a horizon of three spacings the product of both has a condition
/// of 1.3, where the local inverse alone has 3.4.
class FlowPreconditioner {
 public:
  /// Of the present velocities. Collective. Throws what MueLu throws.
  /// `convectsPressure`: whether M' takes part in the convection.
  FlowPreconditioner(Model& model, const FlowEquations& equations, bool hasConvection, bool convectsPressure);

  /// z = about the matrix' inverse times r, over the unknowns of this rank. Collective.
  void apply(const double* r, double* z) const;

 private:
  struct Bond {
    int point;
    double weight, fraction;  ///< weight: of a Laplacian, 1/m2
    std::array<double, 3> xi, sign;
    bool isFluid, isOpen;  ///< isOpen: it leaves by an outflow
  };
  std::vector<Bond> bondsOf(int point) const;
  void numberRows();
  void makeMatrices(bool wantsPressure);
  std::unique_ptr<RowInverse> multigrid(const SparseRows& rows) const;
  double addVelocityRow(std::size_t row, std::size_t component, const std::vector<Bond>& bonds, SparseRows& rows) const;
  void addPressureRow(std::size_t row, const std::vector<Bond>& bonds, SparseRows& rows) const;
  void applyToPressure(const double* r, double* z) const;
  void applyToVelocity(const double* r, double* z) const;
  std::vector<double> gradientOf(const std::vector<double>& scalar) const;
  std::vector<double> convectedBy(const std::vector<double>& divergence) const;

  Model& model_;
  const FlowEquations& equations_;
  const FlowGeometry& geometry_;
  const bool hasConvection_;
  const std::size_t n_;
  long long firstRow_ = 0;                             ///< of this rank
  std::vector<double> columnOf_;                       ///< [points]
  std::vector<std::unique_ptr<RowInverse>> velocity_;  ///< one for all components, or one each beside symmetry
  std::vector<double> shortWaves_;                     ///< [components of velocity_ rows]
  std::unique_ptr<RowInverse> pressure_;               ///< null: M' is 1/mu
};

}  // namespace pd

#endif
