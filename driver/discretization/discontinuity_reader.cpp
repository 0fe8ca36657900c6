#include "discontinuity_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "../deck/vector3.hpp"
#include "stl_file.hpp"
#include "void_lists.hpp"

namespace pd {

using decomposition::Ellipsoid;
using decomposition::Place;

namespace {

[[noreturn]] void refuseForm(const DeckNode& node, const std::string& what) {
  throw DeckError(node.place() + ": " + node.path() + " " + what);
}

std::vector<double> realsOf(const DeckNode& entry, const std::string& key) {
  std::vector<double> numbers;
  for (const DeckNode& item : required(entry, key).items()) numbers.push_back(item.real());
  return numbers;
}

/// Of one place or direction in the dimension of the body.
Place placeIn(const DeckNode& entry, const std::string& key, int dimension) {
  const std::vector<double> numbers = realsOf(entry, key);
  if (static_cast<int>(numbers.size()) != dimension)
    refuseForm(entry[key], dimension == 2 ? "must be two numbers, [x, y]" : "must be three numbers, [x, y, z]");
  Place place{};
  std::copy(numbers.begin(), numbers.end(), place.begin());
  return place;
}

Place axisOf(const DeckNode& entry, const std::string& key) {
  const Place direction = placeIn(entry, key, 3);
  if (!(length(direction) > 0.0)) refuseForm(entry[key], "is a zero vector, not a direction");
  return direction;
}

/// Places in turn, `least` of them at least, no two that follow each other alike.
std::vector<Place> placesOf(const DeckNode& entry, const std::string& key, int dimension, std::size_t least) {
  const std::vector<double> numbers = realsOf(entry, key);
  const auto width = static_cast<std::size_t>(dimension);
  if (numbers.size() % width != 0 || numbers.size() < least * width)
    refuseForm(entry[key], "must be " + std::to_string(dimension) + " numbers for each of " + std::to_string(least) +
                               " places or more, in turn; there are " + std::to_string(numbers.size()) + " numbers");
  std::vector<Place> places(numbers.size() / width);
  for (std::size_t k = 0; k < numbers.size(); ++k) places[k / width][k % width] = numbers[k];
  for (std::size_t k = 1; k < places.size(); ++k)
    if (places[k] == places[k - 1]) refuseForm(entry[key], "has the same place twice in turn");
  return places;
}

/// As long as a half axis, which must be greater than 0.
Place halfAxis(const DeckNode& lengths, const Place& direction, double half) {
  if (!(half > 0.0)) refuseForm(lengths, "must be greater than 0 m");
  return decomposition::plus({}, direction, half / length(direction));
}

Ellipsoid ellipseOf(const DeckNode& entry) {
  const std::vector<double> half = realsOf(entry, "Half Axes");
  if (half.size() != 2) refuseForm(entry["Half Axes"], "must be two numbers, [a, b]");
  const double angle = entry.real("Angle", 0.0), c = std::cos(angle), s = std::sin(angle);
  return {placeIn(entry, "Center", 2),
          {halfAxis(entry["Half Axes"], {c, s, 0.0}, half[0]), halfAxis(entry["Half Axes"], {-s, c, 0.0}, half[1])}};
}

Ellipsoid ellipsoidOf(const DeckNode& entry) {
  const std::vector<double> half = realsOf(entry, "Half Axes");
  if (half.size() != 3) refuseForm(entry["Half Axes"], "must be three numbers, [a, b, c]");
  const Place first = entry["First Axis"] ? axisOf(entry, "First Axis") : Place{1.0, 0.0, 0.0};
  Place second = entry["Second Axis"] ? axisOf(entry, "Second Axis") : Place{0.0, 1.0, 0.0};
  const double given = length(second);
  second = decomposition::plus(second, first, -dot(first, second) / dot(first, first));
  if (!(length(second) > 1e-6 * given)) refuseForm(entry["Second Axis"], "is along First Axis");
  const DeckNode lengths = entry["Half Axes"];
  return {placeIn(entry, "Center", 3),
          {halfAxis(lengths, first, half[0]), halfAxis(lengths, second, half[1]),
           halfAxis(lengths, cross(first, second), half[2])}};
}

Ellipsoid cylinderOf(const DeckNode& entry) {
  const Place axis = axisOf(entry, "Axis");
  const double radius = required(entry, "Radius").real();
  // Any direction across the axis, and the one across both.
  const std::size_t least = std::abs(axis[0]) < std::abs(axis[1]) ? (std::abs(axis[0]) < std::abs(axis[2]) ? 0 : 2)
                                                                  : (std::abs(axis[1]) < std::abs(axis[2]) ? 1 : 2);
  Place unit{};
  unit[least] = 1.0;
  const Place across = cross(axis, unit);
  return {placeIn(entry, "Center", 3),
          {halfAxis(entry["Radius"], across, radius), halfAxis(entry["Radius"], cross(axis, across), radius)}};
}

DiscontinuityForm polygonalHole(const DeckNode& entry) {
  const std::vector<Place> corners = placesOf(entry, "Corners", 2, 3);
  if (const std::string complaint = complaintOfOutline(corners); !complaint.empty())
    refuseForm(entry["Corners"], complaint);
  return polygonForm(corners);
}

DiscontinuityForm sphereOrCircle(const DeckNode& entry, int dimension) {
  return ballForm(placeIn(entry, "Center", dimension), required(entry, "Radius").real(), dimension);
}

std::vector<DiscontinuityForm> fromFile(const DeckNode& entry, const std::string& type,
                                        const ReadGeometryFile& readFile) {
  const GeometryFile file = readFile(required(entry, "File Name"));
  if (type == "Sphere List") return readSphereList(file);
  if (type == "Polygon List") return readPolygonList(file);
  const Place shift = entry["Shift"] ? placeIn(entry, "Shift", 3) : Place{};
  std::vector<DiscontinuityForm> forms;
  for (const decomposition::TriangleSurface& surface : readStl(file.text, file.name, entry.real("Scale", 1.0), shift)) {
    forms.emplace_back().screens = decomposition::surfaceScreens(surface);
    forms.back().voids.push_back(decomposition::surfaceVoid(surface));
  }
  return forms;
}

/// Corners of a flat, convex polygon.
void requireFlatAndConvex(const DeckNode& node, const std::vector<Place>& corners) {
  Place normal{};
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    normal = decomposition::plus(
        normal, cross(decomposition::minus(corners[k], corners[0]), decomposition::minus(corners[k + 1], corners[0])));
  const double size = std::sqrt(length(normal));
  if (!(size > 0.0)) refuseForm(node, "has no area");
  if (corners.front() == corners.back()) refuseForm(node, "closes by itself: leave the last corner out");
  double turned = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Place &a = corners[k], &b = corners[(k + 1) % corners.size()], &c = corners[(k + 2) % corners.size()];
    if (std::abs(dot(decomposition::minus(a, corners[0]), normal)) > 1e-6 * size * size * size)
      refuseForm(node, "is not flat");
    const Place first = decomposition::minus(b, a), second = decomposition::minus(c, b);
    turned += std::atan2(length(cross(first, second)), dot(first, second));
    if (dot(cross(first, second), normal) < 0.0)
      refuseForm(node, "is not convex; cut it into convex parts, each an entry");
  }
  if (turned > 7.0) refuseForm(node, "goes round more than once");  // 2 pi, once
}

void requireFormOf(const DeckNode& entry, int wanted, int dimension) {
  if (wanted == dimension) return;
  refuseForm(entry["Type"], wanted == 2 ? "is a form in the plane, but the mesh fills space"
                                        : "is a form in space, but the mesh fills a plane");
}

}  // namespace

