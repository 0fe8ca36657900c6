// Checkpoints: the whole state of a run in one HDF5 file, from which it goes on, on any number of ranks.
//
//   attributes           step, time, deck (hash of the resolved deck's text)
//   points/<field>       [n (x width)] in the order of global ids: two-step fields at STEP_NP1, and constant ones
//   globals/<field>      [width] values for the whole body
//   bonds/count          [n] neighbours of each point
//   bonds/neighbor       [bonds] global id of the other end, ascending for each point
//   bonds/<field>        [bonds (x width)] in the order of bonds/neighbor
//   solver/state         the solver's own numbers; solver/count: how many of them each rank gave, or one number where
//                        every rank gave the same
//
// At the end of an increment STEP_N is a copy of STEP_NP1, so it is not stored. (readCheckpoint: output.hpp)
#ifndef PD_CHECKPOINT_HPP
#define PD_CHECKPOINT_HPP

#include <string>
#include <vector>

#include "../model/model.hpp"
#include "global_order.hpp"

namespace pd {

/// Replaces the file in one step once the new one is complete. Throws RunError on all ranks. Collective.
void writeCheckpoint(Model& model, const GlobalOrder& order, const std::string& fileName, int step, double time,
                     const std::vector<double>& solverState, const std::string& deckHash);

/// A number for a text (FNV-1a, 64 bits), in hexadecimal.
std::string textHash(const std::string& text);

}  // namespace pd

#endif
