#include "unresolved_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>

#include "../deck/sections.hpp"
#include "long_work.hpp"
#include "mesh_geometry.hpp"
#include "text_file.hpp"

namespace pd {

using decomposition::Cell;
using decomposition::InteractionShares;
using decomposition::NearDiscontinuities;

namespace {

/// Keeps the entries of `values`, `width` each, whose points are kept.
template <class Value>
void keep(const std::vector<char>& isKept, std::size_t width, std::vector<Value>& values) {
  std::size_t out = 0;
  for (std::size_t i = 0; i < isKept.size(); ++i)
    for (std::size_t d = 0; isKept[i] != 0 && d < width; ++d) values[out++] = values[width * i + d];
  values.resize(out);
}

void keepPoints(const std::vector<char>& isKept, MeshPoints& points, NodeSets& nodeSets) {
  std::vector<int> newId(isKept.size(), -1);
  int n = 0;
  for (std::size_t i = 0; i < isKept.size(); ++i)
    if (isKept[i] != 0) newId[i] = n++;
  keep(isKept, 3, points.x);
  keep(isKept, 1, points.volume);
  keep(isKept, 1, points.blockId);
  keep(isKept, 1, points.line);
  points.nRows = n;
  for (NodeSets* sets : {&points.nodeSets, &nodeSets})
    for (auto& [name, ids] : *sets) {
      for (int& id : ids) id = newId[static_cast<std::size_t>(id)];
      ids.erase(std::remove(ids.begin(), ids.end(), -1), ids.end());
    }
}

/// Sets of which Voids have left nothing. Those of the mesh may be there for something else than the deck's conditions.
void checkNodeSets(const Deck& deck, const NodeSets& nodeSets) {
  for (const auto& [name, ids] : nodeSets) {
    if (!ids.empty()) continue;
    if (const DeckNode node = deck["Boundary Conditions"][name])
      deck.mistakes().add(node.keyPlace(), "all points of node set \"" + name +
                                               "\" lie in Voids and are left out, so that nothing acts on it; move the "
                                               "void, or the set");
    else
      deck.warnings().add(deck["Discretization"]["Voids"].keyPlace(),
                          "all points of the mesh's node set \"" + name + "\" lie in Voids and are left out");
  }
}

}  // namespace

UnresolvedGeometry::UnresolvedGeometry(const Deck& deck, const Communicator& comm, int dimension)
    : deck_(deck), dimension_(dimension) {
  const DeckNode section = deck["Discretization"];
  read(section["Cracks"], true, comm);
  read(section["Voids"], false, comm);
  const DeckNode rule = section["Bond Decomposition"];
  if (rule) rule_ = decomposition::ruleFrom(rule.parameters(bondDecompositionDeclarations()));
  const decomposition::DecompositionRule defaults;  // which decks with all defaults written out have
  for (const auto& [key, of, usual] : {std::tuple("Tolerance", "Adaptive", defaults.tolerance),
                                       std::tuple("Partitions", "Uniform", static_cast<double>(defaults.partitions))})
    if (rule[key] && rule.text("Rule", "Adaptive") != of && rule[key].real() != usual)
      deck.mistakes().add(rule[key].keyPlace(),
                          rule[key].path() + " is of the rule " + of + "; remove it, or give \"Rule: " + of + "\"");
  countsCracks_ = rule.flag("Cracks Count In Damage", true);
  if (empty()) {
    if (rule && section["Cracks"].entries().empty() && section["Voids"].entries().empty())
      deck.mistakes().add(rule.keyPlace(),
                          "Bond Decomposition says how Cracks and Voids are brought to the bonds, but "
                          "Discretization has neither; add one, or remove this");
    return;
  }
  if (dimension == 1)
    deck.mistakes().add(entries_.front().node.keyPlace(),
                        "cracks and voids need a mesh that fills a plane or space, not a line");
  if (const DeckNode symmetry = section["Symmetry"])
    deck.mistakes().add(symmetry.keyPlace(),
                        "Cracks and Voids do not go with planes of symmetry; make the mesh of the whole body");
}

void UnresolvedGeometry::read(const DeckNode& list, bool areCracks, const Communicator& comm) {
  for (const auto& [name, node] : list.entries()) {
    try {
      std::vector<DiscontinuityForm> forms;
      if (areCracks)
        forms.push_back(readCrack(node, dimension_));
      else
        forms = readVoid(node, dimension_, [&](const DeckNode& file) { return readFile(file, comm); });
      for (DiscontinuityForm& form : forms) {
        entries_.push_back({node, form.place, areCracks, false, std::move(form.screens), std::move(form.voids)});
        for (const auto& screen : entries_.back().screens) entryOf_[screen.get()] = entries_.size() - 1;
      }
    } catch (const DeckError& error) {
      deck_.mistakes().add("", error.what());
    }
  }
}

GeometryFile UnresolvedGeometry::readFile(const DeckNode& fileName, const Communicator& comm) const {
  GeometryFile file{deck_.resolvePath(fileName.text()), ""};
  Mistakes mistakes;
  if (std::optional<std::string> text = readTextFile(file.name, fileName.place(), comm, mistakes)) file.text = *text;
  mistakes.report();
  return file;
}

std::array<int, 3> UnresolvedGeometry::binOf(const double* place) const {
  std::array<int, 3> bin{};
  for (std::size_t d = 0; d < 3; ++d)
    bin[d] = static_cast<int>(std::clamp((place[d] - origin_[d]) / binEdge_, -1.0, static_cast<double>(nBins_[d])));
  return bin;
}

void UnresolvedGeometry::sortIntoBins(const MeshPoints& points, double reach) {
  const BoundingBox box = boundingBox(points);
  binEdge_ = std::max(reach, 1e-3 * box.diagonal());
  for (std::size_t d = 0; d < 3; ++d) {
    origin_[d] = box.low[d];
    nBins_[d] = static_cast<int>((box.high[d] - box.low[d]) / binEdge_) + 1;
  }
  const auto forEachBin = [&](decomposition::Box around, const auto& visit) {
    for (std::size_t d = 0; d < 3; ++d) {
      around.low[d] -= reach;
      around.high[d] += reach;
      if (around.high[d] < box.low[d] || around.low[d] > box.high[d]) return;
    }
    std::array<int, 3> low = binOf(around.low.data()), high = binOf(around.high.data()), bin{};
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = std::max(low[d], 0);
      high[d] = std::min(high[d], nBins_[d] - 1);
    }
    for (bin[0] = low[0]; bin[0] <= high[0]; ++bin[0])
      for (bin[1] = low[1]; bin[1] <= high[1]; ++bin[1])
        for (bin[2] = low[2]; bin[2] <= high[2]; ++bin[2]) visit(bins_[bin]);
  };
  for (const Entry& entry : entries_) {
    for (const auto& screen : entry.screens)
      forEachBin(screen->box(), [&, box = screen->box()](NearDiscontinuities& bin) {
        bin.screens.push_back(screen.get());
        bin.screenBoxes.push_back(box);
      });
    for (const auto& v : entry.voids)
      forEachBin(v->box(), [&](NearDiscontinuities& bin) { bin.voids.push_back(v.get()); });
  }
}

