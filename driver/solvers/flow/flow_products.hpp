// Products of rows of the operators of a flow with values of points: x, y and z of a vector and a scalar a point.
#ifndef PD_FLOW_PRODUCTS_HPP
#define PD_FLOW_PRODUCTS_HPP

#include "flow_operator.hpp"

namespace pd::flow_products {

constexpr std::size_t width = 4;  ///< values of a point

inline const double* valuesOf(const std::vector<double>& state, int point) {
  return state.data() + width * static_cast<std::size_t>(point);
}

/// All `width` values are summed, though three are asked for, since that is one vector instruction.
using Sum = std::array<double, width>;

/// result[a] += factor sum_b w[3a + b] v_b
inline void addProduct(const FlowOperator<9>::Row& row, const std::vector<double>& state, double factor,
                       double* result) {
  using Form = FlowOperator<9>::Form;
  Sum sum{};
  if (row.form == Form::Identity)
    for (std::size_t k = 0; k < row.count; ++k) {
      const double *v = valuesOf(state, row.pointOf(k)), weight = row.values[k];
      for (std::size_t a = 0; a < width; ++a) sum[a] += weight * v[a];
    }
  else
    for (std::size_t k = 0; k < row.count; ++k) {
      const double *v = valuesOf(state, row.pointOf(k)), *w = row.values + (row.form == Form::SameRows ? 3 : 9) * k;
      for (std::size_t a = 0; a < 3; ++a, w += row.form == Form::SameRows ? 0 : 3)
        sum[a] += w[0] * v[0] + w[1] * v[1] + w[2] * v[2];
    }
  for (std::size_t a = 0; a < 3; ++a) result[a] += factor * sum[a];
}

/// result[a] += factor sum_b carrier_b dv_a/dx_b, of the gradient's row without its constant.
inline void addCarried(const FlowOperator<9>::Row& row, const std::vector<double>& state, const double* carrier,
                       double factor, double* result) {
  using Form = FlowOperator<9>::Form;
  Sum sum{};
  if (row.form == Form::SameRows)
    for (std::size_t k = 0; k < row.count; ++k) {
      const double *v = valuesOf(state, row.pointOf(k)), *w = row.values + 3 * k;
      const double along = w[0] * carrier[0] + w[1] * carrier[1] + w[2] * carrier[2];
      for (std::size_t a = 0; a < width; ++a) sum[a] += along * v[a];
    }
  else
    for (std::size_t k = 0; k < row.count; ++k) {
      const double *v = valuesOf(state, row.pointOf(k)), *w = row.values + (row.form == Form::Identity ? 1 : 9) * k;
      for (std::size_t a = 0; a < 3; ++a)
        sum[a] += (row.form == Form::Identity
                       ? w[0] * carrier[a]
                       : w[3 * a] * carrier[0] + w[3 * a + 1] * carrier[1] + w[3 * a + 2] * carrier[2]) *
                  v[a];
    }
  for (std::size_t a = 0; a < 3; ++a) result[a] += factor * sum[a];
}

/// sum_a w[a] v_a
inline double divergence(const FlowOperator<3>::Row& row, const std::vector<double>& state) {
  std::array<double, 3> sum{};
  for (std::size_t k = 0; k < row.count; ++k) {
    const double *v = valuesOf(state, row.pointOf(k)), *w = row.values + 3 * k;
    for (std::size_t a = 0; a < 3; ++a) sum[a] += w[a] * v[a];
  }
  return sum[0] + sum[1] + sum[2];
}

/// result[a] += factor w[a] times the scalar.
inline void addGradient(const FlowOperator<3>::Row& row, const std::vector<double>& state, double factor,
                        double* result) {
  std::array<double, 3> sum{};
  for (std::size_t k = 0; k < row.count; ++k) {
    const double scalar = valuesOf(state, row.pointOf(k))[3], *w = row.values + 3 * k;
    for (std::size_t a = 0; a < 3; ++a) sum[a] += w[a] * scalar;
  }
  for (std::size_t a = 0; a < 3; ++a) result[a] += factor * sum[a];
}

inline double smoothing(const FlowOperator<1>::Row& row, const std::vector<double>& state) {
  double sum = 0.0;
  for (std::size_t k = 0; k < row.count; ++k) sum += row.values[k] * valuesOf(state, row.pointOf(k))[3];
  return sum;
}

}  // namespace pd::flow_products

#endif
