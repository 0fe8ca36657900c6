#include "quick_grid.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <new>

#include "../model/collective.hpp"

namespace pd {

namespace {

const char* const boxName = "TensorProduct3DMeshGenerator";
const char* const cylinderName = "TensorProductCylinderMeshGenerator";

/// Equal cells along one axis.
struct Cells {
  long long count;
  double start, length;
  double size() const { return length / static_cast<double>(count); }
  double center(long long i) const { return start + (static_cast<double>(i) + 0.5) * size(); }
};

double length(const DeckNode& section, const std::string& key) {
  const DeckNode value = required(section, key);
  if (!(value.real() > 0.0)) throw DeckError(value.place() + ": " + value.path() + " must be greater than 0 m");
  return value.real();
}

long long count(const DeckNode& section, const std::string& key) {
  const DeckNode value = required(section, key);
  if (value.integer() < 1) throw DeckError(value.place() + ": " + value.path() + " must be 1 or more");
  return value.integer();
}

std::array<Cells, 3> boxCells(const DeckNode& generator) {
  const auto along = [&](const std::string& axis) {
    return Cells{count(generator, "Number Points " + axis), required(generator, axis + " Origin").real(),
                 length(generator, axis + " Length")};
  };
  return {along("X"), along("Y"), along("Z")};
}

MeshPoints emptyMesh(const Deck& deck, const DeckNode& generator, double nPoints) {
  if (nPoints > std::numeric_limits<int>::max())
    throw DeckError(generator.place() + fmt::format(": {} asks for {:.3g} points, more than the 2.1e9 that fit",
                                                    generator.path(), nPoints));
  MeshPoints points;
  points.fileName = deck.fileName();
  points.rowName = "point";
  const auto n = static_cast<std::size_t>(nPoints);
  try {
    points.x.reserve(3 * n);
    points.volume.reserve(n);
    points.blockId.reserve(n);
    points.line.reserve(n);
  } catch (const std::bad_alloc&) {
    throw DeckError(generator.place() + ": " +
                    outOfMemory(fmt::format("the {} points that {} asks for", n, generator.path())));
  }
  return points;
}

void addPoint(MeshPoints& points, double x, double y, double z, double volume) {
  points.x.insert(points.x.end(), {x, y, z});
  points.volume.push_back(volume);
  points.blockId.push_back(1);
  points.line.push_back(++points.nRows);
}

MeshPoints makeBox(const Deck& deck, const DeckNode& generator) {
  const auto [x, y, z] = boxCells(generator);
  MeshPoints points = emptyMesh(
      deck, generator, static_cast<double>(x.count) * static_cast<double>(y.count) * static_cast<double>(z.count));
  const double volume = x.size() * y.size() * z.size();
  for (long long k = 0; k < z.count; ++k)
    for (long long j = 0; j < y.count; ++j)
      for (long long i = 0; i < x.count; ++i) addPoint(points, x.center(i), y.center(j), z.center(k), volume);
  return points;
}

MeshPoints makeCylinder(const Deck& deck, const DeckNode& generator) {
  const DeckNode innerNode = required(generator, "Inner Radius");
  const double inner = innerNode.real(), outer = length(generator, "Outer Radius");
  if (!(inner >= 0.0 && inner < outer))
    throw DeckError(innerNode.place() + ": " + innerNode.path() + " must be 0 or more and less than the Outer Radius");
  const Cells r{count(generator, "Number Points Radius"), inner, outer - inner};
  const double meanRadius = 0.5 * (inner + outer), axisLength = length(generator, "Cylinder Length");
  constexpr double pi = 3.14159265358979323846;
  const Cells angle{static_cast<long long>(2.0 * pi / (r.size() / meanRadius)) + 1, 0.0, 2.0 * pi};
  const Cells z{static_cast<long long>(axisLength / r.size()) + 1, required(generator, "Z Origin").real(), axisLength};
  const double xCenter = required(generator, "Ring Center x").real(),
               yCenter = required(generator, "Ring Center y").real();
  MeshPoints points = emptyMesh(
      deck, generator, static_cast<double>(r.count) * static_cast<double>(angle.count) * static_cast<double>(z.count));
  for (long long k = 0; k < z.count; ++k)
    for (long long j = 0; j < angle.count; ++j)
      for (long long i = 0; i < r.count; ++i) {
        const double radius = r.center(i);
        addPoint(points, xCenter + radius * std::cos(angle.center(j)), yCenter + radius * std::sin(angle.center(j)),
                 z.center(k), radius * r.size() * angle.size() * z.size());
      }
  return points;
}

/// The generator that the section has; both or none is a mistake.
DeckNode generatorOf(const DeckNode& section) {
  const DeckNode box = section[boxName], cylinder = section[cylinderName];
  if (box.exists() == cylinder.exists())
    throw DeckError(section.place() + ": Discretization needs one of " + boxName + " and " + cylinderName);
  return box ? box : cylinder;
}

bool hasBoxNeighborhoods(const Deck& deck) {
  return deck["Discretization"].text("NeighborhoodType", deck.isPeridigmDeck() ? "Box" : "Spherical") == "Box";
}

}  // namespace

MeshPoints makeQuickGrid(const Deck& deck) {
  const DeckNode section = deck["Discretization"], generator = generatorOf(section);
  if (section[boxName]) return makeBox(deck, generator);
  if (hasBoxNeighborhoods(deck))
    throw DeckError(section.place() + ": a cylinder needs \"NeighborhoodType: Spherical\" in Discretization");
  return makeCylinder(deck, generator);
}

std::optional<std::array<double, 3>> quickGridNeighborBox(const Deck& deck, double horizon) {
  if (!hasBoxNeighborhoods(deck)) return std::nullopt;
  std::array<double, 3> box{};
  const std::array<Cells, 3> cells = boxCells(generatorOf(deck["Discretization"]));
  for (std::size_t k = 0; k < 3; ++k) box[k] = (std::floor(horizon / cells[k].size() + 0.5) + 0.5) * cells[k].size();
  return box;
}

}  // namespace pd