const NearDiscontinuities& UnresolvedGeometry::near(const double* place) const {
  static const NearDiscontinuities none;
  const auto bin = bins_.find(binOf(place));
  return bin == bins_.end() ? none : bin->second;
}

Cell UnresolvedGeometry::cellOf(const double* place, double spacing) const {
  Cell cell{{place[0], place[1], dimension_ == 2 ? 0.0 : place[2]}, {}, dimension_};
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k) cell.edges[k][k] = spacing;
  return cell;
}

void UnresolvedGeometry::requireSizes(double spacing) const {
  std::string ofVoids;
  std::size_t nSmall = 0;
  for (const Entry& entry : entries_) {
    const std::string path = entry.node.path() + " ";
    for (const auto& screen : entry.screens)
      if (const std::string complaint = decomposition::complaintOfCrack(screen->box(), dimension_, spacing);
          entry.isCrack && !complaint.empty())
        throw DeckError(entry.node.keyPlace() + ": " + path + complaint);
    for (const auto& v : entry.voids) {
      const std::string complaint = decomposition::complaintOfVoid(*v, spacing);
      if (complaint.empty()) continue;
      if (++nSmall == 1)
        ofVoids = (entry.inFile.empty() ? entry.node.keyPlace() : entry.inFile) + ": " + path + complaint;
      break;
    }
  }
  if (nSmall > 1) ofVoids += fmt::format(" (and of {} more)", nSmall - 1);
  if (nSmall > 0) throw DeckError(ofVoids);
}

