// Distributed sparse matrices and linear solves (Tpetra, Belos, Ifpack2, MueLu, Amesos2), behind plain arrays.
#ifndef PD_LINEAR_SYSTEM_HPP
#define PD_LINEAR_SYSTEM_HPP

#include <memory>
#include <string>
#include <vector>

#include "../discretization/discretization.hpp"
#include "../parallel/communicator.hpp"
#include "Peridigm_SerialMatrix.hpp"

namespace pd {

struct LinearSolveReport {
  int iterations = 0;
  double relativeResidual = 0.0;  ///< true residual |b - A x| / |b|, computed after the solve
  bool hasConverged = false;
};

/// A matrix with `width` degrees of freedom a point, the graph of the neighbourhoods (or of neighbours' neighbours
/// where a material's tangent couples a whole family).
class LinearSystem : public PeridigmNS::SerialMatrix {
 public:
  LinearSystem(const Communicator& comm, const Discretization& discretization, int width, bool couplesFamilies);
  ~LinearSystem() override;

  void putScalar(double value) override;
  void addValue(int globalRow, int globalCol, double value) override;
  void addValues(int numIndices, const int* globalIndices, const double* const* values) override;
  void addBlockDiagonalValues(int numIndices, const int* globalIndices, const double* const* values) override;
  void addToDiagonal(int ownedPoint, int component, double value);

  /// Sends contributions to rows of other ranks. Rows of constrained degrees of freedom become identity, their
  /// columns are eliminated symmetrically. `isConstrained`: [width nPoints].
  void finish(const std::vector<char>& isConstrained);

  /// Diagonal at owned degrees of freedom.
  std::vector<double> diagonal() const;
  void apply(const double* x, double* y) const;  ///< y = A x over owned degrees of freedom

  /// Solves A x = b (owned degrees of freedom). `method`: "CG", "GMRES" or "Direct"; `preconditioner`: "None",
  /// "Jacobi", "Block Jacobi", "ILU", "Multigrid". Checks the true residual.
  LinearSolveReport solve(const double* b, double* x, const std::string& method, const std::string& preconditioner,
                          double relativeTolerance, int maximumIterations);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pd

#endif
