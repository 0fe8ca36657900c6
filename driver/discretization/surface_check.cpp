#include "surface_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace pd {

using decomposition::Place;
using decomposition::TriangleSurface;

namespace {

using Corners = std::array<std::size_t, 3>;

std::string textOf(const Place& place) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g}) m", place[0], place[1], place[2]);
}

std::vector<SurfaceFault> emptyTriangles(const TriangleSurface& surface) {
  std::vector<SurfaceFault> faults;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Corners& c = surface.triangles[t];
    const Place &a = surface.vertices[c[0]], &b = surface.vertices[c[1]], &p = surface.vertices[c[2]];
    const double longest2 = std::max({decomposition::dot(decomposition::minus(b, a), decomposition::minus(b, a)),
                                      decomposition::dot(decomposition::minus(p, b), decomposition::minus(p, b)),
                                      decomposition::dot(decomposition::minus(a, p), decomposition::minus(a, p))});
    const Place normal = decomposition::crossed(decomposition::minus(b, a), decomposition::minus(p, a));
    if (!(decomposition::dot(normal, normal) > 1e-24 * longest2 * longest2))
      faults.push_back({t, "this triangle has no area"});
  }
  return faults;
}

std::vector<SurfaceFault> openEdges(const TriangleSurface& surface) {
  std::vector<SurfaceFault> faults;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> owner;
  const auto edge = [&](std::size_t from, std::size_t to) {
    return "the edge from " + textOf(surface.vertices[from]) + " to " + textOf(surface.vertices[to]);
  };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = surface.triangles[t][k], to = surface.triangles[t][(k + 1) % 3];
      const auto [it, isNew] = owner.emplace(std::pair(from, to), t);
      if (!isNew)
        faults.push_back(
            {t, fmt::format("{} is that of triangle {} in the same direction: one of the two is turned over, "
                            "or more than two triangles meet there",
                            edge(from, to), it->second + 1)});
    }
  for (const auto& [ends, t] : owner)
    if (owner.count({ends.second, ends.first}) == 0)
      faults.push_back({t, edge(ends.first, ends.second) +
                               " belongs to no other triangle in the opposite direction: the surface is open there, a "
                               "neighbour is turned over, or its corners differ in their last digits"});
  std::stable_sort(faults.begin(), faults.end(),
                   [](const SurfaceFault& a, const SurfaceFault& b) { return a.triangle < b.triangle; });
  return faults;
}

/// [triangles] number of the part that each belongs to, from 0 in the order of the triangles. Parts hang together by
/// edges: those that touch in a vertex are two bodies, each of which may be convex.
std::vector<std::size_t> partNumbers(const TriangleSurface& surface) {
  std::vector<std::size_t> parent(surface.triangles.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  };
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> owner;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto ends = std::minmax(surface.triangles[t][k], surface.triangles[t][(k + 1) % 3]);
      parent[root(t)] = root(owner.emplace(ends, t).first->second);
    }
  std::map<std::size_t, std::size_t> numbers;
  std::vector<std::size_t> part;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    part.push_back(numbers.emplace(root(t), numbers.size()).first->second);
  return part;
}

std::vector<SurfaceFault> turnedParts(const TriangleSurface& surface) {
  const std::vector<std::size_t> part = partNumbers(surface);
  std::vector<double> volume;
  std::vector<std::size_t> first;
  for (std::size_t t = 0; t < part.size(); ++t) {
    if (part[t] == volume.size()) {
      volume.push_back(0.0);
      first.push_back(t);
    }
    const Place& origin = surface.vertices[surface.triangles[first[part[t]]][0]];
    const Corners& c = surface.triangles[t];
    volume[part[t]] +=
        decomposition::dot(decomposition::minus(surface.vertices[c[0]], origin),
                           decomposition::crossed(decomposition::minus(surface.vertices[c[1]], origin),
                                                  decomposition::minus(surface.vertices[c[2]], origin))) /
        6.0;
  }
  std::vector<SurfaceFault> faults;
  for (std::size_t p = 0; p < volume.size(); ++p)
    if (!(volume[p] > 0.0))
      faults.push_back(
          {first[p], fmt::format("the closed surface of this triangle is turned inside out (volume {:.3g} m3): "
                                 "corners follow each other against the clock as seen from outside of a void",
                                 volume[p])});
  return faults;
}

