// Point data of a block, one contiguous array a component, as vector loops want them.
#ifndef PD_POINT_ARRAYS_HPP
#define PD_POINT_ARRAYS_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "simd.hpp"

namespace pd::kernels {

/// Up to three components of a vector field, separated. Readable and writable `lanes` values before the first and past
/// the last point, which entries of contiguous chunks reach where lanes have no neighbour.
class PointArrays {
 public:
  /// Copies the first `dimension` components of `interleaved` [3 nPoints].
  void separate(const double* interleaved, int nPoints, int dimension) {
    resize(nPoints, dimension);
    for (int i = 0; i < nPoints; ++i)
      for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d)
        component(d)[i] = interleaved[3 * static_cast<std::size_t>(i) + d];
  }
  /// Copies a - b.
  void separateDifference(const double* a, const double* b, int nPoints, int dimension) {
    resize(nPoints, dimension);
    for (int i = 0; i < nPoints; ++i)
      for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d) {
        const std::size_t at = 3 * static_cast<std::size_t>(i) + d;
        component(d)[i] = a[at] - b[at];
      }
  }
  /// Copies a scalar field.
  void copy(const double* values, int nPoints) {
    resize(nPoints, 1);
    std::copy(values, values + nPoints, component(0));
  }
  void zero(int nPoints, int dimension) {
    resize(nPoints, dimension);
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d)
      std::fill(components_[d].begin(), components_[d].end(), 0.0);
  }
  void addTo(double* interleaved, int nPoints, int dimension) const {
    for (int i = 0; i < nPoints; ++i)
      for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d)
        interleaved[3 * static_cast<std::size_t>(i) + d] += (*this)[static_cast<int>(d)][i];
  }

  int nPoints() const { return static_cast<int>(components_[0].size()) - 2 * lanes; }
  double* operator[](int d) { return component(static_cast<std::size_t>(d)); }
  const double* operator[](int d) const { return components_[static_cast<std::size_t>(d)].data() + lanes; }

 private:
  double* component(std::size_t d) { return components_[d].data() + lanes; }
  void resize(int nPoints, int dimension) {
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d)
      components_[d].resize(static_cast<std::size_t>(nPoints + 2 * lanes));
  }
  std::array<std::vector<double>, 3> components_;
};

}  // namespace pd::kernels

#endif
