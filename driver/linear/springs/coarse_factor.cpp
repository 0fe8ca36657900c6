#include "coarse_factor.hpp"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <experimental/simd>
#include <iterator>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace pd {

namespace {

// A pivot that has become so small, relative to the diagonal that it was, is rounding.
constexpr double negligible = 1e-13;

/// Unknowns whose rows have their entries in the same columns.
struct Blocks {
  std::vector<int> start{0};                ///< [blocks + 1] first unknown
  std::vector<std::vector<int>> neighbors;  ///< [blocks] rising, without the block itself
  std::vector<int> rank;                    ///< [blocks] whose they are; `shared`: those with neighbours on others
  static constexpr int shared = -1;
  int width(int block) const {
    return start[static_cast<std::size_t>(block) + 1] - start[static_cast<std::size_t>(block)];
  }
};

void findRanks(Blocks& blocks, const std::vector<int>& endOfRank) {
  std::vector<int> owner;
  for (std::size_t block = 0; block < blocks.neighbors.size(); ++block)
    owner.push_back(static_cast<int>(std::upper_bound(endOfRank.begin(), endOfRank.end(), blocks.start[block]) -
                                     endOfRank.begin()));
  for (std::size_t block = 0; block < owner.size(); ++block) {
    const std::vector<int>& others = blocks.neighbors[block];
    const bool isAlone = std::all_of(others.begin(), others.end(),
                                     [&](int other) { return owner[static_cast<std::size_t>(other)] == owner[block]; });
    blocks.rank.push_back(isAlone ? owner[block] : Blocks::shared);
  }
}

/// `endOfRank` [ranks] of their unknowns: a block is of one rank.
Blocks blocksOf(const CoarseMatrix& matrix, const std::vector<int>& endOfRank) {
  Blocks blocks;
  const auto n = static_cast<int>(matrix.rowStart.size()) - 1;
  const auto columnsOf = [&](int row) {
    const auto r = static_cast<std::size_t>(row);
    return std::make_pair(matrix.columns.begin() + static_cast<std::ptrdiff_t>(matrix.rowStart[r]),
                          matrix.columns.begin() + static_cast<std::ptrdiff_t>(matrix.rowStart[r + 1]));
  };
  std::vector<int> blockOf(static_cast<std::size_t>(n));
  for (int row = 0; row < n; ++row) {
    const auto [begin, end] = columnsOf(row);
    if (row > 0) {
      const auto [before, endBefore] = columnsOf(row - 1);
      if (!std::equal(begin, end, before, endBefore) || !std::binary_search(begin, end, row - 1) ||
          std::binary_search(endOfRank.begin(), endOfRank.end(), row))
        blocks.start.push_back(row);
    }
    blockOf[static_cast<std::size_t>(row)] = static_cast<int>(blocks.start.size()) - 1;
  }
  if (n > 0) blocks.start.push_back(n);
  for (std::size_t block = 0; block + 1 < blocks.start.size(); ++block) {
    std::vector<int>& found = blocks.neighbors.emplace_back();
    const auto [begin, end] = columnsOf(blocks.start[block]);
    for (auto column = begin; column != end; ++column) {
      const int other = blockOf[static_cast<std::size_t>(*column)];
      if (other != static_cast<int>(block) && (found.empty() || found.back() != other)) found.push_back(other);
    }
  }
  findRanks(blocks, endOfRank);
  return blocks;
}

/// Eliminates the block with the fewest neighbours, one after another, each of which makes its neighbours neighbours of
/// each other; shared ones last. Returns the order; leaves in `blocks` the neighbours that each had when its turn came.
std::vector<int> orderOfLeastDegree(Blocks& blocks) {
  std::vector<int> order, degree;
  std::set<std::tuple<bool, int, int>> waiting;
  const auto isShared = [&](int block) { return blocks.rank[static_cast<std::size_t>(block)] == Blocks::shared; };
  const auto degreeOf = [&](const std::vector<int>& neighbors) {
    int sum = 0;
    for (const int other : neighbors) sum += blocks.width(other);
    return sum;
  };
  for (std::size_t block = 0; block < blocks.neighbors.size(); ++block) {
    degree.push_back(degreeOf(blocks.neighbors[block]));
    waiting.emplace(isShared(static_cast<int>(block)), degree.back(), static_cast<int>(block));
  }
  std::vector<int> merged;
  while (!waiting.empty()) {
    const int next = std::get<2>(*waiting.begin());
    waiting.erase(waiting.begin());
    order.push_back(next);
    const std::vector<int>& clique = blocks.neighbors[static_cast<std::size_t>(next)];
    for (const int block : clique) {
      const auto b = static_cast<std::size_t>(block);
      std::vector<int>& own = blocks.neighbors[b];
      merged.clear();
      std::set_union(own.begin(), own.end(), clique.begin(), clique.end(), std::back_inserter(merged));
      own.clear();
      for (const int other : merged)
        if (other != next && other != block) own.push_back(other);
      waiting.erase({isShared(block), degree[b], block});
      degree[b] = degreeOf(own);
      waiting.emplace(isShared(block), degree[b], block);
    }
  }
  return order;
}

/// The lower triangle of a dense symmetric matrix, column by column, over unknowns in the order of elimination.
struct DenseFront {
  std::vector<int> unknowns;
  std::vector<double> values;