void UnresolvedGeometry::leaveOutPoints(MeshPoints& points, NodeSets& nodeSets, std::vector<double>& spacing,
                                        double horizon) {
  const double widest = *std::max_element(spacing.begin(), spacing.end());
  requireSizes(*std::min_element(spacing.begin(), spacing.end()));
  sortIntoBins(points, horizon + 2.0 * widest);
  std::vector<char> isKept(spacing.size(), 1);
  solid_.assign(spacing.size(), 1.0);
  for (int i = 0; i < points.size(); ++i) {
    const Cell cell = cellOf(points.at(i), spacing[i]);
    const NearDiscontinuities within = nearBox(near(points.at(i)), boxAround(cell, cell));
    solid_[i] = solidShare(cell, within.voids, rule_);
    isKept[i] = solid_[i] > decomposition::leastSolid ? 1 : 0;
    if (solid_[i] == 1.0) continue;
    for (Entry& entry : entries_)
      for (const auto& v : entry.voids)
        if (std::find(within.voids.begin(), within.voids.end(), v.get()) != within.voids.end()) markAsMet(entry);
  }
  const auto nLeft = static_cast<int>(std::count(isKept.begin(), isKept.end(), 1));
  if (nLeft == points.size()) return;
  if (nLeft == 0)
    throw DeckError(
        deck_["Discretization"]["Voids"].keyPlace() +
        ": Voids leave nothing of the body; of a Surface see its Scale, by which its lengths become metres");
  deck_.warnings().add(deck_["Discretization"]["Voids"].keyPlace(),
                       fmt::format("{} of the {} points of {} lie in Voids and are left out; the others are numbered "
                                   "without them",
                                   points.size() - nLeft, points.size(), points.fileName));
  const std::set<int> blocks(points.blockId.begin(), points.blockId.end());
  keepPoints(isKept, points, nodeSets);
  checkNodeSets(deck_, nodeSets);
  for (const int block : blocks)
    if (std::find(points.blockId.begin(), points.blockId.end(), block) == points.blockId.end())
      deck_.mistakes().add(deck_["Discretization"]["Voids"].keyPlace(),
                           "Voids leave nothing of block_" + std::to_string(block) +
                               "; take its points out of the mesh, and its entry out of Blocks");
  keep(isKept, 1, spacing);
  keep(isKept, 1, solid_);
}

void UnresolvedGeometry::markAsMet(Entry& entry) {
  if (!entry.isMet) ++nMet_;
  entry.isMet = true;
}

void UnresolvedGeometry::markMet(const NearDiscontinuities& near, const Cell& a, const Cell& b) {
  for (const decomposition::Screen* screen : near.screens) {
    Entry& entry = entries_[entryOf_.at(screen)];
    if (!entry.isMet && screen->box().meets(boxAround(a, b)) && screen->isBetween(a, b)) markAsMet(entry);
  }
}

NearDiscontinuities UnresolvedGeometry::withoutCracks(const NearDiscontinuities& near) const {
  NearDiscontinuities rest = near;
  const auto isCrack = [&](const auto* screen) { return entries_[entryOf_.at(screen)].isCrack; };
  rest.screenBoxes.clear();
  rest.screens.erase(std::remove_if(rest.screens.begin(), rest.screens.end(), isCrack), rest.screens.end());
  return rest;
}

UnresolvedGeometry::Shares UnresolvedGeometry::sharesOf(const MeshPoints& points, const std::vector<double>& spacing,
                                                        const Discretization& d) {
  constexpr double unknown = -1.0;
  const auto nBonds = static_cast<std::size_t>(d.nBonds());
  const bool countsCracks =
      countsCracks_ && std::any_of(entries_.begin(), entries_.end(), [](const Entry& entry) { return entry.isCrack; });
  Shares found;
  found.left.assign(nBonds, unknown);
  if (countsCracks) found.counted.assign(nBonds, unknown);
  InteractionShares shares(rule_), sharesWithoutCracks(rule_);
  int nNearPoints = 0;
  const auto firstBond = [&](int point) { return static_cast<std::size_t>(d.neighborhoodStart[point] - point); };
  for (int i = 0; i < d.nOwned; ++i) {
    const int* neighbors = &d.neighborhoodList[d.neighborhoodStart[i]] + 1;
    const int n = neighbors[-1], id = d.globalIds[i];
    const NearDiscontinuities& around = near(points.at(id));
    if (!around.empty() && ++nNearPoints % 16 == 0)
      LongWork::tell(fmt::format("shares of bonds beside cracks and voids: {} of {} points", i, d.nOwned));
    const NearDiscontinuities rest = countsCracks ? withoutCracks(around) : NearDiscontinuities();
    const bool hasCracks = rest.screens.size() < around.screens.size();
    for (int k = 0; k < n; ++k) {
      const std::size_t bond = firstBond(i) + static_cast<std::size_t>(k);
      if (found.left[bond] != unknown) continue;  // its other end has been here
      const int j = neighbors[k], other = d.globalIds[j];
      double left = 1.0, counted = 1.0;
      const long long nNearBefore = shares.nNear();
      if (!around.empty()) {
        const int first = std::min(id, other), second = std::max(id, other);  // the same from both ends
        const Cell a = cellOf(points.at(first), spacing[first]), b = cellOf(points.at(second), spacing[second]);
        left = counted = shares.of({first, a}, {second, b}, around);
        if (left < 1.0 && nMet_ < entries_.size()) markMet(around, a, b);
        if (left < 1.0 && countsCracks && hasCracks) counted = sharesWithoutCracks.of({first, a}, {second, b}, rest);
      }
      const auto set = [&](std::size_t at) {
        found.left[at] = left;
        if (countsCracks) found.counted[at] = counted;
        found.nNear += shares.nNear() - nNearBefore;
      };
      set(bond);
      if (j < i || j >= d.nOwned) continue;
      const int* ofOther = &d.neighborhoodList[d.neighborhoodStart[j]] + 1;
      const int* back = std::lower_bound(ofOther, ofOther + ofOther[-1], i);
      if (back != ofOther + ofOther[-1] && *back == i) set(firstBond(j) + static_cast<std::size_t>(back - ofOther));
    }
  }
  found.nPairs = shares.nNear();
  found.nLines = shares.nLines();
  return found;
}

