// Data derived from a neighbourhood, kept from call to call.
#ifndef PD_NEIGHBORHOOD_CACHE_HPP
#define PD_NEIGHBORHOOD_CACHE_HPP

#include <list>
#include <utility>

#include "call.hpp"
#include "chunked_neighborhood.hpp"

namespace pd {

/// Keeps `Data` (with a member `neighborhood`) for the few neighbourhood lists that a plug-in was last called with. A
/// host may call with other lists than its block's, as Peridigm's finite-difference Jacobian does.
template <class Data>
class NeighborhoodCache {
 public:
  /// The data of this list; made by make(call) where there are none. `coordinates`: reference coordinates [3 n], part
  /// of the key, so that a list in reused memory is not taken for the old one.
  template <class Make>
  Data& of(const Call& call, const double* coordinates, Make make) {
    for (auto it = entries_.begin(); it != entries_.end(); ++it)
      if (it->isFor(call, coordinates)) {
        entries_.splice(entries_.begin(), entries_, it);
        return entries_.front().data;
      }
    entries_.emplace_front(call, coordinates, make(call));
    if (entries_.size() > capacity) entries_.pop_back();
    return entries_.front().data;
  }
  void clear() { entries_.clear(); }
  /// work(data) for all that are kept.
  template <class Work>
  void forEach(Work work) {
    for (Entry& entry : entries_) work(entry.data);
  }

 private:
  static constexpr std::size_t capacity = 4;

  struct Entry {
    Entry(const Call& call, const double* coordinates, Data&& made)
        : data(std::move(made)), place(coordinates), sum(signature(call, coordinates)) {}
    bool isFor(const Call& call, const double* coordinates) const {
      return place == coordinates && data.neighborhood.isFor(call.nOwned, call.ownedIds, call.neighborhoodList) &&
             sum == signature(call, coordinates);
    }
    /// Of the first point and its neighbours and of the last one: a list of one point is seen whole.
    static double signature(const Call& call, const double* coordinates) {
      if (call.nOwned == 0) return 0.0;
      double sum = 0.0, weight = 1.0;
      const auto add = [&](int point) {
        for (int d = 0; d < 3; ++d, weight += 0.7548776662466927) sum += weight * coordinates[3 * point + d];
      };
      add(call.ownedIds[0]);
      add(call.ownedIds[call.nOwned - 1]);
      for (int k = 1; k <= call.neighborhoodList[0]; ++k) add(call.neighborhoodList[k]);
      return sum;
    }
    Data data;
    const double* place;
    double sum;
  };
  std::list<Entry> entries_;
};

}  // namespace pd

#endif
