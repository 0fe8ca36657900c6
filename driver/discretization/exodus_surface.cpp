#include "exodus_surface.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "../parallel/broadcast.hpp"
#include "exodus_nodes.hpp"

namespace pd {

namespace {

constexpr double tolerance = 1e-10;  ///< in parts of an edge: neighbouring triangles leave no gap

std::vector<double> trianglesOf(const NetcdfFile& file) {
  const std::vector<double> nodes = exodusNodes(file);
  std::vector<double> triangles;
  const auto addCorner = [&](long long node) {
    if (node < 1 || static_cast<std::size_t>(node) > nodes.size() / 3)
      throw std::runtime_error("an element has a node that is not there");
    const auto first = nodes.begin() + 3 * (node - 1);
    triangles.insert(triangles.end(), first, first + 3);
  };
  for (std::size_t block = 1; block <= file.numberOf("num_el_blk"); ++block) {
    const std::string number = std::to_string(block);
    const std::size_t size = file.dimension("num_el_in_blk" + number);
    if (size == 0) continue;
    const std::size_t perElement = file.dimension("num_nod_per_el" + number);
    if (perElement != 3 && perElement != 4)
      throw std::runtime_error("it has elements of " + std::to_string(perElement) +
                               " nodes; surfaces are made of triangles and quadrilaterals");
    file.requireRoomFor(size, "elements");
    const std::vector<long long> connect = file.integers("connect" + number, size * perElement);
    for (std::size_t e = 0; e < connect.size(); e += perElement)
      for (std::size_t half = 0; half + 2 < perElement; ++half)
        for (const std::size_t corner : {std::size_t{0}, half + 1, half + 2}) addCorner(connect[e + corner]);
  }
  if (triangles.empty()) throw std::runtime_error("it has no triangles or quadrilaterals");
  return triangles;
}

}  // namespace

std::vector<double> readExodusSurface(const std::string& fileName, const std::string& place, const Communicator& comm) {
  std::vector<double> triangles;
  std::string failure;
  if (comm.isRoot()) {
    try {
      refusePieces(fileName);
      triangles = trianglesOf(NetcdfFile(fileName));
    } catch (const std::exception& error) {
      failure = error.what();
    }
  }
  broadcast(failure, comm);
  if (!failure.empty()) throw DeckError(place + ": the surface \"" + fileName + "\": " + failure);
  broadcast(triangles, comm);
  return triangles;
}

SurfaceFilter::SurfaceFilter(const MeshPoints& points, const std::vector<double>& triangles) : points_(points) {
  Vector3 high{};
  double sumOfSizes = 0.0;
  for (std::size_t t = 0; t < triangles.size(); t += 9) {
    std::array<Vector3, 3> corners;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 3; ++k) {
        corners[c][k] = triangles[t + 3 * c + k];
        const bool isFirst = t == 0 && c == 0;
        low_[k] = isFirst ? corners[c][k] : std::min(low_[k], corners[c][k]);
        high[k] = isFirst ? corners[c][k] : std::max(high[k], corners[c][k]);
      }
    Triangle triangle{corners[0], difference(corners[1], corners[0]), difference(corners[2], corners[0]), {}};
    triangle.normal = cross(triangle.edge, triangle.otherEdge);
    const double area = length(triangle.normal);
    if (!(area > 0.0)) continue;  // it has no inside
    for (double& component : triangle.normal) component /= area;
    sumOfSizes += std::sqrt(area);
    triangles_.push_back(triangle);
  }
  const double extent = std::max({high[0] - low_[0], high[1] - low_[1], high[2] - low_[2]});
  const auto n = static_cast<double>(triangles_.size());
  cellSize_ = n > 0.0 ? std::max(sumOfSizes / n, 1e-9 * extent) : 1.0;
  const auto cellsAlong = [&](std::size_t k) { return std::floor((high[k] - low_[k]) / cellSize_) + 1.0; };
  while (cellsAlong(0) * cellsAlong(1) * cellsAlong(2) > 8.0 * n + 100.0) cellSize_ *= 1.25;
  for (std::size_t k = 0; k < 3; ++k) nCells_[k] = static_cast<int>(cellsAlong(k));
  trianglesOfCell_.resize(indexOf(nCells_[0] - 1, nCells_[1] - 1, nCells_[2] - 1) + 1);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    Vector3 least = triangles_[t].corner, most = least;
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = triangles_[t].edge[k], b = triangles_[t].otherEdge[k];
      least[k] += std::min({0.0, a, b}) - tolerance * cellSize_;
      most[k] += std::max({0.0, a, b}) + tolerance * cellSize_;
    }
    const Cell from = cellOf(least), to = cellOf(most);
    for (int k = from[2]; k <= to[2]; ++k)
      for (int j = from[1]; j <= to[1]; ++j)
        for (int i = from[0]; i <= to[0]; ++i) trianglesOfCell_[indexOf(i, j, k)].push_back(static_cast<int>(t));
  }
}

