// Displacements and forces of points, one contiguous array a component.
#ifndef PD_POINT_VECTOR_HPP
#define PD_POINT_VECTOR_HPP

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pd {

/// Values of owned points, then of ghosts and images.
template <class Real>
class PointVector {
 public:
  PointVector() = default;
  PointVector(int nPoints, int nComponents)
      : nPoints_(nPoints),
        nComponents_(nComponents),
        values_(std::size_t(nPoints) * std::size_t(nComponents), Real(0)) {}

  int nPoints() const { return nPoints_; }
  int nComponents() const { return nComponents_; }
  Real* operator[](int component) { return values_.data() + std::size_t(component) * std::size_t(nPoints_); }
  const Real* operator[](int component) const {
    return values_.data() + std::size_t(component) * std::size_t(nPoints_);
  }
  void zero() { std::fill(values_.begin(), values_.end(), Real(0)); }

 private:
  int nPoints_ = 0, nComponents_ = 0;
  std::vector<Real> values_;
};

/// Sums and largest sizes over owned points, of this rank.
double dot(const PointVector<double>& a, const PointVector<double>& b, int nOwned);
double largestSize(const PointVector<double>& x, int nOwned);

}  // namespace pd

#endif
