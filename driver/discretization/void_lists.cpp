#include "void_lists.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "../deck/deck_data.hpp"
#include "text_file.hpp"

namespace pd {

using decomposition::Place;

namespace {

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

std::vector<DiscontinuityForm> readSphereList(const GeometryFile& file) {
  std::vector<DiscontinuityForm> forms;
  Mistakes all;
  {
    FileMistakes mistakes(file.name, all);
    forEachRow<4>(file.text, "x y z radius", mistakes, [&](int line, const std::array<double, 4>& row) {
      if (!(row[3] > 0.0)) return mistakes.add(line, "the radius (fourth column) must be greater than 0 m");
      forms.emplace_back(decomposition::ballForm({row[0], row[1], row[2]}, row[3], 3),
                         fmt::format("{}:{}", file.name, line));
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
      if (const std::string complaint = decomposition::complaintOfOutline(polygon.corners); !complaint.empty()) {
        mistakes.add(polygon.line, fmt::format("polygon {:g} {}", polygon.number, complaint));
        continue;
      }
      forms.emplace_back(decomposition::polygonForm(polygon.corners), fmt::format("{}:{}", file.name, polygon.line));
    }
  }
  if (polygons.empty()) all.add(file.name, "has no polygons (one corner a line: polygon x y)");
  all.report();
  return forms;
}

}  // namespace pd
