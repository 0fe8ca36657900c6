#include "bond_decomposition.hpp"

#include <algorithm>
#include <cmath>

namespace pd::decomposition {

namespace {

constexpr double negligible = 1e-6;       ///< what is less counts as nothing
constexpr double errorOfIntegral = 1e-4;  ///< of the share beside a straight crack; what is less is no bond

/// center + sum of s_k edge_k
Place placeIn(const Cell& cell, const std::array<double, 3>& s) {
  Place place = cell.center;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t d = 0; d < 3; ++d) place[d] += s[k] * cell.edges[k][d];
  return place;
}

bool isIn(const std::vector<const Void*>& voids, const Place& place) {
  return std::any_of(voids.begin(), voids.end(), [&](const Void* v) { return v->contains(place); });
}

/// Length of the union of ranges; sorts them.
double covered(std::vector<Range>& ranges) {
  std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) { return a.low < b.low; });
  double sum = 0.0, end = 0.0;
  for (const Range& range : ranges) {
    if (range.high <= end) continue;
    sum += range.high - std::max(range.low, end);
    end = range.high;
  }
  return sum;
}

/// A cell by lines along one of its edges.
struct LinedCell {
  Lines lines;
  /// [lines] what is in voids, or on the other side of a crack than the cell's point; empty where no line has any.
  std::vector<std::vector<Range>> left;
  double counted = 0.0;  ///< sum of the shares of lines that are neither
};

/// The shares of [0, 1] of a line that count: all of it, or the middles of equal parts.
class Measure {
 public:
  explicit Measure(int nParts) : nParts_(nParts) {}
  /// Ends moved so that the length of a range is the share of the middles in it.
  double snapped(double s) const { return nParts_ == 0 ? s : std::ceil(nParts_ * s - 0.5) / nParts_; }

 private:
  int nParts_;  ///< 0: all
};

/// n^(D-1) lines along the edge that is most across `direction`, through the middles of equal parts of the others.
Lines linesAcross(const Cell& cell, const Place& direction, int n) {
  const auto dimension = static_cast<std::size_t>(cell.dimension);
  const auto alongness = [&](std::size_t k) {
    return std::abs(dot(direction, cell.edges[k])) / std::sqrt(dot(cell.edges[k], cell.edges[k]));
  };
  std::size_t axis = 0;
  for (std::size_t k = 1; k < dimension; ++k)
    if (alongness(k) < (1.0 - 1e-9) * alongness(axis)) axis = k;
  Lines lines;
  lines.step = cell.edges[axis];
  const int nOther = dimension == 3 ? n : 1;
  for (int m = 0; m < n; ++m)
    for (int l = 0; l < nOther; ++l) {
      std::array<double, 3> s{};
      s[axis] = -0.5;
      s[(axis + 1) % dimension] = (m + 0.5) / n - 0.5;
      if (dimension == 3) s[(axis + 2) % 3] = (l + 0.5) / n - 0.5;
      const Place start = placeIn(cell, s);
      for (std::size_t d = 0; d < 3; ++d) lines.start[d].push_back(start[d]);
    }
  return lines;
}

/// Adds what `place` does not see of each line.
void addHidden(const Place& place, const std::vector<const Screen*>& screens, const Lines& lines,
               const Measure& measure, std::vector<std::vector<Range>>& hidden) {
  static thread_local std::vector<double> from, to;
  from.resize(lines.size());
  to.resize(lines.size());
  for (const Screen* screen : screens) {
    screen->hide(place, lines, from.data(), to.data());
    for (std::size_t r = 0; r < lines.size(); ++r) {
      const Range range{measure.snapped(from[r]), measure.snapped(to[r])};
      if (from[r] < to[r] && range.low < range.high) hidden[r].push_back(range);
    }
  }
}

