#include "spring_network.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace pd {

namespace {

// Runs shorter than a vector is wide gain nothing.
constexpr int shortestRun = 16;
// Constants that differ by less, relative to the largest of a neighbourhood, are those of one pattern.
constexpr double patternTolerance = 1e-10;
// Patterns that a new run is compared with.
constexpr std::size_t nRemembered = 64;
// Strips of so many points, of whose places so large a part holds springs, are faster than lists. They are larger:
// where springs have several constants, that eats up what they gain, but beside runs.
constexpr int longestStrip = 2 * SpringStrip::lanes, shortestStrip = 4;
constexpr double leastFilled = 0.55;

}  // namespace

void SpringList::add(int point, int neighbor, float unbroken, const SpringConstants<double>& c,
                     const SpringShape& shape) {
  if (rows.empty() || rows.back() != point) {
    rows.push_back(point);
    start.push_back(other.size());
  }
  other.push_back(neighbor);
  alive.push_back(unbroken);
  std::get<0>(columns).add(c, shape);
  std::get<1>(columns).add(c, shape);
  start.back() = other.size();
}

std::size_t SpringList::bytes() const {
  return rows.size() * (sizeof(int) + sizeof(std::size_t)) + other.size() * (sizeof(int) + sizeof(float)) +
         in<double>().bytes() + in<float>().bytes();
}

/// The springs of a point.
struct SpringNetwork::Row {
  int point = 0;
  bool isInside = true;                 ///< of springs that are whole
  std::vector<std::ptrdiff_t> reverse;  ///< number of the bond in the neighbour's list; -1: in none on this rank
  std::size_t firstBorder = 0;          ///< number of its first bond to a ghost or an image
  std::vector<double> xi;               ///< [neighbours][D]
  std::vector<SpringConstants<double>> constants;
};

/// Points that follow each other, and may become a strip.
struct SpringNetwork::StripRows {
  int first = 0, count = 0;
  std::vector<int> offsets;                        ///< that a spring of any of them has, rising
  std::vector<SpringConstants<double>> constants;  ///< of their springs, row after row
};

/// Whether all springs resist across in one proportion to what they resist along, and give half of it to either family.
struct SpringNetwork::Proportion {
  double ratio = 0.0;
  bool isOne = true;
};

/// Reads the rows of points 0, 1, 2 ... one after another.
class SpringNetwork::RowReader {
 public:
  RowReader(const SpringNetwork& network, const std::vector<double>& along, const std::vector<double>& across,
            const OtherEnds& others)
      : network_(network),
        along_(along),
        across_(across),
        others_(others),
        cursor_(static_cast<std::size_t>(network.points_.nOwned), 0) {}

  const Row& next() {
    row_.point = next_++;
    findReverse();
    readConstants();
    return row_;
  }
  /// The next row: those after it find their places without it.
  void skip() {
    const int i = next_++;
    for (int k = network_.nNeighbors(i); k > 0 && network_.neighbors(i)[k - 1] >= network_.points_.nOwned; --k)
      ++nBorder_;
  }

 private:
  std::size_t firstBond(int point) const { return network_.listStart(point) - static_cast<std::size_t>(point); }

  /// Lists are sorted: this point's place in a neighbour's list comes after those of the points before.
  void findReverse() {
    const int i = row_.point, n = network_.nNeighbors(i), nOwned = network_.points_.nOwned;
    const int* neighbors = network_.neighbors(i);
    row_.reverse.assign(static_cast<std::size_t>(n), -1);
    row_.isInside = true;
    row_.firstBorder = nBorder_;
    for (int k = 0; k < n; ++k) {
      const int j = neighbors[k];
      bool isWhole = network_.isTwice(j);
      if (j >= nOwned) {
        ++nBorder_;
      } else {
        const int *others = network_.neighbors(j), nOthers = network_.nNeighbors(j);
        int place = cursor_[static_cast<std::size_t>(j)];
        while (place < nOthers && others[place] < i) ++place;
        cursor_[static_cast<std::size_t>(j)] = place;
        isWhole = place < nOthers && others[place] == i;
        if (isWhole) row_.reverse[static_cast<std::size_t>(k)] = static_cast<std::ptrdiff_t>(firstBond(j)) + place;
      }
      row_.isInside = row_.isInside && isWhole;
    }
  }

