#include "schur_complement.hpp"

#include <mpi.h>

#include "mumps_jobs.hpp"

namespace pd {

SchurComplement schurComplement(SymmetricEntries& matrix, std::vector<int>& kept, const std::vector<int>& order) {
  SchurComplement result;
  const std::size_t n = kept.size();
  result.values.assign(n * n, 0.0);
  std::vector<int> places(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    places[static_cast<std::size_t>(order[k]) - 1] = static_cast<int>(k) + 1;

  DMUMPS_STRUC_C state{};
  mumps::begin(state, MPI_COMM_SELF, 1);
  mumps::control(state, 7) = 1;   // the order is given
  mumps::control(state, 19) = 1;  // a whole Schur complement on the root
  mumps::control(state, 31) = 1;  // factors are not kept
  state.n = matrix.size;
  state.nnz = static_cast<MUMPS_INT8>(matrix.values.size());
  state.irn = matrix.rows.data();
  state.jcn = matrix.columns.data();
  state.a = matrix.values.data();
  state.perm_in = places.data();
  state.size_schur = static_cast<MUMPS_INT>(n);
  state.listvar_schur = kept.data();
  state.schur = result.values.data();
  result.trouble = mumps::factor(state);
  mumps::run(state, mumps::end);
  // It writes one triangle, by rows.
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) result.values[j * n + i] = result.values[i * n + j];
  return result;
}

}  // namespace pd