LinedCell lined(const Cell& cell, const Place& direction, int n, const NearDiscontinuities& near,
                const Measure& measure) {
  LinedCell result;
  result.lines = linesAcross(cell, direction, n);
  const Lines& lines = result.lines;
  result.left.resize(lines.size());
  if (!isIn(near.voids, cell.center)) addHidden(cell.center, near.screens, lines, measure, result.left);
  for (std::size_t r = 0; r < lines.size(); ++r) {
    std::vector<Range> ranges;
    for (const Void* v : near.voids)
      v->addWithin({lines.start[0][r], lines.start[1][r], lines.start[2][r]}, lines.step, ranges);
    for (const Range& range : ranges)
      result.left[r].push_back({measure.snapped(range.low), measure.snapped(range.high)});
    result.counted += 1.0 - covered(result.left[r]);
  }
  if (std::all_of(result.left.begin(), result.left.end(), [](const auto& ranges) { return ranges.empty(); }))
    result.left.clear();
  return result;
}

/// Calls visit(place) for the middles of n^D equal parts of the cell.
template <class Visit>
void forEachPart(const Cell& cell, int n, Visit visit) {
  const int nLast = cell.dimension == 3 ? n : 1;
  for (int k = 0; k < n; ++k)
    for (int l = 0; l < n; ++l)
      for (int m = 0; m < nLast; ++m)
        visit(
            placeIn(cell, {(k + 0.5) / n - 0.5, (l + 0.5) / n - 0.5, cell.dimension == 3 ? (m + 0.5) / n - 0.5 : 0.0}));
}

/// How much of what counts of a cell's lines a place sees past all screens.
class Sight {
 public:
  Sight(const LinedCell& cell, const std::vector<const Screen*>& screens, const Measure& measure)
      : cell_(cell), screens_(screens), measure_(measure), from_(cell.lines.size()), to_(cell.lines.size()) {}

  double seen(const Place& place) {
    if (screens_.size() == 1 && cell_.left.empty()) return seenPastOne(place);
    if (cell_.left.empty())
      hidden_.assign(cell_.lines.size(), {});
    else
      hidden_ = cell_.left;
    addHidden(place, screens_, cell_.lines, measure_, hidden_);
    double sum = static_cast<double>(hidden_.size());
    for (auto& ranges : hidden_) sum -= covered(ranges);
    return sum;
  }

 private:
  double seenPastOne(const Place& place) {
    screens_.front()->hide(place, cell_.lines, from_.data(), to_.data());
    const std::size_t n = from_.size();
    double sum = static_cast<double>(n);
    for (std::size_t r = 0; r < n; ++r) {
      const double length = measure_.snapped(to_[r]) - measure_.snapped(from_[r]);
      sum -= from_[r] < to_[r] ? length : 0.0;
    }
    return sum;
  }

  const LinedCell& cell_;
  const std::vector<const Screen*>& screens_;
  const Measure measure_;
  std::vector<double> from_, to_;
  std::vector<std::vector<Range>> hidden_;
};

/// Whether a screen may pass through the cell.
bool isCut(const Cell& cell, const std::vector<const Screen*>& screens) {
  const Box box = boxAround(cell, cell);
  return std::any_of(screens.begin(), screens.end(),
                     [&](const Screen* screen) { return screen->box().meets(box) && screen->isBetween(cell, cell); });
}

/// Whether a connection meets one of the screens.
bool meetsAny(const std::vector<const Screen*>& screens, const Place& from, const Place& to) {
  // A line of next to no length across the end, whose middle is the end.
  const Place way = minus(to, from),
              across =
                  crossed(way, std::abs(way[2]) < lengthOf(way) * 0.9 ? Place{0.0, 0.0, 1.0} : Place{1.0, 0.0, 0.0});
  Lines end;
  end.step = plus({}, across, 1e-9 * lengthOf(way) / std::max(lengthOf(across), 1e-300));
  const Place start = plus(to, end.step, -0.5);
  for (std::size_t d = 0; d < 3; ++d) end.start[d] = {start[d]};
  return std::any_of(screens.begin(), screens.end(), [&](const Screen* screen) {
    double first = 0.0, last = 0.0;
    screen->hide(from, end, &first, &last);
    return first <= 0.5 && last > 0.5;
  });
}

