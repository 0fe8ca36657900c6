#include "lines_through_plane_cells.hpp"

#include <algorithm>
#include <cmath>

#include "convex_geometry.hpp"

namespace pd::decomposition {

namespace stdx = kernels::stdx;
using kernels::allLanes;
using kernels::choose;
using kernels::greaterBits;
using kernels::Vector;

namespace {

constexpr double halfPi = 1.57079632679489661923;
constexpr Range nowhere{beyondAll, -beyondAll};
constexpr auto nLanes = static_cast<std::size_t>(kernels::lanes);

unsigned char andBits(unsigned a, unsigned b) { return static_cast<unsigned char>(a & b); }

/// Angles from `forward` towards `sideways` of lines through both sets of places, the second one ahead; of sets that
/// are not apart along `forward` all.
Range anglesOf(const std::vector<Place>& ofA, const std::vector<Place>& ofB, const Place& forward,
               const Place& sideways, bool& areApart) {
  double low = beyondAll, high = -beyondAll;
  areApart = true;
  for (const Place& a : ofA)
    for (const Place& b : ofB) {
      const Place way = minus(b, a);
      const double x = dot(way, forward), y = dot(way, sideways), least = 1e-9 * std::abs(y);
      areApart = areApart && x >= -least;
      const double slope = y / std::max(x, least + 1e-300);
      low = std::min(low, slope);
      high = std::max(high, slope);
    }
  return areApart ? Range{std::atan(low), std::atan(high)} : Range{-halfPi, halfPi};
}

/// Along the edge of the first cell that goes most towards the other.
Place forwardOf(const Cell& a, const Cell& b) {
  const Place way = minus(b.center, a.center);
  const Place& edge = a.edges[axisAlong(a, way)];
  return plus({}, edge, std::copysign(1.0 / lengthOf(edge), dot(way, edge)));
}

/// Of ranges of s: the integrals of 1 and of s.
struct Moments {
  Vector zeroth = 0.0, first = 0.0;
  PD_EACH_BOND void add(const Vector& from, const Vector& end) {
    const Vector to = stdx::max(from, end);
    zeroth += to - from;
    first += 0.5 * (to * to - from * from);
  }
};

/// Of pairs of places, one of each, of which none is between two of the other.
PD_EACH_BOND Vector pairsOf(const Moments& a, const Moments& b) {
  return stdx::abs(a.zeroth * b.first - a.first * b.zeroth);
}

/// Of pairs of places of two ranges, wherever they are: from |x|, integrated twice.
double pairsOf(const Range& a, const Range& b) {
  const auto twice = [](double x) { return std::abs(x * x * x) / 6.0; };
  return twice(b.high - a.low) - twice(b.low - a.low) - twice(b.high - a.high) + twice(b.low - a.high);
}

/// Part of a chord between `from` and `to`, without what is taken, of which ranges are in order.
PD_EACH_BOND Moments momentsOf(const Vector& from, const Vector& to, const std::vector<RangePerLane>& taken) {
  Moments moments;
  Vector at = from;
  for (const RangePerLane& range : taken) {
    const unsigned char isThere = greaterBits(range.high, range.low);
    moments.add(at, choose(stdx::min(range.low, to), at, isThere));
    at = choose(stdx::min(to, stdx::max(at, range.high)), at, isThere);
  }
  moments.add(at, to);
  return moments;
}

/// Keeps of each line's range what lies in a half-space.
PD_EACH_BOND void keepWithin(const HalfSpace& half, const Place& origin, const LinePerLane& lines,
                             RangePerLane& range) {
  const Vector slope = dot(half.normal, lines.step), depth = half.offset - dot(half.normal, minus(lines.start, origin));
  const unsigned char isUp = greaterBits(slope, 1e-300), isDown = greaterBits(-1e-300, slope),
                      isOutside = static_cast<unsigned char>(greaterBits(0.0, depth) & ~isUp & ~isDown);
  const Vector s = depth / choose(slope, 1.0, static_cast<unsigned char>(isUp | isDown));
  range.low = choose(stdx::max(range.low, s), range.low, isDown);
  range.high = choose(-beyondAll, choose(stdx::min(range.high, s), range.high, isUp), isOutside);
}

/// Adds what a place does not see of a line past a screen.
void addHidden(const Screen& screen, const Place& place, const Place& start, const Place& step,
               std::vector<Range>& ranges) {
  const Lines line{{std::vector{start[0]}, std::vector{start[1]}, std::vector{start[2]}}, step};
  Range hidden = nowhere;
  screen.hide(place, line, &hidden.low, &hidden.high);
  if (hidden.low < hidden.high) ranges.push_back(hidden);
}

/// Places on the outline at which what counts of a cell begins or ends.
void addKinks(const std::vector<Place>& outline, const WithinCell& within, std::vector<Place>& kinks) {
  std::vector<Range> ranges;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Place &start = outline[k], step = minus(outline[(k + 1) % outline.size()], start);
    ranges.clear();
    for (const Void* v : within.of.voids) v->addWithin(start, step, ranges);
    if (within.seenFrom)
      for (const Screen* screen : within.of.screens) addHidden(*screen, *within.seenFrom, start, step, ranges);
    for (const Range& range : ranges)
      for (const double s : {range.low, range.high})
        if (s > 0.0 && s < 1.0) kinks.push_back(plus(start, step, s));
  }
}

}  // namespace

