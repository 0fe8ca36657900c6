#include "schur_complement.hpp"

#include <dmumps_c.h>
#include <fmt/format.h>
#include <mpi.h>

namespace pd {

namespace {

// MUMPS' jobs, as its guide numbers them.
constexpr int start = -1, end = -2, analyseAndFactor = 4;
constexpr int needsMoreMemory = -9;

}  // namespace

SchurComplement schurComplement(SymmetricEntries& matrix, std::vector<int>& kept, const std::vector<int>& order) {
  SchurComplement result;
  const std::size_t n = kept.size();
  result.values.assign(n * n, 0.0);
  std::vector<int> places(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    places[static_cast<std::size_t>(order[k]) - 1] = static_cast<int>(k) + 1;

  DMUMPS_STRUC_C state{};
  const auto control = [&](int number) -> int& { return state.icntl[number - 1]; };
  const auto run = [&](int job) {
    state.job = job;
    dmumps_c(&state);
  };
  state.par = 1;
  state.sym = 1;  // positive definite
  state.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(MPI_COMM_SELF));
  run(start);
  for (const int output : {1, 2, 3, 4}) control(output) = 0;
  control(7) = 1;    // the order is given
  control(14) = 60;  // per cent of memory beyond what the analysis expects
  control(19) = 1;   // a whole Schur complement on the root
  control(31) = 1;   // factors are not kept
  state.n = matrix.size;
  state.nnz = static_cast<MUMPS_INT8>(matrix.values.size());
  state.irn = matrix.rows.data();
  state.jcn = matrix.columns.data();
  state.a = matrix.values.data();
  state.perm_in = places.data();
  state.size_schur = static_cast<MUMPS_INT>(n);
  state.listvar_schur = kept.data();
  state.schur = result.values.data();
  run(analyseAndFactor);
  for (int pass = 0; pass < 3 && state.infog[0] == needsMoreMemory; ++pass) {
    control(14) *= 3;
    run(analyseAndFactor);
  }
  if (state.infog[0] < 0)
    result.trouble = fmt::format("MUMPS ended with INFOG(1) = {}, INFOG(2) = {}", state.infog[0], state.infog[1]);
  run(end);
  // It writes one triangle, by rows.
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) result.values[j * n + i] = result.values[i * n + j];
  return result;
}

}  // namespace pd
