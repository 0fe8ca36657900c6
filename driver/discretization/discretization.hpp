// The points of this rank, their neighbourhoods and their node sets.
#ifndef PD_DISCRETIZATION_HPP
#define PD_DISCRETIZATION_HPP

#include <map>
#include <string>
#include <vector>

#include "../deck/deck.hpp"
#include "../parallel/communicator.hpp"
#include "symmetry.hpp"

namespace pd {

/// Local numbering: owned points first (0 .. nOwned-1), then ghosts, then images: mirrored points beyond planes of
/// symmetry. Owned points are numbered along lines of the mesh where it has such lines, so that neighbouring points sit
/// next to each other in memory.
struct Discretization {
  int dimension = 3;  ///< 1 (all points on a line along x), 2 (all in one z plane) or 3
  int nOwned = 0;
  int nPoints = 0;                ///< owned + ghosts + images
  long long nGlobal = 0;          ///< points of the whole mesh
  std::vector<int> globalIds;     ///< [nPoints] 0-based number of the point in the mesh file; of an image: nGlobal
                                  ///< times the number of its copy of the body more than that of its source
  std::vector<double> x;          ///< [3 nPoints] reference coordinates, m
  std::vector<double> volume;     ///< [nPoints] m3
  std::vector<double> horizon;    ///< [nPoints] m
  std::vector<int> blockId;       ///< [nPoints] number of the block in the mesh file
  std::vector<int> blockNumbers;  ///< all block numbers of the mesh, sorted (all ranks)
  /// Names of blocks that the mesh gives one; the others are block_<number> (nameOfBlock() says it).
  std::map<int, std::string> blockNames;

  /// Neighbours of owned points, as Peridigm lays them out: [n_0, j.., n_1, j.., ...], local ids, sorted in each
  /// neighbourhood.
  std::vector<int> neighborhoodList;
  std::vector<long long> neighborhoodStart;  ///< [nOwned + 1] where each point's entry starts in neighborhoodList
  /// [bonds] 1 where a bond filter that counts in Damage cuts the bond (others have removed it). Empty where none.
  std::vector<char> bondIsCut;

  // What Cracks and Voids of the deck leave (materials/decomposition/); all empty where there are none. `volume` is
  // then that of the material.
  std::vector<double> interactionShare;  ///< [bonds] share of the bond's connections that is left
  std::vector<double> countedBonds;      ///< [nOwned] of which Damage is the lost share
  std::vector<double> cellVolume;        ///< [nPoints] m3, voids included
  bool isDecomposed = false;             ///< on all ranks alike
  std::string decompositionNote;         ///< how many bonds that concerns, and the time it took

  /// Local ids (owned and ghosts) by name of the node set as the deck writes it.
  std::map<std::string, std::vector<int>> nodeSets;

  Symmetry symmetry;
  std::vector<int> imageSource;  ///< [images] local id of the owned point or ghost that an image mirrors
  std::vector<int> imageCopy;    ///< [images] in which copy of the body it is

  /// Local id of the first image: owned + ghosts.
  int firstImage() const { return nPoints - static_cast<int>(imageSource.size()); }
  bool isImage(int point) const { return point >= firstImage(); }
  /// The point itself, or what it mirrors.
  int sourceOf(int point) const {
    return isImage(point) ? imageSource[static_cast<std::size_t>(point - firstImage())] : point;
  }
  int copyOf(int point) const { return isImage(point) ? imageCopy[static_cast<std::size_t>(point - firstImage())] : 0; }

  double shortestBond = 0.0;  ///< over all ranks, m
  long long nBonds() const { return static_cast<long long>(neighborhoodList.size()) - nOwned; }
};

/// Reads the mesh and node sets that the deck names, partitions, finds neighbours, applies bond filters.
/// Mistakes of files are added to `deck.mistakes()` with file:line; throws DeckError after reporting all of them.
/// Collective.
Discretization readDiscretization(const Deck& deck, const Communicator& comm);

}  // namespace pd

#endif
