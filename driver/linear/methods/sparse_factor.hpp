// A sparse factor of a small matrix that every rank has whole.
// No header of the plug-in interface here (direct_solver.hpp says why).
#ifndef PD_SPARSE_FACTOR_HPP
#define PD_SPARSE_FACTOR_HPP

#include <memory>
#include <vector>

namespace pd {

class SparseFactor {
 public:
  /// Square, compressed by rows.
  SparseFactor(const std::vector<std::size_t>& rowStart, const std::vector<int>& columns,
               const std::vector<double>& values);
  ~SparseFactor();

  /// False where the matrix is singular to working precision.
  bool isFactored() const;
  /// x = A^-1 b. False where a value is not finite.
  bool solve(const double* b, double* x) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pd

#endif
