// Forms of cracks and voids, from the entries of a deck.
#ifndef PD_DISCONTINUITY_READER_HPP
#define PD_DISCONTINUITY_READER_HPP

#include <memory>
#include <vector>

#include "../deck/deck.hpp"
#include "discontinuities.hpp"

namespace pd {

struct DiscontinuityForm {
  std::vector<std::unique_ptr<decomposition::Screen>> screens;
  std::vector<std::unique_ptr<decomposition::Void>> voids;
};

/// An entry of Discretization/Cracks or /Voids whose keys have been checked one by one. Throws DeckError.
DiscontinuityForm readCrack(const DeckNode& node, int dimension);
DiscontinuityForm readVoid(const DeckNode& node, int dimension);

}  // namespace pd

#endif
