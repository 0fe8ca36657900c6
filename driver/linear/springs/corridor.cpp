#include "corridor.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "dissection.hpp"
#include "frontal_factor.hpp"

namespace pd {

Corridor::Corridor(const SpringOperator& stiffness, const std::vector<int>& points)
    : stiffness_(stiffness),
      points_(points),
      isIn_(static_cast<std::size_t>(stiffness.network().points().nOwned), 0),
      isRim_(isIn_.size(), 0) {
  for (const int i : points_) isIn_[static_cast<std::size_t>(i)] = 1;
  std::vector<int> rest;
  for (std::size_t i = 0; i < isIn_.size(); ++i)
    if (isIn_[i] == 0) rest.push_back(static_cast<int>(i));
  condense(std::move(rest));
  supports_ = supportsOfRest();
  held_ = stiffness_.held();
  additions_ = stiffness_.additions();
}

/// Springs between points of the corridor are none of the rest.
void Corridor::condense(std::vector<int> rest) {
  const SpringNetwork& network = stiffness_.network();
  for (const int i : rest)
    for (int k = 0; k < network.nNeighbors(i); ++k)
      if (const int j = network.neighbors(i)[k]; contains(j) && network.alive(i, k) > 0.0F)
        isRim_[static_cast<std::size_t>(j)] = 1;
  std::copy_if(points_.begin(), points_.end(), std::back_inserter(rim_), [&](int i) { return isRim(i); });
  if (rim_.empty()) return;
  Dissection order = dissect(network, std::move(rest));
  order.points.insert(order.points.end(), rim_.begin(), rim_.end());
  PartStiffness part(stiffness_, std::move(order.points));
  part.addSprings([&](int i, int j) { return !contains(i) || !contains(j); });
  part.addAdditions([&](int i) { return !contains(i); });
  FrontalFactor factor(part, order.ends);
  trouble_ = factor.eliminate(false);
  if (trouble_.empty()) ofRest_ = factor.takeLeft();
}

/// The rim, which the rest has filled, goes after what is sparse, and what may change last.
CorridorResponse Corridor::response(const std::vector<int>& rows, const std::vector<int>& columns) const {
  std::vector<char> isKept(isIn_.size(), 0);
  for (const int i : columns) isKept[static_cast<std::size_t>(i)] = 1;
  std::vector<int> sparse, rim;
  for (const int i : points_)
    if (isKept[static_cast<std::size_t>(i)] == 0) (isRim(i) ? rim : sparse).push_back(i);
  Dissection order = dissect(stiffness_.network(), std::move(sparse));
  order.addGroup(rim);
  order.points.insert(order.points.end(), columns.begin(), columns.end());
  PartStiffness part(stiffness_, std::move(order.points));
  part.addSprings([](int, int) { return true; });
  part.addAdditions([](int) { return true; });
  part.add(rim_, ofRest_);
  FrontalFactor factor(part, order.ends);
  CorridorResponse response;
  response.trouble = factor.eliminate(true);
  if (!response.trouble.empty()) return response;
  const std::vector<int> unknowns = part.unknownsOf(rows);
  response.values = factor.columnsOfInverse(unknowns);
  if (response.values.empty() && !unknowns.empty()) response.trouble = FrontalFactor::singular;
  return response;
}

std::vector<double> Corridor::supportsOfRest() const {
  const int dimension = stiffness_.network().dimension();
  std::vector<double> supports(isIn_.size() * static_cast<std::size_t>(dimension), 0.0);
  const auto at = [&](int i, int c) -> double& {
    return supports[static_cast<std::size_t>(i) * static_cast<std::size_t>(dimension) + static_cast<std::size_t>(c)];
  };
  for (const SpringOperator::Addition& each : stiffness_.additions())
    if (!contains(each.point)) at(each.point, each.component) += each.value;
  for (std::size_t p = 0; p < isIn_.size(); ++p) {
    const auto i = static_cast<int>(p);
    for (int c = 0; c < dimension; ++c)
      if ((!contains(i) || isRim(i)) && stiffness_.isHeld(i, c)) at(i, c) = -1.0;
  }
  return supports;
}

bool Corridor::fitsAfter(const std::vector<int>& changed) const {
  if (!std::all_of(changed.begin(), changed.end(), [&](int i) { return contains(i); })) return false;
  if (held_ == stiffness_.held() && additions_ == stiffness_.additions()) return true;
  if (supportsOfRest() != supports_) return false;
  held_ = stiffness_.held();
  additions_ = stiffness_.additions();
  return true;
}

}  // namespace pd
