#include "discretization.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "../model/collective.hpp"
#include "block_horizons.hpp"
#include "bond_filters.hpp"
#include "dimension_check.hpp"
#include "mesh_geometry.hpp"
#include "mesh_reader.hpp"
#include "neighbor_search.hpp"
#include "neighborhoods.hpp"
#include "ordering.hpp"
#include "partition.hpp"
#include "quick_grid.hpp"
#include "resolution_check.hpp"
#include "symmetric_body.hpp"
#include "unresolved_geometry.hpp"

namespace pd {

namespace {

constexpr int maximumListedPoints = 10;  ///< points in one message
/// Points closer than this fraction of the horizon must be meant to be one: rounding of a mesh generator is far below,
/// any spacing far above.
constexpr double closest = 1e-6;

double positiveLength(const DeckNode& section, const std::string& key, Mistakes& mistakes) {
  const double value = section.real(key, 1.0);
  if (!(value > 0.0)) mistakes.add(section[key].place(), "Discretization/" + key + " must be greater than 0");
  return value;
}

bool isQuickGrid(const Deck& deck) { return deck["Discretization"].text("Type", "") == "PdQuickGrid"; }

/// Half edges of neighbourhoods that are boxes.
std::optional<std::array<double, 3>> neighborBox(const Deck& deck, const std::vector<double>& horizon) {
  return isQuickGrid(deck) ? quickGridNeighborBox(deck, horizon.front()) : std::nullopt;
}

/// The rule of distances, and a filter where neighbourhoods are boxes. `body`: what filters see.
NeighborRule neighborRule(const Deck& deck, const std::optional<std::array<double, 3>>& box, const MeshPoints& body,
                          const std::vector<double>& horizon, const std::vector<double>& spacing,
                          BondFilters& filters) {
  // Peridigm's grids leave out what is at the horizon, its searches take it in.
  if (!box && deck.isPeridigmDeck() && spacing.empty()) return NeighborRule::exact(horizon, !isQuickGrid(deck));
  if (!box) return NeighborRule::make(horizon, spacing);
  filters.keepWithin(*box, body);
  const double diagonal = std::hypot((*box)[0], (*box)[1], (*box)[2]);
  return NeighborRule::make(std::vector<double>(horizon.size(), diagonal), {});
}

/// The points in the space where the horizon is a ball or a cube.
MeshPoints mappedPoints(const MeshPoints& points, const kernels::HorizonShape& shape) {
  MeshPoints mapped = points;
  for (int i = 0; i < points.size(); ++i) {
    const std::array<double, 3> x = shape.mapped(shape.along(points.at(i)));
    std::copy(x.begin(), x.end(), mapped.x.begin() + 3 * i);
    mapped.volume[static_cast<std::size_t>(i)] *= shape.volumeFactor();
  }
  return mapped;
}

/// x [3 points] of what this rank owns; of all where it is alone, or owns nothing. Lines of the longest side of a part
/// end at few borders to other parts.
std::vector<double> placesOfRank(const MeshPoints& body, const std::vector<int>& owner, const Communicator& comm) {
  std::vector<double> x;
  for (std::size_t i = 0; i < owner.size() && comm.size() > 1; ++i)
    if (owner[i] == comm.rank()) x.insert(x.end(), &body.x[3 * i], &body.x[3 * i] + 3);
  return x.empty() ? body.x : x;
}

/// Local ids of the points of each node set.
NodeSets localNodeSets(const NodeSets& nodeSets, const Discretization& d) {
  std::vector<int> localId(static_cast<std::size_t>(d.nGlobal), -1);
  for (int i = 0; i < d.firstImage(); ++i) localId[d.globalIds[i]] = i;
  NodeSets result;
  for (const auto& [name, ids] : nodeSets) {
    std::vector<int>& local = result[name];
    for (const int id : ids)
      if (localId[id] >= 0) local.push_back(localId[id]);
    std::sort(local.begin(), local.end());
  }
  return result;
}

/// Takes over the values of this rank's points. `horizon`: of those of the mesh.
void fillPoints(const MeshPoints& body, const std::vector<double>& horizon, Discretization& d) {
  for (const int id : d.globalIds) {
    d.x.insert(d.x.end(), body.at(id), body.at(id) + 3);
    d.volume.push_back(body.volume[id]);
    d.horizon.push_back(horizon[static_cast<std::size_t>(id) % horizon.size()]);
    d.blockId.push_back(body.blockId[id]);
  }
}

/// What is wrong with the neighbourhoods of this rank, a line each: points that have no bond.
std::string lonelyPoints(const MeshPoints& points, const BondFilters& filters, const Discretization& d) {
  std::string lines;
  const char* remedy = !filters.empty() ? "choose a larger Horizon, or set `Count In Damage: true` on the bond filter "
                                          "that takes its bonds away"
                       : d.isDecomposed
                           ? "choose a larger Horizon (3 to 6 spacings), remove the point, or, where Cracks or "
                             "Voids cut all of its bonds, move them off it, or set `Rule: Adaptive`, by which "
                             "parts of bonds are left"
                           : "choose a larger Horizon (3 to 6 spacings) or remove the point";
  int count = 0;
  for (int i = 0; i < d.nOwned; ++i) {
    if (d.neighborhoodList[d.neighborhoodStart[i]] != 0 || ++count > maximumListedPoints) continue;
    lines +=
        fmt::format("{}: the point ({:g}, {:g}, {:g}) has no neighbours within its horizon of {:g} m; {}\n",
                    points.place(d.globalIds[i]), d.x[3 * i], d.x[3 * i + 1], d.x[3 * i + 2], d.horizon[i], remedy);
  }
  if (count > maximumListedPoints)
    lines += fmt::format("{}: {} more points without neighbours\n", points.fileName, count - maximumListedPoints);
  return lines;
}

/// Pairs of points that are nearly at the same place, a line each.
std::string coincidingPoints(const MeshPoints& body, const Discretization& d) {
  std::string lines;
  int count = 0;
  for (int i = 0; i < d.nOwned && count < maximumListedPoints; ++i) {
    const int* entry = &d.neighborhoodList[d.neighborhoodStart[i]];
    for (int k = 1; k <= *entry; ++k) {
      const int j = entry[k];
      const double length =
          std::hypot(d.x[3 * i] - d.x[3 * j], d.x[3 * i + 1] - d.x[3 * j + 1], d.x[3 * i + 2] - d.x[3 * j + 2]);
      if (length > closest * d.horizon[i] || d.globalIds[i] > d.globalIds[j]) continue;
      ++count;
      lines += fmt::format("{}: the point of {} is only {:g} m away; remove one of them\n", body.place(d.globalIds[i]),
                           body.row(d.globalIds[j]), length);
    }
  }
  return lines;
}

void addLines(const std::string& lines, Mistakes& mistakes) {
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = lines.find('\n', begin);
    mistakes.add("", lines.substr(begin, end - begin));
    begin = end + 1;
  }
}

/// Mistakes that show only in the neighbourhoods. The same on all ranks.
void checkNeighborhoods(const MeshPoints& body, const BondFilters& filters, const Communicator& comm,
                        const Discretization& d, const Deck& deck) {
  const std::string lonely = lonelyPoints(body, filters, d);
  if (deck.isPeridigmDeck()) addLines(comm.gather(lonely), deck.warnings());  // as there
  std::string lines = deck.isPeridigmDeck() ? "" : lonely;
  const bool hasPoints = !d.horizon.empty();
  if (hasPoints && d.shortestBond <= closest * *std::max_element(d.horizon.begin(), d.horizon.end()))
    lines += coincidingPoints(body, d);
  if (d.neighborhoodList.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    lines +=
        fmt::format("{}: rank {} has {} bonds, more than the 2.1e9 that fit; use more ranks or a smaller Horizon\n",
                    body.fileName, comm.rank(), d.nBonds());
  addLines(comm.gather(lines), deck.mistakes());
  deck.mistakes().report();
}

}  // namespace

Discretization readDiscretization(const Deck& deck, const Communicator& comm) {
  Mistakes& mistakes = deck.mistakes();
  MeshPoints points;
  withMemoryFor(comm, "the points of the mesh", [&] { points = readMesh(deck, comm); });
  const DeckNode section = deck["Discretization"];
  NodeSets nodeSets = allNodeSets(deck, comm, points);

  Discretization d;
  d.nGlobal = points.nRows;
  d.blockNumbers = blockNumbersOf(points);
  d.blockNames = points.blockNames;
  d.dimension = meshDimension(boundingBox(points));
  const std::map<int, DeckNode> entries = entriesOfBlocks(deck, d.blockNumbers, points);
  std::vector<double> horizon = pointHorizons(points, entries, mistakes);
  std::vector<SymmetryPlane> planes = readSymmetryPlanes(deck, mistakes);
  checkHalfSection(deck, points, d.dimension, horizon, planes, mistakes);
  d.symmetry = symmetryOf(planes, points, d.dimension, mistakes);
  const MeshPoints copies = d.symmetry.empty() ? MeshPoints() : wholeBody(points, d.symmetry);
  const MeshPoints& body = d.symmetry.empty() ? points : copies;
  const double thickness = positiveLength(section, "Thickness", mistakes);
  const double area = positiveLength(section, "Cross Section Area", mistakes);
  UnresolvedGeometry geometry(deck, comm, d.dimension);
  std::vector<double> cellEdges;
  if (!geometry.empty() && mistakes.empty()) {
    cellEdges = pointSpacings(points.volume, d.dimension, thickness, area);
    geometry.leaveOutPoints(points, nodeSets, cellEdges, *std::max_element(horizon.begin(), horizon.end()));
    horizon = pointHorizons(points, entries, mistakes);
    d.nGlobal = points.nRows;
  }
  BondFilters filters(deck, comm, body, nodeSets);
  if (mistakes.empty()) checkDimensions(deck, entries, d.dimension, points.fileName);
  mistakes.report();
  const kernels::HorizonShape shape = horizonShape(deck, entries);
  const auto box = neighborBox(deck, horizon);
  checkHorizon(planes, shape, box.has_value(), mistakes);
  if (!geometry.empty() && !shape.isBall())
    mistakes.add(section.keyPlace(),
                 "Cracks and Voids need cells that are squares or cubes: they do not go with Horizon "
                 "Axes of a material");
  mistakes.report();
  const MeshPoints mapped = shape.isBall() ? MeshPoints() : mappedPoints(body, shape);
  const MeshPoints& searched = shape.isBall() ? body : mapped;

  const std::vector<double> spacing = pointSpacings(searched.volume, d.dimension, thickness, area);
  const bool includesPartial = section.flag("Include Partial Neighbors", !deck.isPeridigmDeck());
  const std::vector<double> ruleSpacing = includesPartial ? spacing : std::vector<double>();
  NeighborRule rule = neighborRule(deck, box, body, wholeBody(horizon, d.symmetry), ruleSpacing, filters);
  rule.isBox = shape.isBox();
  checkBesidePlanes(deck, planes, points, searched, spacing, rule);
  mistakes.report();
  checkResolution(deck, searched, ruleSpacing, d.dimension, rule, comm.size(), d.symmetry.nCopies());
  mistakes.report();

  const double meanSpacing = std::accumulate(spacing.begin(), spacing.end(), 0.0) / static_cast<double>(body.size());
  withMemoryFor(comm, fmt::format("the neighbourhoods of the {} points of the mesh", points.size()), [&] {
    const std::vector<int> owner = partitionPoints(searched.x, points.size(), comm.mpi());
    buildNeighborhoods(searched, rule, filters, lineOrder(searched.x, meanSpacing, placesOfRank(body, owner, comm)),
                       owner, comm.rank(), d);
  });
  filters.warnOfIdle(comm, deck.warnings());
  fillPoints(body, horizon, d);
  makeRings(deck, d.x, d.volume);
  if (!geometry.empty()) geometry.decompose(points, cellEdges, comm, d);
  d.nodeSets = localNodeSets(nodeSets, d);
  d.shortestBond = comm.min(d.shortestBond);
  checkNeighborhoods(body, filters, comm, d, deck);
  return d;
}

}  // namespace pd