SurfaceFilter::Cell SurfaceFilter::cellOf(const Vector3& x) const {
  Cell cell{};
  for (std::size_t k = 0; k < 3; ++k)
    cell[k] = static_cast<int>(std::clamp((x[k] - low_[k]) / cellSize_, 0.0, nCells_[k] - 1.0));
  return cell;
}

std::size_t SurfaceFilter::indexOf(int i, int j, int k) const {
  return (static_cast<std::size_t>(k) * static_cast<std::size_t>(nCells_[1]) + static_cast<std::size_t>(j)) *
             static_cast<std::size_t>(nCells_[0]) +
         static_cast<std::size_t>(i);
}

bool SurfaceFilter::meets(const Triangle& triangle, const Vector3& from, const Vector3& along) const {
  const double rise = dot(along, triangle.normal);
  if (rise * rise <= tolerance * tolerance * dot(along, along)) return false;  // it runs along the surface
  const double t = dot(difference(triangle.corner, from), triangle.normal) / rise;
  if (t < -tolerance || t > 1.0 + tolerance) return false;
  // Barycentric coordinates of the point of intersection.
  const Vector3 place{from[0] + t * along[0] - triangle.corner[0], from[1] + t * along[1] - triangle.corner[1],
                      from[2] + t * along[2] - triangle.corner[2]};
  const double aa = dot(triangle.edge, triangle.edge), bb = dot(triangle.otherEdge, triangle.otherEdge),
               ab = dot(triangle.edge, triangle.otherEdge), ap = dot(triangle.edge, place),
               bp = dot(triangle.otherEdge, place), determinant = aa * bb - ab * ab;
  const double alpha = (bb * ap - ab * bp) / determinant, beta = (aa * bp - ab * ap) / determinant;
  return alpha >= -tolerance && beta >= -tolerance && alpha + beta <= 1.0 + tolerance;
}

bool SurfaceFilter::cuts(int a, int b) const {
  if (a > b) std::swap(a, b);  // the same arithmetic from either end
  const double *xa = points_.at(a), *xb = points_.at(b);
  const Vector3 from{xa[0], xa[1], xa[2]}, along{xb[0] - xa[0], xb[1] - xa[1], xb[2] - xa[2]};
  Vector3 least{}, most{};
  for (std::size_t k = 0; k < 3; ++k) {
    least[k] = std::min(xa[k], xb[k]) - tolerance * cellSize_;
    most[k] = std::max(xa[k], xb[k]) + tolerance * cellSize_;
  }
  const Cell first = cellOf(least), last = cellOf(most);
  for (int k = first[2]; k <= last[2]; ++k)
    for (int j = first[1]; j <= last[1]; ++j)
      for (int i = first[0]; i <= last[0]; ++i)
        for (const int t : trianglesOfCell_[indexOf(i, j, k)])
          if (meets(triangles_[static_cast<std::size_t>(t)], from, along)) return true;
  return false;
}

}  // namespace pd
