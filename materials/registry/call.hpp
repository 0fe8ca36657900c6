// What a plug-in is called with.
#ifndef PD_CALL_HPP
#define PD_CALL_HPP

namespace pd {

/// Owned points of a block and their neighbours, as Peridigm lays them out: [n_0, j.., n_1, j.., ...], local ids.
struct Call {
  int nOwned;
  const int* ownedIds;
  const int* neighborhoodList;
};

}  // namespace pd

#endif
