#include "coarse_space.hpp"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace pd {

namespace {

// What a ghost's owner says of it: piece, first unknown, modes of each component, and their values.
constexpr int nHeaders = 5, exchangedWidth = nHeaders + 12;

// A point that has lost so many of its bonds may move by itself, or with the few that hang with it: it is a piece.
constexpr float mostLost = 0.5F;
constexpr std::size_t mostOfWeak = 50;  // one in so many points

bool isWeak(const SpringNetwork& network, int point) {
  if (!network.isDamaged(point)) return false;
  const int n = network.nNeighbors(point);
  float left = 0.0F;
  for (int k = 0; k < n; ++k) left += network.alive(point, k);
  return left < (1.0F - mostLost) * static_cast<float>(n);
}

/// Sum over the ranks before this one, and over all.
std::pair<int, int> before(const Communicator& comm, int mine) {
  std::vector<int> all(static_cast<std::size_t>(comm.size()));
  MPI_Allgather(&mine, 1, MPI_INT, all.data(), 1, MPI_INT, comm.mpi());
  return {std::accumulate(all.begin(), all.begin() + comm.rank(), 0), std::accumulate(all.begin(), all.end(), 0)};
}

}  // namespace

CoarseSpace::CoarseSpace(const Communicator& comm, const SpringOperator& stiffness, int mostPoints)
    : dimension_(stiffness.network().dimension()),
      nShapes_(dimension_ + 1),
      nOwned_(stiffness.network().points().nOwned),
      points_(stiffness.network().points()) {
  findPieces(stiffness.network(), mostPoints);
  makeModes(stiffness);
  std::tie(firstUnknown_, nUnknowns_) = before(comm, base_.back());
  firstPiece_ = before(comm, nPieces()).first;
}

void CoarseSpace::split(const PointVector<double>& places, std::size_t begin, std::size_t end, std::size_t most) {
  if (end - begin <= most) {
    if (end > begin) boxes_.push_back(end);
    return;
  }
  int longest = 0;
  double length = -1.0;
  for (int c = 0; c < dimension_; ++c) {
    double low = places[c][order_[begin]], high = low;
    for (std::size_t k = begin; k < end; ++k) {
      low = std::min(low, places[c][order_[k]]);
      high = std::max(high, places[c][order_[k]]);
    }
    if (high - low > length * (1.0 + 1e-9)) {
      length = high - low;
      longest = c;
    }
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(begin), at(middle), at(end), [&](int a, int b) {
    const double xa = places[longest][a], xb = places[longest][b];
    return xa < xb || (xa == xb && a < b);
  });
  split(places, begin, middle, most);
  split(places, middle, end, most);
}

void CoarseSpace::findPieces(const SpringNetwork& network, int mostPoints) {
  order_.resize(static_cast<std::size_t>(nOwned_));
  std::iota(order_.begin(), order_.end(), 0);
  split(network.places<double>(), 0, order_.size(), static_cast<std::size_t>(mostPoints));
  std::vector<int> boxOfPoint(order_.size());
  for (std::size_t box = 0, k = 0; box < boxes_.size(); ++box)
    for (; k < boxes_[box]; ++k) boxOfPoint[static_cast<std::size_t>(order_[k])] = static_cast<int>(box);
  std::vector<int> weak;
  for (int point = 0; point < nOwned_; ++point)
    if (isWeak(network, point)) weak.push_back(point);
  // Beside a crack they are few. In a body that is broken all over, more unknowns cost more than they save.
  if (weak.size() <= order_.size() / mostOfWeak)
    for (std::size_t k = 0; k < weak.size(); ++k)
      boxOfPoint[static_cast<std::size_t>(weak[k])] = static_cast<int>(boxes_.size() + k);
  pieceOfPoint_.assign(order_.size(), -1);
  for (const int seed : order_) {
    if (pieceOfPoint_[static_cast<std::size_t>(seed)] >= 0) continue;
    const int piece = static_cast<int>(start_.size()) - 1;
    std::size_t next = members_.size();
    members_.push_back(seed);
    pieceOfPoint_[static_cast<std::size_t>(seed)] = piece;
    for (; next < members_.size(); ++next) {
      const int i = members_[next];
      for (int k = 0; k < network.nNeighbors(i); ++k) {
        const int j = network.neighbors(i)[k];
        if (j >= nOwned_ || pieceOfPoint_[static_cast<std::size_t>(j)] >= 0 || network.alive(i, k) == 0.0F ||
            boxOfPoint[static_cast<std::size_t>(j)] != boxOfPoint[static_cast<std::size_t>(i)])
          continue;
        pieceOfPoint_[static_cast<std::size_t>(j)] = piece;
        members_.push_back(j);
      }
    }
    std::sort(members_.begin() + static_cast<std::ptrdiff_t>(start_.back()), members_.end());
    start_.push_back(members_.size());
  }
}

