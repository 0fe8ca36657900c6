#include "coarse_matrix.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <unordered_map>

namespace pd {

namespace {

using Modes = CoarseSpace::PointModes;
using Piece = CoarseSpace::Piece;

// Of the diagonal, far below what the smoothest displacements of a body of a million points resist.
constexpr double raise = 1e-8;

/// The upper triangle of a symmetric matrix over pieces, in dense blocks.
class BlockMatrix {
 public:
  struct Block {
    int firstRow, firstColumn, nRows, nColumns;
    std::size_t values;  ///< start, row by row
  };

  /// The block of two pieces: rows are those of the piece of smaller number.
  double* of(const Piece& a, const Piece& b) {
    const auto key = (static_cast<std::uint64_t>(a.number) << 32) | static_cast<std::uint32_t>(b.number);
    if (key != lastKey_) {
      const auto [place, isNew] = places_.emplace(key, blocks_.size());
      if (isNew) {
        blocks_.push_back({a.first, b.first, a.n, b.n, values_.size()});
        values_.resize(values_.size() + static_cast<std::size_t>(a.n * b.n), 0.0);
      }
      lastKey_ = key;
      last_ = place->second;
    }
    return &values_[blocks_[last_].values];
  }
  std::vector<Block>& blocks() { return blocks_; }
  std::vector<double>& values() { return values_; }

 private:
  std::unordered_map<std::uint64_t, std::size_t> places_;
  std::vector<Block> blocks_;
  std::vector<double> values_;
  std::uint64_t lastKey_ = ~std::uint64_t{0};
  std::size_t last_ = 0;
};

template <int D>
class Assembly {
 public:
  Assembly(const SpringOperator& stiffness, const CoarseSpace& space)
      : stiffness_(stiffness), network_(stiffness.network()) {
    const auto nPoints = static_cast<std::size_t>(network_.points().nPoints);
    modes_.reserve(nPoints);
    shapes_.resize(nPoints);
    for (std::size_t point = 0; point < nPoints; ++point) {
      modes_.push_back(space.modesAt(static_cast<int>(point)));
      isWhole_.push_back(isWhole(modes_.back()) ? 1 : 0);
      if (isWhole_.back() == 0) continue;
      for (std::size_t c = 0; c < D; ++c)
        for (std::size_t s = 0; s <= D; ++s) shapes_[point][c][s] = modes_.back().values[c][c * (D + 1) + s];
    }
    diagonal_.assign(nPoints * nDiagonal, 0.0);
  }

  BlockMatrix run() {
    network_.forEachSpring(
        [&](int i, int j, const double* xi, const SpringConstants<double>& c) { addSpring(i, j, xi, c); });
    addDiagonal();
    for (const SpringOperator::Addition& addition : stiffness_.additions()) {
      const Modes& modes = modesOf(addition.point);
      const auto& row = modes.values[static_cast<std::size_t>(addition.component)];
      double* block = matrix_.of(modes.piece, modes.piece);
      for (int a = 0; a < modes.piece.n; ++a)
        for (int b = 0; b < modes.piece.n; ++b)
          block[a * modes.piece.n + b] +=
              addition.value * row[static_cast<std::size_t>(a)] * row[static_cast<std::size_t>(b)];
    }
    if (network_.familyWidth() > 0) addFamilies();
    return std::move(matrix_);
  }

 private:
  using Columns = std::array<std::array<double, 12>, D>;
  static constexpr std::size_t nDiagonal = D * (D + 1) / 2;

  const Modes& modesOf(int point) const { return modes_[static_cast<std::size_t>(point)]; }

  /// K of the spring, times modes.
  static Columns resisted(const Modes& modes, const double* xi, const SpringConstants<double>& c) {
    Columns result;
    for (std::size_t m = 0; m < static_cast<std::size_t>(modes.piece.n); ++m) {
      double along = 0.0;
      for (std::size_t d = 0; d < D; ++d) along += xi[d] * modes.values[d][m];
      for (std::size_t d = 0; d < D; ++d) result[d][m] = c.radial * along * xi[d] + c.across * modes.values[d][m];
    }
    return result;
  }
  /// block += sign modes^T right
  static void add(double* block, double sign, const Modes& modes, const Columns& right, int nRight) {
    for (int a = 0; a < modes.piece.n; ++a, block += nRight)
      for (std::size_t d = 0; d < D; ++d) {
        const auto m = static_cast<std::size_t>(a);
        if (!modes.isTurned && modes.component[m] != static_cast<int>(d)) continue;
        const double value = sign * modes.values[d][m];
        for (int b = 0; b < nRight; ++b) block[b] += value * right[d][static_cast<std::size_t>(b)];
      }
  }

