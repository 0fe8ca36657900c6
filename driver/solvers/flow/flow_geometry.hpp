// Which points are fluid, and where their bonds end.
#ifndef PD_FLOW_GEOMETRY_HPP
#define PD_FLOW_GEOMETRY_HPP

#include <array>
#include <string>
#include <vector>

#include "../../boundary/flow_boundary.hpp"
#include "../../model/simulation.hpp"
#include "flow_law.hpp"

namespace pd {

/// By local id, 1 at points of metal that has not dissolved (field Damage below 1): walls. Ghosts agree with owners.
std::vector<char> solidPoints(Model& model);

/// Points of blocks with a flow material whose velocity is not prescribed, that lie before the outflows and are not
/// solid, are fluid.
/// A bond that meets a wall ends there; without a Surface of the wall where the points of the wall are nearest: half
/// way to a row of them.
class FlowGeometry {
 public:
  enum class Kind : char { Fluid, Wall, Beyond };  ///< Beyond an outflow

  /// The end of a bond of a fluid point.
  struct End {
    int point, copy;            ///< what is there, and in which copy of the body beside planes of symmetry
    Kind kind;                  ///< of the velocity at the end: of the point; of a wall; mirrored at an outflow
    std::array<double, 3> xi;   ///< m, the whole bond
    double length;              ///< of it, m
    double volume;              ///< what counts of the neighbour, in bodies of revolution of the plane, m3
    double fraction = 1.0;      ///< of the bond up to the wall
    int boundary = -1;          ///< the wall; -1: one at rest
    double openFraction = 2.0;  ///< up to an outflow, above 1: there is none on the way to `fraction`
    int outflow = -1;
  };

  /// Throws DeckError where points lie on the wrong side of a surface, boundaries claim one place, or a force acts on
  /// nothing that is fluid. Collective.
  FlowGeometry(Simulation& simulation, const FlowLaw& law, const std::vector<int>& flowBlocks,
               std::vector<char> isSolid);

  const FlowLaw& law() const { return law_; }
  const Discretization& mesh() const { return mesh_; }
  int dimension() const { return mesh_.dimension; }
  bool isFluid(int point) const { return kindOf(point) == Kind::Fluid; }
  /// Whether a fluid point has neighbours that are not fluid.
  bool isNearBoundary(int point) const { return isNear_[index(point)] != 0.0; }
  bool isSolid(int point) const { return isSolid_[index(mesh_.sourceOf(point))] != 0; }
  double spacingOf(int point) const { return law_.family.spacing(planeVolume(point)); }
  const kernels::Rings& rings() const { return law_.family.rings; }
  /// Of the point's cell, m3; in bodies of revolution in a plane 1 m thick.
  double planeVolume(int point) const { return rings().planeVolume(mesh_.x.data(), mesh_.volume.data(), point); }
  const std::vector<int>& fluid() const { return fluid_; }  ///< owned points
  /// Owned points that are fluid or will be when they have dissolved, and which of them fluid() are.
  int nPossible() const { return nPossible_; }
  const std::vector<int>& possibleOf() const { return possibleOf_; }

  /// Of an owned fluid point, to all neighbours.
  std::vector<End> endsOf(int point) const;
  /// Of any fluid point of this rank, to `candidates` within the reach of gradients.
  std::vector<End> compactEndsOf(int point, const std::vector<int>& candidates) const;
  End endOf(int point, int neighbor, const std::vector<int>& candidates) const;
  /// Of the bond, within the reach of gradients, in a Laplacian over the nearest neighbours that is symmetric but for
  /// volumes, 1/m2.
  double compactWeight(int point, const End& end) const;
  /// The last boundary that has the point; -1: none.
  int boundaryOf(int point) const { return boundaryOf_[index(mesh_.sourceOf(point))]; }
  const std::string& titleOf(int boundary) const {
    return titles_[static_cast<std::size_t>(boundary)];
  }  ///< with its place
  int nBoundaries() const { return static_cast<int>(boundaries_.size()); }
  bool isOutflow(int boundary) const { return boundaries_[index(boundary)]->isOutflow(); }
  bool isBeyondOutflow(int point) const { return kindOf(point) == Kind::Beyond; }
  /// Local ids of the neighbours of an owned point.
  std::vector<int> neighborsOf(int point) const;

