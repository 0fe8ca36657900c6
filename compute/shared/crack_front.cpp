#include "crack_front.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

#include "connected_points.hpp"
#include "crack_path.hpp"

namespace pd {

namespace {

constexpr double sameColumn = 1e-6;  ///< of the spacing: nearer to each other, two points are equally far ahead

}  // namespace

/// A damaged point of the whole body.
struct CrackFront::Candidate {
  ConnectedPoint point;  ///< with its damaged neighbours
  Vector3 place;         ///< m
  double damage;
  double ahead;  ///< along the direction, m
  double front;  ///< the same where damage falls through the threshold towards the next point ahead, m
  double shortestBond, longestBond;  ///< m
};

/// A damaged point of the part that the mesh holds, as its block sees it.
struct CrackFront::Surroundings {
  std::function<int(int id)> globalId;
  const double *x, *damage;
  int id;
  const int* neighbors;
  int nNeighbors;
  int nGlobal;  ///< points of the mesh
};

void CrackFront::declareParameters(ParameterDeclarations& declarations) {
  declarations.text("Variable", "Scalar point field of the damage.").defaultTo("Damage");
  declarations.real("Threshold", "1", "Damage from which a point counts as cracked.").positive().defaultTo(0.36);
  declareVector(declarations, "Direction", "1", "Direction in which the crack grows (default: x; any length).");
  declareVector(declarations, "Start", "m",
                "Mouth of the crack; what is not given is 0. Where it is given, only damage counts that hangs together "
                "with the line from there along the direction.");
  declarations.flag("Interpolate", "Place the tip between points, where damage falls through the threshold.")
      .defaultTo(true);
  declarations
      .text("Path",
            "Straight: the tip is the foremost place along the direction. Curved: it is the end of the longest way "
            "from the start through damaged points, from each to a neighbour; in plane bodies.")
      .oneOf({"Straight", "Curved"})
      .defaultTo("Straight");
  PointSelection::declareParameters(declarations);
}

CrackFront::CrackFront(const Teuchos::ParameterList& parameters, const ComputeParameters& globalData)
    : points_(parameters, globalData),
      fields_(parameters),
      threshold_(parameters.get<double>("Threshold")),
      direction_(directionOf(parameters, "Direction")),
      start_(vectorOf(parameters, "Start")),
      isInterpolated_(parameters.get<bool>("Interpolate")),
      isCurved_(parameters.get<std::string>("Path") == "Curved"),
      whole_(WholeBody::of(globalData)) {
  const char* keys[] = {"Start X", "Start Y", "Start Z"};
  for (std::size_t k = 0; k < 3; ++k) isStartGiven_[k] = parameters.isParameter(keys[k]);
  if (fields_.damage.width() != 1) throw std::invalid_argument("\"Variable\" of a crack must be a scalar field");
  if (isCurved_ && !(isStartGiven_[0] && isStartGiven_[1]))
    throw std::invalid_argument(
        "a crack with \"Path\" Curved needs \"Start X\" and \"Start Y\", from which it is followed");
}

void CrackFront::initialize(const Blocks& blocks) {
  points_.initialize(blocks);
  fields_.damage.initialize(blocks);
  families_ = Families::of(*blocks);
}

/// In a copy of the body. The next point ahead is the nearest neighbour within 45 degrees of the direction.
CrackFront::Candidate CrackFront::candidate(const Surroundings& around, int copy,
                                            const Vector3& directionOfCopy) const {
  const auto globalIdOf = [&](int id) { return WholeBody::idInCopy(copy, around.globalId(id), around.nGlobal); };
  const double* own = around.x + 3 * around.id;
  const Vector3 place = whole_->place(copy, own);
  // In the part, of what points along the direction in the copy.
  const std::array<double, 9> m = whole_->reflection(copy);
  const Vector3 direction{dot(directionOfCopy, &m[0]), dot(directionOfCopy, &m[3]), dot(directionOfCopy, &m[6])};
  constexpr double farAway = std::numeric_limits<double>::max();
  Candidate result{{globalIdOf(around.id), {}},
                   place,
                   around.damage[around.id],
                   dot(directionOfCopy, place.data()),
                   0.0,
                   farAway,
                   0.0};
  double nearest = farAway, step = 0.0, damageAhead = 0.0;
  for (int k = 0; k < around.nNeighbors; ++k) {
    const int j = around.neighbors[k];
    const double damage = around.damage[j], *other = around.x + 3 * j;
    if (damage >= threshold_) result.point.neighbors.push_back(globalIdOf(j));
    const double bond[3] = {other[0] - own[0], other[1] - own[1], other[2] - own[2]};
    const double length = std::sqrt(bond[0] * bond[0] + bond[1] * bond[1] + bond[2] * bond[2]);
    result.shortestBond = std::min(result.shortestBond, length);
    result.longestBond = std::max(result.longestBond, length);
    const double ahead = dot(direction, bond);
    if (ahead < std::sqrt(0.5) * length) continue;
    const bool isAsNear = std::abs(length - nearest) <= 1e-6 * length;
    if (isAsNear ? damage > damageAhead : length < nearest) {
      nearest = length;
      step = ahead;
      damageAhead = damage;
    }
  }
  if (around.nNeighbors == 0) result.shortestBond = 0.0;
  const double here = result.damage;
  const double share = damageAhead >= threshold_ ? 1.0 : (here - threshold_) / (here - damageAhead);
  result.front = result.ahead + (isInterpolated_ ? step * share : 0.0);
  return result;
}

template <class IsWanted>
std::vector<CrackFront::Candidate> CrackFront::candidates(const Blocks& blocks, const Epetra_Comm& comm,
                                                          const Vector3& direction, const IsWanted& isWanted) const {
  int nOwned = 0;
  for (PeridigmNS::Block& block : *blocks) nOwned += block.getNeighborhoodData()->NumOwnedPoints();
  const int nGlobal = static_cast<int>(sumOverRanks(comm, static_cast<double>(nOwned)));
  std::vector<Candidate> result;
  for (std::size_t b = 0; b < blocks->size(); ++b) {
    PeridigmNS::Block& block = (*blocks)[b];
    const auto map = block.getOverlapScalarPointMap();
    const auto globalId = [&](int id) { return map->GID(id); };
    const double* x = view(block, fields_.modelCoordinates);
    const double* damage = fields_.damage.values(block);
    const Families& families = families_[b];
    for (std::size_t p = 0; p < families.size(); ++p) {
      if (!(damage[families.id(p)] >= threshold_) || !points_.includes(b, static_cast<int>(p))) continue;
      const Family family = families[p];
      for (int copy = 0; copy < whole_->nCopies(); ++copy)
        if (isWanted(WholeBody::idInCopy(copy, globalId(family.id), nGlobal)))
          result.push_back(
              candidate({globalId, x, damage, family.id, family.neighbors, family.n, nGlobal}, copy, direction));
    }
  }
  return result;
}

std::vector<CrackFront::Candidate> CrackFront::candidates(const Blocks& blocks, const Epetra_Comm& comm) const {
  return candidates(blocks, comm, direction_, [](int) { return true; });
}

bool CrackFront::isOnItsLine(const Candidate& candidate) const {
  const double advance = std::max(0.0, candidate.ahead - dot(direction_, start_.data()));
  double squared = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double distance = candidate.place[k] - start_[k] - advance * direction_[k];
    if (isStartGiven_[k]) squared += distance * distance;
  }
  return squared <= candidate.longestBond * candidate.longestBond * (1.0 + 1e-10);
}

