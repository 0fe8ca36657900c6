// Bonds that the deck cuts or leaves out from the start.
#ifndef PD_BOND_FILTERS_HPP
#define PD_BOND_FILTERS_HPP

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "../deck/deck.hpp"
#include "../parallel/communicator.hpp"
#include "mesh_points.hpp"
#include "node_sets.hpp"

namespace pd {

/// One rule that cuts bonds. cuts(a, b) == cuts(b, a), to the last bit.
class BondFilter {
 public:
  virtual ~BondFilter() = default;
  virtual bool cuts(int a, int b) const = 0;  ///< ids of points in the whole body (wholeBody())
};

/// The "Bond Filters" of a discretization, and "Omit Bonds Between Blocks". Types:
///   * Rectangular_Plane, Disk: a bond is cut where the straight line between its reference points meets the
///     surface, border included. A point on the surface loses its bonds to either side and keeps those within the
///     surface (Peridigm's rule).
///   * Node Set Pair: bonds between the points of two node sets.
///   * Exodus Mesh: bonds that meet a surface of triangles and quadrilaterals in an Exodus file.
/// Cut bonds are removed, or with `Count In Damage: true` kept and marked, so that they count as broken.
class BondFilters {
 public:
  enum class Verdict { keep, mark, remove };  ///< the worse, the greater

  /// Refers to `points`, of the whole body, which must outlive this object. Mistakes are added to deck.mistakes().
  /// Collective.
  BondFilters(const Deck& deck, const Communicator& comm, const MeshPoints& points, const NodeSets& nodeSets);

  /// Removes pairs that are further apart than this along x, y or z, m.
  void keepWithin(const std::array<double, 3>& box, const MeshPoints& points);

  bool empty() const { return filters_.empty(); }
  bool canMark() const;
  /// Remembers which filters cut any bond.
  Verdict judge(int a, int b);
  /// Warns of each filter that cut no bond on any rank, which is seldom meant.
  void warnOfIdle(const Communicator& comm, Mistakes& warnings) const;

 private:
  struct Entry {
    std::unique_ptr<BondFilter> filter;
    bool countsInDamage;
    std::string place, path;  ///< in the deck
    bool hasCut = false;
  };
  std::vector<Entry> filters_;
};

}  // namespace pd

#endif