void UnresolvedGeometry::decompose(const MeshPoints& points, const std::vector<double>& spacing,
                                   const Communicator& comm, Discretization& d) {
  d.isDecomposed = true;
  const std::clock_t start = std::clock();
  Shares found = sharesOf(points, spacing, d);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const long long nBonds = d.nBonds();
  const std::vector<double>& counted = found.counted.empty() ? found.left : found.counted;
  std::size_t out = 0, bond = 0, outBond = 0;
  for (int i = 0; i < d.nOwned; ++i) {
    const int* entry = &d.neighborhoodList[d.neighborhoodStart[i]];
    const int n = *entry;
    const std::size_t head = out++;
    d.countedBonds.push_back(std::accumulate(&counted[bond], &counted[bond] + n, 0.0));
    for (int k = 0; k < n; ++k, ++bond) {
      if (found.left[bond] == 0.0) continue;
      d.neighborhoodList[out++] = entry[k + 1];
      if (!d.bondIsCut.empty()) d.bondIsCut[outBond] = d.bondIsCut[bond];
      found.left[outBond++] = found.left[bond];
    }
    d.neighborhoodList[head] = static_cast<int>(out - head - 1);
    d.neighborhoodStart[i] = static_cast<long long>(head);
  }
  d.neighborhoodList.resize(out);
  d.neighborhoodStart.back() = static_cast<long long>(out);
  if (!d.bondIsCut.empty()) d.bondIsCut.resize(outBond);
  found.left.resize(outBond);
  const auto nShared = std::count_if(found.left.begin(), found.left.end(), [](double left) { return left < 1.0; });
  d.decompositionNote = fmt::format(
      "cracks and voids: {} of {} directed bonds pass near them; {} keep a part, {} are cut off; {} pairs of "
      "points by {} lines in {:.3g} s of processor time",
      comm.sum(found.nNear), comm.sum(nBonds), comm.sum(static_cast<long long>(nShared)),
      comm.sum(nBonds - static_cast<long long>(outBond)), comm.sum(found.nPairs), comm.sum(found.nLines),
      comm.sum(seconds));
  d.interactionShare = std::move(found.left);
  d.cellVolume = d.volume;
  for (int i = 0; i < d.nPoints; ++i) d.volume[i] *= solid_[d.globalIds[i]];
  checkMet(points, comm);
}

void UnresolvedGeometry::checkMet(const MeshPoints& points, const Communicator& comm) {
  const std::string body = boundingBox(points).text() + " m";
  for (std::size_t first = 0, end = 0; first < entries_.size(); first = end) {
    std::size_t nMissed = 0;
    std::string firstMissed;
    for (end = first; end < entries_.size() && entries_[end].node.path() == entries_[first].node.path(); ++end) {
      if (comm.any(entries_[end].isMet)) continue;
      if (++nMissed == 1) firstMissed = entries_[end].inFile;
    }
    const std::string path = entries_[first].node.path(), place = entries_[first].node.keyPlace();
    if (nMissed == end - first)
      deck_.mistakes().add(place, path + " meets no cell and no bond of the body, whose points fill " + body +
                                      "; move it, or remove it");
    else if (nMissed > 0)
      deck_.warnings().add(place,
                           fmt::format("{}: {} of its {} forms meet no cell and no bond of the body, whose points "
                                       "fill {}; the first is that of {}",
                                       path, nMissed, end - first, body, firstMissed));
  }
}

}  // namespace pd
