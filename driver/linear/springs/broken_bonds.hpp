// Loops over broken bonds that lie side by side.
#ifndef PD_BROKEN_BONDS_HPP
#define PD_BROKEN_BONDS_HPP

#include <array>
#include <experimental/simd>
#include <type_traits>

#include "spring_measure.hpp"

namespace pd {

/// Takes away from both ends what the bonds of a stretch gave them as if they were whole.
template <class Real, int D, SpringNetwork::Family family>
class BrokenBonds {
 public:
  BrokenBonds(const SpringNetwork& network, const BrokenStretch& stretch)
      : first_(stretch.first), count_(stretch.count) {
    const SpringPattern& pattern = network.patterns()[static_cast<std::size_t>(stretch.pattern)];
    const auto k = static_cast<std::size_t>(stretch.neighbor);
    offset_ = pattern.offsets[k];
    const double* xi = &pattern.xi[k * D];
    const SpringConstants<double>& c = pattern.constants[k];
    gives_ = times(c.own, xi);
    takes_ = times(c.others, xi);
    radial_ = times(c.radial, xi);
    xi_ = times(1.0, xi);
    across_ = static_cast<Real>(c.across);
  }

  void takeFromFamilies(const PointVector<Real>& x, PointVector<Real>& s) const {
    if constexpr (M::width > 0) {
      forEachPart([&](int i, auto zero) {
        using Value = decltype(zero);
        Value eta[D], own[nArrays], others[nArrays];
        for (int d = 0; d < D; ++d) eta[d] = load<Value>(x[d] + i + offset_) - load<Value>(x[d] + i);
        for (int m = 0; m < M::width; ++m) own[m] = others[m] = zero;
        M::add(gives_.data(), eta, own);
        M::add(takes_.data(), eta, others);
        for (int m = 0; m < M::width; ++m) {
          store(load<Value>(s[m] + i) - own[m], s[m] + i);
          store(load<Value>(s[m] + i + offset_) - others[m], s[m] + i + offset_);
        }
      });
    }
  }

  /// `t`: what families respond by.
  void takeFromForces(const PointVector<Real>& x, const PointVector<Real>& t, PointVector<Real>& y) const {
    forEachPart([&](int i, auto zero) {
      using Value = decltype(zero);
      Value eta[D], force[D], along = zero;
      for (int d = 0; d < D; ++d) {
        eta[d] = load<Value>(x[d] + i + offset_) - load<Value>(x[d] + i);
        along += radial_[static_cast<std::size_t>(d)] * eta[d];
      }
      for (int d = 0; d < D; ++d) force[d] = along * xi_[static_cast<std::size_t>(d)] + across_ * eta[d];
      if constexpr (M::width > 0) {
        Value own[nArrays], others[nArrays];
        for (int m = 0; m < M::width; ++m) {
          own[m] = load<Value>(t[m] + i);
          others[m] = load<Value>(t[m] + i + offset_);
        }
        M::addGradient(gives_.data(), own, force);
        M::addGradient(takes_.data(), others, force);
      }
      for (int d = 0; d < D; ++d) {
        store(load<Value>(y[d] + i) + force[d], y[d] + i);
        store(load<Value>(y[d] + i + offset_) - force[d], y[d] + i + offset_);
      }
    });
  }

 private:
  using Vector = std::experimental::native_simd<Real>;
  using M = SpringMeasure<D, family>;
  static constexpr std::size_t nArrays = M::width > 0 ? M::width : 1;

  /// work(first point, zero) for vectors of points and for the points that are left; zero tells which. The two ends of
  /// a stretch may overlap, so that one work() ends before the next.
  template <class Work>
  void forEachPart(const Work& work) const {
    constexpr int lanes = static_cast<int>(Vector::size());
    int i = first_;
    const int end = first_ + count_;
    for (; i + lanes <= end; i += lanes) work(i, Vector(Real(0)));
    for (; i < end; ++i) work(i, Real(0));
  }
  template <class Value>
  static Value load(const Real* from) {
    if constexpr (std::is_same_v<Value, Real>)
      return *from;
    else
      return Value(from, std::experimental::element_aligned);
  }
  static void store(const Vector& value, Real* to) { value.copy_to(to, std::experimental::element_aligned); }
  static void store(Real value, Real* to) { *to = value; }
  static std::array<Real, D> times(double factor, const double* xi) {
    std::array<Real, D> result;
    for (int d = 0; d < D; ++d) result[static_cast<std::size_t>(d)] = static_cast<Real>(factor * xi[d]);
    return result;
  }

  int first_, count_, offset_;
  std::array<Real, D> gives_, takes_, radial_, xi_;  ///< xi, and xi times a constant of the spring
  Real across_;
};

}  // namespace pd

#endif
