#include "connected_parts.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "Peridigm_Field.hpp"

namespace pd {

namespace {

/// Disjoint sets over 0 .. n-1; the smallest member stands for its set. Members are of copies of a body: the image of a
/// member in its copy belongs to the set of which the smallest member itself is one (Symmetry: copies mirrored about
/// one copy's planes after another's are those of the exclusive or of both).
class DisjointSets {
 public:
  struct Place {
    std::size_t set;
    int copy;
  };

  explicit DisjointSets(std::size_t n) : parent_(n), copy_(n, 0), mirrors_(n, 0) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  Place find(std::size_t i) {
    int copy = 0;
    while (parent_[i] != i) {
      copy_[i] ^= copy_[parent_[i]];
      parent_[i] = parent_[parent_[i]];
      copy ^= copy_[i];
      i = parent_[i];
    }
    return {i, copy};
  }
  /// Connects i with the image of j in `copy`.
  void unite(std::size_t i, std::size_t j, int copy) {
    const Place a = find(i), b = find(j);
    const int between = copy ^ a.copy ^ b.copy;
    if (a.set == b.set) {
      addMirror(a.set, between);
      return;
    }
    const auto [low, high] = std::minmax(a.set, b.set);
    parent_[high] = low;
    copy_[high] = between;
    mirrors_[low] |= mirrors_[high];
  }
  /// Connects the set of i with its image in `copy`.
  void addMirror(std::size_t i, int copy) {
    if (copy != 0) mirrors_[find(i).set] |= 1u << copy;
  }
  unsigned mirrors(std::size_t set) const { return mirrors_[set]; }

 private:
  std::vector<std::size_t> parent_;
  std::vector<int> copy_;          ///< of each member, seen from its parent
  std::vector<unsigned> mirrors_;  ///< by set: bit c where it is connected with its own image in copy c
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

/// Two parts, or twice the same: the first is connected with the second's image in `copy`.
struct Link {
  long long first, second, copy;
  bool operator<(const Link& o) const { return std::tie(first, second, copy) < std::tie(o.first, o.second, o.copy); }
};

/// The part that each rank's own points form among themselves, by its smallest global id, and the copy in which a point
/// belongs to it, as one number that ghosts get from their owners: a double holds it exactly.
constexpr long long mostCopies = 8;
double encoded(long long name, int copy) { return static_cast<double>(name * mostCopies + copy); }
long long nameOf(double code) { return static_cast<long long>(code) / mostCopies; }
int copyIn(double code) { return static_cast<int>(static_cast<long long>(code) % mostCopies); }

struct RankParts {
  std::vector<double> codeOfPoint;  ///< [points]
  std::set<Link> links;             ///< between parts of different ranks, and of parts with their own images
};

RankParts findRankParts(Model& model) {
  const auto nOwned = static_cast<std::size_t>(model.nOwned());
  const Discretization& points = model.discretization();
  DisjointSets sets(nOwned);
  std::vector<std::pair<int, int>> bondsToGhosts;
  forEachBond(model, [&](int i, int j, double damage) {
    if (damage >= 1.0) return;
    if (const auto source = static_cast<std::size_t>(points.sourceOf(j)); source < nOwned)
      sets.unite(static_cast<std::size_t>(i), source, points.copyOf(j));
    else
      bondsToGhosts.emplace_back(i, j);
  });
  std::vector<std::size_t> first(nOwned, nOwned);  // of each set, the point of smallest global id
  for (std::size_t i = 0; i < nOwned; ++i) {
    std::size_t& best = first[sets.find(i).set];
    if (best == nOwned || points.globalIds[i] < points.globalIds[best]) best = i;
  }
  RankParts parts;
  parts.codeOfPoint.resize(static_cast<std::size_t>(model.nPoints()));
  for (std::size_t i = 0; i < nOwned; ++i) {
    const DisjointSets::Place place = sets.find(i);
    const std::size_t named = first[place.set];
    const long long name = points.globalIds[named];
    parts.codeOfPoint[i] = encoded(name, place.copy ^ sets.find(named).copy);
    for (int copy = 1; copy < points.symmetry.nCopies() && place.set == i; ++copy)
      if ((sets.mirrors(i) >> copy & 1u) != 0) parts.links.insert({name, name, copy});
  }
  model.exchange().import(parts.codeOfPoint.data(), 1, Reflection::Even);
  for (const auto& [i, j] : bondsToGhosts) {
    const double own = parts.codeOfPoint[static_cast<std::size_t>(i)];
    const double other = parts.codeOfPoint[static_cast<std::size_t>(j)];
    parts.links.insert({nameOf(own), nameOf(other), points.copyOf(j) ^ copyIn(own) ^ copyIn(other)});
  }
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

ConnectedParts findConnectedParts(Model& model) {
  const Communicator& comm = model.comm();
  const auto nOwned = static_cast<std::ptrdiff_t>(model.nOwned());
  const RankParts rankParts = findRankParts(model);
  std::set<long long> mine;
  std::transform(rankParts.codeOfPoint.begin(), rankParts.codeOfPoint.begin() + nOwned, std::inserter(mine, mine.end()),
                 nameOf);
  // All ranks' parts and the links between them; every rank joins them alike.
  std::vector<long long> names = gatherAll(comm, std::vector<long long>(mine.begin(), mine.end()));
  std::sort(names.begin(), names.end());
  std::unordered_map<long long, std::size_t> indexOf;
  for (std::size_t k = 0; k < names.size(); ++k) indexOf.emplace(names[k], k);
  std::vector<long long> links;
  for (const Link& link : rankParts.links) links.insert(links.end(), {link.first, link.second, link.copy});
  links = gatherAll(comm, links);
  DisjointSets sets(names.size());
  for (std::size_t k = 0; k < links.size(); k += 3)
    sets.unite(indexOf.at(links[k]), indexOf.at(links[k + 1]), static_cast<int>(links[k + 2]));

  ConnectedParts parts;
  std::vector<int> partOfSet(names.size(), -1);
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (sets.find(k).set != k) continue;  // the smallest name stands for the set and comes first
    partOfSet[k] = static_cast<int>(parts.names.size());
    parts.names.push_back(names[k]);
    parts.mirrors.push_back(sets.mirrors(k));
  }
  parts.sizes.assign(parts.names.size(), 0);
  for (std::ptrdiff_t i = 0; i < nOwned; ++i) {
    const double code = rankParts.codeOfPoint[static_cast<std::size_t>(i)];
    const DisjointSets::Place place = sets.find(indexOf.at(nameOf(code)));
    parts.partOfPoint.push_back(partOfSet[place.set]);
    parts.copyOfPoint.push_back(place.copy ^ copyIn(code));
    ++parts.sizes[static_cast<std::size_t>(partOfSet[place.set])];
  }
  MPI_Allreduce(MPI_IN_PLACE, parts.sizes.data(), static_cast<int>(parts.sizes.size()), MPI_LONG_LONG, MPI_SUM,
                comm.mpi());
  return parts;
}

}  // namespace pd
