// The copies of a body that planes of symmetry make, and what becomes of a point's values in them.
#ifndef PD_SYMMETRY_HPP
#define PD_SYMMETRY_HPP

#include <array>
#include <vector>

#include "fields.hpp"

namespace pd {

/// Planes that are perpendicular to each other. With the part that is modelled, copy 0, they make up a whole of
/// 2^planes copies: copy c is mirrored about each plane k whose bit k is set in c. Mirroring a copy's values again
/// gives back those of the part; copy b of copy c is copy b ^ c.
class Symmetry {
 public:
  using Vector = std::array<double, 3>;
  using Matrix = std::array<double, 9>;  ///< row by row

  /// `normal`: of length 1, perpendicular to those of the planes before.
  void addPlane(const Vector& point, const Vector& normal);

  bool empty() const { return copies_.size() == 1; }
  int nCopies() const { return static_cast<int>(copies_.size()); }
  /// Takes vectors of the part to those of a copy; symmetric, and its own inverse.
  const Matrix& matrix(int copy) const { return copies_[static_cast<std::size_t>(copy)].matrix; }
  Vector place(int copy, const double* x) const;  ///< of a point at x, m
  /// Whether all planes are perpendicular to x, y or z.
  bool isAlongAxes() const;

  /// Writes what becomes in a copy of the `width` values of a point; `image` is another array than `values`. Vector,
  /// AxialVector and Position take 3 values.
  void reflect(int copy, Reflection rule, int width, const double* values, double* image) const;

 private:
  struct Copy {
    Matrix matrix;  ///< x' = matrix x + shift
    Vector shift;
    double sign;  ///< -1 where the number of planes is odd
  };
  std::vector<Copy> copies_{{{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {}, 1.0}};
};

}  // namespace pd

#endif