  void readConstants() {
    const int i = row_.point, n = network_.nNeighbors(i), d = network_.dimension();
    const int* neighbors = network_.neighbors(i);
    const PointVector<double>& x = network_.places<double>();
    const double perUnit = 1.0 / network_.stiffnessUnit_;
    const bool hasAcross = !across_.empty(), hasFamily = network_.family_ != Family::None;
    const bool givesAcross = network_.family_ == Family::Rotation;
    readOtherEnds(along_, others_.along, otherAlong_);
    if (hasAcross) readOtherEnds(across_, others_.across, otherAcross_);
    row_.xi.resize(static_cast<std::size_t>(n * d));
    row_.constants.resize(static_cast<std::size_t>(n));
    double* xi = row_.xi.data();
    for (std::size_t k = 0, own = firstBond(i); k < row_.constants.size(); ++k, ++own, xi += d) {
      double length2 = 0.0;
      for (int c = 0; c < d; ++c) {
        xi[c] = x[c][neighbors[k]] - x[c][i];
        length2 += xi[c] * xi[c];
      }
      const Ends along{along_[own], otherAlong_[k]};
      const Ends across = hasAcross ? Ends{across_[own], otherAcross_[k]} : Ends{0.0, 0.0};
      const double ofAcross = across.own + across.other;
      const Ends& gives = givesAcross ? across : along;
      row_.constants[k] = {perUnit * (along.own + along.other - ofAcross) / length2, perUnit * ofAcross,
                           hasFamily ? perUnit * gives.own : 0.0, hasFamily ? perUnit * gives.other : 0.0};
    }
  }

  /// What both ends of a bond give.
  struct Ends {
    double own, other;
  };
  /// They lie far from each other: a loop of its own waits for many of them at once.
  void readOtherEnds(const std::vector<double>& ofBonds, const std::vector<double>& ofOthers,
                     std::vector<double>& ofRow) const {
    const int* neighbors = network_.neighbors(row_.point);
    std::size_t border = row_.firstBorder;
    ofRow.assign(row_.reverse.size(), 0.0);
    for (std::size_t k = 0; k < ofRow.size(); ++k) {
      const std::ptrdiff_t back = row_.reverse[k];
      if (back >= 0)
        ofRow[k] = ofBonds[static_cast<std::size_t>(back)];
      else if (network_.isTwice(neighbors[k]))
        ofRow[k] = ofOthers[border++];
    }
  }

  const SpringNetwork& network_;
  const std::vector<double>&along_, &across_;
  const OtherEnds& others_;
  std::vector<int> cursor_;
  std::vector<double> otherAlong_, otherAcross_;  ///< [neighbours] of the row
  std::size_t nBorder_ = 0;
  int next_ = 0;
  Row row_;
};

