#include "yardstick.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace pd_benchmark {

namespace {

constexpr double horizon = 3.015;
constexpr double micromodulus = 1.0;

struct Row {
  const double *x, *y, *z;
};

/// Of n bonds side by side, from the points `here` to those `there`.
void addForce(int n, double length, const Row& here, const Row& there, const double* volume, double* __restrict forceX,
              double* __restrict forceY, double* __restrict forceZ) {
  const double factor = micromodulus / length;
  for (int bond = 0; bond < n; ++bond) {
    const double dx = there.x[bond] - here.x[bond], dy = there.y[bond] - here.y[bond],
                 dz = there.z[bond] - here.z[bond];
    const double newLength = std::sqrt(dx * dx + dy * dy + dz * dz);
    const double share = factor * (newLength - length) * volume[bond] / newLength;
    forceX[bond] += share * dx;
    forceY[bond] += share * dy;
    forceZ[bond] += share * dz;
  }
}

}  // namespace

BareBody::BareBody(int n) : n_(n) {
  const auto count = static_cast<std::size_t>(n) * static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  volume_.assign(count, 1.0);
  for (std::vector<double>* field : {&reference_, &current_, &listForce_}) field->resize(3 * count);
  for (auto* fields : {&row_, &latticeForce_})
    for (std::vector<double>& component : *fields) component.resize(count);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> displacement(-1e-3, 1e-3);
  for (std::size_t point = 0; point < count; ++point) {
    const std::size_t width = static_cast<std::size_t>(n);
    const std::size_t place[3] = {point % width, point / width % width, point / (width * width)};
    for (std::size_t d = 0; d < 3; ++d) {
      reference_[3 * point + d] = static_cast<double>(place[d]);
      current_[3 * point + d] = row_[d][point] = reference_[3 * point + d] + displacement(random);
    }
  }
  makeList();
}

std::size_t BareBody::number(int i, int j, int k) const { return static_cast<std::size_t>((k * n_ + j) * n_ + i); }

void BareBody::makeList() {
  const int reach = static_cast<int>(horizon);
  for (int k = -reach; k <= reach; ++k)
    for (int j = -reach; j <= reach; ++j)
      for (int i = -reach; i <= reach; ++i) {
        const int squared = i * i + j * j + k * k;
        if (squared > 0 && squared < horizon * horizon) offsets_.push_back({i, j, k});
      }
  const auto isInside = [this](int index) { return index >= 0 && index < n_; };
  for (int k = 0; k < n_; ++k)
    for (int j = 0; j < n_; ++j)
      for (int i = 0; i < n_; ++i) {
        const std::size_t head = list_.size();
        list_.push_back(0);
        for (const Offset& offset : offsets_)
          if (isInside(i + offset.i) && isInside(j + offset.j) && isInside(k + offset.k))
            list_.push_back(static_cast<int>(number(i + offset.i, j + offset.j, k + offset.k)));
        list_[head] = static_cast<int>(list_.size() - head) - 1;
      }
}

void BareBody::forceByList() {
  const int nPoints = n_ * n_ * n_;
  const int* list = list_.data();
  const double *x = reference_.data(), *y = current_.data(), *volume = volume_.data();
  double* force = listForce_.data();
  for (int i = 0; i < nPoints; ++i) {
    double sumX = 0.0, sumY = 0.0, sumZ = 0.0;
    const int nNeighbors = *list++;
    for (int neighbor = 0; neighbor < nNeighbors; ++neighbor) {
      const int j = *list++;
      const double X = x[3 * j] - x[3 * i], Y = x[3 * j + 1] - x[3 * i + 1], Z = x[3 * j + 2] - x[3 * i + 2];
      const double dx = y[3 * j] - y[3 * i], dy = y[3 * j + 1] - y[3 * i + 1], dz = y[3 * j + 2] - y[3 * i + 2];
      const double length = std::sqrt(X * X + Y * Y + Z * Z);
      const double newLength = std::sqrt(dx * dx + dy * dy + dz * dz);
      const double stretch = (newLength - length) / length;
      const double share = micromodulus * stretch * volume[j] / newLength;
      sumX += share * dx;
      sumY += share * dy;
      sumZ += share * dz;
    }
    force[3 * i] = sumX;
    force[3 * i + 1] = sumY;
    force[3 * i + 2] = sumZ;
  }
}

void BareBody::forceByOffsets() {
  for (int k = 0; k < n_; ++k)
    for (int j = 0; j < n_; ++j) {
      for (std::vector<double>& component : latticeForce_)
        std::fill_n(component.begin() + static_cast<std::ptrdiff_t>(number(0, j, k)), n_, 0.0);
      for (const Offset& offset : offsets_) {
        const int row = j + offset.j, plane = k + offset.k;
        if (row >= 0 && row < n_ && plane >= 0 && plane < n_) addForceOfRow(j, k, offset);
      }
    }
}

/// Of the bonds of one offset, that start in the row of points (0 .. n-1, j, k).
void BareBody::addForceOfRow(int j, int k, const Offset& offset) {
  const double length = std::sqrt(offset.i * offset.i + offset.j * offset.j + offset.k * offset.k);
  const int first = std::max(0, -offset.i), end = std::min(n_, n_ - offset.i);
  const std::size_t here = number(first, j, k), there = number(first + offset.i, j + offset.j, k + offset.k);
  addForce(end - first, length, {row_[0].data() + here, row_[1].data() + here, row_[2].data() + here},
           {row_[0].data() + there, row_[1].data() + there, row_[2].data() + there}, volume_.data() + there,
           latticeForce_[0].data() + here, latticeForce_[1].data() + here, latticeForce_[2].data() + here);
}

void triad(std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& c) {
  double* result = a.data();
  const double *left = b.data(), *right = c.data();
  const std::size_t n = a.size();
  for (std::size_t i = 0; i < n; ++i) result[i] = left[i] + 3.0 * right[i];
}

}  // namespace pd_benchmark
