#include "coarse_matrix.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <type_traits>
#include <unordered_map>

namespace pd {

namespace {

using Modes = CoarseSpace::PointModes;
using Piece = CoarseSpace::Piece;

// Of the diagonal, far below what the smoothest displacements of a body of a million points resist.
constexpr double raise = 1e-8;

/// Numbers pairs of pieces in the order in which they come.
class PiecePairs {
 public:
  std::size_t size() const { return numbers_.size(); }
  /// What is one pair after another, mostly, is found at once.
  std::size_t find(const Piece& a, const Piece& b) {
    const auto key = (static_cast<std::uint64_t>(a.number) << 32) | static_cast<std::uint32_t>(b.number);
    if (key == lastKey_) return last_;
    lastKey_ = key;
    last_ = numbers_.emplace(key, numbers_.size()).first->second;
    return last_;
  }

 private:
  std::unordered_map<std::uint64_t, std::size_t> numbers_;
  std::uint64_t lastKey_ = ~std::uint64_t{0};
  std::size_t last_ = 0;
};

/// The upper triangle of a symmetric matrix over pieces, in dense blocks.
class BlockMatrix {
 public:
  struct Block {
    int firstRow, firstColumn, nRows, nColumns;
    std::size_t values;  ///< start, row by row
  };

  /// The block of two pieces: rows are those of the piece of smaller number.
  double* of(const Piece& a, const Piece& b) {
    const std::size_t number = pairs_.find(a, b);
    if (number == blocks_.size()) {
      blocks_.push_back({a.first, b.first, a.n, b.n, values_.size()});
      values_.resize(values_.size() + static_cast<std::size_t>(a.n * b.n), 0.0);
    }
    return &values_[blocks_[number].values];
  }
  std::vector<Block>& blocks() { return blocks_; }
  std::vector<double>& values() { return values_; }

 private:
  PiecePairs pairs_;
  std::vector<Block> blocks_;
  std::vector<double> values_;
};

/// The shapes 1, x, y .. of most pieces are those of all components alike. Between two such pieces the sum over springs
/// of (stiffness of components d, e) x (shape s here) x (shape t there) is found before it is written where it belongs.
template <int D>
class PlainSums {
 public:
  /// The shapes of a piece at a point; the last of four is 0 in a plane.
  using Shapes = std::array<double, 4>;
  static constexpr std::size_t nStiffness = D * (D + 1) / 2;
  using Stiffness = std::array<double, nStiffness>;  ///< upper triangle

  void add(const Piece& low, const Piece& high, const Stiffness& stiffness, const Shapes& here, const Shapes& there) {
    const std::size_t number = pairs_.find(low, high);
    if (number == sums_.size()) sums_.push_back({low, high, {}});
    double* to = sums_[number].values.data();
    for (std::size_t k = 0; k < nStiffness; ++k)
      for (std::size_t s = 0; s <= D; ++s, to += 4) {
        const double factor = stiffness[k] * here[s];
        for (std::size_t t = 0; t < 4; ++t) to[t] += factor * there[t];
      }
  }
  void addTo(BlockMatrix& matrix) const {
    for (const Sum& sum : sums_) {
      double* block = matrix.of(sum.low, sum.high);
      for (std::size_t d = 0; d < D; ++d)
        for (std::size_t s = 0; s <= D; ++s, block += D * (D + 1))
          for (std::size_t e = 0; e < D; ++e) {
            const std::size_t a = std::min(d, e), b = std::max(d, e), k = a * D - a * (a + 1) / 2 + b;
            for (std::size_t t = 0; t <= D; ++t) block[e * (D + 1) + t] += sum.values[(k * (D + 1) + s) * 4 + t];
          }
    }
  }

 private:
  struct Sum {
    Piece low, high;
    std::array<double, nStiffness*(D + 1) * 4> values;  ///< [stiffness][shape here][shape there]
  };
  PiecePairs pairs_;
  std::vector<Sum> sums_;
};

template <int D>
class Assembly {
 public:
  Assembly(const SpringOperator& stiffness, const CoarseSpace& space)
      : stiffness_(stiffness), network_(stiffness.network()), space_(space) {
    const auto nPoints = static_cast<std::size_t>(network_.points().nPoints);
    pieces_.reserve(nPoints);
    shapes_.resize(nPoints);
    isPlain_.resize(nPoints);
    for (std::size_t point = 0; point < nPoints; ++point) {
      const Modes modes = space.modesAt(static_cast<int>(point));
      pieces_.push_back(modes.piece);
      isPlain_[point] = isPlain(modes) ? 1 : 0;
      for (std::size_t s = 0; s <= D && isPlain_[point] != 0; ++s) shapes_[point][s] = modes.values[0][s];
      if (isPlain_[point] == 0) others_.emplace(static_cast<int>(point), modes);
    }
    diagonal_.resize(nPoints);
  }

