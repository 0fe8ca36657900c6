// Checkpoints: the whole state of a run in one HDF5 file, from which it goes on, on any number of ranks.
//
//   attributes           checkpoint (2: the form described here), step, time, solver (its name)
//   deck                 text of the resolved deck
//   points/<field>       [n (x width)] in the order of global ids: two-step fields at STEP_NP1, and constant ones
//   globals/<field>      [width] values for the whole body
//   bonds/count          [n] neighbours of each point
//   bonds/neighbor       [bonds] global id of the other end, ascending for each point
//   bonds/<field>        [bonds (x width)] in the order of bonds/neighbor
//   solver/state         the solver's own numbers; solver/names: their names, one a line
//
// At the end of an increment STEP_N is a copy of STEP_NP1, so it is not stored. Everything has checksums: what was
// damaged is refused.
#ifndef PD_CHECKPOINT_HPP
#define PD_CHECKPOINT_HPP

#include <string>
#include <vector>

#include "../model/model.hpp"
#include "../model/restart_state.hpp"
#include "global_order.hpp"

namespace pd {

/// What a run goes on from, beyond the fields of its model.
struct Checkpoint {
  int step = 0;
  double time = 0.0;
  std::string solver;                      ///< that was at work
  RestartState state;                      ///< of the solver; the same on every rank
  std::string deck;                        ///< text of the resolved deck
  std::vector<std::string> missingFields;  ///< that the model has and the file that was read has not
};

/// Replaces the file in one step once the new one is complete. Throws RunError on all ranks. Collective.
void writeCheckpoint(Model& model, const GlobalOrder& order, const std::string& fileName, const Checkpoint& checkpoint);

/// Fills the fields of the model from the checkpoint `fileName`, which may have been written on another number of
/// ranks. Call after Model::initialize. Throws RunError where the file is damaged, or is not a checkpoint of this mesh
/// and these neighbourhoods. Collective.
Checkpoint readCheckpoint(Model& model, const std::string& fileName);

}  // namespace pd

#endif
