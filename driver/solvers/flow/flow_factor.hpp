// A preconditioner for the equations of a flow: the factor of an earlier one.
#ifndef PD_FLOW_FACTOR_HPP
#define PD_FLOW_FACTOR_HPP

#include <memory>
#include <string>
#include <vector>

#include "../../linear/row_inverse.hpp"
#include "flow_equations.hpp"

namespace pd {

/// The LU factor of the matrix of FlowEquations at some time, and, where metal has dissolved since, the present
/// equations within a horizon of it, which go first, each rank's for themselves: a Schwarz method of two domains that
/// overlap, multiplicative (Smith, Bjorstad & Gropp, Domain Decomposition, 1996, ch. 1). What the old factor does not
/// know is there alone, but for the velocities' changes. Where that is much of the fluid a new factor is better.
class FlowFactor {
 public:
  explicit FlowFactor(const Communicator& comm);

  /// Of the present matrix. Returns what stands in the way of a factor; empty where nothing does. Collective.
  std::string make(const FlowEquations& equations, bool hasConvection, FactorPrecision precision);
  /// Whether it has been made for equations of so many unknowns, of which most are still those. Collective.
  bool isMadeFor(const FlowEquations& equations) const;
  /// For the equations of another flow of the same mesh, whose rows and velocities are there. Collective.
  void follow(const FlowEquations& equations, bool hasConvection);
  double entries() const { return factor_.factorEntries(); }

  /// z = about the matrix' inverse times r, over the unknowns of this rank. Collective.
  void apply(const FlowEquations& equations, bool hasConvection, const double* r, double* z) const;

 private:
  static std::vector<char> solidOf(const FlowGeometry& geometry);
  std::vector<std::size_t> rowsAroundChanges(const FlowGeometry& geometry) const;

  const Communicator& comm_;
  const Communicator alone_{MPI_COMM_SELF};
  RowInverse factor_;
  std::unique_ptr<RowInverse> around_;  ///< of this rank
  std::vector<char> wasSolid_;          ///< [points] when factor_ was made
  std::vector<std::size_t> unknowns_;   ///< of around_
  bool hasChanged_ = false;             ///< on some rank there are such
  bool isOld_ = false;                  ///< they are too many
};

}  // namespace pd

#endif
