#include "lined_cells.hpp"

#include <algorithm>

namespace pd::decomposition {

namespace {

constexpr std::size_t mostLines = 1000000;  ///< that LinedCells remembers: some 30 MB

double alongness(const Cell& cell, const Place& direction, std::size_t axis) {
  return std::abs(dot(direction, cell.edges[axis])) / lengthOf(cell.edges[axis]);
}

/// The first axis that is better than those before it.
template <class IsBetter>
std::size_t bestAxis(const Cell& cell, const Place& direction, IsBetter isBetter) {
  std::size_t axis = 0;
  for (std::size_t k = 1; k < static_cast<std::size_t>(cell.dimension); ++k)
    if (isBetter(alongness(cell, direction, k), alongness(cell, direction, axis))) axis = k;
  return axis;
}

bool isInAny(const std::vector<const Void*>& voids, const Place& place) {
  return std::any_of(voids.begin(), voids.end(), [&](const Void* v) { return v->contains(place); });
}

/// What is left of a line of a cell: a range of it, and the part of the cell's material that it belongs to.
struct Piece {
  int line;
  Range range;
  std::size_t part;  ///< number of one piece of that part; its own for exactly one
  double length() const { return range.high - range.low; }
};

std::vector<Piece> piecesOf(const LineGrid& grid, const std::vector<const Void*>& voids) {
  std::vector<Piece> pieces;
  std::vector<Range> ranges;
  for (int line = 0; line < grid.size(); ++line) {
    ranges.clear();
    for (const Void* v : voids) v->addWithin(grid.start(line), grid.step, ranges);
    joined(ranges);
    ranges.push_back({1.0, 1.0});
    double low = 0.0;
    for (const Range& range : ranges) {
      if (low < range.low) pieces.push_back({line, {low, range.low}, pieces.size()});
      low = range.high;
    }
  }
  return pieces;
}

std::size_t partOf(std::vector<Piece>& pieces, std::size_t k) {
  while (pieces[k].part != k) k = pieces[k].part = pieces[pieces[k].part].part;
  return k;
}

/// Gives pieces of neighbouring lines one part where the step from one to the other, at the middle of what they share,
/// meets no void.
void joinParts(const LineGrid& grid, const std::vector<const Void*>& voids, std::vector<Piece>& pieces) {
  std::vector<Range> met;
  for (std::size_t k = 0; k < pieces.size(); ++k)
    for (std::size_t l = k + 1; l < pieces.size(); ++l) {
      const int first = pieces[k].line, second = pieces[l].line;
      const bool isNextRow = second == first + grid.nOther,
                 isNextInRow = second == first + 1 && second % grid.nOther != 0;
      if (!isNextRow && !isNextInRow) continue;
      const double low = std::max(pieces[k].range.low, pieces[l].range.low),
                   high = std::min(pieces[k].range.high, pieces[l].range.high);
      if (low >= high) continue;
      const Place start = plus(grid.start(first), grid.step, 0.5 * (low + high));
      met.clear();
      for (const Void* v : voids) v->addWithin(start, minus(grid.start(second), grid.start(first)), met);
      if (met.empty()) pieces[partOf(pieces, l)].part = partOf(pieces, k);
    }
}

/// A part of a cell's material: its share of the cell, and the middle of it.
struct SolidPart {
  std::size_t number;
  double share = 0.0;
  Place middle{};
};

/// Without crumbs.
std::vector<SolidPart> solidParts(const LineGrid& grid, std::vector<Piece>& pieces) {
  constexpr double crumb = 0.02;
  std::map<std::size_t, SolidPart> parts;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    SolidPart& part = parts[pieces[k].part = partOf(pieces, k)];
    const double share = pieces[k].length() / grid.size(), s = 0.5 * (pieces[k].range.low + pieces[k].range.high);
    part.number = pieces[k].part;
    part.share += share;
    part.middle = plus(part.middle, plus(grid.start(pieces[k].line), grid.step, s), share);
  }
  std::vector<SolidPart> result;
  for (auto& [number, part] : parts) {
    part.middle = plus({}, part.middle, 1.0 / part.share);
    if (part.share > crumb) result.push_back(part);
  }
  return result;
}

/// Whether parts of a cell are one in what is three cells wide around it.
bool hangTogetherAround(const Cell& cell, const std::vector<const Void*>& voids, const std::vector<SolidPart>& parts) {
  Cell around = cell;
  for (Place& edge : around.edges) edge = plus({}, edge, 3.0);
  const LineGrid grid(around, 0, cell.dimension == 3 ? 24 : 48);
  std::vector<Piece> pieces = piecesOf(grid, voids);
  joinParts(grid, voids, pieces);
  std::vector<std::size_t> numbers;
  for (const SolidPart& part : parts) {
    const auto apart = [&](const Piece& piece) {
      const double s = dot(minus(part.middle, grid.start(piece.line)), grid.step) / dot(grid.step, grid.step);
      const Place foot = plus(grid.start(piece.line), grid.step, std::clamp(s, piece.range.low, piece.range.high));
      return lengthOf(minus(foot, part.middle));
    };
    const auto nearest = std::min_element(pieces.begin(), pieces.end(),
                                          [&](const Piece& a, const Piece& b) { return apart(a) < apart(b); });
    numbers.push_back(partOf(pieces, static_cast<std::size_t>(nearest - pieces.begin())));
  }
  return std::all_of(numbers.begin(), numbers.end(), [&](std::size_t number) { return number == numbers.front(); });
}

Taken takenByAll(const LineGrid& grid, const LineMeasure& measure, const WithinCell& within) {
  const Lines lines = linesOf(grid);
  std::vector<std::vector<Range>> ofLine(lines.size());
  const auto add = [&](std::size_t line, const Range& range) {
    const Range measured{measure.upTo(range.low), measure.upTo(range.high)};
    if (range.low < range.high && measured.low < measured.high) ofLine[line].push_back(measured);
  };
  std::vector<Range> ranges;
  for (std::size_t r = 0; r < lines.size(); ++r) {
    ranges.clear();
    for (const Void* v : within.of.voids)
      v->addWithin({lines.start[0][r], lines.start[1][r], lines.start[2][r]}, lines.step, ranges);
    for (const Range& range : ranges) add(r, range);
  }
  if (within.seenFrom) {
    std::vector<double> from(lines.size()), to(lines.size());
    for (const Screen* screen : within.of.screens) {
      screen->hide(*within.seenFrom, lines, from.data(), to.data());
      for (std::size_t r = 0; r < lines.size(); ++r) add(r, {from[r], to[r]});
    }
  }
  Taken taken;
  taken.start.push_back(0);
  for (auto& ofOne : ofLine) {
    taken.sum += joined(ofOne);
    taken.most = std::max(taken.most, static_cast<int>(ofOne.size()));
    taken.ranges.insert(taken.ranges.end(), ofOne.begin(), ofOne.end());
    taken.start.push_back(static_cast<int>(taken.ranges.size()));
  }
  return taken.ranges.empty() ? Taken() : taken;
}

/// Whether a place of a cell is material, and on the side of a crack that counts.
bool isCounted(const Cell& cell, const Place& place, const WithinCell& within) {
  if (isInAny(within.of.voids, place)) return false;
  if (!within.seenFrom) return true;
  const Lines line{{std::vector{place[0]}, std::vector{place[1]}, std::vector{place[2]}}, cell.edges[0]};
  return std::none_of(within.of.screens.begin(), within.of.screens.end(), [&](const Screen* screen) {
    double from = 1.0, to = 0.0;
    screen->hide(*within.seenFrom, line, &from, &to);
    return from <= 0.0 && to > 0.0;
  });
}

}  // namespace

