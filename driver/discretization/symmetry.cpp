#include "symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace pd {

namespace {

Symmetry::Vector applied(const Symmetry::Matrix& m, const double* v) {
  return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[3] * v[0] + m[4] * v[1] + m[5] * v[2],
          m[6] * v[0] + m[7] * v[1] + m[8] * v[2]};
}

Symmetry::Matrix product(const Symmetry::Matrix& a, const double* b) {
  Symmetry::Matrix result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) result[3 * i + j] += a[3 * i + k] * b[3 * k + j];
  return result;
}

}  // namespace

void Symmetry::addPlane(const Vector& point, const Vector& normal) {
  const double height = point[0] * normal[0] + point[1] * normal[1] + point[2] * normal[2];
  Matrix mirror{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) mirror[3 * i + j] = (i == j ? 1.0 : 0.0) - 2.0 * normal[i] * normal[j];
  const std::size_t n = copies_.size();
  for (std::size_t c = 0; c < n; ++c) {
    const Copy& before = copies_[c];
    // Perpendicular planes do not move what the others shift.
    Vector shift = before.shift;
    for (std::size_t k = 0; k < 3; ++k) shift[k] += 2.0 * height * normal[k];
    copies_.push_back({product(mirror, before.matrix.data()), shift, -before.sign});
  }
}

Symmetry::Vector Symmetry::place(int copy, const double* x) const {
  const Copy& c = copies_[static_cast<std::size_t>(copy)];
  Vector result = applied(c.matrix, x);
  for (std::size_t k = 0; k < 3; ++k) result[k] += c.shift[k];
  return result;
}

bool Symmetry::isAlongAxes() const {
  return std::all_of(copies_.begin(), copies_.end(), [](const Copy& copy) {
    return copy.matrix[1] == 0.0 && copy.matrix[2] == 0.0 && copy.matrix[5] == 0.0;
  });
}

void Symmetry::reflect(int copy, Reflection rule, int width, const double* values, double* image) const {
  const Copy& c = copies_[static_cast<std::size_t>(copy)];
  if (rule == Reflection::Even) {
    std::copy(values, values + width, image);
    return;
  }
  if (rule == Reflection::Odd) {
    for (int k = 0; k < width; ++k) image[k] = c.sign * values[k];
    return;
  }
  if (width != 3) throw std::logic_error("a vector has 3 values, not " + std::to_string(width));
  Vector mirrored = rule == Reflection::Position ? place(copy, values) : applied(c.matrix, values);
  if (rule == Reflection::AxialVector)
    for (double& component : mirrored) component *= c.sign;
  std::copy(mirrored.begin(), mirrored.end(), image);
}

}  // namespace pd