  std::size_t size() const { return unknowns.size(); }
  double* column(std::size_t c) { return &values[c * size()]; }
  const double* column(std::size_t c) const { return &values[c * size()]; }

  /// Adds a matrix over some of the same unknowns.
  void extendBy(const DenseFront& other) {
    std::vector<std::size_t> place;
    for (std::size_t k = 0, at = 0; k < other.size(); ++k) {
      while (unknowns[at] != other.unknowns[k]) ++at;
      place.push_back(at);
    }
    for (std::size_t c = 0; c < other.size(); ++c) {
      double* to = column(place[c]);
      const double* from = other.column(c);
      for (std::size_t r = c; r < other.size(); ++r) to[place[r]] += from[r];
    }
  }

  /// The first `width` columns become those of the factor, the rest what is left of the matrix. `original` [width]: the
  /// diagonal before anything was eliminated.
  void eliminate(std::size_t width, const double* original) {
    const std::size_t n = size();
    for (std::size_t p = 0; p < width; ++p) {
      double* pivot = column(p);
      if (!(pivot[p] > negligible * original[p])) {
        std::fill(pivot + p, pivot + n, 0.0);
        pivot[p] = HUGE_VAL;
        continue;
      }
      const double root = std::sqrt(pivot[p]);
      pivot[p] = root;
      for (std::size_t r = p + 1; r < n; ++r) pivot[r] /= root;
      for (std::size_t c = p + 1; c < width; ++c) {
        double* to = column(c);
        for (std::size_t r = c; r < n; ++r) to[r] -= pivot[c] * pivot[r];
      }
    }
    for (std::size_t c = width; c < n; ++c) subtractProducts(c, width);
  }

 private:
  /// What the first `width` columns take away from column c.
  void subtractProducts(std::size_t c, std::size_t width) {
    double* to = column(c);
    const std::size_t n = size();
    std::size_t p = 0;
    for (; p + 4 <= width; p += 4) {
      const double *x0 = column(p), *x1 = column(p + 1), *x2 = column(p + 2), *x3 = column(p + 3);
      const double a0 = x0[c], a1 = x1[c], a2 = x2[c], a3 = x3[c];
      for (std::size_t r = c; r < n; ++r) to[r] -= a0 * x0[r] + a1 * x1[r] + a2 * x2[r] + a3 * x3[r];
    }
    for (; p < width; ++p) {
      const double* x = column(p);
      const double a = x[c];
      for (std::size_t r = c; r < n; ++r) to[r] -= a * x[r];
    }
  }
};

float product(const float* x, const float* y, int n) {
  namespace stdx = std::experimental;
  using Vector = stdx::native_simd<float>;
  constexpr int lanes = static_cast<int>(Vector::size());
  Vector sums = 0.0F;
  int k = 0;
  for (; k + lanes <= n; k += lanes)
    sums += Vector(x + k, stdx::element_aligned) * Vector(y + k, stdx::element_aligned);
  float sum = stdx::reduce(sums);
  for (; k < n; ++k) sum += x[k] * y[k];
  return sum;
}

}  // namespace