  /// Most pieces have every shape for every component.
  using Shapes = std::array<std::array<double, D + 1>, D>;
  static bool isWhole(const Modes& modes) {
    bool result = modes.piece.n == D * (D + 1) && !modes.isTurned;
    for (int m = 0; m < modes.piece.n && result; ++m)
      result = modes.component[static_cast<std::size_t>(m)] == m / (D + 1);
    return result;
  }
  static void addWhole(double* block, double sign, const Shapes& a, const Shapes& b, const double* xi,
                       const SpringConstants<double>& c) {
    for (std::size_t d = 0; d < D; ++d)
      for (std::size_t s = 0; s <= D; ++s, block += D * (D + 1))
        for (std::size_t e = 0; e < D; ++e) {
          const double factor = sign * (c.radial * xi[d] * xi[e] + (d == e ? c.across : 0.0)) * a[d][s];
          for (std::size_t t = 0; t <= D; ++t) block[e * (D + 1) + t] += factor * b[e][t];
        }
  }
  void addDiagonalOf(int point, const double* xi, const SpringConstants<double>& c) {
    double* own = &diagonal_[static_cast<std::size_t>(point) * nDiagonal];
    for (std::size_t d = 0; d < D; ++d)
      for (std::size_t e = d; e < D; ++e) *own++ += c.radial * xi[d] * xi[e] + (d == e ? c.across : 0.0);
  }
  void addSpringOfWholes(int i, int j, const double* xi, const SpringConstants<double>& c) {
    const Piece &a = modesOf(i).piece, &b = modesOf(j).piece;
    const Shapes &atI = shapes_[static_cast<std::size_t>(i)], &atJ = shapes_[static_cast<std::size_t>(j)];
    if (a.number == b.number) {
      Shapes difference = atI;
      for (std::size_t d = 0; d < D; ++d)
        for (std::size_t s = 0; s <= D; ++s) difference[d][s] -= atJ[d][s];
      addWhole(matrix_.of(a, a), 1.0, difference, difference, xi, c);
      return;
    }
    if (a.number < b.number)
      addWhole(matrix_.of(a, b), -1.0, atI, atJ, xi, c);
    else
      addWhole(matrix_.of(b, a), -1.0, atJ, atI, xi, c);
    addDiagonalOf(i, xi, c);
    addDiagonalOf(j, xi, c);
  }

  void addSpring(int i, int j, const double* xi, const SpringConstants<double>& c) {
    if (isWhole_[static_cast<std::size_t>(i)] != 0 && isWhole_[static_cast<std::size_t>(j)] != 0)
      return addSpringOfWholes(i, j, xi, c);
    const Modes &a = modesOf(i), &b = modesOf(j);
    if (a.piece.number == b.piece.number) {
      // What the modes differ by at both ends.
      Modes difference = a;
      difference.isTurned = a.isTurned || b.isTurned;
      for (std::size_t d = 0; d < D; ++d)
        for (std::size_t m = 0; m < static_cast<std::size_t>(a.piece.n); ++m) difference.values[d][m] -= b.values[d][m];
      add(matrix_.of(a.piece, a.piece), 1.0, difference, resisted(difference, xi, c), a.piece.n);
      return;
    }
    const bool isInOrder = a.piece.number < b.piece.number;
    const Modes &low = isInOrder ? a : b, &high = isInOrder ? b : a;
    add(matrix_.of(low.piece, high.piece), -1.0, low, resisted(high, xi, c), high.piece.n);
    for (const int point : {i, j}) addDiagonalOf(point, xi, c);
  }

  void addDiagonal() {
    for (std::size_t point = 0; point < modes_.size(); ++point) {
      const Modes& modes = modes_[point];
      const double* own = &diagonal_[point * nDiagonal];
      if (modes.piece.n == 0 || (own[0] == 0.0 && static_cast<int>(point) >= network_.points().nOwned)) continue;
      Columns right{};
      for (std::size_t d = 0; d < D; ++d)
        for (std::size_t e = d; e < D; ++e, ++own)
          for (std::size_t m = 0; m < static_cast<std::size_t>(modes.piece.n); ++m) {
            right[d][m] += *own * modes.values[e][m];
            if (e != d) right[e][m] += *own * modes.values[d][m];
          }
      add(matrix_.of(modes.piece, modes.piece), 1.0, modes, right, modes.piece.n);
    }
  }

