// The few displacements in which a body is solved exactly: affine ones of its pieces.
#ifndef PD_COARSE_SPACE_HPP
#define PD_COARSE_SPACE_HPP

#include <array>
#include <vector>

#include "spring_operator.hpp"

namespace pd {

/// The body is halved across its longest side, and its halves again, down to boxes of a few hundred bonds a point's
/// reach or so; points of a box that unbroken bonds hold together are a piece. Its modes are 1, x, y, z of each
/// component, orthonormal over the degrees of freedom that are not held; what these do not tell apart is left out.
class CoarseSpace {
 public:
  /// `n` unknowns from `first` on, in the numbers of all ranks.
  struct Piece {
    int number = 0, first = 0, n = 0;
  };
  /// The modes of its piece at a point.
  struct PointModes {
    Piece piece;
    std::array<std::array<double, 12>, 3> values{};  ///< [component][mode]
    std::array<int, 12> component{};                 ///< of each mode, the one that is not zero; of images any may be
    bool isTurned = false;                           ///< of an image
  };

  /// Pieces of at most `mostPoints`. Collective.
  CoarseSpace(const Communicator& comm, const SpringOperator& stiffness, int mostPoints);

  int nUnknowns() const { return nUnknowns_; }       ///< of all ranks
  int nOwnUnknowns() const { return base_.back(); }  ///< of this one
  int nPieces() const { return static_cast<int>(base_.size()) - 1; }
  /// Of an owned point, or of a ghost or an image after exchange().
  PointModes modesAt(int point) const;
  /// Gets what modesAt() says of ghosts. Collective.
  void exchange(const SpringOperator& stiffness);

  /// values [nOwnUnknowns] = products of the modes with x.
  void restrict(const PointVector<float>& x, double* values) const;
  /// x += the modes times values [nOwnUnknowns].
  void addTo(PointVector<float>& x, const double* values) const;

 private:
  void findPieces(const SpringNetwork& network, int mostPoints);
  void split(const PointVector<double>& places, std::size_t begin, std::size_t end, std::size_t most);
  void makeModes(const SpringOperator& stiffness);
  template <int D>
  void restrictIn(const PointVector<float>& x, double* values) const;
  template <int D>
  void addIn(PointVector<float>& x, const double* values) const;

  int dimension_, nShapes_, nOwned_;
  const Discretization& points_;
  std::vector<int> order_;                  ///< owned points, box by box
  std::vector<std::size_t> boxes_;          ///< where boxes end in order_
  std::vector<int> pieceOfPoint_;           ///< [nOwned]
  std::vector<int> members_;                ///< points of the pieces, one piece after another
  std::vector<std::size_t> start_{0};       ///< [pieces + 1] into members_
  std::vector<int> base_{0};                ///< [pieces + 1] first unknown of this rank's
  std::vector<std::array<int, 3>> nModes_;  ///< [pieces] of each component
  std::vector<float> modes_;                ///< [members_][D][D + 1]; those that a piece lacks are 0
  std::vector<int> placeOfPoint_;           ///< in members_
  std::vector<double> exchanged_;           ///< [nPoints][exchangedWidth]
  int firstUnknown_ = 0, nUnknowns_ = 0, firstPiece_ = 0;
};

}  // namespace pd

#endif
