// The LU factor of a distributed matrix, by MUMPS.
#ifndef PD_MUMPS_FACTOR_HPP
#define PD_MUMPS_FACTOR_HPP

#include <mpi.h>

#include <memory>
#include <string>

#include "../sparse_rows.hpp"

namespace pd {

class MumpsFactor {
 public:
  /// Collective.
  MumpsFactor(MPI_Comm comm, const SparseRows& matrix, FactorPrecision precision);
  ~MumpsFactor();

  /// What stands in the way of a factor; empty where there is none.
  const std::string& trouble() const;
  /// Entries of the factor, of all ranks.
  double entries() const;
  /// x = A^-1 b over the rows of this rank, which may be the same array. Collective.
  void solve(const double* b, double* x) const;

 private:
  struct Implementation;
  template <class State, class Real>
  struct OfPrecision;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pd

#endif