  /// What the modes of a piece make of the s of one family.
  static constexpr std::size_t mostModes = D * (D + 1), mostWidth = D == 3 ? 3 : 1;
  using Gains = std::array<std::array<double, mostModes>, mostWidth>;
  struct Share {
    Piece piece;
    Gains s{};
  };

  void addTo(std::vector<Share>& family, const Modes& modes, const double* xi, double gives) const {
    auto share = std::find_if(family.begin(), family.end(),
                              [&](const Share& other) { return other.piece.number == modes.piece.number; });
    if (share == family.end()) {
      family.push_back({modes.piece, {}});
      share = family.end() - 1;
    }
    for (std::size_t m = 0; m < static_cast<std::size_t>(modes.piece.n); ++m)
      for (std::size_t d = 0; d < D; ++d) {
        if (!modes.isTurned && modes.component[m] != static_cast<int>(d)) continue;
        const double u = gives * modes.values[d][m];
        if (network_.family() == SpringNetwork::Family::Dilatation) {
          share->s[0][m] += xi[d] * u;
        } else if constexpr (D == 2) {
          share->s[0][m] += d == 0 ? -xi[1] * u : xi[0] * u;
        } else if constexpr (D == 3) {
          const std::size_t e = (d + 1) % 3, f = (d + 2) % 3;  // xi x e_d = xi_f e_e - xi_e e_f
          share->s[e][m] += xi[f] * u;
          share->s[f][m] -= xi[e] * u;
        }
      }
  }

  void addFamilies() {
    const int nOwned = network_.points().nOwned;
    std::vector<std::vector<Share>> families(static_cast<std::size_t>(nOwned));
    std::vector<std::array<double, D>> toOwn(families.size());  // sum of what springs give, times minus xi
    network_.forEachSpring([&](int i, int j, const double* xi, const SpringConstants<double>& c) {
      const Modes &a = modesOf(i), &b = modesOf(j);
      addTo(families[static_cast<std::size_t>(i)], b, xi, c.own);
      for (std::size_t d = 0; d < D; ++d) toOwn[static_cast<std::size_t>(i)][d] -= c.own * xi[d];
      if (j >= nOwned) return;
      addTo(families[static_cast<std::size_t>(j)], a, xi, -c.others);
      for (std::size_t d = 0; d < D; ++d) toOwn[static_cast<std::size_t>(j)][d] += c.others * xi[d];
    });
    for (int i = 0; i < nOwned; ++i)
      addTo(families[static_cast<std::size_t>(i)], modesOf(i), toOwn[static_cast<std::size_t>(i)].data(), 1.0);
    const auto width = static_cast<std::size_t>(network_.familyWidth());
    const PointVector<double>& response = stiffness_.response<double>();
    for (int i = 0; i < nOwned; ++i) {
      std::vector<Share>& family = families[static_cast<std::size_t>(i)];
      std::sort(family.begin(), family.end(),
                [](const Share& x, const Share& y) { return x.piece.number < y.piece.number; });
      std::array<std::array<double, 3>, 3> c{};
      for (std::size_t p = 0; p < width; ++p)
        for (std::size_t q = p; q < width; ++q)
          c[p][q] = c[q][p] = response[width == 1 ? 0 : static_cast<int>(p * (5 - p) / 2 + q)][i];
      for (std::size_t x = 0; x < family.size(); ++x)
        for (std::size_t y = x; y < family.size(); ++y) addProduct(family[x], family[y], c, width);
    }
  }

  void addProduct(const Share& x, const Share& y, const std::array<std::array<double, 3>, 3>& c, std::size_t width) {
    const auto rows = static_cast<std::size_t>(x.piece.n), columns = static_cast<std::size_t>(y.piece.n);
    Gains cy{};
    for (std::size_t p = 0; p < width; ++p)
      for (std::size_t q = 0; q < width; ++q)
        for (std::size_t m = 0; m < columns; ++m) cy[p][m] += c[p][q] * y.s[q][m];
    double* block = matrix_.of(x.piece, y.piece);
    for (std::size_t p = 0; p < width; ++p)
      for (std::size_t a = 0; a < rows; ++a)
        for (std::size_t b = 0; b < columns; ++b) block[a * columns + b] += x.s[p][a] * cy[p][b];
  }

