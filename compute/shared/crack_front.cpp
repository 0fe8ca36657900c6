#include "crack_front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pd {

/// A damaged point that may be the foremost one.
struct CrackFront::Candidate {
  std::size_t block;
  int id;
  const int* neighbors;
  int nNeighbors;
  double ahead;  ///< coordinate along the direction, m
};

void CrackFront::declareParameters(ParameterDeclarations& declarations) {
  declarations.text("Variable", "Scalar point field of the damage.").defaultTo("Damage");
  declarations.real("Threshold", "1", "Damage from which a point counts as cracked.").positive().defaultTo(0.36);
  declareVector(declarations, "Direction", "1", "Direction in which the crack grows (default: x; any length).");
  declareVector(declarations, "Start", "m", "Mouth of the crack; what is not given is 0.");
  declarations.flag("Interpolate", "Place the tip between points, where damage falls through the threshold.")
      .defaultTo(true);
  PointSelection::declareParameters(declarations);
}

CrackFront::CrackFront(const Teuchos::ParameterList& parameters, const ComputeParameters& globalData)
    : points_(parameters, globalData),
      fields_(parameters),
      threshold_(parameters.get<double>("Threshold")),
      direction_(directionOf(parameters, "Direction")),
      start_(vectorOf(parameters, "Start")),
      isInterpolated_(parameters.get<bool>("Interpolate")) {
  if (fields_.damage.width() != 1) throw std::invalid_argument("\"Variable\" of a crack must be a scalar field");
}

void CrackFront::initialize(const Blocks& blocks) {
  points_.initialize(blocks);
  fields_.damage.initialize(blocks);
}

std::vector<CrackFront::Candidate> CrackFront::candidates(const Blocks& blocks) const {
  std::vector<Candidate> result;
  for (std::size_t b = 0; b < blocks->size(); ++b) {
    PeridigmNS::Block& block = (*blocks)[b];
    const auto neighborhood = block.getNeighborhoodData();
    const double* x = view(block, fields_.modelCoordinates);
    const double* damage = fields_.damage.values(block);
    const int* list = neighborhood->NeighborhoodList();
    for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
      const int id = neighborhood->OwnedIDs()[i];
      const int n = *list++;
      if (damage[id] >= threshold_ && points_.includes(b, i))
        result.push_back({b, id, list, n, dot(direction_, x + 3 * id)});
      list += n;
    }
  }
  return result;
}

/// How far ahead of the candidate damage falls through the threshold: up to its nearest neighbour within 45 degrees
/// of the direction.
double CrackFront::stepAhead(const Candidate& candidate, const double* x, const double* damage) const {
  const double* own = x + 3 * candidate.id;
  double nearest = std::numeric_limits<double>::max(), step = 0.0, damageAhead = 0.0;
  for (int k = 0; k < candidate.nNeighbors; ++k) {
    const int j = candidate.neighbors[k];
    const double bond[3] = {x[3 * j] - own[0], x[3 * j + 1] - own[1], x[3 * j + 2] - own[2]};
    const double length = std::sqrt(bond[0] * bond[0] + bond[1] * bond[1] + bond[2] * bond[2]);
    const double ahead = dot(direction_, bond);
    if (ahead < std::sqrt(0.5) * length || damage[j] >= threshold_) continue;
    const bool isAsNear = std::abs(length - nearest) <= 1e-6 * length;
    if (isAsNear ? damage[j] > damageAhead : length < nearest) {
      nearest = length;
      step = ahead;
      damageAhead = damage[j];
    }
  }
  if (step == 0.0) return 0.0;
  const double damageHere = damage[candidate.id];
  return step * (damageHere - threshold_) / (damageHere - damageAhead);
}

Vector3 CrackFront::locate(const Blocks& blocks, const Epetra_Comm& comm) const {
  const std::vector<Candidate> cracked = candidates(blocks);
  double foremost = std::numeric_limits<double>::lowest();
  for (const Candidate& candidate : cracked) foremost = std::max(foremost, candidate.ahead);
  foremost = maxOverRanks(comm, foremost);
  if (foremost == std::numeric_limits<double>::lowest()) return start_;

  std::vector<double> sums(4, 0.0);  // positions, number of points
  for (const Candidate& candidate : cracked) {
    PeridigmNS::Block& block = (*blocks)[candidate.block];
    const double* x = view(block, fields_.modelCoordinates);
    const double* own = x + 3 * candidate.id;
    // Equally far ahead: closer to the foremost point than a millionth of the spacing.
    double spacing = 0.0;
    for (int k = 0; k < candidate.nNeighbors; ++k) {
      const double* other = x + 3 * candidate.neighbors[k];
      const double length = std::hypot(other[0] - own[0], other[1] - own[1], other[2] - own[2]);
      if (spacing == 0.0 || length < spacing) spacing = length;
    }
    if (candidate.ahead < foremost - 1e-6 * spacing) continue;
    const double step = isInterpolated_ ? stepAhead(candidate, x, fields_.damage.values(block)) : 0.0;
    for (std::size_t k = 0; k < 3; ++k) sums[k] += own[k] + step * direction_[k];
    sums[3] += 1.0;
  }
  sums = sumOverRanks(comm, sums);
  return {sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3]};
}

}  // namespace pd
