#include "crack_path.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace pd {

CrackPath::CrackPath(const std::vector<Point>& mine, double reach, const Epetra_Comm& comm) : reach_(reach) {
  std::vector<double> packed;
  for (const Point& point : mine) {
    packed.insert(packed.end(),
                  {static_cast<double>(point.point.globalId), point.place[0], point.place[1], point.place[2],
                   point.damage, point.fromStart, static_cast<double>(point.point.neighbors.size())});
    packed.insert(packed.end(), point.point.neighbors.begin(), point.point.neighbors.end());
  }
  const std::vector<double> all = gatherFromRanks(comm, packed);
  for (auto at = all.begin(); at != all.end();) {
    Point point{{static_cast<int>(at[0]), {}}, {at[1], at[2], at[3]}, at[4], at[5]};
    const auto n = static_cast<std::ptrdiff_t>(at[6]);
    at += 7;
    for (const auto last = at + n; at != last; ++at) point.point.neighbors.push_back(static_cast<int>(*at));
    points_.push_back(std::move(point));
  }
  findPositions();
  findDistances();
}

void CrackPath::findPositions() {
  if (points_.empty()) return;
  const auto isLower = [](const Point& a, const Point& b) { return a.point.globalId < b.point.globalId; };
  const auto [lowest, highest] = std::minmax_element(points_.begin(), points_.end(), isLower);
  lowestId_ = lowest->point.globalId;
  positions_.assign(static_cast<std::size_t>(highest->point.globalId - lowestId_) + 1, -1);
  for (std::size_t k = 0; k < points_.size(); ++k)
    positions_[static_cast<std::size_t>(points_[k].point.globalId - lowestId_)] = static_cast<int>(k);
}

/// Dijkstra, Numer. Math. 1 (1959) 269. Most ways to a point are longer than one that is known: lengths are found to
/// the last digit where they may not be.
void CrackPath::findDistances() {
  constexpr double rounding = 1e-12;
  distances_.assign(points_.size(), -1.0);
  std::vector<double> shortest(points_.size(), HUGE_VAL);
  using Step = std::pair<double, std::size_t>;
  std::priority_queue<Step, std::vector<Step>, std::greater<>> next;
  const auto add = [&](double distance, std::size_t k) {
    if (!(distance < shortest[k])) return;
    shortest[k] = distance;
    next.emplace(distance, k);
  };
  for (std::size_t k = 0; k < points_.size(); ++k)
    if (points_[k].fromStart >= 0.0) add(points_[k].fromStart, k);
  while (!next.empty()) {
    const auto [distance, k] = next.top();
    next.pop();
    if (distances_[k] >= 0.0) continue;
    distances_[k] = distance;
    length_ = std::max(length_, distance);
    const Vector3& x = points_[k].place;
    for (const int id : points_[k].point.neighbors) {
      const int found = positionOf(id);
      if (found < 0) continue;
      const auto other = static_cast<std::size_t>(found);
      const Vector3& y = points_[other].place;
      const Vector3 way{y[0] - x[0], y[1] - x[1], y[2] - x[2]};
      if (distance + std::sqrt(dot(way, way.data())) * (1.0 - rounding) >= shortest[other]) continue;
      add(distance + std::hypot(way[0], way[1], way[2]), other);
    }
  }
}

double CrackPath::distance(int globalId) const {
  const int found = positionOf(globalId);
  return found < 0 ? -1.0 : distances_[static_cast<std::size_t>(found)];
}

Vector3 CrackPath::meanBetween(double nearest, double furthest) const {
  Vector3 sum{};
  double weight = 0.0;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const double behind = length_ - distances_[k];
    if (distances_[k] < 0.0 || behind < nearest * endLength() || behind > furthest * endLength()) continue;
    for (std::size_t d = 0; d < 3; ++d) sum[d] += points_[k].damage * points_[k].place[d];
    weight += points_[k].damage;
  }
  for (double& value : sum) value /= weight;
  return sum;
}

Vector3 CrackPath::directionAtEnd(const Vector3& atStart) const {
  if (length_ < reach_) return atStart;
  const Vector3 to = meanBetween(0.0, 1.0), from = meanBetween(1.0, 2.0);
  Vector3 direction{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  const double norm = std::hypot(direction[0], direction[1], direction[2]);
  for (double& value : direction) value /= norm;
  return direction;
}

}  // namespace pd