std::vector<CrackFront::Candidate> CrackFront::crack(const Blocks& blocks, const Epetra_Comm& comm) const {
  std::vector<Candidate> damaged = candidates(blocks, comm);
  std::vector<ConnectedPoint> points;
  std::vector<char> isOfCrack;
  for (const Candidate& candidate : damaged) {
    points.push_back(candidate.point);
    isOfCrack.push_back(isOnItsLine(candidate) ? 1 : 0);
  }
  spread(points, isOfCrack, comm);
  std::size_t n = 0;
  for (std::size_t k = 0; k < damaged.size(); ++k)
    if (isOfCrack[k] != 0) damaged[n++] = damaged[k];
  damaged.erase(damaged.begin() + static_cast<std::ptrdiff_t>(n), damaged.end());
  return damaged;
}

CrackFront::Tip CrackFront::locateAhead(const Blocks& blocks, const Epetra_Comm& comm) const {
  const std::vector<Candidate> cracked = crack(blocks, comm);
  constexpr double nowhere = std::numeric_limits<double>::lowest();
  double front = nowhere, foremost = nowhere;
  for (const Candidate& candidate : cracked) front = std::max(front, candidate.front);
  front = maxOverRanks(comm, front);
  const bool hasStart = isStartGiven_[0] || isStartGiven_[1] || isStartGiven_[2];
  if (front == nowhere || (hasStart && front <= dot(direction_, start_.data()))) return {start_, direction_, 0.0};

  // The point from which the tip is reached, and those equally far ahead.
  for (const Candidate& candidate : cracked)
    if (candidate.front >= front - sameColumn * candidate.shortestBond) foremost = std::max(foremost, candidate.ahead);
  foremost = maxOverRanks(comm, foremost);
  std::vector<double> sums(4, 0.0);  // positions, number of points
  for (const Candidate& candidate : cracked) {
    if (std::abs(candidate.ahead - foremost) > sameColumn * candidate.shortestBond) continue;
    for (std::size_t k = 0; k < 3; ++k) sums[k] += candidate.place[k];
    sums[3] += 1.0;
  }
  sums = sumOverRanks(comm, sums);
  Vector3 tip{sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3]};
  const double step = front - dot(direction_, tip.data());
  for (std::size_t k = 0; k < 3; ++k) tip[k] += step * direction_[k];
  return {tip, direction_, std::max(0.0, front - dot(direction_, start_.data()))};
}

