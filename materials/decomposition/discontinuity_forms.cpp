#include "discontinuity_forms.hpp"

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <cmath>

namespace pd::decomposition {

namespace {

using Params = Teuchos::ParameterList;

/// Places in turn of `dimension` numbers each, `least` of them at least, no two that follow each other alike.
std::vector<Place> placesOf(const Params& params, const std::string& key, int dimension, std::size_t least) {
  const auto numbers = params.get<Teuchos::Array<double>>(key);
  const auto width = static_cast<std::size_t>(dimension), n = static_cast<std::size_t>(numbers.size());
  if (n % width != 0 || n < least * width)
    throw FormError(key, "must be " + std::to_string(dimension) + " numbers for each of " + std::to_string(least) +
                             " places or more, in turn; there are " + std::to_string(n) + " numbers");
  std::vector<Place> places(n / width);
  for (std::size_t k = 0; k < n; ++k) places[k / width][k % width] = numbers[static_cast<int>(k)];
  for (std::size_t k = 1; k < places.size(); ++k)
    if (places[k] == places[k - 1]) throw FormError(key, "has the same place twice in turn");
  return places;
}

/// One place or direction.
Place placeOf(const Params& params, const std::string& key, int dimension) {
  const auto numbers = params.get<Teuchos::Array<double>>(key);
  if (numbers.size() != dimension)
    throw FormError(key, dimension == 2 ? "must be two numbers, [x, y]" : "must be three numbers, [x, y, z]");
  Place place{};
  std::copy(numbers.begin(), numbers.end(), place.begin());
  return place;
}

Place directionOf(const Params& params, const std::string& key) {
  const Place direction = placeOf(params, key, 3);
  if (!(lengthOf(direction) > 0.0)) throw FormError(key, "is a zero vector, not a direction");
  return direction;
}

/// As long as a half axis, which must be greater than 0.
Place halfAxis(const std::string& key, const Place& direction, double half) {
  if (!(half > 0.0)) throw FormError(key, "must be greater than 0 m");
  return plus({}, direction, half / lengthOf(direction));
}

Ellipsoid ellipseOf(const Params& params) {
  const std::string key = "Half Axes";
  const auto half = params.get<Teuchos::Array<double>>(key);
  if (half.size() != 2) throw FormError(key, "must be two numbers, [a, b]");
  const double angle = params.get<double>("Angle"), c = std::cos(angle), s = std::sin(angle);
  return {placeOf(params, "Center", 2), {halfAxis(key, {c, s, 0.0}, half[0]), halfAxis(key, {-s, c, 0.0}, half[1])}};
}

Ellipsoid ellipsoidOf(const Params& params) {
  const std::string key = "Half Axes";
  const auto half = params.get<Teuchos::Array<double>>(key);
  if (half.size() != 3) throw FormError(key, "must be three numbers, [a, b, c]");
  const Place first = params.isParameter("First Axis") ? directionOf(params, "First Axis") : Place{1.0, 0.0, 0.0};
  Place second = params.isParameter("Second Axis") ? directionOf(params, "Second Axis") : Place{0.0, 1.0, 0.0};
  const double given = lengthOf(second);
  second = plus(second, first, -dot(first, second) / dot(first, first));
  if (!(lengthOf(second) > 1e-6 * given)) throw FormError("Second Axis", "is along First Axis");
  return {
      placeOf(params, "Center", 3),
      {halfAxis(key, first, half[0]), halfAxis(key, second, half[1]), halfAxis(key, crossed(first, second), half[2])}};
}

Ellipsoid cylinderOf(const Params& params) {
  const Place axis = directionOf(params, "Axis");
  const double radius = params.get<double>("Radius");
  // Any direction across the axis, and the one across both.
  const std::size_t least = std::abs(axis[0]) < std::abs(axis[1]) ? (std::abs(axis[0]) < std::abs(axis[2]) ? 0 : 2)
                                                                  : (std::abs(axis[1]) < std::abs(axis[2]) ? 1 : 2);
  Place unit{};
  unit[least] = 1.0;
  const Place across = crossed(axis, unit);
  return {placeOf(params, "Center", 3),
          {halfAxis("Radius", across, radius), halfAxis("Radius", crossed(axis, across), radius)}};
}

/// Corners of a flat, convex polygon.
void requireFlatAndConvex(const std::string& key, const std::vector<Place>& corners) {
  Place normal{};
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    normal = plus(normal, crossed(minus(corners[k], corners[0]), minus(corners[k + 1], corners[0])));
  const double size = std::sqrt(lengthOf(normal));
  if (!(size > 0.0)) throw FormError(key, "has no area");
  if (corners.front() == corners.back()) throw FormError(key, "closes by itself: leave the last corner out");
  double turned = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Place &a = corners[k], &b = corners[(k + 1) % corners.size()], &c = corners[(k + 2) % corners.size()];
    if (std::abs(dot(minus(a, corners[0]), normal)) > 1e-6 * size * size * size) throw FormError(key, "is not flat");
    const Place first = minus(b, a), second = minus(c, b);
    turned += std::atan2(lengthOf(crossed(first, second)), dot(first, second));
    if (dot(crossed(first, second), normal) < 0.0)
      throw FormError(key, "is not convex; cut it into convex parts, each an entry");
  }
  if (turned > 7.0) throw FormError(key, "goes round more than once");  // 2 pi, once
}

/// Whether two segments in the plane have a place in common.
bool doMeet(const Place& a, const Place& b, const Place& c, const Place& d) {
  const auto side = [](const Place& from, const Place& to, const Place& place) {
    return crossed(minus(to, from), minus(place, from))[2];
  };
  const auto isWithin = [](const Place& from, const Place& to, const Place& place) {
    return std::min(from[0], to[0]) <= place[0] && place[0] <= std::max(from[0], to[0]) &&
           std::min(from[1], to[1]) <= place[1] && place[1] <= std::max(from[1], to[1]);
  };
  const double ofC = side(a, b, c), ofD = side(a, b, d), ofA = side(c, d, a), ofB = side(c, d, b);
  if (ofC * ofD < 0.0 && ofA * ofB < 0.0) return true;
  return (ofC == 0.0 && isWithin(a, b, c)) || (ofD == 0.0 && isWithin(a, b, d)) || (ofA == 0.0 && isWithin(c, d, a)) ||
         (ofB == 0.0 && isWithin(c, d, b));
}

}  // namespace

