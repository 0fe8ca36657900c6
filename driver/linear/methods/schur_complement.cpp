#include "schur_complement.hpp"

#include <mpi.h>

#include <algorithm>
#include <numeric>

#include "mumps_jobs.hpp"

namespace pd {

namespace {

// Right-hand sides that are substituted at a time.
constexpr std::size_t mostSides = 128;

std::vector<int> placesIn(const std::vector<int>& order) {
  std::vector<int> places(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    places[static_cast<std::size_t>(order[k]) - 1] = static_cast<int>(k) + 1;
  return places;
}

/// `places`: placesIn() the order of elimination. All that it refers to has to stay.
void begin(DMUMPS_STRUC_C& state, SymmetricEntries& matrix, std::vector<int>& places) {
  mumps::begin(state, MPI_COMM_SELF, 1);
  mumps::control(state, 7) = 1;  // the order is given
  state.n = matrix.size;
  state.nnz = static_cast<MUMPS_INT8>(matrix.values.size());
  state.irn = matrix.rows.data();
  state.jcn = matrix.columns.data();
  state.a = matrix.values.data();
  state.perm_in = places.data();
}

}  // namespace

SchurComplement schurComplement(SymmetricEntries& matrix, std::vector<int>& kept, const std::vector<int>& order) {
  SchurComplement result;
  const std::size_t n = kept.size();
  result.values.assign(n * n, 0.0);
  std::vector<int> places = placesIn(order);
  DMUMPS_STRUC_C state{};
  begin(state, matrix, places);
  mumps::control(state, 19) = 1;  // a whole Schur complement on the root
  mumps::control(state, 31) = 1;  // factors are not kept
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

InverseColumns columnsOfInverse(SymmetricEntries& matrix, const std::vector<int>& rows, const std::vector<int>& columns,
                                const std::vector<int>& order) {
  InverseColumns result;
  std::vector<int> places = placesIn(order);
  DMUMPS_STRUC_C state{};
  begin(state, matrix, places);
  result.trouble = mumps::factor(state);
  const auto n = static_cast<std::size_t>(matrix.size);
  mumps::control(state, 20) = 3;  // sides are sparse, and substituted as such
  std::vector<int> unknowns = columns, starts(mostSides + 1);
  std::iota(starts.begin(), starts.end(), 1);
  std::vector<double> ones(mostSides, 1.0), sides;
  for (std::size_t first = 0; result.trouble.empty() && first < columns.size(); first += mostSides) {
    const std::size_t count = std::min(mostSides, columns.size() - first);
    sides.assign(count * n, 0.0);
    state.nrhs = state.nz_rhs = static_cast<MUMPS_INT>(count);
    state.lrhs = static_cast<MUMPS_INT>(n);
    state.rhs = sides.data();
    state.rhs_sparse = ones.data();
    state.irhs_sparse = &unknowns[first];
    state.irhs_ptr = starts.data();
    mumps::control(state, 27) = static_cast<int>(count);  // all of them at a time
    mumps::run(state, mumps::substitute);
    if (state.infog[0] < 0) result.trouble = fmt::format("MUMPS ended with INFOG(1) = {}", state.infog[0]);
    for (std::size_t k = 0; k < count; ++k)
      for (const int row : rows) result.values.push_back(sides[k * n + static_cast<std::size_t>(row) - 1]);
  }
  mumps::run(state, mumps::end);
  return result;
}

}  // namespace pd