/// Negative where no place of `a`, or of `b`, that it looks at counts.
double sharePast(const Cell& a, const Cell& b, const NearDiscontinuities& near, int n, bool countsMiddles,
                 long long* nLines) {
  const Measure measure(countsMiddles ? n : 0);
  const LinedCell cell = lined(b, minus(b.center, a.center), n, near, measure);
  Sight sight(cell, near.screens, measure);
  // Of a point in a void nobody knows on which side it is.
  const bool hasSide = !isIn(near.voids, a.center) && isCut(a, near.screens);
  double seen = 0.0, all = 0.0;
  forEachPart(a, n, [&](const Place& place) {
    if (isIn(near.voids, place) || (hasSide && meetsAny(near.screens, a.center, place))) return;
    all += cell.counted;
    seen += sight.seen(place);
    if (nLines != nullptr) *nLines += static_cast<long long>(cell.lines.size());
  });
  if (all == 0.0) return -1.0;
  const double share = seen / all;
  return share < negligible ? 0.0 : share > 1.0 - negligible ? 1.0 : share;
}

/// Is each place of `b` hidden from each of `a` by one screen? What a place does not see is convex, and so are the
/// places that do not see it: corners tell.
bool hidesAll(const Screen& screen, const std::vector<const Void*>& voids, const Cell& a, const Cell& b) {
  Lines edges;
  const std::vector<Place> corners = b.corners();
  edges.step = b.edges[0];
  for (std::size_t c = 0; c < corners.size(); c += 2)
    for (std::size_t d = 0; d < 3; ++d) edges.start[d].push_back(corners[c][d]);
  std::array<double, 4> from{}, to{};
  for (const Place& corner : a.corners()) {
    if (isIn(voids, corner)) return false;
    screen.hide(corner, edges, from.data(), to.data());
    for (std::size_t r = 0; r < edges.size(); ++r)
      if (from[r] > 0.0 || to[r] < 1.0) return false;
  }
  return true;
}

/// Shares of n lines are off by about a constant over n: what doubling changes is what is left of the error.
double adaptiveShare(const Cell& a, const Cell& b, const NearDiscontinuities& near, double tolerance,
                     long long* nLines) {
  if (near.screens.size() == 1 && near.voids.empty() && !isCut(a, near.screens) && !isCut(b, near.screens))
    if (const std::optional<double> hidden = near.screens.front()->hiddenShare(a, b))
      return 1.0 - *hidden < errorOfIntegral ? 0.0 : std::min(1.0, 1.0 - *hidden);
  const int most = a.dimension == 3 ? 8 : 32;
  double coarse = sharePast(a, b, near, 4, false, nLines);
  for (int n = 8;; n *= 2) {
    const double fine = sharePast(a, b, near, n, false, nLines);
    // The first change is small by chance at times.
    const double least = n == 8 && n < most ? 0.1 * tolerance : 0.5 * tolerance;
    if ((fine >= 0.0 && std::abs(fine - coarse) <= least) || n >= most) return std::max(fine, 0.0);
    coarse = fine;
  }
}

/// 0 where a crack cuts the bond by the rule for tips, or another screen its line.
double shareByTipRule(const Cell& a, const Cell& b, const NearDiscontinuities& near, TipRule rule) {
  NearDiscontinuities others;
  others.voids = near.voids;
  for (const Screen* screen : near.screens) {
    const std::optional<bool> cuts = screen->cuts(a.center, b.center, rule);
    if (cuts.value_or(false)) return 0.0;
    if (!cuts) others.screens.push_back(screen);
  }
  return others.screens.empty() ? 1.0 : std::max(0.0, sharePast(a, b, others, 1, true, nullptr));
}

/// Nodes and weights of Gauss and Legendre on [-1, 1].
struct GaussRule {
  static constexpr int n = 16;
  std::array<double, n> at{}, weight{};
  GaussRule() {
    constexpr double pi = 3.14159265358979323846;
    for (int k = 0; k < n; ++k) {
      double x = std::cos(pi * (k + 0.75) / (n + 0.5)), slope = 0.0;
      for (int iteration = 0; iteration < 20; ++iteration) {
        double previous = 1.0, value = x;
        for (int m = 2; m <= n; ++m) {
          const double next = ((2 * m - 1) * x * value - (m - 1) * previous) / m;
          previous = value;
          value = next;
        }
        slope = n * (x * value - previous) / (x * x - 1.0);
        x -= value / slope;
      }
      at[static_cast<std::size_t>(k)] = x;
      weight[static_cast<std::size_t>(k)] = 2.0 / ((1.0 - x * x) * slope * slope);
    }
  }
};

