#include "void_lists.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "../deck/deck_data.hpp"
#include "../deck/vector3.hpp"
#include "text_file.hpp"

namespace pd {

using decomposition::Place;

namespace {

/// Whether two segments in the plane have a place in common.
bool doMeet(const Place& a, const Place& b, const Place& c, const Place& d) {
  const auto side = [](const Place& from, const Place& to, const Place& place) {
    return cross(decomposition::minus(to, from), decomposition::minus(place, from))[2];
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

/// Calls visit(line, numbers) for each line of `width` finite numbers; others are mistakes. `columns`: what they are.
template <std::size_t width, class Visit>
void forEachRow(const std::string& text, const std::string& columns, FileMistakes& mistakes, Visit visit) {
  DataLines lines(text);
  while (lines.next()) {
    std::array<double, width> numbers{};
    std::size_t count = 0;
    std::string problem;
    for (std::string_view word = lines.word(); !word.empty(); word = lines.word(), ++count) {
      const std::optional<double> value = parseReal(std::string(word));
      if (!value && problem.empty()) problem = quoted(word) + " is not a finite number";
      if (value && count < width) numbers[count] = *value;
    }
    if (count != width) problem = fmt::format("a line has {} numbers, {}; this one has {}", width, columns, count);
    if (problem.empty())
      visit(lines.number(), numbers);
    else
      mistakes.add(lines.number(), problem);
  }
}

struct NumberedPolygon {
  double number = 0.0;
  int line = 0;  ///< of its first corner
  std::vector<Place> corners;
};

}  // namespace

DiscontinuityForm ellipsoidForm(const decomposition::Ellipsoid& shape) {
  DiscontinuityForm form;
  form.screens.push_back(decomposition::ellipsoidScreen(shape));
  form.voids.push_back(decomposition::ellipsoidVoid(shape));
  return form;
}

DiscontinuityForm ballForm(const Place& center, double radius, int dimension) {
  decomposition::Ellipsoid ball{center, {{radius, 0.0, 0.0}, {0.0, radius, 0.0}}};
  if (dimension == 3) ball.halfAxes.push_back({0.0, 0.0, radius});
  return ellipsoidForm(ball);
}

DiscontinuityForm polygonForm(const std::vector<Place>& corners) {
  DiscontinuityForm form;
  for (std::size_t k = 0; k < corners.size(); ++k)
    form.screens.push_back(decomposition::segmentScreen(corners[k], corners[(k + 1) % corners.size()]));
  form.voids.push_back(decomposition::polygonVoid(corners));
  return form;
}

std::string complaintOfOutline(const std::vector<Place>& corners) {
  const std::size_t n = corners.size();
  if (n < 3) return "has less than three corners";
  if (corners.front() == corners.back()) return "closes by itself: leave the last corner out";
  for (std::size_t i = 0; i < n; ++i) {
    const Place &a = corners[i], &b = corners[(i + 1) % n], &c = corners[(i + 2) % n];
    const Place first = decomposition::minus(b, a), second = decomposition::minus(c, b);
    if (a == b) return "has the same place twice in turn";
    if (cross(first, second)[2] == 0.0 && dot(first, second) < 0.0)
      return fmt::format("goes back on itself at its corner {}", (i + 1) % n + 1);
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && doMeet(a, b, corners[j], corners[(j + 1) % n]))
        return fmt::format("crosses or touches itself: its sides {} and {}; cut it into several entries", i + 1, j + 1);
  }
  return "";
}

std::vector<DiscontinuityForm> readSphereList(const GeometryFile& file) {
  std::vector<DiscontinuityForm> forms;
  Mistakes all;
  {
    FileMistakes mistakes(file.name, all);
    forEachRow<4>(file.text, "x y z radius", mistakes, [&](int line, const std::array<double, 4>& row) {
      if (!(row[3] > 0.0)) return mistakes.add(line, "the radius (fourth column) must be greater than 0 m");
      forms.push_back(ballForm({row[0], row[1], row[2]}, row[3], 3));
      forms.back().place = fmt::format("{}:{}", file.name, line);
    });
  }
  if (forms.empty()) all.add(file.name, "has no spheres (one a line: x y z radius)");
  all.report();
  return forms;
}

std::vector<DiscontinuityForm> readPolygonList(const GeometryFile& file) {
  std::vector<NumberedPolygon> polygons;
  std::vector<DiscontinuityForm> forms;
  Mistakes all;
  {
    FileMistakes mistakes(file.name, all);
    forEachRow<3>(file.text, "polygon x y", mistakes, [&](int line, const std::array<double, 3>& row) {
      if (polygons.empty() || row[0] != polygons.back().number) {
        const bool isBack = std::any_of(polygons.begin(), polygons.end(),
                                        [&](const NumberedPolygon& polygon) { return polygon.number == row[0]; });
        if (isBack) mistakes.add(line, fmt::format("polygon {:g} goes on here, after another one", row[0]));
        polygons.push_back({row[0], line, {}});
      }
      polygons.back().corners.push_back({row[1], row[2], 0.0});
    });
    for (const NumberedPolygon& polygon : polygons) {
      if (const std::string complaint = complaintOfOutline(polygon.corners); !complaint.empty()) {
        mistakes.add(polygon.line, fmt::format("polygon {:g} {}", polygon.number, complaint));
        continue;
      }
      forms.push_back(polygonForm(polygon.corners));
      forms.back().place = fmt::format("{}:{}", file.name, polygon.line);
    }
  }
  if (polygons.empty()) all.add(file.name, "has no polygons (one corner a line: polygon x y)");
  all.report();
  return forms;
}

}  // namespace pd