void LinesThroughPlaneCells::setUp(SideAtWork& side, const Side& of) {
  side.of = of;
  const Cell& cell = *of.cell;
  for (std::size_t k = 0; k < 2; ++k) {
    // Faces across one edge are along the other.
    const Place normal{-cell.edges[1 - k][1], cell.edges[1 - k][0], 0.0};
    side.perEdge[k] = plus({}, normal, 1.0 / dot(normal, cell.edges[k]));
  }
  const Corners corners = cell.corners();
  side.outline.assign(corners.begin(), corners.end());
  std::swap(side.outline[2], side.outline[3]);
  side.shadows.clear();
  if (!of.within->seenFrom) return;
  for (const Screen* screen : of.within->of.screens) {
    side.shadows.emplace_back();
    screen->addShadow(inAllLanes(*of.within->seenFrom), cell.center, side.shadows.back());
  }
}

double LinesThroughPlaneCells::share(const Side& a, const Side& b, const std::vector<const Screen*>& screens,
                                     double tolerance) {
  setUp(a_, a);
  setUp(b_, b);
  screens_ = screens;
  middle_ = plus(plus({}, a.cell->center, 0.5), b.cell->center, 0.5);
  kinks_.clear();
  addKinks(a_.outline, *a_.of.within, kinks_);
  addKinks(b_.outline, *b_.of.within, kinks_);
  const Pairs pairs = atAllAngles(tolerance);
  return pairs.all <= 0.0 ? -1.0 : pairs.seen / pairs.all;
}

LinesThroughPlaneCells::Pairs LinesThroughPlaneCells::atAllAngles(double tolerance) {
  const Place forward = forwardOf(*a_.of.cell, *b_.of.cell), sideways{-forward[1], forward[0], 0.0};
  bool areApart = true;
  const Range range = anglesOf(a_.outline, b_.outline, forward, sideways, areApart);
  const auto at = [&](double angle) {
    return atAngle(plus(plus({}, forward, std::cos(angle)), sideways, std::sin(angle)));
  };
  const auto rule = [](const Pairs& first, const Pairs& middle, const Pairs& last, double width) {
    const double sixth = width / 6.0;
    return Pairs{sixth * (first.seen + 4.0 * middle.seen + last.seen),
                 sixth * (first.all + 4.0 * middle.all + last.all)};
  };
  struct Piece {
    double low, high;
    Pairs first, middle, last;
  };
  // At the ends lines touch corners only; or they are those of the other end.
  constexpr int nPieces = 3;         // not directions of lattices
  constexpr double ofPieces = 0.25;  // of the tolerance, since what several pieces miss adds up
  std::vector<Piece> pieces;
  const double width = (range.high - range.low) / nPieces, least = 1e-4 * width;
  const Pairs end = areApart ? Pairs() : at(range.low);
  double size = 0.0;
  for (int k = 0; k < nPieces; ++k) {
    const double low = range.low + k * width;
    const Pairs first = k == 0 ? end : pieces.back().last, last = k + 1 == nPieces ? end : at(low + width);
    pieces.push_back({low, low + width, first, at(low + 0.5 * width), last});
    size += rule(first, pieces.back().middle, last, width).all;
  }
  Pairs sum;
  while (!pieces.empty()) {
    const Piece piece = pieces.back();
    pieces.pop_back();
    const double half = 0.5 * (piece.high - piece.low), middle = piece.low + half;
    const Piece left{piece.low, middle, piece.first, at(piece.low + 0.5 * half), piece.middle},
        right{middle, piece.high, piece.middle, at(middle + 0.5 * half), piece.last};
    const Pairs coarse = rule(piece.first, piece.middle, piece.last, 2.0 * half),
                one = rule(left.first, left.middle, left.last, half),
                two = rule(right.first, right.middle, right.last, half);
    const Pairs fine{one.seen + two.seen, one.all + two.all};
    const double change = fine.seen - coarse.seen, changeOfHidden = fine.all - coarse.all - change;
    if (std::max(std::abs(change), std::abs(changeOfHidden)) <= ofPieces * tolerance * size || half < least) {
      sum.seen += fine.seen;
      sum.all += fine.all;
    } else {
      pieces.push_back(left);
      pieces.push_back(right);
    }
  }
  return sum;
}

