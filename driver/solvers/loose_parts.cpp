#include "loose_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "connected_parts.hpp"
#include "symmetric_eigen.hpp"

namespace pd {

namespace {

using Point = RigidMotions::Point;
using Mode = RigidMotions::Mode;

/// One connected part of two points or more, in which images count.
struct Part {
  RigidMotions motions;                                     ///< radius: root mean square distance from the centre
  Point first{};                                            ///< its point of smallest global id
  std::vector<double> held = std::vector<double>(36, 0.0);  ///< sum of the outer products of held degrees' motions
};

/// The motions that nothing holds yet: orthonormal.
std::vector<Mode> freeMotions(const Part& part, int nModes) {
  const auto n = static_cast<std::size_t>(nModes);
  std::vector<double> matrix;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) matrix.push_back(part.held[6 * i + j]);
  const SymmetricEigen eigen = symmetricEigen(matrix, nModes);
  std::vector<Mode> motions;
  // 1e-8: two supports nearer than 1e-4 of the part's size do not stop it from turning.
  for (std::size_t k = 0; k < n; ++k) {
    if (eigen.values[k] > 1e-8) continue;
    motions.emplace_back();
    std::copy_n(eigen.vectors.begin() + static_cast<std::ptrdiff_t>(k * n), n, motions.back().begin());
  }
  return motions;
}

/// Square of the part of `row` that the motions already held do not contain.
double freeShare(const Part& part, const Mode& row, int nModes) {
  double share = 0.0;
  for (const Mode& motion : freeMotions(part, nModes)) {
    const double product = std::inner_product(row.begin(), row.end(), motion.begin(), 0.0);
    share += product * product;
  }
  return share;
}

void hold(Part& part, const Mode& row) {
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) part.held[6 * i + j] += row[i] * row[j];
}

/// Everything about the parts of a body, and the search for the degrees of freedom to hold.
class Holder {
 public:
  Holder(Model& model, const ConnectedParts& connected, std::vector<char>& isHeld)
      : model_(model),
        mesh_(model.discretization()),
        connected_(connected),
        isHeld_(isHeld),
        nModes_(RigidMotions::count(mesh_.dimension)),
        partOfName_(connected.names.size(), -1) {
    for (std::size_t k = 0; k < connected.names.size(); ++k)
      if (!connected.isSingle(k)) {
        partOfName_[k] = static_cast<int>(parts_.size());
        parts_.emplace_back();
        parts_.back().motions.dimension = mesh_.dimension;
        nameOfPart_.push_back(k);
      }
    measure();
    addPrescribed();
    for (std::size_t k = 0; k < parts_.size(); ++k) addMirrors(parts_[k], connected.mirrors[nameOfPart_[k]]);
  }

  void holdLooseParts(HeldInPlace& result) {
    std::vector<std::size_t> loose;
    std::vector<int> looseOfPart(parts_.size(), HeldInPlace::isSupported);
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const std::vector<Mode> motions = freeMotions(parts_[k], nModes_);
      if (motions.empty()) continue;
      looseOfPart[k] = static_cast<int>(loose.size());
      loose.push_back(k);
      result.parts.push_back({parts_[k].motions, connected_.sizes[nameOfPart_[k]], motions});
    }
    for (int point = 0; point < mesh_.nOwned; ++point) {
      const int k = partOf(point);
      result.partOfPoint.push_back(k < 0 ? HeldInPlace::isAlone : looseOfPart[static_cast<std::size_t>(k)]);
      result.copyOfPoint.push_back(copyOf(point));
    }
    if (loose.empty()) return;

