#include "flow_pockets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "flow_parts.hpp"

namespace pd {

FlowPockets findFlowPockets(Model& model, const FlowGeometry& geometry, const FlowRows& rows) {
  const Discretization& mesh = model.discretization();
  const auto gradientOf = [&](std::size_t row, const auto& connect) {
    const auto stored = rows.pressureGradient.row(row);
    for (std::size_t k = 0; k < stored.count; ++k) connect(stored.pointOf(k));
  };
  const FlowParts parts = findFlowParts(model, geometry.fluid(), gradientOf);

  FlowPockets result;
  result.pockets.resize(parts.nParts);
  result.pocketOf.assign(static_cast<std::size_t>(mesh.nOwned), -1);
  for (std::size_t row = 0; row < geometry.fluid().size(); ++row) {
    const int point = geometry.fluid()[row];
    FlowPockets::Pocket& pocket = result.pockets[parts.partOf[row]];
    result.pocketOf[static_cast<std::size_t>(point)] = static_cast<int>(parts.partOf[row]);
    if (parts.isFirst[row] != 0) pocket.firstPoint = point;
    pocket.volume += mesh.volume[static_cast<std::size_t>(point)];
    ++pocket.nPoints;
    // Weights of a gradient add up to nothing where all ends are points.
    std::array<double, 3> sum{}, size{};
    rows.pressureGradient.forEach(row, [&](const auto& term) {
      for (std::size_t a = 0; a < 3; ++a) {
        sum[a] += term.weights[a];
        size[a] += std::abs(term.weights[a]);
      }
    });
    for (std::size_t a = 0; a < 3; ++a) pocket.isOpen = pocket.isOpen || std::abs(sum[a]) > 1e-9 * size[a];
  }
  for (FlowPockets::Pocket& pocket : result.pockets) {
    pocket.isOpen = model.comm().any(pocket.isOpen);
    pocket.volume = model.comm().sum(pocket.volume);
    pocket.nPoints = model.comm().sum(pocket.nPoints);
  }
  return result;
}

double largestNetFlow(const FlowPockets& pockets, const std::vector<double>& flows, double velocity,
                      std::size_t dimension) {
  double largest = 0.0;
  for (std::size_t k = 0; k < flows.size(); ++k)
    if (flows[k] != 0.0 && velocity > 0.0)
      largest = std::max(
          largest, std::abs(flows[k]) / velocity *
                       std::pow(static_cast<double>(pockets.pockets[k].nPoints), 1.0 / static_cast<double>(dimension)));
  return largest;
}

void requireNoNetFlow(double netFlow, const std::string& where, const std::string& why) {
  constexpr double most = 0.02;  // corners of lids let less than 1e-3 through, walls without a surface not much more
  if (netFlow <= most) return;
  throw RunError(fmt::format(
      "{}: walls and inlets let {:.2g} of the largest velocity, over the width of the fluid, into a part of it that "
      "has no Outflow, or out of it, and {}. Give it an Outflow, or velocities that let out what they let in",
      where, netFlow, why));
}

}  // namespace pd