SpringNetwork::SpringNetwork(const Communicator& comm, const Discretization& points, Family family,
                             const std::vector<double>& along, const std::vector<double>& across,
                             const std::vector<double>& dilatational, const OtherEnds& others)
    : points_(points),
      family_(points.dimension == 1 ? Family::None : family),
      shape_{!across.empty(), family_ != Family::None, 0.0},
      hasHalves_(!others.areKnown),
      dilatational_(dilatational) {
  lengthUnit_ = points.shortestBond > 0.0 ? points.shortestBond : 1.0;
  stiffnessUnit_ = 0.0;
  for (std::size_t b = 0; b < along.size(); ++b) {
    const double least = shape_.hasAcross ? std::min(along[b], across[b]) : along[b];
    stiffnessUnit_ = std::max(stiffnessUnit_, std::abs(along[b]));
    hasNegative_ = hasNegative_ || least < 0.0;
  }
  stiffnessUnit_ = comm.max(stiffnessUnit_);
  hasNegative_ = comm.any(hasNegative_);
  if (stiffnessUnit_ == 0.0) stiffnessUnit_ = 1.0;
  const int d = points.dimension;
  places_ = {PointVector<double>(points.nPoints, d), PointVector<float>(points.nPoints, d)};
  for (int c = 0; c < d; ++c) {
    double middle = 0.0;
    for (int i = 0; i < points.nOwned; ++i) middle += points.x[static_cast<std::size_t>(3 * i + c)] / points.nOwned;
    for (int i = 0; i < points.nPoints; ++i) {
      const double place = (points.x[static_cast<std::size_t>(3 * i + c)] - middle) / lengthUnit_;
      std::get<0>(places_)[c][i] = place;
      std::get<1>(places_)[c][i] = static_cast<float>(place);
    }
  }
  const auto nOwned = static_cast<std::size_t>(points.nOwned);
  isComplete_.assign(static_cast<std::size_t>(points.nPoints), 0);
  aliveOfPoint_.resize(nOwned);
  Proportion proportion;
  findRuns(RowReader(*this, along, across, others), proportion);
  if (family_ == Family::Rotation) {
    const double largest = comm.max(proportion.ratio), smallest = -comm.max(-proportion.ratio);
    if (!comm.any(!proportion.isOne || !shape_.hasAcross))
      shape_.acrossPerRadial = largest > -smallest ? largest : smallest;
  }
  findStrips(RowReader(*this, along, across, others));
  makeLists(RowReader(*this, along, across, others));
}

void SpringNetwork::look(const Row& row, Proportion& proportion) const {
  constexpr double tolerance = 1e-12, least = 1e-3;
  const auto d = static_cast<std::size_t>(dimension());
  for (std::size_t k = 0; k < row.constants.size() && proportion.isOne; ++k) {
    const SpringConstants<double>& c = row.constants[k];
    if (!c.acts()) continue;
    double length2 = 0.0;
    for (std::size_t a = 0; a < d; ++a) length2 += row.xi[k * d + a] * row.xi[k * d + a];
    const double radial = c.radial * length2, bound = tolerance * std::abs(radial + c.across);
    if (proportion.ratio == 0.0 && std::abs(radial) > least * std::abs(radial + c.across))
      proportion.ratio = c.across / radial;
    const bool isShared = !hasOtherShare(neighbors(row.point)[k]) || std::abs(c.own - c.others) <= bound;
    proportion.isOne = isShared && std::abs(proportion.ratio * radial - c.across) <= bound;
  }
}

SpringConstants<double> SpringNetwork::constantsOf(const SpringColumns<double>& columns, std::size_t k,
                                                   const std::array<double, 3>& xi, int j) const {
  const auto value = [&](const std::vector<double>& column) { return column.empty() ? 0.0 : column[k]; };
  if (shape_.acrossPerRadial == 0.0)
    return {columns.radial[k], value(columns.across), value(columns.own), value(columns.others)};
  const double length2 = xi[0] * xi[0] + xi[1] * xi[1] + xi[2] * xi[2];
  const double across = shape_.acrossPerRadial * columns.radial[k] * length2;
  if (!hasOtherShare(j)) return {columns.radial[k], across, across, 0.0};
  return {columns.radial[k], across, 0.5 * across, 0.5 * across};
}

bool SpringNetwork::follows(const Row& row, const SpringPattern& pattern) const {
  const std::size_t n = row.constants.size();
  if (!row.isInside || n != pattern.offsets.size()) return false;
  for (std::size_t k = 0; k < n; ++k)
    if (neighbors(row.point)[k] - row.point != pattern.offsets[k]) return false;
  // Lengths are near 1 by their unit, stiffnesses at most.
  for (std::size_t k = 0; k < row.xi.size(); ++k)
    if (std::abs(row.xi[k] - pattern.xi[k]) > patternTolerance) return false;
  for (std::size_t k = 0; k < n; ++k) {
    const SpringConstants<double>&a = row.constants[k], &b = pattern.constants[k];
    if (std::abs(a.radial - b.radial) > patternTolerance || std::abs(a.across - b.across) > patternTolerance ||
        std::abs(a.own - b.own) > patternTolerance || std::abs(a.others - b.others) > patternTolerance)
      return false;
  }
  return true;
}