DiscontinuityForm ellipsoidForm(const Ellipsoid& shape) {
  DiscontinuityForm form;
  form.screens.push_back(ellipsoidScreen(shape));
  form.voids.push_back(ellipsoidVoid(shape));
  return form;
}

DiscontinuityForm ballForm(const Place& center, double radius, int dimension) {
  Ellipsoid ball{center, {{radius, 0.0, 0.0}, {0.0, radius, 0.0}}};
  if (dimension == 3) ball.halfAxes.push_back({0.0, 0.0, radius});
  return ellipsoidForm(ball);
}

DiscontinuityForm polygonForm(const std::vector<Place>& corners) {
  DiscontinuityForm form;
  for (std::size_t k = 0; k < corners.size(); ++k)
    form.screens.push_back(segmentScreen(corners[k], corners[(k + 1) % corners.size()]));
  form.voids.push_back(polygonVoid(corners));
  return form;
}

std::string complaintOfOutline(const std::vector<Place>& corners) {
  const std::size_t n = corners.size();
  if (n < 3) return "has less than three corners";
  if (corners.front() == corners.back()) return "closes by itself: leave the last corner out";
  for (std::size_t i = 0; i < n; ++i) {
    const Place &a = corners[i], &b = corners[(i + 1) % n], &c = corners[(i + 2) % n];
    const Place first = minus(b, a), second = minus(c, b);
    if (a == b) return "has the same place twice in turn";
    if (crossed(first, second)[2] == 0.0 && dot(first, second) < 0.0)
      return "goes back on itself at its corner " + std::to_string((i + 1) % n + 1);
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && doMeet(a, b, corners[j], corners[(j + 1) % n]))
        return "crosses or touches itself: its sides " + std::to_string(i + 1) + " and " + std::to_string(j + 1) +
               "; cut it into several entries";
  }
  return "";
}

DiscontinuityForm crackFrom(const Params& params) {
  const auto type = params.get<std::string>("Type");
  DiscontinuityForm form;
  if (type == "Polyline") {
    const std::vector<Place> places = placesOf(params, "Points", 2, 2);
    for (std::size_t k = 1; k < places.size(); ++k) form.screens.push_back(segmentScreen(places[k - 1], places[k]));
  } else if (type == "Polygon") {
    const std::vector<Place> corners = placesOf(params, "Corners", 3, 3);
    requireFlatAndConvex("Corners", corners);
    form.screens.push_back(polygonScreen(corners));
  } else {
    form.screens.push_back(
        diskScreen(placeOf(params, "Center", 3), directionOf(params, "Normal"), params.get<double>("Radius")));
  }
  return form;
}

DiscontinuityForm voidFrom(const Params& params) {
  const auto type = params.get<std::string>("Type");
  if (type == "Ellipse") return ellipsoidForm(ellipseOf(params));
  if (type == "Ellipsoid") return ellipsoidForm(ellipsoidOf(params));
  if (type == "Cylinder") return ellipsoidForm(cylinderOf(params));
  if (type == "Polygon") {
    const std::vector<Place> corners = placesOf(params, "Corners", 2, 3);
    if (const std::string complaint = complaintOfOutline(corners); !complaint.empty())
      throw FormError("Corners", complaint);
    return polygonForm(corners);
  }
  const int dimension = voidForms().at(type).dimension;
  return ballForm(placeOf(params, "Center", dimension), params.get<double>("Radius"), dimension);
}

}  // namespace pd::decomposition