/// Front after front. What a front leaves waits for the front of the first unknown that it is about.
class CoarseFactor::Elimination {
 public:
  Elimination(const CoarseMatrix& matrix, const std::vector<int>& endOfRank, CoarseFactor& factor)
      : matrix_(matrix), factor_(factor), blocks_(blocksOf(matrix, endOfRank)) {
    const std::vector<int> order = orderOfLeastDegree(blocks_);
    const auto n = static_cast<std::size_t>(blocks_.start.back());
    factor_.place_.resize(n);
    unknownAt_.resize(n);
    waiting_.resize(n);
    int place = 0;
    for (const int block : order) {
      if (rankOf(block) != Blocks::shared) factor_.firstShared_ += blocks_.width(block);
      for (int k = 0; k < blocks_.width(block); ++k, ++place) {
        const int unknown = blocks_.start[static_cast<std::size_t>(block)] + k;
        factor_.place_[static_cast<std::size_t>(unknown)] = place;
        unknownAt_[static_cast<std::size_t>(place)] = unknown;
      }
    }
    std::size_t first = 0;
    while (first < order.size()) {
      std::size_t last = first + 1;
      while (last < order.size() && follows(order[last - 1], order[last])) ++last;
      addFront({order.begin() + static_cast<std::ptrdiff_t>(first), order.begin() + static_cast<std::ptrdiff_t>(last)});
      first = last;
    }
  }

 private:
  int rankOf(int block) const { return blocks_.rank[static_cast<std::size_t>(block)]; }

  /// Whether a block has the neighbours of the one before, but for itself.
  bool follows(int before, int block) const {
    if (rankOf(before) != rankOf(block)) return false;
    const std::vector<int>&a = blocks_.neighbors[static_cast<std::size_t>(before)],
          &b = blocks_.neighbors[static_cast<std::size_t>(block)];
    return a.size() == b.size() + 1 && std::binary_search(a.begin(), a.end(), block) &&
           std::includes(a.begin(), a.end(), b.begin(), b.end());
  }

  void addFront(const std::vector<int>& group) {
    DenseFront front;
    std::size_t width = 0;
    const auto add = [&](int block) {
      for (int k = 0; k < blocks_.width(block); ++k)
        front.unknowns.push_back(
            factor_.place_[static_cast<std::size_t>(blocks_.start[static_cast<std::size_t>(block)] + k)]);
    };
    for (const int block : group) add(block);
    width = front.unknowns.size();
    for (const int block : blocks_.neighbors[static_cast<std::size_t>(group.back())]) add(block);
    std::sort(front.unknowns.begin(), front.unknowns.end());
    front.values.assign(front.size() * front.size(), 0.0);
    std::vector<double> diagonal;
    for (std::size_t c = 0; c < width; ++c) diagonal.push_back(addMatrix(front, c));
    for (std::size_t c = 0; c < width; ++c) {
      for (const DenseFront& left : waiting_[static_cast<std::size_t>(front.unknowns[c])]) front.extendBy(left);
      waiting_[static_cast<std::size_t>(front.unknowns[c])] = {};
    }
    front.eliminate(width, diagonal.data());
    const int rank = rankOf(group.front());
    if (rank == Blocks::shared || rank == factor_.comm_.rank()) keep(front, width);
    if (rank == factor_.comm_.rank()) ++factor_.nOwnFronts_;
    leaveRest(front, width);
  }

  /// The entries of the matrix below the diagonal of column c; returns the diagonal.
  double addMatrix(DenseFront& front, std::size_t c) const {
    const int place = front.unknowns[c];
    const auto row = static_cast<std::size_t>(unknownAt_[static_cast<std::size_t>(place)]);
    double* column = front.column(c);
    for (std::size_t k = matrix_.rowStart[row]; k < matrix_.rowStart[row + 1]; ++k) {
      const int other = factor_.place_[static_cast<std::size_t>(matrix_.columns[k])];
      if (other < place) continue;
      const auto at = std::lower_bound(front.unknowns.begin(), front.unknowns.end(), other) - front.unknowns.begin();
      column[at] += matrix_.values[k];
    }
    return column[c];
  }

  /// Takes the columns of the factor out of an eliminated front.
  void keep(const DenseFront& front, std::size_t width) {
    const std::size_t n = front.size();
    factor_.fronts_.push_back({front.unknowns.front(), static_cast<int>(width), factor_.rows_.size(),
                               factor_.values_.size(), static_cast<int>(n - width)});
    factor_.rows_.insert(factor_.rows_.end(), front.unknowns.begin() + static_cast<std::ptrdiff_t>(width),
                         front.unknowns.end());
    for (std::size_t c = 0; c < width; ++c)
      for (std::size_t r = 0; r < n; ++r) {
        const double value = r < c ? 0.0 : front.column(c)[r];
        factor_.values_.push_back(static_cast<float>(r == c ? 1.0 / value : value));
      }
  }