namespace {

template <class Real>
void fill(const SpringPattern& pattern, int dimension, SpringPattern::Tables<Real>& tables) {
  const auto d = static_cast<std::size_t>(dimension);
  std::array<double, 3> sumOfOwn{};
  for (std::size_t k = 0; k < pattern.offsets.size(); ++k) {
    const SpringConstants<double>& c = pattern.constants[k];
    if (!c.acts()) continue;
    tables.offsets.push_back(pattern.offsets[k]);
    const double* xi = &pattern.xi[k * d];
    for (std::size_t a = 0; a < d; ++a) {
      for (std::size_t b = a; b < d; ++b)
        tables.stiffness.push_back(static_cast<Real>(c.radial * xi[a] * xi[b] + (a == b ? c.across : 0.0)));
      tables.own.push_back(static_cast<Real>(c.own * xi[a]));
      tables.others.push_back(static_cast<Real>(c.others * xi[a]));
      sumOfOwn[a] += c.own * xi[a];
    }
  }
  for (std::size_t a = 0; a < d; ++a) tables.sumOfOwn[a] = static_cast<Real>(sumOfOwn[a]);
}

}  // namespace

void SpringNetwork::endRun(SpringRun& run, SpringPattern& pattern) {
  if (run.count >= shortestRun) {
    if (run.pattern < 0) {
      run.pattern = static_cast<int>(patterns_.size());
      fill(pattern, dimension(), std::get<0>(pattern.tables));
      fill(pattern, dimension(), std::get<1>(pattern.tables));
      patterns_.push_back(std::move(pattern));
      pattern = {};
    }
    std::fill_n(isComplete_.begin() + run.first, run.count, 1);
    runs_.push_back(run);
  }
  run = {0, 0, -1};
}

/// Rows that follow a pattern are in proportion where the pattern is.
void SpringNetwork::findRuns(RowReader reader, Proportion& proportion) {
  SpringRun run{0, 0, -1};
  SpringPattern pattern;  // of the present run, where it is new
  const auto patternOf = [&](const SpringRun& r) -> const SpringPattern& {
    return r.pattern < 0 ? pattern : patterns_[static_cast<std::size_t>(r.pattern)];
  };
  for (int i = 0; i < points_.nOwned; ++i) {
    const Row& row = reader.next();
    if (run.count > 0 && follows(row, patternOf(run))) {
      ++run.count;
      continue;
    }
    if (family_ == Family::Rotation) look(row, proportion);
    endRun(run, pattern);
    if (!row.isInside || row.constants.empty()) continue;
    run = {i, 1, -1};
    const std::size_t first = patterns_.size() > nRemembered ? patterns_.size() - nRemembered : 0;
    for (std::size_t p = patterns_.size(); p-- > first && run.pattern < 0;)
      if (follows(row, patterns_[p])) run.pattern = static_cast<int>(p);
    if (run.pattern >= 0) continue;
    pattern.offsets.clear();
    for (std::size_t k = 0; k < row.constants.size(); ++k) pattern.offsets.push_back(neighbors(i)[k] - i);
    pattern.constants = row.constants;
    pattern.xi = row.xi;
  }
  endRun(run, pattern);
}

/// Makes a strip of them, where one is worth it, and starts anew.
void SpringNetwork::endStrip(StripRows& rows) {
  const int end = rows.first + (rows.count + SpringStrip::lanes - 1) / SpringStrip::lanes * SpringStrip::lanes;
  const int nPoints = points_.nPoints;
  // Lanes without a point read beside the others.
  const bool isInside = rows.count > 0 && rows.first + rows.offsets.front() >= 0 && end <= nPoints &&
                        end + rows.offsets.back() <= nPoints;
  if (rows.count >= shortestStrip && isInside) {
    SpringStrip strip{rows.first, rows.count, rows.offsets, {}};
    const std::size_t size =
        strip.offsets.size() * static_cast<std::size_t>(rows.count) + static_cast<std::size_t>(SpringStrip::lanes);
    auto& [columns, floatColumns] = strip.columns;
    columns.resize(size, shape_);
    floatColumns.resize(size, shape_);
    const SpringConstants<double>* constants = rows.constants.data();
    for (int i = rows.first; i < rows.first + rows.count; ++i)
      for (int k = 0, offset = 0; k < nNeighbors(i); ++k, ++constants) {
        while (strip.offsets[static_cast<std::size_t>(offset)] < neighbors(i)[k] - i) ++offset;
        const std::size_t at = strip.at(static_cast<std::size_t>(offset), i);
        columns.set(at, *constants);
        floatColumns.set(at, *constants);
      }
    std::fill_n(isComplete_.begin() + strip.first, strip.count, 1);
    strips_.push_back(std::move(strip));
  }
  rows.count = 0;
  rows.offsets.clear();
  rows.constants.clear();
}

