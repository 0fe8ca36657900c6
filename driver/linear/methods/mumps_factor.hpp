// The LU factor of a distributed matrix, by MUMPS.
#ifndef PD_MUMPS_FACTOR_HPP
#define PD_MUMPS_FACTOR_HPP

#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

namespace pd {

class MumpsFactor {
 public:
  /// Entries of this rank: `rows` and `columns` counted from 1 over all ranks, `values`; `size` rows in all, of which
  /// this rank has `ownRows` in sequence, after those of the ranks before. Collective.
  MumpsFactor(MPI_Comm comm, int size, int ownRows, std::vector<int> rows, std::vector<int> columns,
              std::vector<double> values);
  ~MumpsFactor();

  /// What stands in the way of a factor; empty where there is none.
  const std::string& trouble() const;
  /// Entries of the factor, of all ranks.
  double entries() const;
  /// x = A^-1 b over the rows of this rank, which may be the same array. Collective.
  void solve(const double* b, double* x) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pd

#endif
