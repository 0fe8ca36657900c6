// Neighbours and bonds of single points, for those who look at few of many.
#ifndef PD_FAMILIES_HPP
#define PD_FAMILIES_HPP

#include <cstddef>
#include <vector>

#include "Peridigm_Block.hpp"

namespace pd {

/// An owned point of a block with its part of the block's list.
struct Family {
  std::size_t place;  ///< in the block's OwnedIDs
  int id;
  const int* neighbors;  ///< [n]
  int n;
  std::size_t firstBond;  ///< in bond fields of the block
};

/// Of the block as its list is now; refers to the list.
class Families {
 public:
  explicit Families(PeridigmNS::Block& block)
      : ids_(block.getNeighborhoodData()->OwnedIDs()), list_(block.getNeighborhoodData()->NeighborhoodList()) {
    const int* entry = list_;
    for (int p = 0; p < block.getNeighborhoodData()->NumOwnedPoints(); ++p, entry += *entry + 1)
      starts_.push_back(static_cast<std::size_t>(entry - list_));
  }
  static std::vector<Families> of(std::vector<PeridigmNS::Block>& blocks) { return {blocks.begin(), blocks.end()}; }
  std::size_t size() const { return starts_.size(); }
  int id(std::size_t p) const { return ids_[p]; }
  /// Each list begins with its length, which is no bond.
  Family operator[](std::size_t p) const {
    const int* entry = list_ + starts_[p];
    return {p, ids_[p], entry + 1, *entry, starts_[p] - p};
  }
  std::vector<Family> all() const {
    std::vector<Family> families;
    for (std::size_t p = 0; p < size(); ++p) families.push_back((*this)[p]);
    return families;
  }

 private:
  const int *ids_, *list_;
  std::vector<std::size_t> starts_;  ///< [points] in the list
};

}  // namespace pd

#endif
