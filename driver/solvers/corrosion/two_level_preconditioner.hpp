// Preconditioner of one implicit step of diffusion in the electrolyte.
#ifndef PD_TWO_LEVEL_PRECONDITIONER_HPP
#define PD_TWO_LEVEL_PRECONDITIONER_HPP

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "../../model/model.hpp"

namespace pd {

/// Points are gathered in cubes of space, a few tens in each. Within a cube the step's matrix is inverted exactly; what
/// is constant in cubes is solved for together (additive Schwarz with Nicolaides' coarse space: Dolean, Jolivet &
/// Nataf, An Introduction to Domain Decomposition Methods, 2015). Since diffusion knows no direction, cubes suit grids
/// of any aspect ratio: of one that is 25 times finer across a gap than along it, a cube holds columns of points.
class TwoLevelPreconditioner {
 public:
  /// Of V (1 - h L - h s), V: volumes, L: diffusion, s: slopes of the dissolution rate as the material's Jacobian has
  /// them, at the points `ids` (owned local ids) where `isFree`. Collective.
  void build(Model& model, const std::vector<int>& ids, const std::vector<char>& isFree, double h);
  bool isBuilt() const { return isBuilt_; }
  void discard() { isBuilt_ = false; }

  /// z = M^-1 V r at the points `ids`, which may be more than those it was built for; 0 where not `isFree`. Collective.
  void apply(Model& model, const std::vector<int>& ids, const std::vector<char>& isFree, const std::vector<double>& r,
             std::vector<double>& z);

  double largestDiagonal() const { return largestDiagonal_; }  ///< of 1 - h L

 private:
  using Key = std::array<int, 3>;  ///< place of a cube, in edges
  struct Cube {
    std::size_t first, nPoints;  ///< in points_
    std::size_t inverse;         ///< start of its inverse in inverses_, [nPoints^2]
    int coarse = -1;             ///< its unknown in the coarse matrix
  };
  using Entries = std::map<std::pair<Key, Key>, double>;
  class Collector;
  Key keyOf(const double* x) const;
  void makeCubes(Model& model, const std::vector<int>& ids, const std::vector<char>& isFree);
  void invertCubes();
  void makeCoarse(const Communicator& comm, const Entries& own);

  bool isBuilt_ = false;
  double edge_ = 0.0, largestDiagonal_ = 1.0;
  std::vector<Cube> cubes_;
  std::map<Key, std::size_t> cubeAt_;
  std::vector<int> points_;           ///< local ids, by cube
  std::vector<int> cubeOf_, slotOf_;  ///< by owned local id; -1: in none
  std::vector<double> inverses_;
  int nCoarse_ = 0, band_ = 0;
  std::vector<double> coarse_;  ///< factors as LAPACK's banded LU lays them out
  std::vector<int> pivots_;
  std::vector<double> full_, local_, coarseValues_;  ///< scratch
};

}  // namespace pd

#endif