  const SpringOperator& stiffness_;
  const SpringNetwork& network_;
  std::vector<Modes> modes_;
  std::vector<Shapes> shapes_;  ///< [points] of those whose piece isWhole()
  std::vector<char> isWhole_;
  std::vector<double> diagonal_;  ///< [points] upper triangle of what springs to other pieces resist
  BlockMatrix matrix_;
};

template <class T>
std::vector<T> gatherAll(const Communicator& comm, const std::vector<T>& mine, MPI_Datatype type) {
  if (comm.size() == 1) return mine;
  const int count = static_cast<int>(mine.size());
  std::vector<int> counts(static_cast<std::size_t>(comm.size())), starts(counts.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, comm.mpi());
  for (std::size_t rank = 1; rank < counts.size(); ++rank) starts[rank] = starts[rank - 1] + counts[rank - 1];
  std::vector<T> all(static_cast<std::size_t>(starts.back() + counts.back()));
  MPI_Allgatherv(mine.data(), count, type, all.data(), counts.data(), starts.data(), type, comm.mpi());
  return all;
}

/// Sums the blocks of all ranks, and writes both triangles by rows.
CoarseMatrix compressed(const Communicator& comm, BlockMatrix& mine, int nUnknowns) {
  std::vector<int> headers;
  for (const BlockMatrix::Block& block : mine.blocks())
    headers.insert(headers.end(), {block.firstRow, block.firstColumn, block.nRows, block.nColumns});
  headers = gatherAll(comm, headers, MPI_INT);
  const std::vector<double> values = gatherAll(comm, mine.values(), MPI_DOUBLE);

  struct Piece {
    int row, column, nRows, nColumns;
    bool isTurned;
    std::size_t at;
  };
  std::vector<Piece> blocks;
  std::size_t at = 0;
  for (std::size_t h = 0; h < headers.size(); h += 4) {
    const int row = headers[h], column = headers[h + 1], nRows = headers[h + 2], nColumns = headers[h + 3];
    if (nRows > 0 && nColumns > 0) {
      blocks.push_back({row, column, nRows, nColumns, false, at});
      if (row != column) blocks.push_back({column, row, nColumns, nRows, true, at});
    }
    at += static_cast<std::size_t>(nRows * nColumns);
  }
  std::stable_sort(blocks.begin(), blocks.end(), [](const Piece& a, const Piece& b) {
    return a.row < b.row || (a.row == b.row && a.column < b.column);
  });
  CoarseMatrix result;
  result.rowStart.push_back(0);
  for (std::size_t first = 0, last = 0; first < blocks.size(); first = last) {
    while (last < blocks.size() && blocks[last].row == blocks[first].row) ++last;
    for (int r = 0; r < blocks[first].nRows; ++r) {
      for (std::size_t k = first; k < last; ++k) {
        const Piece& block = blocks[k];
        const bool isSame = k > first && blocks[k - 1].column == block.column;
        for (int c = 0; c < block.nColumns; ++c) {
          const double value = block.isTurned ? values[block.at + static_cast<std::size_t>(c * block.nRows + r)]
                                              : values[block.at + static_cast<std::size_t>(r * block.nColumns + c)];
          if (isSame) {
            result.values[result.values.size() - static_cast<std::size_t>(block.nColumns - c)] += value;
            continue;
          }
          result.columns.push_back(block.column + c);
          result.values.push_back(value);
        }
      }
      result.rowStart.push_back(result.columns.size());
    }
  }
  for (std::size_t row = 0; row < static_cast<std::size_t>(nUnknowns); ++row)
    for (std::size_t k = result.rowStart[row]; k < result.rowStart[row + 1]; ++k)
      if (result.columns[k] == static_cast<int>(row))
        result.values[k] = result.values[k] > 0.0 ? result.values[k] * (1.0 + raise) : 1.0;
  return result;
}

}  // namespace

CoarseMatrix makeCoarseMatrix(const Communicator& comm, const SpringOperator& stiffness, const CoarseSpace& space) {
  const auto assembled = [&](auto dimension) {
    BlockMatrix matrix = Assembly<decltype(dimension)::value>(stiffness, space).run();
    return compressed(comm, matrix, space.nUnknowns());
  };
  const int dimension = stiffness.network().dimension();
  if (dimension == 1) return assembled(std::integral_constant<int, 1>());
  if (dimension == 2) return assembled(std::integral_constant<int, 2>());
  return assembled(std::integral_constant<int, 3>());
}

}  // namespace pd
