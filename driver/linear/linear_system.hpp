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
  bool hasConverged = false;      ///< the true residual is within the tolerance
  std::string method;             ///< that gave the solution: "GMRES" where CG met an indefinite matrix
};

/// A matrix with `width` degrees of freedom a point, the graph of the neighbourhoods (or of neighbours' neighbours
/// where a material's tangent couples a whole family). Degrees of freedom are numbered width * global id + component
/// in the calls of SerialMatrix, width * local id + component in arrays.
///
/// With three degrees of freedom in a plane (or on a line), the components that do not take part are left out of the
/// matrix; to the caller their rows are those of the identity.
class LinearSystem : public PeridigmNS::SerialMatrix {
 public:
  /// Collective. `discretization` is not needed afterwards.
  LinearSystem(const Communicator& comm, const Discretization& discretization, int width, bool couplesFamilies);
  ~LinearSystem() override;

  void putScalar(double value) override;
  // Contributions. Throw std::logic_error for a point that this rank does not hold. Values outside the graph that are
  // not zero are counted, see graphIsTooSmall().
  void addValue(int globalRow, int globalCol, double value) override;
  void addValues(int numIndices, const int* globalIndices, const double* const* values) override;
  void addBlockDiagonalValues(int numIndices, const int* globalIndices, const double* const* values) override;
  void addToDiagonal(int ownedPoint, int component, double value);
  /// Multiplies all contributions made so far.
  void scale(double factor);

  /// Sends contributions to rows of other ranks. Rows of constrained degrees of freedom become identity, their
  /// columns are eliminated symmetrically: right for unknowns that are zero there, as increments are.
  /// `isConstrained`: [width nPoints]. After this, putScalar() begins a new assembly. Collective.
  void finish(const std::vector<char>& isConstrained);

  /// Whether any rank's contribution since putScalar() fell outside the graph: the material couples whole families.
  /// Known after finish().
  bool graphIsTooSmall() const;

  /// Diagonal at owned degrees of freedom.
  std::vector<double> diagonal() const;
  /// [width^2 nOwned] what couples each owned point with itself, row by row.
  std::vector<double> diagonalBlocks() const;
  void apply(const double* x, double* y) const;  ///< y = A x over owned degrees of freedom

  /// Solves A x = b (owned degrees of freedom); `x` holds the first guess. Collective.
  /// `method`: "CG" (goes on with GMRES where the matrix turns out not to be positive definite), "GMRES" or "Direct"
  /// (sparse LU; on several ranks the system is gathered on one). `preconditioner`: "None", "Jacobi",
  /// "Block Jacobi" (per point), "ILU" (per rank), "Multigrid" (smoothed aggregation). Factors and preconditioners are
  /// kept until the matrix changes. The true residual is checked. Throws std::invalid_argument for unknown names.
  LinearSolveReport solve(const double* b, double* x, const std::string& method, const std::string& preconditioner,
                          double relativeTolerance, int maximumIterations);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pd

#endif
