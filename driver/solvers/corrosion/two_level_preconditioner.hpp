// Preconditioner of one implicit step of diffusion in the electrolyte.
#ifndef PD_TWO_LEVEL_PRECONDITIONER_HPP
#define PD_TWO_LEVEL_PRECONDITIONER_HPP

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "../../model/model.hpp"

namespace pd {

/// The step's matrix is inverted along lines of points, those in which the grid is finest, where bonds are strongest;
/// and what is constant in cubes of space, a few tens of points in each, is solved for together (additive Schwarz with
/// Nicolaides' coarse space: Dolean, Jolivet & Nataf, An Introduction to Domain Decomposition Methods, 2015). Of a grid
/// that is 25 times finer across a gap than along it, a line is a column across the gap, and a cube a part of one.
class TwoLevelPreconditioner {
 public:
  /// Of V (1 - h L - h s), V: volumes, L: diffusion, s: slopes of the dissolution rate as the material's Jacobian has
  /// them, at the points `ids` (owned local ids) where `isFree`. Collective.
  void build(Model& model, const std::string& field, const std::vector<int>& ids, const std::vector<char>& isFree,
             double h);
  bool isBuilt() const { return isBuilt_; }
  void discard() { isBuilt_ = false; }

  /// z = M^-1 V r at the points `ids`, which may be more than those it was built for; 0 where not `isFree`. Collective.
  void apply(Model& model, const std::vector<int>& ids, const std::vector<char>& isFree, const std::vector<double>& r,
             std::vector<double>& z);

  double largestDiagonal() const { return largestDiagonal_; }  ///< of 1 - h L

 private:
  using Key = std::array<int, 3>;  ///< place of a cube, in edges
  class Collector;
  Key keyOf(const double* x) const;
  void measure(Model& model);
  void setCubes(const Discretization& d, const Communicator& comm, const double (&low)[3], const double (&high)[3],
                const double (&nearest)[3]);
  void gatherPoints(Model& model, const std::vector<int>& ids, const std::vector<char>& isFree);
  void factorLines();
  template <int used>
  void solveLines(double* values) const;  ///< readable and 0 `used` values before and behind
  void makeCoarse(const Communicator& comm, const std::vector<double>& own);

  static constexpr int lineBand = 8;  ///< points of a line that one is coupled with, on either side

  bool isBuilt_ = false;
  std::array<double, 3> edges_{}, corner_{};  ///< of cubes
  double spacing_ = 0.0, largestDiagonal_ = 1.0;
  std::size_t axis_ = 0;     ///< of lines
  std::vector<int> points_;  ///< by slot: local ids line by line, in order along it
  struct Place {
    int cube = -1, slot = -1, line = -1;
  };
  std::vector<Place> places_;  ///< by owned local id; -1: in none
  std::vector<int> localId_;   ///< by global id, for owned points and ghosts
  std::map<Key, int> cubeAt_;
  std::vector<int> coarseOf_;  ///< by cube: its unknown in the coarse matrix
  /// L D L^T of each line: [slot (lineBand + 1) + k]: 1/D, then L of the k-th slot before.
  std::vector<double> lines_;
  int usedBand_ = 0;
  int nCoarse_ = 0, band_ = 0;
  std::vector<double> coarse_;  ///< factors as LAPACK's banded LU lays them out
  std::vector<int> pivots_;
  std::vector<double> lineValues_, partial_, coarseValues_;  ///< scratch
};

}  // namespace pd

#endif
