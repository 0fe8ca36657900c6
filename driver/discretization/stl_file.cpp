#include "stl_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>

#include "../deck/deck_data.hpp"
#include "surface_check.hpp"
#include "text_file.hpp"

namespace pd {

using decomposition::Place;
using decomposition::TriangleSurface;

namespace {

struct StlTriangle {
  std::array<Place, 3> corners;
  std::string place;  ///< in the file
};

constexpr std::size_t binaryHead = 84, binaryTriangle = 50;  ///< bytes; the number of triangles ends the head

std::uint32_t binaryCount(const std::string& text) {
  std::uint32_t count = 0;
  std::memcpy(&count, text.data() + binaryHead - sizeof count, sizeof count);
  return count;
}

/// Binary files begin with any text, "solid" too: their length tells.
bool isBinary(const std::string& text) {
  return text.size() >= binaryHead && text.size() == binaryHead + binaryTriangle * std::size_t{binaryCount(text)};
}

std::vector<StlTriangle> readBinary(const std::string& text, const std::string& fileName) {
  std::vector<StlTriangle> triangles(binaryCount(text));
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    triangles[t].place = fmt::format("{}: triangle {}", fileName, t + 1);
    std::array<float, 9> numbers{};
    std::memcpy(numbers.data(), text.data() + binaryHead + binaryTriangle * t + 3 * sizeof(float), sizeof numbers);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (!std::isfinite(numbers[k])) throw DeckError(triangles[t].place + ": has a corner that is no finite number");
      triangles[t].corners[k / 3][k % 3] = numbers[k];
    }
  }
  return triangles;
}

/// Keywords in capitals are good, too.
std::string inSmallLetters(std::string_view word) {
  std::string small(word);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

/// Goes through the words of an STL file in text.
class StlText {
 public:
  StlText(const std::string& text, const std::string& fileName) : lines_(text), fileName_(fileName) {}

  std::vector<StlTriangle> read() {
    std::vector<StlTriangle> triangles;
    while (lines_.next()) {
      const std::string_view word = lines_.word();
      const std::string keyword = inSmallLetters(word);
      if (keyword == "solid" || keyword == "endsolid") continue;
      if (keyword != "facet") refuse("expected \"facet normal\", \"solid\" or \"endsolid\", found " + quoted(word));
      StlTriangle& triangle = triangles.emplace_back();
      triangle.place = place();
      expectLine("outer");
      for (Place& corner : triangle.corners) {
        expectLine("vertex");
        for (double& coordinate : corner) coordinate = number();
      }
      expectLine("endloop");
      expectLine("endfacet");
    }
    return triangles;
  }

 private:
  std::string place() const { return fmt::format("{}:{}", fileName_, lines_.number()); }
  [[noreturn]] void refuse(const std::string& what) const { throw DeckError(place() + ": " + what); }

  void expectLine(const std::string& first) {
    if (!lines_.next()) refuse("the file ends within a triangle, where \"" + first + "\" should follow");
    const std::string_view word = lines_.word();
    if (inSmallLetters(word) != first)
      refuse("expected \"" + first + "\", found " + quoted(word) + "; a facet has three vertices");
  }

  double number() {
    const std::string_view word = lines_.word();
    const std::optional<double> value = parseReal(std::string(word));
    if (!value) refuse("a vertex has three finite numbers, x y z; found " + quoted(word));
    return *value;
  }

  DataLines lines_;
  const std::string& fileName_;
};

/// Corners at the same place become one vertex.
TriangleSurface welded(const std::vector<StlTriangle>& triangles, double scale, const Place& shift) {
  TriangleSurface surface;
  std::map<Place, std::size_t> known;
  for (const StlTriangle& triangle : triangles) {
    std::array<std::size_t, 3> numbers{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Place place = decomposition::plus({}, triangle.corners[k]);  // one zero for both signs
      const auto [it, isNew] = known.emplace(place, surface.vertices.size());
      if (isNew) surface.vertices.push_back(decomposition::plus(shift, place, scale));
      numbers[k] = it->second;
    }
    surface.triangles.push_back(numbers);
  }
  return surface;
}

}  // namespace

std::vector<TriangleSurface> readStl(const std::string& text, const std::string& fileName, double scale,
                                     const Place& shift) {
  const bool isSolid = inSmallLetters(text.substr(0, 5)) == "solid";
  const bool isText = isSolid && text.find('\0') == std::string::npos;
  if (!isBinary(text) && isSolid && !isText && text.size() >= binaryHead)
    throw DeckError(fmt::format("{}: is a damaged STL file: a binary one of {} triangles has {} bytes, not {}",
                                fileName, binaryCount(text),
                                binaryHead + binaryTriangle * std::size_t{binaryCount(text)}, text.size()));
  if (!isBinary(text) && !isText)
    throw DeckError(fileName +
                    (text.size() < binaryHead
                         ? ": is no STL file: it begins with no \"solid\" and is too short to be binary"
                         : fmt::format(": is no STL file: it begins with no \"solid\", and a binary one of {} "
                                       "triangles has {} bytes, not {}",
                                       binaryCount(text), binaryHead + binaryTriangle * std::size_t{binaryCount(text)},
                                       text.size())));
  const std::vector<StlTriangle> triangles =
      isBinary(text) ? readBinary(text, fileName) : StlText(text, fileName).read();
  if (triangles.empty()) throw DeckError(fileName + ": has no triangles");
  const TriangleSurface surface = welded(triangles, scale, shift);
  Mistakes mistakes;
  const std::vector<SurfaceFault> faults = faultsOf(surface);
  constexpr std::size_t maximumListed = 20;
  for (std::size_t k = 0; k < std::min(faults.size(), maximumListed); ++k)
    mistakes.add(triangles[faults[k].triangle].place, faults[k].what);
  if (faults.size() > maximumListed)
    mistakes.add(fileName, fmt::format("{} more mistakes of this file are not listed", faults.size() - maximumListed));
  mistakes.report();
  return partsOf(surface);
}

}  // namespace pd
