// The neighbourhoods of a block's owned points; the names of Peridigm's NeighborhoodData.
#ifndef PERIDIGM_NEIGHBORHOODDATA_HPP
#define PERIDIGM_NEIGHBORHOODDATA_HPP

#include <vector>

namespace PeridigmNS {

/// Flat lists over local ids: neighborhoodList = [n_0, j.., n_1, j.., ...] in the order of ownedIDs.
/// Bond data are in the same order, without the counts.
class NeighborhoodData {
 public:
  NeighborhoodData() = default;
  NeighborhoodData(std::vector<int> ownedIDs, std::vector<int> neighborhoodList)
      : ownedIDs_(std::move(ownedIDs)), neighborhoodList_(std::move(neighborhoodList)) {}

  int NumOwnedPoints() const { return static_cast<int>(ownedIDs_.size()); }
  int* OwnedIDs() const { return const_cast<int*>(ownedIDs_.data()); }
  int NeighborhoodListSize() const { return static_cast<int>(neighborhoodList_.size()); }
  int* NeighborhoodList() const { return const_cast<int*>(neighborhoodList_.data()); }
  int NumBonds() const { return NeighborhoodListSize() - NumOwnedPoints(); }

 private:
  std::vector<int> ownedIDs_, neighborhoodList_;
};

}  // namespace PeridigmNS

#endif
