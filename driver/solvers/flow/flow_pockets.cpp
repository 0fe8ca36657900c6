#include "flow_pockets.hpp"

#include <algorithm>

namespace pd {

namespace {

/// [points] For fluid points the smallest global id of those that they are connected with. Collective.
std::vector<double> pocketNames(Model& model, const FlowGeometry& geometry, const FlowRows& rows) {
  const Discretization& mesh = model.discretization();
  std::vector<double> names(mesh.globalIds.begin(), mesh.globalIds.end());
  for (bool hasChanged = true; hasChanged;) {
    hasChanged = false;
    for (bool isMoving = true; isMoving;) {
      isMoving = false;
      for (std::size_t row = 0; row < geometry.fluid().size(); ++row) {
        double& own = names[static_cast<std::size_t>(geometry.fluid()[row])];
        double smallest = own;
        for (const auto* term = rows.pressureGradient.begin(row); term != rows.pressureGradient.end(row); ++term)
          smallest = std::min(smallest, names[static_cast<std::size_t>(term->point)]);
        isMoving = isMoving || smallest < own;
        own = smallest;
        for (const auto* term = rows.pressureGradient.begin(row); term != rows.pressureGradient.end(row); ++term) {
          double& other = names[static_cast<std::size_t>(term->point)];
          isMoving = isMoving || smallest < other;
          other = std::min(other, smallest);
        }
      }
      hasChanged = hasChanged || isMoving;
    }
    model.exchange().import(names.data(), 1, std::nullopt);
    hasChanged = model.comm().any(hasChanged);
  }
  return names;
}

}  // namespace

FlowPockets findFlowPockets(Model& model, const FlowGeometry& geometry, const FlowRows& rows) {
  const Discretization& mesh = model.discretization();
  const std::vector<double> names = pocketNames(model, geometry, rows);
  std::vector<double> own;
  for (const int point : geometry.fluid())
    if (names[static_cast<std::size_t>(point)] == mesh.globalIds[static_cast<std::size_t>(point)])
      own.push_back(names[static_cast<std::size_t>(point)]);
  std::vector<double> all = model.comm().gather(own);
  std::sort(all.begin(), all.end());

  FlowPockets result;
  result.pockets.resize(all.size());
  result.pocketOf.assign(static_cast<std::size_t>(mesh.nOwned), -1);
  for (std::size_t row = 0; row < geometry.fluid().size(); ++row) {
    const int point = geometry.fluid()[row];
    const double name = names[static_cast<std::size_t>(point)];
    const auto number = std::lower_bound(all.begin(), all.end(), name) - all.begin();
    FlowPockets::Pocket& pocket = result.pockets[static_cast<std::size_t>(number)];
    result.pocketOf[static_cast<std::size_t>(point)] = static_cast<int>(number);
    if (name == mesh.globalIds[static_cast<std::size_t>(point)]) pocket.firstPoint = point;
    pocket.volume += mesh.volume[static_cast<std::size_t>(point)];
    ++pocket.nPoints;
    // Weights of a gradient add up to nothing where all ends are points.
    std::array<double, 3> sum{}, size{};
    for (const auto* term = rows.pressureGradient.begin(row); term != rows.pressureGradient.end(row); ++term)
      for (std::size_t a = 0; a < 3; ++a) {
        sum[a] += term->weights[a];
        size[a] += std::abs(term->weights[a]);
      }
    for (std::size_t a = 0; a < 3; ++a) pocket.isOpen = pocket.isOpen || std::abs(sum[a]) > 1e-9 * size[a];
  }
  for (FlowPockets::Pocket& pocket : result.pockets) {
    pocket.isOpen = model.comm().any(pocket.isOpen);
    pocket.volume = model.comm().sum(pocket.volume);
    pocket.nPoints = model.comm().sum(pocket.nPoints);
  }
  return result;
}

}  // namespace pd