/// Heights at which something begins or ends, in order; false where no line passes through both cells.
bool LinesThroughPlaneCells::findHeights(const Place& across) {
  const double origin = dot(middle_, across);
  Range common{-beyondAll, beyondAll};
  heights_.clear();
  for (const SideAtWork* side : {&a_, &b_}) {
    Range own = nowhere;
    for (const Place& corner : side->outline) {
      const double height = dot(corner, across) - origin;
      own.low = std::min(own.low, height);
      own.high = std::max(own.high, height);
      heights_.push_back(height);
    }
    common.low = std::max(common.low, own.low);
    common.high = std::min(common.high, own.high);
    if (!side->shadows.empty()) heights_.push_back(dot(*side->of.within->seenFrom, across) - origin);
  }
  if (common.low >= common.high) return false;
  for (const Place& kink : kinks_) heights_.push_back(dot(kink, across) - origin);
  inReach_.clear();
  const bool isPartVoid = !a_.of.within->of.voids.empty() || !b_.of.within->of.voids.empty();
  for (const Screen* screen : screens_) {
    const Range reach = screen->heights(across);
    if (reach.low - origin >= common.high || reach.high - origin <= common.low) continue;
    inReach_.push_back(screen);
    heights_.push_back(reach.low - origin);
    heights_.push_back(reach.high - origin);
    if (!isPartVoid) continue;
    // At its ends what a round void takes of a line grows like a root.
    constexpr double nearEnd = 0.05;
    heights_.push_back((1.0 - nearEnd) * reach.low + nearEnd * reach.high - origin);
    heights_.push_back(nearEnd * reach.low + (1.0 - nearEnd) * reach.high - origin);
  }
  std::size_t n = 0;
  for (const double height : heights_)
    if (height > common.low && height < common.high) heights_[n++] = height;
  heights_.resize(n);
  heights_.push_back(common.low);
  heights_.push_back(common.high);
  std::sort(heights_.begin(), heights_.end());
  return true;
}

/// Of all parallel lines in this direction.
PD_INLINES LinesThroughPlaneCells::Pairs LinesThroughPlaneCells::atAngle(const Place& along) {
  const Place across{-along[1], along[0], 0.0};
  if (!findHeights(across)) return {};
  // Gauss's rule of two nodes, exact for polynomials of third degree, as pairs between straight lines are.
  constexpr std::array<double, 2> nodes{0.21132486540518713, 0.7886751345948129};
  LinePerLane lines{{}, inAllLanes(along)};
  Vector height = 0.0, weight = 0.0, seen = 0.0, all = 0.0;
  std::size_t lane = 0;
  const auto count = [&] {
    for (std::size_t d = 0; d < 3; ++d) lines.start[d] = middle_[d] + height * across[d];
    const PairsPerLane pairs = pairsOn(lines);
    seen += weight * pairs.seen;
    all += weight * pairs.all;
    nLines_ += static_cast<long long>(lane);
    weight = 0.0;
    lane = 0;
  };
  const double least = 1e-9 * (heights_.back() - heights_.front());
  for (std::size_t k = 0; k + 1 < heights_.size(); ++k) {
    const double low = heights_[k], piece = heights_[k + 1] - low;
    if (piece <= least) continue;
    for (const double node : nodes) {
      height[lane] = low + node * piece;
      weight[lane] = 0.5 * piece;
      if (++lane == nLanes) count();
    }
  }
  if (lane > 0) count();
  return {stdx::reduce(seen), stdx::reduce(all)};
}

PD_INLINES void LinesThroughPlaneCells::findChord(SideAtWork& side, const LinePerLane& lines) {
  const Cell& cell = *side.of.cell;
  const Places start = minus(lines.start, cell.center);
  side.chord = {-beyondAll, beyondAll};
  for (std::size_t k = 0; k < side.perEdge.size(); ++k) {
    const Vector slope = dot(side.perEdge[k], lines.step), height = dot(side.perEdge[k], start);
    // Lines along the faces: all or nothing.
    const Vector perSlope = 1.0 / choose(slope, 1e-12, greaterBits(stdx::abs(slope), 1e-12));
    const Vector at = -height * perSlope, half = 0.5 * stdx::abs(perSlope);
    side.chord = {stdx::max(side.chord.low, at - half), stdx::min(side.chord.high, at + half)};
  }
  side.chord.high = stdx::max(side.chord.low, side.chord.high);
  side.taken.clear();
  for (const Void* v : side.of.within->of.voids) v->addWithinEach(lines, side.taken);
  for (const auto& shadow : side.shadows) {
    RangePerLane hidden{-beyondAll, beyondAll};
    for (const HalfSpace& half : shadow) keepWithin(half, cell.center, lines, hidden);
    side.taken.push_back(hidden);
  }
  sortEach(side.taken);
}

