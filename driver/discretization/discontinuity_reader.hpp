// Forms of cracks and voids, from the entries of a deck.
#ifndef PD_DISCONTINUITY_READER_HPP
#define PD_DISCONTINUITY_READER_HPP

#include <functional>
#include <string>
#include <vector>

#include "../deck/deck.hpp"
#include "discontinuity_forms.hpp"

namespace pd {

struct DiscontinuityForm : decomposition::DiscontinuityForm {
  DiscontinuityForm(decomposition::DiscontinuityForm form, std::string itsPlace = "")
      : decomposition::DiscontinuityForm(std::move(form)), place(std::move(itsPlace)) {}
  std::string place;  ///< "pores.txt:7" of one that a file lists
};

struct GeometryFile {
  std::string name, text;
};
/// The file that a value of the deck names. Throws DeckError where it cannot be read.
using ReadGeometryFile = std::function<GeometryFile(const DeckNode& fileName)>;

/// An entry of Discretization/Cracks or /Voids whose keys have been checked one by one. Throws DeckError.
DiscontinuityForm readCrack(const DeckNode& node, int dimension);
/// Of a file with several forms all of them.
std::vector<DiscontinuityForm> readVoid(const DeckNode& node, int dimension, const ReadGeometryFile& readFile);

}  // namespace pd

#endif
