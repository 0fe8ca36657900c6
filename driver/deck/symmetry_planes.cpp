#include "symmetry_planes.hpp"

#include <cmath>
#include <optional>

#include "vector3.hpp"

namespace pd {

namespace {

/// None after a mistake.
std::optional<Vector3> vectorOf(const DeckNode& plane, const std::string& key, Mistakes& mistakes) {
  const DeckNode node = plane[key];
  if (!node) {
    mistakes.add(plane.keyPlace(), plane.path() + " needs " + key + ": [x, y, z]");
    return std::nullopt;
  }
  const std::vector<DeckNode> items = node.isSequence() ? node.items() : std::vector<DeckNode>();
  if (items.size() != 3) {
    mistakes.add(node.place(), node.path() + " must be three numbers, [x, y, z]");
    return std::nullopt;
  }
  Vector3 result{};
  for (std::size_t k = 0; k < 3; ++k) result[k] = items[k].real();
  return result;
}

std::optional<SymmetryPlane> readPlane(const DeckNode& node, Mistakes& mistakes) {
  const auto point = vectorOf(node, "Point", mistakes);
  auto normal = vectorOf(node, "Normal", mistakes);
  if (!point || !normal) return std::nullopt;
  const double norm = length(*normal);
  if (!(norm > 0.0) || !std::isfinite(norm)) {
    mistakes.add(node["Normal"].place(), node.path() + ": the normal has no length");
    return std::nullopt;
  }
  for (double& component : *normal) component /= norm;
  return SymmetryPlane{*point, *normal, node.keyPlace(), node.path()};
}

}  // namespace

kernels::Rings ringsOf(const Deck& deck) {
  const DeckNode node = deck["Discretization"][axisOfRevolution];
  return kernels::Rings(node.isScalar() ? node.text() : "");
}

std::optional<SymmetryPlane> axisPlane(const Deck& deck) {
  const DeckNode node = deck["Discretization"][axisOfRevolution];
  const kernels::Rings rings = ringsOf(deck);
  if (!rings.areUsed()) return std::nullopt;
  SymmetryPlane plane{{}, {}, node.place(), node.path()};
  plane.normal[rings.radial()] = 1.0;
  return plane;
}

std::vector<SymmetryPlane> readSymmetryPlanes(const Deck& deck, Mistakes& mistakes) {
  constexpr double rightAngle = 1e-9;  // far above rounding; planes turned by more would leave gaps between images
  std::vector<SymmetryPlane> planes;
  if (const auto plane = axisPlane(deck)) planes.push_back(*plane);
  for (const auto& [name, node] : deck["Discretization"]["Symmetry"].entries()) {
    const auto plane = readPlane(node, mistakes);
    if (!plane) continue;
    bool isPerpendicular = true;
    for (const SymmetryPlane& other : planes) {
      if (std::abs(dot(plane->normal, other.normal)) <= rightAngle) continue;
      isPerpendicular = false;
      mistakes.add(plane->place, plane->path + " is not perpendicular to " + other.path +
                                     ": there may be one plane of symmetry, or two or three that are perpendicular to "
                                     "each other; model a larger part of the body and leave one of these out");
    }
    if (isPerpendicular) planes.push_back(*plane);
  }
  return planes;
}

}  // namespace pd
