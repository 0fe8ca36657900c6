#include "bond_decomposition.hpp"

#include <algorithm>
#include <cmath>

#include "sight.hpp"

namespace pd::decomposition {

namespace {

constexpr double negligible = 1e-6;  ///< what is less counts as nothing

// Of the adaptive rule in space.
constexpr int nOffsets = sampleOffsetsASide * sampleOffsetsASide;  ///< of lines, one after the other
constexpr int placesAnOffset = 8;                                  ///< in a round through all of them
constexpr int mostRounds = 64;

double rounded(double share) { return share < negligible ? 0.0 : share > 1.0 - negligible ? 1.0 : share; }

/// The middles of equal parts of a cell that count, [3][parts], and after them the last one again, for a vector's sake.
void findParts(const LineGrid& grid, const Taken& taken, const LineMeasure& measure,
               std::array<std::vector<double>, 3>& parts) {
  const std::size_t room = static_cast<std::size_t>(grid.size()) * static_cast<std::size_t>(grid.n);
  for (auto& ofAxis : parts) ofAxis.resize(room + static_cast<std::size_t>(kernels::lanes));
  std::size_t n = 0;
  for (int line = 0; line < grid.size(); ++line) {
    const Place start = grid.start(line);
    const bool isWhole = taken.number(line) == 0;
    for (int part = 0; part < grid.n; ++part) {
      const double s = (part + 0.5) / grid.n;
      for (std::size_t d = 0; d < 3; ++d) parts[d][n] = start[d] + s * grid.step[d];
      if (isWhole || !taken.covers(line, s * measure.whole())) ++n;
    }
  }
  for (auto& ofAxis : parts) {
    const double last = n == 0 ? 0.0 : ofAxis[n - 1];
    std::fill(ofAxis.begin() + static_cast<std::ptrdiff_t>(n), ofAxis.end(), last);
    ofAxis.resize(n + static_cast<std::size_t>(kernels::lanes));
  }
}

/// Is each place of `b` hidden from each of `a` by one screen? What a place does not see is convex, and so are the
/// places that do not see it: corners tell.
bool hidesAll(const Screen& screen, const Cell& a, const Cell& b) {
  static thread_local Lines edges;
  for (auto& starts : edges.start) starts.clear();
  const Corners corners = b.corners();
  edges.step = b.edges[0];
  for (std::size_t c = 0; c < corners.size(); c += 2)
    for (std::size_t d = 0; d < 3; ++d) edges.start[d].push_back(corners[c][d]);
  std::array<double, 4> from{}, to{};
  for (const Place& corner : a.corners()) {
    screen.hide(corner, edges, from.data(), to.data());
    for (std::size_t r = 0; r < edges.size(); ++r)
      if (from[r] > 0.0 || to[r] < 1.0) return false;
  }
  return true;
}

void keepNear(const NearDiscontinuities& candidates, const Box& box, NearDiscontinuities& near) {
  near.screens.clear();
  near.voids.clear();
  const bool hasBoxes = candidates.screenBoxes.size() == candidates.screens.size();
  for (std::size_t k = 0; k < candidates.screens.size(); ++k)
    if (hasBoxes ? candidates.screenBoxes[k].meets(box) : candidates.screens[k]->box().meets(box))
      near.screens.push_back(candidates.screens[k]);
  for (const Void* v : candidates.voids)
    if (v->box().meets(box)) near.voids.push_back(v);
}

}  // namespace

NearDiscontinuities nearBox(const NearDiscontinuities& candidates, const Box& box) {
  NearDiscontinuities near;
  keepNear(candidates, box, near);
  return near;
}

double InteractionShares::of(const NamedCell& a, const NamedCell& b, const NearDiscontinuities& near) {
  using Kind = DecompositionRule::Kind;
  cells_.forgetMany();
  keepNear(near, boxAround(a.cell, b.cell), between_);
  auto& screens = between_.screens;
  const auto isBeside = [&](const Screen* screen) { return !screen->isBetween(a.cell, b.cell); };
  screens.erase(std::remove_if(screens.begin(), screens.end(), isBeside), screens.end());
  if (screens.empty()) return 1.0;
  ++nNear_;
  if (rule_.kind == Kind::Both) return byTipRule(a, b, near, TipRule::Both);
  if (rule_.kind == Kind::Either) return byTipRule(a, b, near, TipRule::Either);
  if (rule_.kind == Kind::Intersection) return std::max(0.0, byMiddles(a, b, near, 1));
  const Screen& first = *screens.front();
  if (screens.size() == 1 && between_.voids.empty() && first.divides(a.cell, b.cell))
    return first.isAbove(a.cell.center) == first.isAbove(b.cell.center) ? 1.0 : 0.0;
  for (const Screen* screen : screens)
    if (hidesAll(*screen, a.cell, b.cell)) return 0.0;
  narrow(a.cell, b.cell);
  if (rule_.kind == Kind::Uniform) return std::max(0.0, byMiddles(a, b, near, rule_.partitions));
  return adaptively(a, b, near);
}

void InteractionShares::narrow(const Cell& a, const Cell& b) {
  auto& screens = between_.screens;
  const auto hidesNothing = [&](const Screen* screen) { return !screen->mayHideFrom(a); };
  screens.erase(std::remove_if(screens.begin(), screens.end(), hidesNothing), screens.end());
  narrowed_.clear();
  for (const Screen*& screen : screens)
    if (std::unique_ptr<Screen> narrowed = screen->narrowed(a, b)) {
      screen = narrowed.get();
      narrowed_.push_back(std::move(narrowed));
    }
}

double InteractionShares::byMiddles(const NamedCell& a, const NamedCell& b, const NearDiscontinuities& near, int n) {
  const LineMeasure measure{n};
  const Place way = minus(b.cell.center, a.cell.center);
  const std::size_t along = axisAlong(a.cell, way), across = axisAcross(b.cell, way);
  const Taken& ofA = cells_.taken(a.id, a.cell, along, n, measure, near);
  findParts(LineGrid(a.cell, along, n), ofA, measure, parts_);
  sight_.turnTo(b.cell, LineGrid(b.cell, across, n), measure, cells_.taken(b.id, b.cell, across, n, measure, near),
                between_.screens);
  const int nParts = static_cast<int>(parts_[0].size()) - kernels::lanes;
  const double all = nParts * sight_.counted();
  double seen = 0.0;
  for (int first = 0; first < nParts; first += kernels::lanes)
    seen += sight_.seen(
        {kernels::load(&parts_[0][first]), kernels::load(&parts_[1][first]), kernels::load(&parts_[2][first])},
        std::min(kernels::lanes, nParts - first));
  nLines_ += static_cast<long long>(nParts) * sight_.nLines();
  if (all == 0.0) return -1.0;
  return rounded(seen / all);
}

double InteractionShares::bySamples(const NamedCell& a, const NamedCell& b, const NearDiscontinuities& near) {
  constexpr int perRound = nOffsets * placesAnOffset;
  const std::size_t across = axisAcross(b.cell, minus(b.cell.center, a.cell.center));
  double seen = 0.0, all = 0.0;
  for (int round = 0; round < mostRounds;) {
    const int end = std::max(1, 2 * round);
    const std::vector<char>& isCounted = cells_.countedSamples(a.id, a.cell, end * perRound, near);
    const double seenBefore = seen, allBefore = all;
    for (int offset = 0; offset < nOffsets; ++offset) {
      sight_.turnTo(b.cell, LineGrid(b.cell, across, sampleLines, sampleOffset(offset)), LineMeasure{0},
                    cells_.takenOfSample(b.id, b.cell, across, offset, near), between_.screens);
      Places places{};
      int n = 0;
      const auto look = [&] {
        if (n > 0) seen += sight_.seen(places, n);
        all += n * sight_.counted();
        nLines_ += n * sight_.nLines();
        n = 0;
      };
      for (int r = round; r < end; ++r)
        for (int k = r * perRound + offset * placesAnOffset, last = k + placesAnOffset; k < last; ++k) {
          if (isCounted[static_cast<std::size_t>(k)] == 0) continue;
          const Place place = samplePlace(a.cell, k);
          for (std::size_t d = 0; d < 3; ++d) {
            if (n == 0) places[d] = place[d];  // in all lanes
            places[d][static_cast<std::size_t>(n)] = place[d];
          }
          if (++n == kernels::lanes) look();
        }
      look();
    }
    const bool hasHalves = round > 3 && allBefore > 0.0 && all > allBefore;
    const double apart = hasHalves ? std::abs(seenBefore / allBefore - (seen - seenBefore) / (all - allBefore)) : 1.0;
    if (apart < 0.5 * rule_.tolerance) break;  // halves may agree by chance
    round = end;
  }
  return all > 0.0 ? rounded(seen / all) : 0.0;
}

double InteractionShares::adaptively(const NamedCell& a, const NamedCell& b, const NearDiscontinuities& near) {
  if (a.cell.dimension == 3) return bySamples(a, b, near);
  const WithinCell &withinA = cells_.within(a.id, a.cell, near), &withinB = cells_.within(b.id, b.cell, near);
  return rounded(throughBoth_.share({&a.cell, &withinA}, {&b.cell, &withinB}, between_.screens, rule_.tolerance));
}

double InteractionShares::byTipRule(const NamedCell& a, const NamedCell& b, const NearDiscontinuities& near,
                                    TipRule rule) {
  bool isCut = false;
  const auto hasRule = [&](const Screen* screen) {
    const std::optional<bool> cuts = screen->cuts(a.cell.center, b.cell.center, rule);
    isCut = isCut || cuts.value_or(false);
    return cuts.has_value();
  };
  auto& screens = between_.screens;
  screens.erase(std::remove_if(screens.begin(), screens.end(), hasRule), screens.end());
  if (isCut) return 0.0;
  return screens.empty() ? 1.0 : std::max(0.0, byMiddles(a, b, near, 1));
}

double interactionShare(const Cell& a, const Cell& b, const NearDiscontinuities& near, const DecompositionRule& rule,
                        long long* nLines) {
  InteractionShares shares(rule);
  const double share = shares.of({0, a}, {1, b}, near);
  if (nLines != nullptr) *nLines += shares.nLines();
  return share;
}

}  // namespace pd::decomposition