    // Three points span the part: its first one, the farthest from it, and the farthest from the line of these two.
    std::vector<std::vector<Candidate>> corners = {firstPoints()};
    corners.push_back(farthest([&](std::size_t k, const Point& x) { return distance(x, parts_[k].first); }));
    if (mesh_.dimension == 3)
      corners.push_back(farthest(
          [&](std::size_t k, const Point& x) { return distanceFromLine(x, parts_[k].first, corners[1][k].place); }));
    for (const std::size_t k : loose)
      for (const double share : {0.3, 0.03, 1e-3, 1e-6})  // first the degrees of freedom that hold a free motion well
        for (const std::vector<Candidate>& corner : corners) holdAt(parts_[k], corner[k], share);
  }

 private:
  struct Candidate {
    double measure = -1.0;
    long long globalId = -1;
    int copy = 0;  ///< in which the point belongs to the part
    Point place{};
  };

  int copyOf(int point) const { return connected_.copyOfPoint[static_cast<std::size_t>(point)]; }
  /// Where the point belongs to its part, if `further` is 0; else an image of the point there.
  Point place(int point, int further = 0) const {
    return mesh_.symmetry.place(copyOf(point) ^ further, &mesh_.x[static_cast<std::size_t>(3 * point)]);
  }
  static double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }
  static double distanceFromLine(const Point& x, const Point& a, const Point& b) {
    const Point u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v = {x[0] - a[0], x[1] - a[1], x[2] - a[2]};
    const double length = distance(a, b);  // 0 of a point with its image alone
    if (length == 0.0) return distance(x, a);
    return std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / length;
  }
  int partOf(int point) const {
    return partOfName_[static_cast<std::size_t>(connected_.partOfPoint[static_cast<std::size_t>(point)])];
  }
  void sumOverRanks(std::vector<double>& values) const {
    MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM,
                  model_.comm().mpi());
  }

  /// The copies, 0 included, of which a part that goes on in the copies of `mirrors` holds the images of all its
  /// points.
  std::vector<int> copiesOf(unsigned mirrors) const {
    std::vector<int> copies{0};
    for (int copy = 1; copy < mesh_.symmetry.nCopies(); ++copy) {
      if ((mirrors >> copy & 1u) == 0 || std::find(copies.begin(), copies.end(), copy) != copies.end()) continue;
      const std::vector<int> before = copies;
      for (const int other : before) copies.push_back(other ^ copy);
    }
    return copies;
  }

  /// Centres, radii and first points.
  void measure() {
    std::vector<double> sums(6 * parts_.size(), 0.0), squares(parts_.size(), 0.0);
    std::vector<std::vector<int>> copies;
    for (const std::size_t name : nameOfPart_) copies.push_back(copiesOf(connected_.mirrors[name]));
    for (int point = 0; point < mesh_.nOwned; ++point) {
      const int k = partOf(point);
      if (k < 0) continue;
      const auto part = static_cast<std::size_t>(k);
      const bool isFirst = mesh_.globalIds[static_cast<std::size_t>(point)] == connected_.names[nameOfPart_[part]];
      for (std::size_t c = 0; c < 3; ++c) {
        for (const int copy : copies[part]) sums[6 * part + c] += place(point, copy)[c];
        if (isFirst) sums[6 * part + 3 + c] = place(point)[c];
      }
    }
    sumOverRanks(sums);
    const auto nPoints = [&](std::size_t k) {
      return static_cast<double>(connected_.sizes[nameOfPart_[k]]) * static_cast<double>(copies[k].size());
    };
    for (std::size_t k = 0; k < parts_.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c) {
        parts_[k].motions.centre[c] = sums[6 * k + c] / nPoints(k);
        parts_[k].first[c] = sums[6 * k + 3 + c];
      }
    for (int point = 0; point < mesh_.nOwned; ++point)
      if (const int k = partOf(point); k >= 0)
        for (const int copy : copies[static_cast<std::size_t>(k)])
          squares[static_cast<std::size_t>(k)] +=
              std::pow(distance(place(point, copy), parts_[static_cast<std::size_t>(k)].motions.centre), 2);
    sumOverRanks(squares);
    for (std::size_t k = 0; k < parts_.size(); ++k) parts_[k].motions.radius = std::sqrt(squares[k] / nPoints(k));
  }

  /// Of a point of the mesh that belongs to the part in `copy`, where it is at x.
  Mode motions(const Part& part, const Point& x, int copy, int axis) const {
    return part.motions.at(x, axis, mesh_.symmetry.matrix(copy));
  }

  void addPrescribed() {
    std::vector<double> all(36 * parts_.size(), 0.0);
    for (int point = 0; point < mesh_.nOwned; ++point) {
      const int k = partOf(point);
      if (k < 0) continue;
      for (int axis = 0; axis < mesh_.dimension; ++axis) {
        if (!isHeld_[static_cast<std::size_t>(3 * point + axis)]) continue;
        const Mode row = motions(parts_[static_cast<std::size_t>(k)], place(point), copyOf(point), axis);
        for (std::size_t i = 0; i < 6; ++i)
          for (std::size_t j = 0; j < 6; ++j) all[36 * static_cast<std::size_t>(k) + 6 * i + j] += row[i] * row[j];
      }
    }
    sumOverRanks(all);
    for (std::size_t k = 0; k < parts_.size(); ++k)
      parts_[k].held.assign(all.begin() + static_cast<std::ptrdiff_t>(36 * k),
                            all.begin() + static_cast<std::ptrdiff_t>(36 * (k + 1)));
  }

  /// A part that is connected with its own image moves as that does: as many points as span a body do.
  void addMirrors(Part& part, unsigned mirrors) const {
    for (int copy = 1; copy < mesh_.symmetry.nCopies(); ++copy) {
      if ((mirrors >> copy & 1u) == 0) continue;
      for (int corner = 0; corner <= mesh_.dimension; ++corner) {
        Point x = part.motions.centre;
        if (corner > 0) x[static_cast<std::size_t>(corner - 1)] += part.motions.radius;
        const Point image = mesh_.symmetry.place(copy, x.data());
        for (int axis = 0; axis < mesh_.dimension; ++axis) {
          Mode row = motions(part, x, 0, axis);
          const Mode mirrored = motions(part, image, copy, axis);
          for (std::size_t mode = 0; mode < row.size(); ++mode) row[mode] -= mirrored[mode];
          hold(part, row);
        }
      }
    }
  }

  std::vector<Candidate> firstPoints() const {
    std::vector<Candidate> result;
    for (std::size_t k = 0; k < parts_.size(); ++k)
      result.push_back({0.0, connected_.names[nameOfPart_[k]], 0, parts_[k].first});
    return result;
  }

  /// In each part the point of largest measure(part, place); of equals the one of smallest global id.
  std::vector<Candidate> farthest(const std::function<double(std::size_t, const Point&)>& measureOf) const {
    const auto isBetter = [](const Candidate& a, const Candidate& b) {
      return a.measure > b.measure || (a.measure == b.measure && a.globalId < b.globalId);
    };
    std::vector<Candidate> best(parts_.size());
    for (int point = 0; point < mesh_.nOwned; ++point) {
      const int k = partOf(point);
      if (k < 0) continue;
      const Point x = place(point);
      const Candidate candidate{measureOf(static_cast<std::size_t>(k), x),
                                mesh_.globalIds[static_cast<std::size_t>(point)], copyOf(point), x};
      if (isBetter(candidate, best[static_cast<std::size_t>(k)])) best[static_cast<std::size_t>(k)] = candidate;
    }
    constexpr std::size_t width = 6;
    std::vector<double> mine, all(width * best.size() * static_cast<std::size_t>(model_.comm().size()));
    for (const Candidate& c : best)
      mine.insert(mine.end(), {c.measure, static_cast<double>(c.globalId), static_cast<double>(c.copy), c.place[0],
                               c.place[1], c.place[2]});
    MPI_Allgather(mine.data(), static_cast<int>(mine.size()), MPI_DOUBLE, all.data(), static_cast<int>(mine.size()),
                  MPI_DOUBLE, model_.comm().mpi());
    for (std::size_t k = 0; k < all.size() / width; ++k) {
      const double* c = &all[width * k];
      const Candidate candidate{c[0], static_cast<long long>(c[1]), static_cast<int>(c[2]), {c[3], c[4], c[5]}};
      if (isBetter(candidate, best[k % best.size()])) best[k % best.size()] = candidate;
    }
    return best;
  }

  void holdAt(Part& part, const Candidate& candidate, double leastShare) {
    for (int axis = 0; axis < mesh_.dimension; ++axis) {
      const Mode row = motions(part, candidate.place, candidate.copy, axis);
      if (freeShare(part, row, nModes_) < leastShare) continue;
      hold(part, row);
      for (int point = 0; point < mesh_.nOwned; ++point)
        if (mesh_.globalIds[static_cast<std::size_t>(point)] == candidate.globalId)
          isHeld_[static_cast<std::size_t>(3 * point + axis)] = 1;
    }
  }

  Model& model_;
  const Discretization& mesh_;
  const ConnectedParts& connected_;
  std::vector<char>& isHeld_;
  int nModes_;
  std::vector<Part> parts_;
  std::vector<int> partOfName_;  ///< index into parts_; -1 for a single point
  std::vector<std::size_t> nameOfPart_;
};

}  // namespace

HeldInPlace findLooseParts(Model& model, const std::vector<char>& isPrescribed) {
  HeldInPlace result;
  result.isHeld = isPrescribed;
  const ConnectedParts connected = findConnectedParts(model);
  for (std::size_t i = 0; i < connected.partOfPoint.size(); ++i) {
    if (!connected.isSingle(static_cast<std::size_t>(connected.partOfPoint[i]))) continue;
    const auto begin = result.isHeld.begin() + static_cast<std::ptrdiff_t>(3 * i);
    if (std::any_of(begin, begin + 3, [](char held) { return held == 0; })) ++result.nPointsWithoutBonds;
    std::fill(begin, begin + 3, char{1});
  }
  result.nPointsWithoutBonds = model.comm().sum(result.nPointsWithoutBonds);
  Holder(model, connected, result.isHeld).holdLooseParts(result);
  return result;
}

}  // namespace pd