/// Integral of f over s from -1/2 to 1/2 across the cell's edge k, piece by piece between the heights at which voids
/// change their form; ends with infinite slope, as of a circle, do no harm.
template <class Function>
double integralAcross(const Cell& cell, std::size_t k, const std::vector<const Void*>& voids, Function f) {
  static const GaussRule gauss;
  constexpr double halfPi = 1.57079632679489661923;
  const double edge2 = dot(cell.edges[k], cell.edges[k]), middle = dot(cell.center, cell.edges[k]);
  std::vector<double> breaks{-0.5, 0.5};
  for (const Void* v : voids)
    for (const double height : v->heights(cell.edges[k])) {
      const double s = (height - middle) / edge2;
      if (s > -0.5 && s < 0.5) breaks.push_back(s);
    }
  std::sort(breaks.begin(), breaks.end());
  double sum = 0.0;
  for (std::size_t piece = 0; piece + 1 < breaks.size(); ++piece) {
    const double half = 0.5 * (breaks[piece + 1] - breaks[piece]), center = breaks[piece] + half;
    if (half <= 0.0) continue;
    for (std::size_t g = 0; g < GaussRule::n; ++g) {
      const double angle = halfPi * gauss.at[g];
      sum += gauss.weight[g] * half * halfPi * std::cos(angle) * f(center + half * std::sin(angle));
    }
  }
  return sum;
}

}  // namespace

NearDiscontinuities nearBox(const NearDiscontinuities& candidates, const Box& box) {
  NearDiscontinuities near;
  for (const Screen* screen : candidates.screens)
    if (screen->box().meets(box)) near.screens.push_back(screen);
  for (const Void* v : candidates.voids)
    if (v->box().meets(box)) near.voids.push_back(v);
  return near;
}

double solidShare(const Cell& cell, const std::vector<const Void*>& voids) {
  if (voids.empty()) return 1.0;
  std::vector<Range> ranges;
  const auto takenOfLine = [&](double t, double u) {
    const Place start = placeIn(cell, {-0.5, t, u});
    ranges.clear();
    for (const Void* v : voids) v->addWithin(start, cell.edges[0], ranges);
    return covered(ranges);
  };
  const auto takenOfSection = [&](double u) {
    return integralAcross(cell, 1, voids, [&](double t) { return takenOfLine(t, u); });
  };
  const double taken = cell.dimension == 3 ? integralAcross(cell, 2, voids, takenOfSection) : takenOfSection(0.0);
  return std::max(0.0, 1.0 - taken);
}

double interactionShare(const Cell& a, const Cell& b, const NearDiscontinuities& near, const DecompositionRule& rule,
                        long long* nLines) {
  using Kind = DecompositionRule::Kind;
  NearDiscontinuities between = nearBox(near, boxAround(a, b));
  const auto isBeside = [&](const Screen* screen) { return !screen->isBetween(a, b); };
  between.screens.erase(std::remove_if(between.screens.begin(), between.screens.end(), isBeside),
                        between.screens.end());
  if (between.screens.empty()) return 1.0;
  if (rule.kind == Kind::Both) return shareByTipRule(a, b, between, TipRule::Both);
  if (rule.kind == Kind::Either) return shareByTipRule(a, b, between, TipRule::Either);
  if (rule.kind == Kind::Intersection) return std::max(0.0, sharePast(a, b, between, 1, true, nLines));
  const bool isUniform = rule.kind == Kind::Uniform;
  const Screen& first = *between.screens.front();
  if (between.screens.size() == 1 && between.voids.empty() && first.divides(a, b))
    return first.isAbove(a.center) == first.isAbove(b.center) ? 1.0 : 0.0;
  for (const Screen* screen : between.screens)
    if (hidesAll(*screen, between.voids, a, b)) return 0.0;
  if (isUniform) return std::max(0.0, sharePast(a, b, between, rule.partitions, true, nLines));
  return adaptiveShare(a, b, between, rule.tolerance, nLines);
}

}  // namespace pd::decomposition