DiscontinuityForm readCrack(const DeckNode& node, int dimension) {
  const std::string type = required(node, "Type").text();
  requireFormOf(node, type == "Polyline" ? 2 : 3, dimension);
  DiscontinuityForm form;
  if (type == "Polyline") {
    const std::vector<Place> places = placesOf(node, "Points", 2, 2);
    for (std::size_t k = 1; k < places.size(); ++k)
      form.screens.push_back(decomposition::segmentScreen(places[k - 1], places[k]));
  } else if (type == "Polygon") {
    const std::vector<Place> corners = placesOf(node, "Corners", 3, 3);
    requireFlatAndConvex(node["Corners"], corners);
    form.screens.push_back(decomposition::polygonScreen(corners));
  } else {
    form.screens.push_back(
        decomposition::diskScreen(placeIn(node, "Center", 3), axisOf(node, "Normal"), required(node, "Radius").real()));
  }
  return form;
}

std::vector<DiscontinuityForm> readVoid(const DeckNode& node, int dimension, const ReadGeometryFile& readFile) {
  const std::string type = required(node, "Type").text();
  const bool isPlane = type == "Circle" || type == "Ellipse" || type == "Polygon" || type == "Polygon List";
  requireFormOf(node, isPlane ? 2 : 3, dimension);
  if (type == "Sphere List" || type == "Polygon List" || type == "Surface") return fromFile(node, type, readFile);
  std::vector<DiscontinuityForm> forms;
  forms.push_back(type == "Polygon"     ? polygonalHole(node)
                  : type == "Ellipse"   ? ellipsoidForm(ellipseOf(node))
                  : type == "Ellipsoid" ? ellipsoidForm(ellipsoidOf(node))
                  : type == "Cylinder"  ? ellipsoidForm(cylinderOf(node))
                                        : sphereOrCircle(node, dimension));
  return forms;
}

}  // namespace pd