  /// Where the bond meets the wall, or what `fraction` of it says.
  std::array<double, 3> placeOn(int point, const End& end, double fraction) const;
  /// Of a wall at a place, in the solver's time.
  std::array<double, 3> wallVelocity(int boundary, const std::array<double, 3>& place, double t) const;
  double outflowPressure(int boundary, const std::array<double, 3>& place, double t) const;
  /// Of the velocity of a wall (-1: one at rest) or the pressure of an outflow.
  bool changesWithTime(int boundary) const {
    return boundary >= 0 && boundaries_[static_cast<std::size_t>(boundary)]->dependsOnTime();
  }
  bool dependsOnPlace(int boundary) const {
    return boundary >= 0 && boundaries_[static_cast<std::size_t>(boundary)]->dependsOnPlace();
  }
  /// Whether the velocity of any wall or inlet changes with time.
  bool wallsChangeWithTime() const;
  /// Normal of length 1 into the fluid at a place on a boundary; zero where the deck does not say where it is.
  std::array<double, 3> normalAt(int boundary, const std::array<double, 3>& place) const;
  /// In bodies of revolution; throws DeckError where a wall or an inlet that meets the axis has a velocity across it at
  /// the solver's time t.
  void requireNoneAcrossAxis(double t) const;
  /// From a fluid point to the mirror image, at the outflow, of the end of the bond.
  std::array<double, 3> mirrored(int point, const End& end) const;
  /// The same at the wall that it meets, whose normalAt() that place is not zero.
  std::array<double, 3> mirroredAtWall(int point, const End& end) const {
    return mirroredAt(end.boundary, end.fraction, point, end);
  }

 private:
  static std::size_t index(int point) { return static_cast<std::size_t>(point); }
  Kind kindOf(int point) const { return kind_[index(mesh_.sourceOf(point))]; }
  /// Of a wall without a surface.
  bool isCell(int point) const {
    const int boundary = boundaryOf_[index(mesh_.sourceOf(point))];
    return kindOf(point) == Kind::Wall && (boundary < 0 || !boundaries_[index(boundary)]->hasSurface());
  }
  const double* placeOf(int point) const { return mesh_.x.data() + 3 * index(point); }
  void findKinds(const std::vector<int>& flowBlocks);
  void checkSides() const;
  void findNearBoundary();
  // flow_claims.cpp
  void checkClaims() const;
  std::vector<int> boundariesBefore(int neighbor) const;
  void findWallsAtAxis();
  bool isOneOutflow(int one, int other, const std::array<double, 3>& place) const;
  int wallCutAt(int outflow, int point, int neighbor, const std::vector<int>& candidates) const;
  bool cutsAnotherChannel(int outflow, int point, int neighbor, const std::vector<int>& candidates) const;
  bool claimOnePlace(int one, int other, int point, int neighbor) const;
  void meetBoundaries(int point, const std::vector<int>& candidates, End& end) const;
  void meetCells(int point, const std::vector<int>& candidates, End& end) const;
  double crossing(const FlowBoundary& boundary, const double* from, const End& end) const;
  std::array<double, 3> mirroredAt(int boundary, double fraction, int point, const End& end) const;

  Simulation& simulation_;
  const Discretization& mesh_;
  FlowLaw law_;
  std::vector<const FlowBoundary*> boundaries_;
  std::vector<std::string> titles_;       ///< of the boundaries, for messages
  std::vector<std::vector<int>> beyond_;  ///< their points
  std::vector<int> boundaryOf_;           ///< [points] the last one that has the point; -1: none
  std::vector<Kind> kind_;                ///< [points]
  std::vector<double> isNear_;            ///< [points] 1 where a neighbour is not fluid
  std::vector<char> isSolid_, isCell_;    ///< [points]
  std::vector<int> fluid_, possibleOf_;   ///< possibleOf_: [fluid_] their numbers among possible points
  int nPossible_ = 0;
  bool hasCells_ = false;  ///< walls without a surface
  struct WallAtAxis {
    int boundary, point;
    std::array<double, 3> place;
  };
  std::vector<WallAtAxis> wallsAtAxis_;  ///< where bonds of points beside the axis meet walls
};

}  // namespace pd

#endif
