#include "flow_boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boundary_conditions.hpp"
#include "condition.hpp"

namespace pd {

FlowBoundary::FlowBoundary(const DeckNode& node) {
  given_.emplace();
  for (const char* key : {"Velocity", "Pressure"})
    for (const DeckNode& component : node[key].each()) {
      if (given_ && component.isScalar()) given_->push_back(component.text());
      if (!component.isScalar()) given_.reset();
    }
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

FlowForces::FlowForces(const BoundaryConditions& conditions) : conditions_(conditions) {
  for (const auto& condition : conditions.all())
    if (const auto* force = dynamic_cast<const FlowForce*>(condition.get())) forces_.push_back(force);
}

bool FlowForces::dependOnTime() const {
  return std::any_of(forces_.begin(), forces_.end(), [](const FlowForce* force) { return force->dependsOnTime(); });
}

std::vector<double> FlowForces::at(const Discretization& mesh, double t) const {
  std::vector<double> sum(3 * static_cast<std::size_t>(mesh.nOwned), 0.0);
  for (const FlowForce* force : forces_) force->addTo(mesh, conditions_.runTime(t), sum.data());
  return sum;
}

}  // namespace pd