void SpringNetwork::findStrips(RowReader reader) {
  const bool hasOneConstant = shape_.acrossPerRadial != 0.0 || (!shape_.hasAcross && !shape_.hasFamily);
  const auto inRuns = std::count(isComplete_.begin(), isComplete_.end(), 1);  // ghosts and images are in none
  if (2 * inRuns < points_.nOwned && !hasOneConstant) return;
  StripRows rows;
  std::vector<int> own, all;
  for (int i = 0; i < points_.nOwned; ++i) {
    if (isComplete(i)) {  // in a run
      reader.skip();
      endStrip(rows);
      continue;
    }
    const Row& row = reader.next();
    if (!row.isInside || row.constants.empty()) {
      endStrip(rows);
      continue;
    }
    own.clear();
    all.clear();
    for (std::size_t k = 0; k < row.constants.size(); ++k) own.push_back(neighbors(i)[k] - i);
    std::set_union(own.begin(), own.end(), rows.offsets.begin(), rows.offsets.end(), std::back_inserter(all));
    const double places = static_cast<double>(all.size()) * (rows.count + 1);
    const bool isSparse = static_cast<double>(rows.constants.size() + own.size()) < leastFilled * places;
    if (rows.count == longestStrip || isSparse) {
      endStrip(rows);
      all.swap(own);
    }
    if (rows.count++ == 0) rows.first = i;
    rows.offsets.swap(all);
    rows.constants.insert(rows.constants.end(), row.constants.begin(), row.constants.end());
  }
  endStrip(rows);
}

void SpringNetwork::makeLists(RowReader reader) {
  pairRow_.assign(static_cast<std::size_t>(points_.nOwned), -1);
  singleRow_ = pairRow_;
  for (int i = 0; i < points_.nOwned; ++i) {
    if (isComplete(i)) {
      reader.skip();
      continue;
    }
    const Row& row = reader.next();
    for (std::size_t k = 0; k < row.constants.size(); ++k) {
      const int j = neighbors(i)[k];
      if (!row.constants[k].acts()) continue;
      if (isComplete(j) || isTwice(j))
        add(singles_, i, j, 1.0F, row.constants[k]);
      else if (j > i || row.reverse[k] < 0)
        add(pairs_, i, j, 1.0F, row.constants[k]);
    }
  }
  for (std::size_t r = 0; r < pairs_.rows.size(); ++r)
    pairRow_[static_cast<std::size_t>(pairs_.rows[r])] = static_cast<int>(r);
  for (std::size_t r = 0; r < singles_.rows.size(); ++r)
    singleRow_[static_cast<std::size_t>(singles_.rows[r])] = static_cast<int>(r);
}

std::size_t SpringNetwork::bytes() const {
  std::size_t sum = pairs_.bytes() + singles_.bytes() + corrections_.bytes() + singleCorrections_.bytes();
  for (const SpringStrip& strip : strips_)
    sum += strip.offsets.size() * sizeof(int) + strip.in<double>().bytes() + strip.in<float>().bytes();
  for (const SpringPattern& pattern : patterns_)
    sum += pattern.offsets.size() * (sizeof(int) + sizeof(SpringConstants<double>) + 12 * 8 + 8);
  return sum + static_cast<std::size_t>(points_.nPoints) * static_cast<std::size_t>(dimension()) * 12;
}

}  // namespace pd
