// The checks of a fit that need its decks.
#ifndef PD_CHECK_FIT_HPP
#define PD_CHECK_FIT_HPP

#include "../parallel/communicator.hpp"
#include "fit_file.hpp"

namespace pd {

/// Checks the deck of every run with the values of the start, and each deck with each value at its bounds; whether the
/// runs write what is compared, in units that convert, over the times of the fitted points; where `withMeshes`, reads
/// meshes and node sets (each that differs once). Finds the columns and units of the histories. Adds all mistakes:
/// those of values that the fit overrides by their place in it, those of decks by theirs. Runs that are not known for
/// mistakes of the fit itself are left out.
void checkFit(Fit& fit, const Communicator& comm, bool withMeshes, Mistakes& mistakes);

}  // namespace pd

#endif