void CoarseSpace::makeModes(const SpringOperator& stiffness) {
  const PointVector<double>& places = stiffness.network().places<double>();
  modes_.assign(members_.size() * static_cast<std::size_t>(dimension_ * nShapes_), 0.0F);
  placeOfPoint_.resize(members_.size());
  for (std::size_t k = 0; k < members_.size(); ++k)
    placeOfPoint_[static_cast<std::size_t>(members_[k])] = static_cast<int>(k);
  std::vector<std::vector<double>> shapes;
  for (std::size_t piece = 0; piece + 1 < start_.size(); ++piece) {
    const int* member = &members_[start_[piece]];
    const std::size_t n = start_[piece + 1] - start_[piece];
    std::array<double, 3> middle{};
    for (int c = 0; c < dimension_; ++c) {
      for (std::size_t p = 0; p < n; ++p) middle[static_cast<std::size_t>(c)] += places[c][member[p]];
      middle[static_cast<std::size_t>(c)] /= static_cast<double>(n);
    }
    std::array<int, 3> count{};
    for (int c = 0; c < dimension_; ++c) {
      shapes.clear();
      for (int s = 0; s < nShapes_; ++s) {
        std::vector<double> shape(n);
        for (std::size_t p = 0; p < n; ++p)
          if (!stiffness.isHeld(member[p], c))
            shape[p] = s == 0 ? 1.0 : places[s - 1][member[p]] - middle[static_cast<std::size_t>(s - 1)];
        const auto norm = [&] { return std::sqrt(std::inner_product(shape.begin(), shape.end(), shape.begin(), 0.0)); };
        const double before = norm();
        for (int pass = 0; pass < 2; ++pass)
          for (const std::vector<double>& other : shapes) {
            const double part = std::inner_product(shape.begin(), shape.end(), other.begin(), 0.0);
            for (std::size_t p = 0; p < n; ++p) shape[p] -= part * other[p];
          }
        const double after = norm();
        if (before == 0.0 || after < 1e-6 * before) continue;
        for (double& value : shape) value /= after;
        const auto width = static_cast<std::size_t>(dimension_ * nShapes_);
        float* to = &modes_[start_[piece] * width + static_cast<std::size_t>(c * nShapes_) + shapes.size()];
        for (std::size_t p = 0; p < n; ++p) to[p * width] = static_cast<float>(shape[p]);
        shapes.push_back(std::move(shape));
      }
      count[static_cast<std::size_t>(c)] = static_cast<int>(shapes.size());
    }
    nModes_.push_back(count);
    base_.push_back(base_.back() + count[0] + count[1] + count[2]);
  }
}

void CoarseSpace::exchange(const SpringOperator& stiffness) {
  exchanged_.assign(static_cast<std::size_t>(points_.nPoints) * exchangedWidth, 0.0);
  for (int i = 0; i < nOwned_; ++i) {
    double* values = &exchanged_[static_cast<std::size_t>(i) * exchangedWidth];
    const auto piece = static_cast<std::size_t>(pieceOfPoint_[static_cast<std::size_t>(i)]);
    values[0] = firstPiece_ + static_cast<double>(piece);
    values[1] = firstUnknown_ + base_[piece];
    for (int c = 0; c < dimension_; ++c) values[2 + c] = nModes_[piece][static_cast<std::size_t>(c)];
    const auto place = static_cast<std::size_t>(placeOfPoint_[static_cast<std::size_t>(i)]);
    const float* modes = &modes_[place * static_cast<std::size_t>(dimension_ * nShapes_)];
    for (int m = 0; m < dimension_ * nShapes_; ++m) values[nHeaders + m] = static_cast<double>(modes[m]);
  }
  stiffness.exchange().import(exchanged_.data(), exchangedWidth, std::nullopt);
}