  BlockMatrix run() {
    network_.forEachSpringByOffset([&](int i, int j, const double* xi, const SpringConstants<double>& c) {
      // Another rank has the spring, too, or a copy of the body: each gives half of it.
      const double share = network_.isTwice(j) ? 0.5 : 1.0;
      addSpring(i, j, xi, {share * c.radial, share * c.across, c.own, c.others});
    });
    addDiagonal();
    sums_.addTo(matrix_);
    for (const SpringOperator::Addition& addition : stiffness_.additions()) {
      const Modes modes = space_.modesAt(addition.point);
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
  using Shapes = typename PlainSums<D>::Shapes;
  using Stiffness = typename PlainSums<D>::Stiffness;

  const Piece& pieceOf(int point) const { return pieces_[static_cast<std::size_t>(point)]; }
  const Shapes& shapesOf(int point) const { return shapes_[static_cast<std::size_t>(point)]; }
  bool isPlain(int point) const { return isPlain_[static_cast<std::size_t>(point)] != 0; }
  Modes modesOf(int point) const { return isPlain(point) ? space_.modesAt(point) : others_.at(point); }

  /// Whether the piece has every shape, the same for every component.
  static bool isPlain(const Modes& modes) {
    if (modes.piece.n != D * (D + 1) || modes.isTurned) return false;
    for (std::size_t d = 0; d < D; ++d)
      for (std::size_t s = 0; s <= D; ++s)
        if (modes.component[d * (D + 1) + s] != static_cast<int>(d) ||
            modes.values[d][d * (D + 1) + s] != modes.values[0][s])
          return false;
    return true;
  }

  /// Of a spring, times `sign`.
  static Stiffness stiffnessOf(const double* xi, const SpringConstants<double>& c, double sign) {
    Stiffness result;
    for (std::size_t d = 0, k = 0; d < D; ++d)
      for (std::size_t e = d; e < D; ++e, ++k)
        result[k] = sign * (c.radial * xi[d] * xi[e] + (d == e ? c.across : 0.0));
    return result;
  }
  void addDiagonalOf(int point, const Stiffness& minus) {
    for (std::size_t k = 0; k < minus.size(); ++k) diagonal_[static_cast<std::size_t>(point)][k] -= minus[k];
  }

  void addSpring(int i, int j, const double* xi, const SpringConstants<double>& c) {
    if (!isPlain(i) || !isPlain(j)) return addToOthers(i, j, xi, c);
    const Piece &a = pieceOf(i), &b = pieceOf(j);
    if (a.number == b.number) {
      Shapes difference = shapesOf(i);
      for (std::size_t s = 0; s <= D; ++s) difference[s] -= shapesOf(j)[s];
      sums_.add(a, a, stiffnessOf(xi, c, 1.0), difference, difference);
      return;
    }
    const Stiffness minus = stiffnessOf(xi, c, -1.0);
    if (a.number < b.number)
      sums_.add(a, b, minus, shapesOf(i), shapesOf(j));
    else
      sums_.add(b, a, minus, shapesOf(j), shapesOf(i));
    addDiagonalOf(i, minus);
    addDiagonalOf(j, minus);
  }

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
  /// A spring of which one end at least is in a piece that is not plain.
  void addToOthers(int i, int j, const double* xi, const SpringConstants<double>& c) {
    const Modes a = modesOf(i), b = modesOf(j);
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
    for (const int point : {i, j}) addDiagonalOf(point, stiffnessOf(xi, c, -1.0));
  }

  void addDiagonal() {
    for (std::size_t at = 0; at < pieces_.size(); ++at) {
      const auto point = static_cast<int>(at);
      const Piece& piece = pieceOf(point);
      if (piece.n == 0 || (diagonal_[at][0] == 0.0 && point >= network_.points().nOwned)) continue;
      if (isPlain(point)) {
        sums_.add(piece, piece, diagonal_[at], shapesOf(point), shapesOf(point));
        continue;
      }
      const Modes& modes = others_.at(point);
      const double* own = diagonal_[at].data();
      Columns right{};
      for (std::size_t d = 0; d < D; ++d)
        for (std::size_t e = d; e < D; ++e, ++own)
          for (std::size_t m = 0; m < static_cast<std::size_t>(piece.n); ++m) {
            right[d][m] += *own * modes.values[e][m];
            if (e != d) right[e][m] += *own * modes.values[d][m];
          }
      add(matrix_.of(piece, piece), 1.0, modes, right, piece.n);
    }
  }

  /// What the modes of a piece make of the s of one family.
  static constexpr std::size_t mostModes = D * (D + 1), mostWidth = D == 3 ? 3 : 1;
  using Gains = std::array<std::array<double, mostModes>, mostWidth>;
  struct Share {
    Piece piece;
    int next = -1;  ///< of the same family
    Gains s{};
  };
  /// Those of all families, each of which is a list.
  struct Shares {
    std::deque<Share> all;
    std::vector<int> first;  ///< [points]
    Gains& of(int point, const Piece& piece) {
      int* at = &first[static_cast<std::size_t>(point)];
      while (*at >= 0 && all[static_cast<std::size_t>(*at)].piece.number != piece.number)
        at = &all[static_cast<std::size_t>(*at)].next;
      if (*at < 0) {
        *at = static_cast<int>(all.size());
        all.push_back({piece, -1, {}});
        return all.back().s;
      }
      return all[static_cast<std::size_t>(*at)].s;
    }
  };

  /// s += what a displacement `value` of component d at xi makes.
  void addGain(Gains& s, std::size_t m, std::size_t d, const double* xi, double value) const {
    if (network_.family() == SpringNetwork::Family::Dilatation) {
      s[0][m] += xi[d] * value;
    } else if constexpr (D == 2) {
      s[0][m] += d == 0 ? -xi[1] * value : xi[0] * value;
    } else if constexpr (D == 3) {
      const std::size_t e = (d + 1) % 3, f = (d + 2) % 3;  // xi x e_d = xi_f e_e - xi_e e_f
      s[e][m] += xi[f] * value;
      s[f][m] -= xi[e] * value;
    }
  }
  /// What the modes at `member` make of the family of `point`, over a bond xi that gives it so much.
  void addToFamily(Shares& shares, int point, int member, const double* xi, double gives) const {
    Gains& s = shares.of(point, pieceOf(member));
    if (isPlain(member)) {
      for (std::size_t d = 0; d < D; ++d)
        for (std::size_t k = 0; k <= D; ++k) addGain(s, d * (D + 1) + k, d, xi, gives * shapesOf(member)[k]);
      return;
    }
    const Modes& modes = others_.at(member);
    for (std::size_t m = 0; m < static_cast<std::size_t>(modes.piece.n); ++m)
      for (std::size_t d = 0; d < D; ++d)
        if (modes.isTurned || modes.component[m] == static_cast<int>(d))
          addGain(s, m, d, xi, gives * modes.values[d][m]);
  }

  void addFamilies() {
    const int nOwned = network_.points().nOwned;
    Shares shares;
    shares.first.assign(static_cast<std::size_t>(nOwned), -1);
    std::vector<std::array<double, D>> toOwn(shares.first.size());  // sum of what springs give, times minus xi
    network_.forEachSpring([&](int i, int j, const double* xi, const SpringConstants<double>& c) {
      addToFamily(shares, i, j, xi, c.own);
      for (std::size_t d = 0; d < D; ++d) toOwn[static_cast<std::size_t>(i)][d] -= c.own * xi[d];
      if (j >= nOwned) return;
      addToFamily(shares, j, i, xi, -c.others);
      for (std::size_t d = 0; d < D; ++d) toOwn[static_cast<std::size_t>(j)][d] += c.others * xi[d];
    });
    for (int i = 0; i < nOwned; ++i) addToFamily(shares, i, i, toOwn[static_cast<std::size_t>(i)].data(), 1.0);
    const auto width = static_cast<std::size_t>(network_.familyWidth());
    const PointVector<double>& response = stiffness_.response<double>();
    std::vector<const Share*> family;
    for (int i = 0; i < nOwned; ++i) {
      family.clear();
      for (int at = shares.first[static_cast<std::size_t>(i)]; at >= 0; at = family.back()->next)
        family.push_back(&shares.all[static_cast<std::size_t>(at)]);
      std::sort(family.begin(), family.end(),
                [](const Share* x, const Share* y) { return x->piece.number < y->piece.number; });
      std::array<std::array<double, 3>, 3> c{};
      for (std::size_t p = 0; p < width; ++p)
        for (std::size_t q = p; q < width; ++q)
          c[p][q] = c[q][p] = response[width == 1 ? 0 : static_cast<int>(p * (5 - p) / 2 + q)][i];
      for (std::size_t x = 0; x < family.size(); ++x)
        for (std::size_t y = x; y < family.size(); ++y) addProduct(*family[x], *family[y], c, width);
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
  const CoarseSpace& space_;
  std::vector<Piece> pieces_;              ///< [points]
  std::vector<char> isPlain_;              ///< [points]
  std::vector<Shapes> shapes_;             ///< [points] of those that are plain
  std::unordered_map<int, Modes> others_;  ///< of the rest
  std::vector<Stiffness> diagonal_;        ///< [points] what springs to other pieces resist
  PlainSums<D> sums_;
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
