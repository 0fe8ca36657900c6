#include "two_level.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "coarse_matrix.hpp"

namespace pd {

namespace {

// Points of a piece: a solve of the coarse level then costs about as much as one or two products.
constexpr int piecePoints2 = 100, piecePoints3 = 160;
// The smoother takes care of the eigenvalues above the largest over this.
constexpr float smoothedRange = 4.0F;
constexpr int degree = 2;

}  // namespace

TwoLevel::TwoLevel(const Communicator& comm, SpringOperator& stiffness)
    : comm_(comm),
      stiffness_(stiffness),
      nOwned_(stiffness.network().points().nOwned),
      dimension_(stiffness.network().dimension()),
      springDiagonal_(stiffness),
      diagonal_(stiffness.network().points().nPoints, dimension_ * (dimension_ + 1) / 2),
      inverse_(nOwned_, dimension_ * (dimension_ + 1) / 2) {
  const int nPoints = stiffness.network().points().nPoints;
  for (PointVector<float>* vector : {&rest_, &sum_, &direction_, &product_, &scaled_, &left_})
    *vector = PointVector<float>(nPoints, dimension_);
}

TwoLevel::~TwoLevel() = default;

void TwoLevel::refreshSmoother(const std::vector<int>& changed) {
  const auto isChanged = [&](const SpringOperator::Addition& addition) {
    return std::binary_search(changed.begin(), changed.end(), addition.point);
  };
  std::vector<SpringOperator::Addition> additions = stiffness_.additions();
  additions.erase(std::remove_if(additions.begin(), additions.end(), isChanged), additions.end());
  springDiagonal_.find(changed, diagonal_);
  const std::vector<SpringOperator::Addition> found = stiffeningOfLoosePoints(stiffness_, diagonal_, changed);
  for (const SpringOperator::Addition& addition : found) {
    const int c = addition.component;
    diagonal_[c * dimension_ - c * (c - 1) / 2][addition.point] += addition.value;
  }
  additions.insert(additions.end(), found.begin(), found.end());
  std::sort(additions.begin(), additions.end(), [](const auto& x, const auto& y) {
    return x.point < y.point || (x.point == y.point && x.component < y.component);
  });
  stiffness_.setAdditions(std::move(additions));
  invertDiagonal(changed);
}

void TwoLevel::invertDiagonal(const std::vector<int>& points) {
  for (const int i : points) {
    std::array<double, 6> a{};
    for (int k = 0, c = 0; c < dimension_; ++c)
      for (int d = c; d < dimension_; ++d, ++k) {
        const bool isCut = stiffness_.isHeld(i, c) || stiffness_.isHeld(i, d);
        a[static_cast<std::size_t>(k)] = isCut ? (c == d ? 1.0 : 0.0) : diagonal_[k][i];
      }
    const auto set = [&](int k, double value) { inverse_[k][i] = static_cast<float>(value); };
    if (dimension_ == 1) {
      set(0, 1.0 / a[0]);
    } else if (dimension_ == 2) {
      const double determinant = a[0] * a[2] - a[1] * a[1];
      set(0, a[2] / determinant);
      set(1, -a[1] / determinant);
      set(2, a[0] / determinant);
    } else {
      const double c00 = a[3] * a[5] - a[4] * a[4], c01 = a[2] * a[4] - a[1] * a[5], c02 = a[1] * a[4] - a[2] * a[3];
      const double determinant = a[0] * c00 + a[1] * c01 + a[2] * c02;
      set(0, c00 / determinant);
      set(1, c01 / determinant);
      set(2, c02 / determinant);
      set(3, (a[0] * a[5] - a[2] * a[2]) / determinant);
      set(4, (a[1] * a[2] - a[0] * a[4]) / determinant);
      set(5, (a[0] * a[3] - a[1] * a[1]) / determinant);
    }
  }
}

void TwoLevel::precondition(const PointVector<float>& r, PointVector<float>& z) const {
  const PointVector<float>& k = inverse_;
  if (dimension_ == 1) {
    for (int i = 0; i < nOwned_; ++i) z[0][i] = k[0][i] * r[0][i];
  } else if (dimension_ == 2) {
    const float *a = k[0], *b = k[1], *c = k[2], *x = r[0], *y = r[1];
    float *u = z[0], *v = z[1];
    for (int i = 0; i < nOwned_; ++i) {
      u[i] = a[i] * x[i] + b[i] * y[i];
      v[i] = b[i] * x[i] + c[i] * y[i];
    }
  } else {
    const float *x = r[0], *y = r[1], *w = r[2];
    for (int i = 0; i < nOwned_; ++i) {
      z[0][i] = k[0][i] * x[i] + k[1][i] * y[i] + k[2][i] * w[i];
      z[1][i] = k[1][i] * x[i] + k[3][i] * y[i] + k[4][i] * w[i];
      z[2][i] = k[2][i] * x[i] + k[4][i] * y[i] + k[5][i] * w[i];
    }
  }
}

/// Each spring joins two points: x.K x <= 2 x.D x, where it pulls and families give way. Elsewhere a few steps of the
/// power method tell.
void TwoLevel::estimateLargest() {
  const SpringNetwork& network = stiffness_.network();
  bool mayBeLarger = network.hasNegative();
  for (const double c : network.dilatational()) mayBeLarger = mayBeLarger || c > 0.0;
  largest_ = 2.0F;
  if (!comm_.any(mayBeLarger)) return;
  for (int c = 0; c < dimension_; ++c)
    for (int i = 0; i < nOwned_; ++i) {
      // Anything rough that every number of ranks makes alike.
      const auto id = static_cast<unsigned>(network.points().globalIds[static_cast<std::size_t>(i)]);
      direction_[c][i] =
          static_cast<float>((id * 2654435761U + static_cast<unsigned>(c) * 40503U) >> 8 & 1023U) - 512.0F;
    }
  stiffness_.zeroHeld(direction_);
  double estimate = 0.0;
  for (int step = 0; step < 12; ++step) {
    stiffness_.applyStiffly(direction_, product_);
    precondition(product_, scaled_);
    double up = 0.0, down = 0.0;
    for (int c = 0; c < dimension_; ++c)
      for (int i = 0; i < nOwned_; ++i) {
        up += static_cast<double>(scaled_[c][i]) * static_cast<double>(scaled_[c][i]);
        down += static_cast<double>(direction_[c][i]) * static_cast<double>(direction_[c][i]);
      }
    up = std::sqrt(comm_.sum(up));
    down = std::sqrt(comm_.sum(down));
    if (!(up > 0.0) || !(down > 0.0)) return;
    estimate = up / down;
    for (int c = 0; c < dimension_; ++c)
      for (int i = 0; i < nOwned_; ++i) direction_[c][i] = scaled_[c][i] / static_cast<float>(up);
  }
  largest_ = std::max(largest_, static_cast<float>(1.2 * estimate));
}

void TwoLevel::rebuild() {
  estimateLargest();
  space_ = std::make_unique<CoarseSpace>(comm_, stiffness_, dimension_ == 3 ? piecePoints3 : piecePoints2);
  space_->exchange(stiffness_);
  const CoarseMatrix matrix = makeCoarseMatrix(comm_, stiffness_, *space_);
  factor_.reset();
  if (space_->nUnknowns() > 0) factor_ = std::make_unique<CoarseFactor>(comm_, matrix, space_->nOwnUnknowns());
  right_.assign(static_cast<std::size_t>(space_->nOwnUnknowns()), 0.0);
  solution_ = right_;
}

void TwoLevel::smooth(const PointVector<float>& r, PointVector<float>& z) {
  const float low = largest_ / smoothedRange, middle = 0.5F * (largest_ + low), half = 0.5F * (largest_ - low);
  const float sigma = middle / half;
  float rho = 1.0F / sigma;
  left_ = r;
  for (int k = 0; k < degree; ++k) {
    const float next = 1.0F / (2.0F * sigma - rho), keep = next * rho, take = 2.0F * next / half;
    if (k > 0) {
      rho = next;
      stiffness_.applyStiffly(direction_, product_);
      subtract(product_, left_);
    }
    precondition(left_, scaled_);
    for (int c = 0; c < dimension_; ++c)
      for (int i = 0; i < nOwned_; ++i) {
        direction_[c][i] = k > 0 ? keep * direction_[c][i] + take * scaled_[c][i] : scaled_[c][i] / middle;
        z[c][i] += direction_[c][i];
      }
  }
}

void TwoLevel::subtract(const PointVector<float>& x, PointVector<float>& from) const {
  for (int c = 0; c < dimension_; ++c)
    for (int i = 0; i < nOwned_; ++i) from[c][i] -= x[c][i];
}

void TwoLevel::correct(PointVector<float>& r, PointVector<float>& z) {
  if (!factor_) return;
  space_->restrict(r, right_.data());
  factor_->solve(right_.data(), solution_.data());
  direction_.zero();
  space_->addTo(direction_, solution_.data());
  stiffness_.zeroHeld(direction_);  // points without springs may be held since the level was made
  stiffness_.apply(direction_, product_);
  subtract(product_, r);
  for (int c = 0; c < dimension_; ++c)
    for (int i = 0; i < nOwned_; ++i) z[c][i] += direction_[c][i];
}

void TwoLevel::apply(const PointVector<double>& r, PointVector<double>& z) {
  const double largest = comm_.max(largestSize(r, nOwned_));
  sum_.zero();
  if (largest > 0.0) {
    const double scale = 1.0 / largest;
    for (int c = 0; c < dimension_; ++c)
      for (int i = 0; i < nOwned_; ++i) rest_[c][i] = static_cast<float>(scale * r[c][i]);
    smooth(rest_, sum_);
    stiffness_.apply(sum_, product_);
    subtract(product_, rest_);
    correct(rest_, sum_);
    smooth(rest_, sum_);
  }
  for (int c = 0; c < dimension_; ++c)
    for (int i = 0; i < nOwned_; ++i) z[c][i] = largest * static_cast<double>(sum_[c][i]);
}

}  // namespace pd
