// Cells by parallel lines, and what of them counts.
#ifndef PD_LINED_CELLS_HPP
#define PD_LINED_CELLS_HPP

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "discontinuities.hpp"

namespace pd::decomposition {

/// What of the discontinuities is near a bond or a cell.
struct NearDiscontinuities {
  std::vector<const Screen*> screens;
  std::vector<const Void*> voids;
  std::vector<Box> screenBoxes{};  ///< of many screens, so that they need not be asked; or empty
  bool empty() const { return screens.empty() && voids.empty(); }
};

/// How lines are measured: by the number of the middles of n equal parts on them, or by their length, which is 1.
struct LineMeasure {
  int nParts;  ///< 0: by length
  bool counts() const { return nParts > 0; }
  double whole() const { return counts() ? nParts : 1.0; }
  /// Of the range of a line from 0 to s.
  double upTo(double s) const { return counts() ? std::ceil(nParts * s - 0.5) : s; }
};

/// Where in the squares, or on the pieces, of other edges the lines of a grid are: from 0 to 1.
using Offset = std::array<double, 2>;
constexpr Offset inTheMiddle{0.5, 0.5};

/// n^(D-1) lines along an edge of a cell, through the middles (or other places) of n equal parts of the others: line
/// m nOther + l begins at first + m strides[0] + l strides[1].
struct LineGrid {
  LineGrid() = default;
  LineGrid(const Cell& cell, std::size_t axis, int n, const Offset& offset = inTheMiddle);
  int size() const { return n * nOther; }
  Place start(int line) const { return plus(plus(first, strides[0], line / nOther), strides[1], line % nOther); }

  Place first{}, step{};
  std::array<Place, 2> strides{};
  int n = 0, nOther = 1;
};
Lines linesOf(const LineGrid& grid);

/// The edge of a cell that is most across a direction, or most along it; of several the first.
std::size_t axisAcross(const Cell& cell, const Place& direction);
std::size_t axisAlong(const Cell& cell, const Place& direction);

/// Sorts ranges, joins those that overlap, and returns their length together.
double joined(std::vector<Range>& ranges);

/// The place from which a cell sees its material; what it does not see does not count. That is the cell's point, but
/// where that is in a void which parts the material of the cell in two, a place in the larger part (of those within 2 %
/// of the cell as large: in that above, along one direction for all cells), so that only one face of the void holds on;
/// and so of more parts that are apart beyond the cell, too, as where slits cross. Nothing where a void at the point
/// leaves one part, or more than two that hang together around it, as a pore does: all counts. `voids`: those that meet
/// it.
std::optional<Place> placeThatSees(const Cell& cell, const std::vector<const Void*>& voids);

/// What of a cell's lines does not count, by a measure: what is in voids, or on the other side of a crack than the
/// cell's point (placeThatSees).
struct Taken {
  std::vector<Range> ranges;  ///< apart from each other
  std::vector<int> start;     ///< [lines + 1] where those of a line begin; empty where everything counts
  int most = 0;               ///< ranges of one line
  double sum = 0.0;           ///< over all lines

  int number(int line) const { return start.empty() ? 0 : start[line + 1] - start[line]; }
  const Range* of(int line) const { return ranges.data() + start[line]; }
  bool covers(int line, double s) const;
};

/// What of the discontinuities is in a cell, and from where it is seen.
struct WithinCell {
  NearDiscontinuities of;
  std::optional<Place> seenFrom;
};

/// Of a sample of a cell in space: place k = 0, 1 ... of a sequence that fills it evenly, however long (Kronecker's,
/// with the powers of the root of g^4 = g + 1).
Place samplePlace(const Cell& cell, int k);
constexpr int sampleLines = 4;         ///< lines along each edge, at one offset
constexpr int sampleOffsetsASide = 4;  ///< of the grid that all offsets make
/// Of the lines of a sample, k = 0 ... 15: the first few are spread evenly, all together make a grid of 16 x 16 lines.
Offset sampleOffset(int k);

/// What discontinuities take of cells, and remembers it.
class LinedCells {
 public:
  /// `id`: that of the cell; `near`: all that is near it, and always the same. What is returned is good until
  /// forgetMany().
  const Taken& taken(int id, const Cell& cell, std::size_t axis, int n, const LineMeasure& measure,
                     const NearDiscontinuities& near);
  /// Of lines sampleLines a side at sampleOffset(k), by their length.
  const Taken& takenOfSample(int id, const Cell& cell, std::size_t axis, int k, const NearDiscontinuities& near);
  /// Which of the first `n` places of the cell (samplePlace) count.
  const std::vector<char>& countedSamples(int id, const Cell& cell, int n, const NearDiscontinuities& near);
  const WithinCell& within(int id, const Cell& cell, const NearDiscontinuities& near) {
    return found(id, cell, near).within;
  }
  /// Forgets all where that is much.
  void forgetMany();

 private:
  struct Found {
    WithinCell within;
    std::map<std::array<int, 4>, Taken> taken;  ///< by axis, n, whether middles are counted, and the sample
    std::vector<char> countedSamples;
  };
  const Taken& takenBy(int id, const Cell& cell, const std::array<int, 4>& key, const Offset& offset,
                       const NearDiscontinuities& near);
  Found& found(int id, const Cell& cell, const NearDiscontinuities& near);

  std::unordered_map<int, Found> cells_;
  std::size_t nLines_ = 0;
};

}  // namespace pd::decomposition

#endif