/// Does the segment from p to q pass through the inside of the triangle?
bool passesThrough(const Place& p, const Place& q, const std::array<Place, 3>& triangle) {
  const Place normal = decomposition::crossed(decomposition::minus(triangle[1], triangle[0]),
                                              decomposition::minus(triangle[2], triangle[0]));
  const double tolerance = 1e-9 * std::pow(decomposition::dot(normal, normal), 0.75);
  const double ofP = decomposition::dot(decomposition::minus(p, triangle[0]), normal),
               ofQ = decomposition::dot(decomposition::minus(q, triangle[0]), normal);
  if (std::abs(ofP) <= tolerance || std::abs(ofQ) <= tolerance || (ofP > 0.0) == (ofQ > 0.0)) return false;
  const Place at = decomposition::plus(p, decomposition::minus(q, p), ofP / (ofP - ofQ));
  for (std::size_t k = 0; k < 3; ++k) {
    const Place side = decomposition::minus(triangle[(k + 1) % 3], triangle[k]);
    if (decomposition::dot(decomposition::crossed(side, decomposition::minus(at, triangle[k])), normal) <=
        1e-9 * decomposition::dot(normal, normal))
      return false;
  }
  return true;
}

class Crossings {
 public:
  explicit Crossings(const TriangleSurface& surface) : surface_(surface) {}

  /// Pairs of triangles of one part, the later one first.
  std::vector<SurfaceFault> find() const {
    const std::vector<std::size_t> part = partNumbers(surface_);
    std::vector<decomposition::Box> boxes;
    for (const Corners& c : surface_.triangles) boxes.push_back(boxOfTriangle(cornersOfTriangle(c)));
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return boxes[a].low[0] < boxes[b].low[0]; });
    std::vector<SurfaceFault> faults;
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size() && boxes[order[j]].low[0] <= boxes[order[i]].high[0]; ++j) {
        const std::size_t a = std::max(order[i], order[j]), b = std::min(order[i], order[j]);
        if (part[a] == part[b] && boxes[a].meets(boxes[b]) && (cuts(a, b) || cuts(b, a)))
          faults.push_back({a, fmt::format("this triangle passes through triangle {} of the same surface", b + 1)});
      }
    std::sort(faults.begin(), faults.end(),
              [](const SurfaceFault& a, const SurfaceFault& b) { return a.triangle < b.triangle; });
    return faults;
  }

 private:
  std::array<Place, 3> cornersOfTriangle(const Corners& c) const {
    return {surface_.vertices[c[0]], surface_.vertices[c[1]], surface_.vertices[c[2]]};
  }
  static decomposition::Box boxOfTriangle(const std::array<Place, 3>& corners) {
    decomposition::Box box{corners[0], corners[0]};
    for (const Place& corner : corners)
      for (std::size_t d = 0; d < 3; ++d) {
        box.low[d] = std::min(box.low[d], corner[d]);
        box.high[d] = std::max(box.high[d], corner[d]);
      }
    return box;
  }
  /// Edges of the first that end in a vertex of the second touch it there, no more.
  bool cuts(std::size_t first, std::size_t second) const {
    const Corners &of = surface_.triangles[first], &other = surface_.triangles[second];
    const auto isShared = [&](std::size_t vertex) {
      return std::find(other.begin(), other.end(), vertex) != other.end();
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t p = of[k], q = of[(k + 1) % 3];
      if (!isShared(p) && !isShared(q) &&
          passesThrough(surface_.vertices[p], surface_.vertices[q], cornersOfTriangle(other)))
        return true;
    }
    return false;
  }

  const TriangleSurface& surface_;
};

}  // namespace

std::vector<SurfaceFault> faultsOf(const TriangleSurface& surface) {
  std::vector<SurfaceFault> faults = emptyTriangles(surface);
  if (faults.empty()) faults = openEdges(surface);
  if (faults.empty()) faults = turnedParts(surface);
  if (faults.empty()) faults = Crossings(surface).find();
  return faults;
}

std::vector<TriangleSurface> partsOf(const TriangleSurface& surface) {
  const std::vector<std::size_t> part = partNumbers(surface);
  std::vector<TriangleSurface> parts(*std::max_element(part.begin(), part.end()) + 1);
  std::vector<std::map<std::size_t, std::size_t>> numbers(parts.size());
  for (std::size_t t = 0; t < part.size(); ++t) {
    Corners corners = surface.triangles[t];
    TriangleSurface& own = parts[part[t]];
    for (std::size_t& vertex : corners) {
      const auto [it, isNew] = numbers[part[t]].emplace(vertex, own.vertices.size());
      if (isNew) own.vertices.push_back(surface.vertices[vertex]);
      vertex = it->second;
    }
    own.triangles.push_back(corners);
  }
  return parts;
}

}  // namespace pd