Place samplePlace(const Cell& cell, int k) {
  constexpr double g = 1.2207440846057596;
  Place place = cell.center;
  double power = 1.0;
  for (const Place& edge : cell.edges) {
    power /= g;
    const double s = 0.5 + k * power;
    place = plus(place, edge, s - std::floor(s) - 0.5);
  }
  return place;
}

Offset sampleOffset(int k) {
  // Bits of k in turn, the first the most: all so far are evenly spread.
  Offset offset{0.0, 0.0};
  double part = 0.5;
  for (; k > 0; k >>= 2, part *= 0.5) {
    offset[0] += part * ((k ^ (k >> 1)) & 1);
    offset[1] += part * ((k >> 1) & 1);
  }
  return {offset[0] + 0.5 / sampleOffsetsASide, offset[1] + 0.5 / sampleOffsetsASide};
}

std::optional<Place> placeThatSees(const Cell& cell, const std::vector<const Void*>& voids) {
  if (!isInAny(voids, cell.center)) return cell.center;
  const LineGrid grid(cell, 0, cell.dimension == 3 ? 8 : 16);
  std::vector<Piece> pieces = piecesOf(grid, voids);
  joinParts(grid, voids, pieces);
  const std::vector<SolidPart> parts = solidParts(grid, pieces);
  if (parts.size() < 2 || (parts.size() > 2 && hangTogetherAround(cell, voids, parts))) return std::nullopt;
  // Any direction, along no lattice: all cells of a row take the same side.
  constexpr Place above{0.29, 0.57, 0.77};
  constexpr double tie = 0.02;
  const SolidPart* part = &parts.front();
  for (const SolidPart& other : parts) {
    const double more = other.share - part->share;
    if (std::abs(more) > tie ? more > 0.0 : dot(minus(other.middle, part->middle), above) > 0.0) part = &other;
  }
  std::optional<Place> nearest;
  for (const Piece& piece : pieces) {
    if (piece.part != part->number) continue;
    const Place place = plus(grid.start(piece.line), grid.step, 0.5 * (piece.range.low + piece.range.high));
    if (!nearest || lengthOf(minus(place, part->middle)) < lengthOf(minus(*nearest, part->middle))) nearest = place;
  }
  return nearest;
}