/// In the coordinates that are given; negative for points that a path does not start at.
double CrackFront::fromStart(const Candidate& candidate) const {
  double squared = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    if (isStartGiven_[k]) squared += (candidate.place[k] - start_[k]) * (candidate.place[k] - start_[k]);
  const double distance = std::sqrt(squared);
  return distance <= candidate.longestBond * (1.0 + 1e-10) ? distance : -1.0;
}

CrackFront::Tip CrackFront::locateAlongPath(const Blocks& blocks, const Epetra_Comm& comm) const {
  std::vector<CrackPath::Point> points;
  double reach = 0.0;
  for (Candidate& candidate : candidates(blocks, comm)) {
    // The other way from the start the crack may be longer: a cut from a face, whose length counts from elsewhere.
    if (candidate.ahead < dot(direction_, start_.data()) - 1e-10 * candidate.longestBond) continue;
    points.push_back({std::move(candidate.point), candidate.place, candidate.damage, fromStart(candidate)});
    reach = std::max(reach, candidate.longestBond);
  }
  const CrackPath path(points, maxOverRanks(comm, reach), comm);
  if (path.length() <= 0.0) return {start_, direction_, 0.0};

  const Vector3 direction = path.directionAtEnd(direction_);
  std::vector<double> furthest(2, std::numeric_limits<double>::lowest());  // along the direction, along the path
  const auto isOfEnd = [&](int globalId) { return path.distance(globalId) >= path.length() - path.endLength(); };
  for (const Candidate& candidate : candidates(blocks, comm, direction, isOfEnd)) {
    const double distance = path.distance(candidate.point.globalId);
    furthest[0] = std::max(furthest[0], candidate.front);
    furthest[1] = std::max(furthest[1], distance + candidate.front - candidate.ahead);
  }
  furthest = maxOverRanks(comm, furthest);
  Vector3 tip = path.meanOfEnd();
  const double step = furthest[0] - dot(direction, tip.data());
  for (std::size_t k = 0; k < 3; ++k) tip[k] += step * direction[k];
  return {tip, direction, furthest[1]};
}

}  // namespace pd