/// A connection from a place of the chord that comes first to one of the other passes what begins before the middle of
/// the gap between them if the place is before its end, and what begins behind it if that is before the other place.
PD_INLINES void LinesThroughPlaneCells::meetScreens(const LinePerLane& lines) {
  const unsigned char isAFirst = greaterBits(b_.chord.low, a_.chord.low);
  const Vector gap = 0.5 * (choose(a_.chord.high, b_.chord.high, isAFirst) + stdx::max(a_.chord.low, b_.chord.low));
  a_.inSight = b_.inSight = {-beyondAll, beyondAll};
  met_.clear();
  for (const Screen* screen : inReach_) {
    const RangePerLane met = screen->meet(lines);
    met_.push_back(met);
    const auto isThere = static_cast<unsigned char>(~greaterBits(met.low, met.high)),
               isLeft = andBits(greaterBits(gap, met.low), isThere), isRight = andBits(~isLeft, isThere);
    for (SideAtWork* side : {&a_, &b_}) {
      const auto isFirst = static_cast<unsigned char>(side == &a_ ? isAFirst : ~isAFirst);
      side->inSight = {stdx::max(side->inSight.low, choose(met.high, -beyondAll, andBits(isLeft, isFirst))),
                       stdx::min(side->inSight.high, choose(met.low, beyondAll, andBits(isRight, ~isFirst)))};
    }
  }
}

PD_INLINES LinesThroughPlaneCells::PairsPerLane LinesThroughPlaneCells::pairsOn(const LinePerLane& lines) {
  findChord(a_, lines);
  findChord(b_, lines);
  meetScreens(lines);
  std::array<Moments, 2> all, seen;
  for (std::size_t k = 0; k < 2; ++k) {
    const SideAtWork& side = k == 0 ? a_ : b_;
    const auto& [low, high] = side.chord;
    all[k] = momentsOf(low, high, side.taken);
    const Vector from = stdx::min(high, stdx::max(low, side.inSight.low)),
                 to = stdx::max(from, stdx::min(high, side.inSight.high));
    seen[k] = momentsOf(from, to, side.taken);
  }
  PairsPerLane pairs{pairsOf(seen[0], seen[1]), pairsOf(all[0], all[1])};
  const unsigned char doOverlap =
      greaterBits(stdx::min(a_.chord.high, b_.chord.high), stdx::max(a_.chord.low, b_.chord.low) + 1e-12);
  for (std::size_t lane = 0; doOverlap != 0 && lane < nLanes; ++lane)
    if (((doOverlap >> lane) & 1) != 0) countOverlapping(lane, pairs);
  return pairs;
}

/// Of a line on which chords of both cells have a part in common: piece by piece between what it meets.
void LinesThroughPlaneCells::countOverlapping(std::size_t lane, PairsPerLane& pairs) const {
  const auto counted = [&](const SideAtWork& side, const Range& within) {
    std::vector<Range> ranges;
    double low = std::max<double>(side.chord.low[lane], within.low);
    const double high = std::min<double>(side.chord.high[lane], within.high);
    for (const RangePerLane& range : side.taken) {
      const double from = range.low[lane], to = range.high[lane];
      if (from >= to) continue;
      if (low < std::min(from, high)) ranges.push_back({low, std::min(from, high)});
      low = std::max(low, to);
    }
    if (low < high) ranges.push_back({low, high});
    return ranges;
  };
  const auto pairsWithin = [&](const Range& within) {
    const std::vector<Range> ofB = counted(b_, within);
    double number = 0.0;
    for (const Range& a : counted(a_, within))
      for (const Range& b : ofB) number += pairsOf(a, b);
    return number;
  };
  std::vector<Range> met;
  for (const RangePerLane& range : met_)
    if (range.low[lane] <= range.high[lane]) met.push_back({range.low[lane], range.high[lane]});
  std::sort(met.begin(), met.end(), [](const Range& a, const Range& b) { return a.low < b.low; });
  double low = -beyondAll, seen = 0.0;
  for (const Range& range : met) {
    if (low < range.low) seen += pairsWithin({low, range.low});
    low = std::max(low, range.high);
  }
  pairs.seen[lane] = seen + pairsWithin({low, beyondAll});
  pairs.all[lane] = pairsWithin({-beyondAll, beyondAll});
}

}  // namespace pd::decomposition