LineGrid::LineGrid(const Cell& cell, std::size_t axis, int nParts, const Offset& offset)
    : step(cell.edges[axis]), strides{}, n(nParts), nOther(cell.dimension == 3 ? nParts : 1) {
  const auto dimension = static_cast<std::size_t>(cell.dimension);
  first = plus(cell.center, step, -0.5);
  for (std::size_t k = 0; k + 1 < dimension; ++k) {
    const Place& edge = cell.edges[(axis + 1 + k) % dimension];
    strides[k] = plus({}, edge, 1.0 / n);
    first = plus(first, edge, offset[k] / n - 0.5);
  }
}

Lines linesOf(const LineGrid& grid) {
  Lines lines;
  lines.step = grid.step;
  for (int r = 0; r < grid.size(); ++r) {
    const Place start = grid.start(r);
    for (std::size_t d = 0; d < 3; ++d) lines.start[d].push_back(start[d]);
  }
  return lines;
}

std::size_t axisAcross(const Cell& cell, const Place& direction) {
  return bestAxis(cell, direction, [](double a, double b) { return a < (1.0 - 1e-9) * b; });
}

std::size_t axisAlong(const Cell& cell, const Place& direction) {
  return bestAxis(cell, direction, [](double a, double b) { return a > (1.0 + 1e-9) * b; });
}

double joined(std::vector<Range>& ranges) {
  std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) { return a.low < b.low; });
  std::size_t n = 0;
  for (const Range& range : ranges) {
    if (n > 0 && range.low <= ranges[n - 1].high)
      ranges[n - 1].high = std::max(ranges[n - 1].high, range.high);
    else if (range.low < range.high)
      ranges[n++] = range;
  }
  ranges.resize(n);
  double sum = 0.0;
  for (const Range& range : ranges) sum += range.high - range.low;
  return sum;
}

bool Taken::covers(int line, double s) const {
  for (int k = 0; k < number(line); ++k)
    if (of(line)[k].low <= s && s < of(line)[k].high) return true;
  return false;
}

const Taken& LinedCells::taken(int id, const Cell& cell, std::size_t axis, int n, const LineMeasure& measure,
                               const NearDiscontinuities& near) {
  return takenBy(id, cell, {static_cast<int>(axis), n, measure.nParts, -1}, inTheMiddle, near);
}

const Taken& LinedCells::takenOfSample(int id, const Cell& cell, std::size_t axis, int k,
                                       const NearDiscontinuities& near) {
  return takenBy(id, cell, {static_cast<int>(axis), sampleLines, 0, k}, sampleOffset(k), near);
}

const Taken& LinedCells::takenBy(int id, const Cell& cell, const std::array<int, 4>& key, const Offset& offset,
                                 const NearDiscontinuities& near) {
  static const Taken nothing;
  Found& found = this->found(id, cell, near);
  if (found.within.of.empty()) return nothing;
  const auto [entry, isNew] = found.taken.try_emplace(key);
  if (isNew) {
    const LineGrid grid(cell, static_cast<std::size_t>(key[0]), key[1], offset);
    entry->second = takenByAll(grid, LineMeasure{key[2]}, found.within);
    nLines_ += static_cast<std::size_t>(grid.size());
  }
  return entry->second;
}

const std::vector<char>& LinedCells::countedSamples(int id, const Cell& cell, int n, const NearDiscontinuities& near) {
  Found& found = this->found(id, cell, near);
  auto& counted = found.countedSamples;
  nLines_ += static_cast<std::size_t>(std::max(0, n - static_cast<int>(counted.size()))) / 32;
  for (int k = static_cast<int>(counted.size()); k < n; ++k)
    counted.push_back(found.within.of.empty() || isCounted(cell, samplePlace(cell, k), found.within) ? 1 : 0);
  return counted;
}

void LinedCells::forgetMany() {
  if (nLines_ < mostLines) return;
  cells_.clear();
  nLines_ = 0;
}

LinedCells::Found& LinedCells::found(int id, const Cell& cell, const NearDiscontinuities& near) {
  const auto [entry, isNew] = cells_.try_emplace(id);
  if (isNew) {
    nLines_ += 4;
    const Box box = boxAround(cell, cell);
    for (const Screen* screen : near.screens)
      if (screen->box().meets(box) && screen->isBetween(cell, cell)) entry->second.within.of.screens.push_back(screen);
    for (const Void* v : near.voids)
      if (v->box().meets(box)) entry->second.within.of.voids.push_back(v);
    entry->second.within.seenFrom = placeThatSees(cell, entry->second.within.of.voids);
  }
  return entry->second;
}

}  // namespace pd::decomposition
