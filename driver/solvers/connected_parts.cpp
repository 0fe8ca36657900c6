#include "connected_parts.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <unordered_map>
#include <utility>

#include "Peridigm_Field.hpp"

namespace pd {

namespace {

/// Disjoint sets over 0 .. n-1; the smallest member stands for its set.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<std::size_t> parent_;
};

std::vector<long long> gatherAll(const Communicator& comm, const std::vector<long long>& mine) {
  const int count = static_cast<int>(mine.size());
  std::vector<int> counts(static_cast<std::size_t>(comm.size())), starts(counts.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, comm.mpi());
  for (std::size_t rank = 1; rank < counts.size(); ++rank) starts[rank] = starts[rank - 1] + counts[rank - 1];
  std::vector<long long> all(static_cast<std::size_t>(starts.back() + counts.back()));
  MPI_Allgatherv(mine.data(), count, MPI_LONG_LONG, all.data(), counts.data(), starts.data(), MPI_LONG_LONG,
                 comm.mpi());
  return all;
}

/// Names of the parts that each rank's own points form among themselves, and bonds between parts of different ranks.
struct RankParts {
  std::vector<double> nameOfPoint;  ///< [points] ghosts from their owners; a double holds an id exactly
  std::set<std::pair<long long, long long>> links;
};

RankParts findRankParts(Model& model, const GhostExchange& ghosts) {
  const auto nOwned = static_cast<std::size_t>(model.nOwned());
  const std::vector<int>& globalIds = model.discretization().globalIds;
  DisjointSets sets(nOwned);
  std::vector<std::pair<int, int>> bondsToGhosts;
  forEachBond(model, [&](int i, int j, double damage) {
    if (damage >= 1.0) return;
    if (static_cast<std::size_t>(j) < nOwned)
      sets.unite(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
    else
      bondsToGhosts.emplace_back(i, j);
  });
  std::vector<double> smallest(nOwned);
  for (std::size_t i = 0; i < nOwned; ++i) smallest[i] = globalIds[i];
  for (std::size_t i = 0; i < nOwned; ++i) smallest[sets.find(i)] = std::min(smallest[sets.find(i)], smallest[i]);
  RankParts parts;
  parts.nameOfPoint.resize(static_cast<std::size_t>(model.nPoints()));
  for (std::size_t i = 0; i < nOwned; ++i) parts.nameOfPoint[i] = smallest[sets.find(i)];
  ghosts.import(parts.nameOfPoint.data(), 1);
  for (const auto& [i, j] : bondsToGhosts)
    parts.links.emplace(static_cast<long long>(parts.nameOfPoint[static_cast<std::size_t>(i)]),
                        static_cast<long long>(parts.nameOfPoint[static_cast<std::size_t>(j)]));
  return parts;
}

}  // namespace

void forEachBond(Model& model, const std::function<void(int, int, double)>& visit) {
  using namespace PeridigmNS;
  auto& fields = FieldManager::self();
  const int id = fields.hasField("Bond_Damage") ? fields.getFieldId("Bond_Damage") : -1;
  for (Block& block : *model.blocks()) {
    const auto points = block.getNeighborhoodData();
    const double* damage = nullptr;
    double* view = nullptr;
    if (id >= 0 && block.hasData(id, PeridigmField::STEP_NP1)) {
      block.getData(id, PeridigmField::STEP_NP1)->ExtractView(&view);
      damage = view;
    }
    const int* list = points->NeighborhoodList();
    for (int p = 0; p < points->NumOwnedPoints(); ++p)
      for (int count = *list++; count > 0; --count) visit(points->OwnedIDs()[p], *list++, damage ? *damage++ : 0.0);
  }
}

ConnectedParts findConnectedParts(Model& model, const GhostExchange& ghosts) {
  const Communicator& comm = model.comm();
  const auto nOwned = static_cast<std::size_t>(model.nOwned());
  const RankParts rankParts = findRankParts(model, ghosts);
  const std::set<double> mine(rankParts.nameOfPoint.begin(),
                              rankParts.nameOfPoint.begin() + static_cast<std::ptrdiff_t>(nOwned));
  // All ranks' parts and the links between them; every rank joins them alike.
  std::vector<long long> names = gatherAll(comm, std::vector<long long>(mine.begin(), mine.end()));
  std::sort(names.begin(), names.end());
  std::unordered_map<long long, std::size_t> indexOf;
  for (std::size_t k = 0; k < names.size(); ++k) indexOf.emplace(names[k], k);
  std::vector<long long> links;
  for (const auto& [a, b] : rankParts.links) links.insert(links.end(), {a, b});
  links = gatherAll(comm, links);
  DisjointSets sets(names.size());
  for (std::size_t k = 0; k < links.size(); k += 2) sets.unite(indexOf.at(links[k]), indexOf.at(links[k + 1]));

  ConnectedParts parts;
  std::vector<int> partOfSet(names.size(), -1);
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (sets.find(k) != k) continue;  // the smallest name stands for the set and comes first
    partOfSet[k] = static_cast<int>(parts.names.size());
    parts.names.push_back(names[k]);
  }
  parts.sizes.assign(parts.names.size(), 0);
  for (std::size_t i = 0; i < nOwned; ++i) {
    const std::size_t set = sets.find(indexOf.at(static_cast<long long>(rankParts.nameOfPoint[i])));
    parts.partOfPoint.push_back(partOfSet[set]);
    ++parts.sizes[static_cast<std::size_t>(partOfSet[set])];
  }
  MPI_Allreduce(MPI_IN_PLACE, parts.sizes.data(), static_cast<int>(parts.sizes.size()), MPI_LONG_LONG, MPI_SUM,
                comm.mpi());
  return parts;
}

}  // namespace pd
