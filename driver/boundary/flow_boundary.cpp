#include "flow_boundary.hpp"

#include <fmt/format.h>

#include <cmath>

namespace pd {

FlowBoundary::FlowBoundary(const DeckNode& node) {
  const DeckNode surface = node["Surface"];
  if (!surface) return;
  surface_ = Function::fromDeck(surface);
  if (surface_->dependsOnTime())
    throw DeckError(surface.place() + ": " + surface.path() + " depends on the time; surfaces stay where they are");
}

std::array<double, 3> FlowBoundary::surfaceGradient(const double* x, double step, int dimension) const {
  std::array<double, 3> gradient{};
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
    std::array<double, 3> before{x[0], x[1], x[2]}, after = before;
    before[a] -= step;
    after[a] += step;
    gradient[a] = (surfaceAt(after.data()) - surfaceAt(before.data())) / (2.0 * step);
  }
  return gradient;
}

double FlowBoundary::finiteValue(const Function& function, const DeckNode& node, const double* x, double t) {
  const double value = function(x[0], x[1], x[2], t);
  if (!std::isfinite(value))
    throw DeckError(
        fmt::format("{}: {} has no finite value at ({:.9g}, {:.9g}, {:.9g}) m on the boundary, t = {:.9g} s",
                    node.place(), node.path(), x[0], x[1], x[2], t));
  return value;
}

}  // namespace pd
