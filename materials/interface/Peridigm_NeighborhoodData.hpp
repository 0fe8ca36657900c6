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
      : ownedIDs_(std::move(ownedIDs)),
        storage_(std::move(neighborhoodList)),
        list_(storage_.data()),
        listSize_(static_cast<int>(storage_.size())) {}
  /// Sees a list that lives at least as long, instead of a copy of it.
  NeighborhoodData(std::vector<int> ownedIDs, const int* neighborhoodList, int listSize)
      : ownedIDs_(std::move(ownedIDs)), list_(neighborhoodList), listSize_(listSize) {}
  NeighborhoodData(const NeighborhoodData&) = delete;
  NeighborhoodData& operator=(const NeighborhoodData&) = delete;

  int NumOwnedPoints() const { return static_cast<int>(ownedIDs_.size()); }
  int* OwnedIDs() const { return const_cast<int*>(ownedIDs_.data()); }
  int NeighborhoodListSize() const { return listSize_; }
  int* NeighborhoodList() const { return const_cast<int*>(list_); }
  int NumBonds() const { return NeighborhoodListSize() - NumOwnedPoints(); }
  /// Bytes of lists that this object holds itself.
  std::size_t bytes() const { return (ownedIDs_.capacity() + storage_.capacity()) * sizeof(int); }

 private:
  std::vector<int> ownedIDs_, storage_;
  const int* list_ = nullptr;
  int listSize_ = 0;
};

}  // namespace PeridigmNS

#endif