  /// To a later front.
  void leaveRest(const DenseFront& front, std::size_t width) {
    const std::size_t n = front.size();
    if (n == width) return;
    DenseFront left;
    left.unknowns.assign(front.unknowns.begin() + static_cast<std::ptrdiff_t>(width), front.unknowns.end());
    left.values.resize(left.size() * left.size());
    for (std::size_t c = width; c < n; ++c)
      std::copy(front.column(c) + width, front.column(c) + n, left.column(c - width));
    waiting_[static_cast<std::size_t>(left.unknowns.front())].push_back(std::move(left));
  }

  const CoarseMatrix& matrix_;
  CoarseFactor& factor_;
  Blocks blocks_;
  std::vector<int> unknownAt_;                    ///< [places]
  std::vector<std::vector<DenseFront>> waiting_;  ///< [places]
};

CoarseFactor::CoarseFactor(const Communicator& comm, const CoarseMatrix& matrix, int nOwn) : comm_(comm), nOwn_(nOwn) {
  std::vector<int> end(static_cast<std::size_t>(comm.size()));
  MPI_Allgather(&nOwn, 1, MPI_INT, end.data(), 1, MPI_INT, comm.mpi());
  std::partial_sum(end.begin(), end.end(), end.begin());
  first_ = end[static_cast<std::size_t>(comm.rank())] - nOwn;
  Elimination(matrix, end, *this);
  int most = 0;
  for (const Front& front : fronts_) most = std::max(most, front.nBelow);
  work_.resize(place_.size());
  below_.resize(static_cast<std::size_t>(most));
}

void CoarseFactor::eliminate(std::size_t firstFront, std::size_t lastFront) const {
  float* below = below_.data();
  for (std::size_t f = firstFront; f < lastFront; ++f) {
    const Front& front = fronts_[f];
    float* own = &work_[static_cast<std::size_t>(front.first)];
    const int n = front.nBelow, height = front.width + n;
    const float* column = &values_[front.values];
    std::fill_n(below, n, 0.0F);
    for (int c = 0; c < front.width; ++c, column += height) {
      const float value = own[c] *= column[c];
      for (int r = c + 1; r < front.width; ++r) own[r] -= column[r] * value;
      const float* low = column + front.width;
      for (int r = 0; r < n; ++r) below[r] += low[r] * value;
    }
    const int* row = rows_.data() + front.rows;
    for (int r = 0; r < n; ++r) work_[static_cast<std::size_t>(row[r])] -= below[r];
  }
}

void CoarseFactor::substitute(std::size_t firstFront, std::size_t lastFront) const {
  float* below = below_.data();
  for (std::size_t f = lastFront; f-- > firstFront;) {
    const Front& front = fronts_[f];
    float* own = &work_[static_cast<std::size_t>(front.first)];
    const int n = front.nBelow, height = front.width + n;
    const int* row = rows_.data() + front.rows;
    for (int r = 0; r < n; ++r) below[r] = work_[static_cast<std::size_t>(row[r])];
    for (int c = front.width - 1; c >= 0; --c) {
      const float* column = &values_[front.values + static_cast<std::size_t>(c * height)];
      float sum = own[c];
      for (int r = c + 1; r < front.width; ++r) sum -= column[r] * own[r];
      const float* low = column + front.width;
      own[c] = (sum - product(low, below, n)) * column[c];
    }
  }
}

void CoarseFactor::solve(const double* b, double* x) const {
  const int nShared = static_cast<int>(work_.size()) - firstShared_;
  float* shared = work_.data() + firstShared_;
  std::fill_n(shared, nShared, 0.0F);  // of which each rank has a part
  const auto own = [&](int i) -> float& {
    return work_[static_cast<std::size_t>(place_[static_cast<std::size_t>(first_ + i)])];
  };
  for (int i = 0; i < nOwn_; ++i) own(i) = static_cast<float>(b[i]);
  eliminate(0, nOwnFronts_);
  if (nShared > 0) MPI_Allreduce(MPI_IN_PLACE, shared, nShared, MPI_FLOAT, MPI_SUM, comm_.mpi());
  eliminate(nOwnFronts_, fronts_.size());
  substitute(nOwnFronts_, fronts_.size());
  substitute(0, nOwnFronts_);
  for (int i = 0; i < nOwn_; ++i) x[i] = static_cast<double>(own(i));
}

}  // namespace pd