CoarseSpace::PointModes CoarseSpace::modesAt(int point) const {
  PointModes result;
  const bool isOwned = point < nOwned_;
  const int source = points_.sourceOf(point);
  std::array<int, 3> count{};
  const double* foreign = nullptr;
  const float* own = nullptr;
  if (isOwned || source < nOwned_) {
    const auto piece = static_cast<std::size_t>(pieceOfPoint_[static_cast<std::size_t>(source)]);
    const auto place = static_cast<std::size_t>(placeOfPoint_[static_cast<std::size_t>(source)]);
    result.piece = {firstPiece_ + static_cast<int>(piece), firstUnknown_ + base_[piece], 0};
    count = nModes_[piece];
    own = &modes_[place * static_cast<std::size_t>(dimension_ * nShapes_)];
  } else {
    foreign = &exchanged_[static_cast<std::size_t>(source) * exchangedWidth];
    result.piece = {static_cast<int>(foreign[0]), static_cast<int>(foreign[1]), 0};
    for (std::size_t c = 0; c < 3; ++c) count[c] = static_cast<int>(foreign[2 + c]);
  }
  for (int c = 0; c < dimension_; ++c)
    for (int s = 0; s < count[static_cast<std::size_t>(c)]; ++s, ++result.piece.n) {
      const auto m = static_cast<std::size_t>(result.piece.n);
      result.component[m] = c;
      result.values[static_cast<std::size_t>(c)][m] =
          foreign != nullptr ? foreign[nHeaders + c * nShapes_ + s] : static_cast<double>(own[c * nShapes_ + s]);
    }
  if (const int copy = points_.copyOf(point); copy != 0) {
    const Symmetry::Matrix& m = points_.symmetry.matrix(copy);
    const auto values = result.values;
    result.isTurned = true;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t k = 0; k < 12; ++k)
        result.values[a][k] = m[3 * a] * values[0][k] + m[3 * a + 1] * values[1][k] + m[3 * a + 2] * values[2][k];
  }
  return result;
}

template <int D>
void CoarseSpace::restrictIn(const PointVector<float>& x, double* values) const {
  constexpr std::size_t shapes = D + 1;
  for (std::size_t piece = 0; piece + 1 < start_.size(); ++piece) {
    std::array<float, D * shapes> sums{};
    for (std::size_t k = start_[piece]; k < start_[piece + 1]; ++k) {
      const float* modes = &modes_[k * D * shapes];
      for (std::size_t c = 0; c < D; ++c) {
        const float value = x[static_cast<int>(c)][members_[k]];
        for (std::size_t s = 0; s < shapes; ++s) sums[c * shapes + s] += modes[c * shapes + s] * value;
      }
    }
    for (std::size_t c = 0; c < D; ++c)
      for (std::size_t s = 0; s < static_cast<std::size_t>(nModes_[piece][c]); ++s)
        *values++ = static_cast<double>(sums[c * shapes + s]);
  }
}

template <int D>
void CoarseSpace::addIn(PointVector<float>& x, const double* values) const {
  constexpr std::size_t shapes = D + 1;
  for (std::size_t piece = 0; piece + 1 < start_.size(); ++piece) {
    std::array<float, D * shapes> factors{};
    for (std::size_t c = 0; c < D; ++c)
      for (std::size_t s = 0; s < static_cast<std::size_t>(nModes_[piece][c]); ++s)
        factors[c * shapes + s] = static_cast<float>(*values++);
    for (std::size_t k = start_[piece]; k < start_[piece + 1]; ++k) {
      const float* modes = &modes_[k * D * shapes];
      for (std::size_t c = 0; c < D; ++c) {
        float sum = 0.0F;
        for (std::size_t s = 0; s < shapes; ++s) sum += modes[c * shapes + s] * factors[c * shapes + s];
        x[static_cast<int>(c)][members_[k]] += sum;
      }
    }
  }
}

void CoarseSpace::restrict(const PointVector<float>& x, double* values) const {
  if (dimension_ == 1) return restrictIn<1>(x, values);
  if (dimension_ == 2) return restrictIn<2>(x, values);
  restrictIn<3>(x, values);
}

void CoarseSpace::addTo(PointVector<float>& x, const double* values) const {
  if (dimension_ == 1) return addIn<1>(x, values);
  if (dimension_ == 2) return addIn<2>(x, values);
  addIn<3>(x, values);
}

}  // namespace pd
