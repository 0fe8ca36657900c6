// Surfaces of triangles and quadrilaterals in Exodus files, which cut the bonds that meet them.
#ifndef PD_EXODUS_SURFACE_HPP
#define PD_EXODUS_SURFACE_HPP

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "../deck/deck.hpp"
#include "../deck/vector3.hpp"
#include "../parallel/communicator.hpp"
#include "bond_filters.hpp"
#include "mesh_points.hpp"

namespace pd {

/// [9 triangles] Corners of the triangles of a file; quadrilaterals count as two. Read by the root rank. Throws
/// DeckError, at `place` of the deck, where it holds other elements. Collective.
std::vector<double> readExodusSurface(const std::string& fileName, const std::string& place, const Communicator& comm);

/// Cuts bonds that meet one of the triangles, edges included; not those that run along it.
class SurfaceFilter : public BondFilter {
 public:
  /// Refers to `points`.
  SurfaceFilter(const MeshPoints& points, const std::vector<double>& triangles);
  bool cuts(int a, int b) const override;

 private:
  using Cell = std::array<int, 3>;
  struct Triangle {
    Vector3 corner, edge, otherEdge, normal;  ///< unit normal
  };
  bool meets(const Triangle& triangle, const Vector3& from, const Vector3& along) const;
  Cell cellOf(const Vector3& x) const;
  std::size_t indexOf(int i, int j, int k) const;

  const MeshPoints& points_;
  std::vector<Triangle> triangles_;
  Vector3 low_{};
  double cellSize_ = 1.0;
  Cell nCells_{1, 1, 1};
  std::vector<std::vector<int>> trianglesOfCell_;
};

}  // namespace pd

#endif
