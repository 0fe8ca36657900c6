// Point data of a block, one contiguous array a component, as vector loops want them.
#ifndef PD_POINT_ARRAYS_HPP
#define PD_POINT_ARRAYS_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "simd.hpp"

namespace pd::kernels {

/// Up to three components of a vector field, separated; readable `lanes` values past the last point.
class PointArrays {
 public:
  /// Copies the first `dimension` components of `interleaved` [3 nPoints].
  void separate(const double* interleaved, int nPoints, int dimension) {
    resize(nPoints, dimension);
    for (int i = 0; i < nPoints; ++i)
      for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d)
        components_[d][static_cast<std::size_t>(i)] = interleaved[3 * static_cast<std::size_t>(i) + d];
  }
  /// Copies a - b.
  void separateDifference(const double* a, const double* b, int nPoints, int dimension) {
    resize(nPoints, dimension);
    for (int i = 0; i < nPoints; ++i)
      for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d) {
        const std::size_t at = 3 * static_cast<std::size_t>(i) + d;
        components_[d][static_cast<std::size_t>(i)] = a[at] - b[at];
      }
  }
  /// Copies a scalar field.
  void copy(const double* values, int nPoints) {
    resize(nPoints, 1);
    std::copy(values, values + nPoints, components_[0].begin());
  }
  void zero(int nPoints, int dimension) {
    resize(nPoints, dimension);
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d)
      std::fill(components_[d].begin(), components_[d].end(), 0.0);
  }
  void addTo(double* interleaved, int nPoints, int dimension) const {
    for (int i = 0; i < nPoints; ++i)
      for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d)
        interleaved[3 * static_cast<std::size_t>(i) + d] += components_[d][static_cast<std::size_t>(i)];
  }

  double* operator[](int d) { return components_[static_cast<std::size_t>(d)].data(); }
  const double* operator[](int d) const { return components_[static_cast<std::size_t>(d)].data(); }

 private:
  void resize(int nPoints, int dimension) {
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d)
      components_[d].resize(static_cast<std::size_t>(nPoints + lanes));
  }
  std::array<std::vector<double>, 3> components_;
};

}  // namespace pd::kernels

#endif
