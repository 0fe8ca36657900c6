// Cracks and voids of a deck, of which the mesh knows nothing: what they leave of cells and bonds.
#ifndef PD_UNRESOLVED_GEOMETRY_HPP
#define PD_UNRESOLVED_GEOMETRY_HPP

#include <array>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "../deck/deck.hpp"
#include "../parallel/communicator.hpp"
#include "bond_decomposition.hpp"
#include "discontinuity_reader.hpp"
#include "discretization.hpp"
#include "mesh_points.hpp"
#include "node_sets.hpp"

namespace pd {

/// The entries of Cracks and Voids in Discretization, and the rule of Bond Decomposition. A point stands for a square
/// or cube of its volume, with edges along x, y and z.
class UnresolvedGeometry {
 public:
  /// Adds mistakes to deck.mistakes(). Collective where voids are in files.
  UnresolvedGeometry(const Deck& deck, const Communicator& comm, int dimension);
  bool empty() const { return entries_.empty(); }

  /// Takes points with next to no material out of the mesh and its node sets, says so in deck.warnings(), and keeps how
  /// much of the other cells is left. `spacing`: edge of each point's cell, m, of which it takes the same ones out;
  /// `horizon`: the longest.
  void leaveOutPoints(MeshPoints& points, NodeSets& nodeSets, std::vector<double>& spacing, double horizon);

  /// Removes bonds that are cut off and fills interactionShare, countedBonds, cellVolume and volume. `points`: as
  /// leaveOutPoints() has left them. Discontinuities that meet nothing are mistakes of the deck. Collective.
  void decompose(const MeshPoints& points, const std::vector<double>& spacing, const Communicator& comm,
                 Discretization& discretization);

 private:
  struct Entry {
    DeckNode node;       ///< in the deck
    std::string inFile;  ///< place of one of several that a file lists
    bool isCrack = false;
    bool isMet = false;
    std::vector<std::unique_ptr<decomposition::Screen>> screens;
    std::vector<std::unique_ptr<decomposition::Void>> voids;
  };
  void read(const DeckNode& list, bool areCracks, const Communicator& comm);
  GeometryFile readFile(const DeckNode& fileName, const Communicator& comm) const;
  /// Throws DeckError where a void is far smaller than the spacing, or a crack far longer.
  void requireSizes(double spacing) const;
  void sortIntoBins(const MeshPoints& points, double reach);
  std::array<int, 3> binOf(const double* place) const;
  /// What may be near the cell or the bonds of a point at this place.
  const decomposition::NearDiscontinuities& near(const double* place) const;
  decomposition::Cell cellOf(const double* place, double spacing) const;
  /// Entries of the deck that meet nothing are mistakes, some of many in a file are warned of. Collective.
  void checkMet(const MeshPoints& points, const Communicator& comm);
  decomposition::NearDiscontinuities withoutCracks(const decomposition::NearDiscontinuities& near) const;
  /// Of bonds as they are in the neighbourhoods.
  struct Shares {
    std::vector<double> left;     ///< [bonds]
    std::vector<double> counted;  ///< [bonds] of which Damage is the lost share; empty where that is `left`
    long long nNear = 0;          ///< bonds that may meet something
    long long nPairs = 0;         ///< such pairs of points that were looked at
    long long nLines = 0;         ///< of cells, times places that looked at them
  };
  /// Each pair of points of this rank once.
  Shares sharesOf(const MeshPoints& points, const std::vector<double>& spacing, const Discretization& discretization);
  void markAsMet(Entry& entry);
  void markMet(const decomposition::NearDiscontinuities& near, const decomposition::Cell& a,
               const decomposition::Cell& b);

  const Deck& deck_;
  int dimension_;
  decomposition::DecompositionRule rule_;
  bool countsCracks_ = true;
  std::vector<Entry> entries_;
  std::size_t nMet_ = 0;  ///< of these
  std::unordered_map<const decomposition::Screen*, std::size_t> entryOf_;
  std::vector<double> solid_;  ///< share of the cell that is material, of points that are left
  // Bins as long as bonds reach, each with what meets it or its surroundings.
  std::array<double, 3> origin_{};
  double binEdge_ = 1.0;
  std::array<int, 3> nBins_{};
  std::map<std::array<int, 3>, decomposition::NearDiscontinuities> bins_;
};

}  // namespace pd

#endif
