// Loads that only what holds loose parts in place would carry.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "loose_parts.hpp"

namespace pd {

namespace {

using Mode = RigidMotions::Mode;

/// What the loads on one part, or on all points without bonds, come to.
struct Work {
  Mode free{};           ///< N, along each rigid-body motion, as far as it is free; of points alone sums of components
  double carried = 0.0;  ///< N
};

/// Sums over ranks.
void sum(const Communicator& comm, std::vector<double>& values) {
  std::vector<double> all(values.size());
  comm.SumAll(values.data(), all.data(), static_cast<int>(values.size()));
  values = all;
}

/// The part of `work` along the motions that are free.
Work alongFree(const HeldInPlace::Part& part, const double* work) {
  Work result;
  for (const Mode& motion : part.free) {
    double along = 0.0;
    for (std::size_t i = 0; i < motion.size(); ++i) along += motion[i] * work[i];
    for (std::size_t i = 0; i < motion.size(); ++i) result.free[i] += along * motion[i];
    result.carried += along * along;
  }
  result.carried = std::sqrt(result.carried);
  return result;
}

std::string vectorText(const std::array<double, 3>& v) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", v[0], v[1], v[2]);
}

std::string messageOf(const HeldInPlace::Part& part, const Work& work) {
  const int dimension = part.motions.dimension;
  std::array<double, 3> force{};
  std::copy_n(work.free.begin(), dimension, force.begin());
  const std::array<double, 3> moment = part.motions.moment(work.free);
  const auto size = [](const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); };
  std::string text;
  if (size(force) > 1e-6 * work.carried) text = fmt::format("a force of {} N", vectorText(force));
  if (size(moment) > 1e-6 * work.carried * part.motions.radius)
    text += fmt::format("{}a moment of {} N m", text.empty() ? "" : " and ", vectorText(moment));
  return fmt::format("{} on a part of {} points around {} m", text, part.nPoints, vectorText(part.motions.centre));
}

}  // namespace

std::string loadsThatNothingHolds(Model& model, const HeldInPlace& held, const std::vector<char>& isPrescribed,
                                  const std::vector<double>& forceDensity, double scale) {
  if (!held.hasAny()) return "";
  const Discretization& mesh = model.discretization();
  const std::size_t nParts = held.parts.size(), alone = 6 * nParts;
  // Work along the motions of each part; then points alone: sums of components, of sizes, and their number; all loads.
  std::vector<double> sums(alone + 6, 0.0);
  for (std::size_t i = 0; i < forceDensity.size(); ++i) {
    const std::size_t point = i / 3;
    const int axis = static_cast<int>(i % 3), part = held.partOfPoint[point];
    const double force = forceDensity[i] * mesh.volume[point];
    if (force == 0.0 || axis >= mesh.dimension) continue;
    sums[alone + 5] += std::abs(force);
    if (part == HeldInPlace::isAlone && !isPrescribed[i]) {
      sums[alone + static_cast<std::size_t>(axis)] += force;
      sums[alone + 3] += std::abs(force);
      sums[alone + 4] += 1.0;
    } else if (part >= 0) {
      const int copy = held.copyOfPoint[point];
      const Mode row = held.parts[static_cast<std::size_t>(part)].motions.at(
          mesh.symmetry.place(copy, &mesh.x[3 * point]), axis, mesh.symmetry.matrix(copy));
      for (std::size_t mode = 0; mode < row.size(); ++mode)
        sums[6 * static_cast<std::size_t>(part) + mode] += force * row[mode];
    }
  }
  sum(model.comm(), sums);
  const double ofPointsAlone = sums[alone + 3];
  double total = ofPointsAlone;
  std::size_t most = nParts;
  Work largest;
  largest.carried = ofPointsAlone;
  for (std::size_t k = 0; k < nParts; ++k) {
    const Work work = alongFree(held.parts[k], &sums[6 * k]);
    total += work.carried;
    if (work.carried <= largest.carried) continue;
    largest = work;
    most = k;
  }
  constexpr double negligible = 1e-3;
  if (!(total > negligible * std::max(sums[alone + 5], scale))) return "";
  const std::string what =
      most < nParts ? messageOf(held.parts[most], largest)
                    : fmt::format("forces of {:.4g} N in all on points without bonds, {} N together", ofPointsAlone,
                                  vectorText({sums[alone], sums[alone + 1], sums[alone + 2]}));
  return "nothing holds the body against its loads: no prescribed displacement carries " + what;
}

}  // namespace pd
