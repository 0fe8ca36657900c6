// What calls of MUMPS have in common, in either precision.
#ifndef PD_MUMPS_JOBS_HPP
#define PD_MUMPS_JOBS_HPP

#include <dmumps_c.h>
#include <fmt/format.h>
#include <smumps_c.h>

#include <string>

namespace pd::mumps {

// Jobs, as its guide numbers them.
constexpr int start = -1, end = -2, analyseAndFactor = 4, substitute = 3;

inline void run(DMUMPS_STRUC_C& state, int job) {
  state.job = job;
  dmumps_c(&state);
}
inline void run(SMUMPS_STRUC_C& state, int job) {
  state.job = job;
  smumps_c(&state);
}

/// ICNTL(number) of the guide.
template <class State>
int& control(State& state, int number) {
  return state.icntl[number - 1];
}

/// Of a matrix that is 0: not symmetric, 1: symmetric and positive definite. It prints nothing. Collective.
template <class State>
void begin(State& state, MPI_Comm comm, int symmetry) {
  state.par = 1;  // the root computes, too
  state.sym = symmetry;
  state.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(comm));
  run(state, start);
  for (const int output : {1, 2, 3, 4}) control(state, output) = 0;
}

/// With more memory where the analysis has expected too little. Returns what went wrong; empty: nothing. Collective.
template <class State>
std::string factor(State& state) {
  constexpr int needsMoreMemory = -9, isStructurallySingular = -6, isSingular = -10;
  control(state, 14) = 60;  // per cent of memory beyond what the analysis expects
  run(state, analyseAndFactor);
  for (int pass = 0; pass < 3 && state.infog[0] == needsMoreMemory; ++pass) {
    control(state, 14) *= 3;
    run(state, analyseAndFactor);
  }
  if (state.infog[0] >= 0) return "";
  if (state.infog[0] == isStructurallySingular || state.infog[0] == isSingular) return "the matrix is singular";
  return fmt::format("MUMPS ended with INFOG(1) = {}, INFOG(2) = {}", state.infog[0], state.infog[1]);
}

}  // namespace pd::mumps

#endif
