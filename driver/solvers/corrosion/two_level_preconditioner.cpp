#include "two_level_preconditioner.hpp"

#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "Peridigm_DegreesOfFreedomManager.hpp"
#include "Peridigm_SerialMatrix.hpp"

namespace pd {

namespace {

constexpr double pointsOfCube[] = {32.0, 32.0, 64.0};  ///< by dimension

}  // namespace

/// Takes the material's Jacobian apart: blocks of cubes, and sums between cubes.
class TwoLevelPreconditioner::Collector : public PeridigmNS::SerialMatrix {
 public:
  Collector(TwoLevelPreconditioner& owner, Model& model, double h) : owner_(owner), h_(h) {
    const Discretization& d = model.discretization();
    const double* x = model.field("Model_Coordinates");
    free_ = model.field("Transport_Unknown");
    cubeOfGhost_.assign(static_cast<std::size_t>(d.nPoints - d.nOwned), Key{});
    nOwned_ = d.nOwned;
    for (int i = d.nOwned; i < d.nPoints; ++i)
      cubeOfGhost_[static_cast<std::size_t>(i - d.nOwned)] = owner.keyOf(x + 3 * i);
    couplings_.resize(owner.cubeAt_.size());
    position_.resize(owner.cubeAt_.size());
    lastRow_.resize(owner.cubeAt_.size(), -1);
    keys_.resize(owner.cubeAt_.size());
    for (const auto& [key, number] : owner.cubeAt_) keys_[static_cast<std::size_t>(number)] = key;
    const double* volume = model.field("Volume");
    for (const int i : owner.points_) add(i, i, volume[i]);
  }

  void addValue(int row, int column, double value) override {
    add(owner_.localId_[static_cast<std::size_t>(row)], owner_.localId_[static_cast<std::size_t>(column)], -h_ * value);
  }
  void addValues(int n, const int* ids, const double* const* values) override {
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) addValue(ids[a], ids[b], values[a][b]);
  }
  void addBlockDiagonalValues(int n, const int* ids, const double* const* values) override {
    for (int a = 0; a < n; ++a) addValue(ids[a], ids[a], values[a][a]);
  }
  void putScalar(double) override {}

  /// Sums over pairs of cubes, those with ghosts included.
  Entries entries() const {
    Entries result = betweenRanks_;
    for (const auto& [key, number] : owner_.cubeAt_)
      for (const auto& [other, value] : couplings_[static_cast<std::size_t>(number)])
        result[{key, keys_[other]}] += value;
    return result;
  }

 private:
  void add(int i, int j, double value) {
    const int cube = owner_.cubeOf_[static_cast<std::size_t>(i)];
    if (cube < 0) return;
    if (j >= nOwned_) {
      if (free_[j] == 0.0) return;
      betweenRanks_[{keys_[static_cast<std::size_t>(cube)], cubeOfGhost_[static_cast<std::size_t>(j - nOwned_)]}] +=
          value;
      return;
    }
    const int other = owner_.cubeOf_[static_cast<std::size_t>(j)];
    if (other < 0) return;
    const int slot = owner_.slotOf_[static_cast<std::size_t>(i)],
              back = slot - owner_.slotOf_[static_cast<std::size_t>(j)];
    if (back >= 0 && back <= lineBand &&
        owner_.lineOf_[static_cast<std::size_t>(slot)] == owner_.lineOf_[static_cast<std::size_t>(slot - back)]) {
      owner_.lines_[static_cast<std::size_t>(slot * (lineBand + 1) + back)] += value;
      owner_.usedBand_ = std::max(owner_.usedBand_, back);
    }
    couplings_[static_cast<std::size_t>(cube)]
              [positionOf(i, static_cast<std::size_t>(cube), static_cast<std::size_t>(other))]
                  .second += value;
  }

  /// Where the row of `cube` keeps `other`: looked for once in each row of points.
  std::size_t positionOf(int i, std::size_t cube, std::size_t other) {
    if (lastRow_[other] == i) return position_[other];
    auto& row = couplings_[cube];
    std::size_t at = 0;
    while (at < row.size() && row[at].first != other) ++at;
    if (at == row.size()) row.emplace_back(other, 0.0);
    lastRow_[other] = i;
    return position_[other] = at;
  }

  TwoLevelPreconditioner& owner_;
  const double h_;
  const double* free_;
  int nOwned_;
  std::vector<Key> cubeOfGhost_, keys_;
  std::vector<std::vector<std::pair<std::size_t, double>>> couplings_;  ///< by cube: other cubes, and sums
  std::vector<std::size_t> position_;                                   ///< by other cube, of the row lastRow_
  std::vector<int> lastRow_;
  Entries betweenRanks_;
};

TwoLevelPreconditioner::Key TwoLevelPreconditioner::keyOf(const double* x) const {
  Key key;
  for (std::size_t d = 0; d < 3; ++d) key[d] = static_cast<int>(std::floor(x[d] / edge_));
  return key;
}

/// What does not change in a run: edge of cubes, the axis along which the nearest neighbours lie, arrays of all points.
void TwoLevelPreconditioner::measure(Model& model) {
  const Discretization& d = model.discretization();
  const Communicator& comm = model.comm();
  const double* x = model.field("Model_Coordinates");
  localId_.assign(static_cast<std::size_t>(d.nGlobal), -1);
  for (int i = 0; i < d.nPoints; ++i) localId_[static_cast<std::size_t>(d.globalIds[static_cast<std::size_t>(i)])] = i;
  cubeOf_.assign(static_cast<std::size_t>(d.nOwned), -1);
  slotOf_ = cubeOf_;
  double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300}, nearest[3] = {1e300, 1e300, 1e300};
  for (int i = 0; i < d.nOwned; ++i) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], x[3 * i + k]);
      high[k] = std::max(high[k], x[3 * i + k]);
    }
    const int* list = &d.neighborhoodList[static_cast<std::size_t>(d.neighborhoodStart[static_cast<std::size_t>(i)])];
    constexpr int sampleStride = 97;
    for (int n = 1; n <= *list && i % sampleStride == 0; ++n) {
      double xi[3];
      for (int k = 0; k < 3; ++k) xi[k] = std::abs(x[3 * list[n] + k] - x[3 * i + k]);
      for (int k = 0; k < 3; ++k)
        if (xi[(k + 1) % 3] + xi[(k + 2) % 3] < 1e-6 * xi[k]) nearest[k] = std::min(nearest[k], xi[k]);
    }
  }
  double filled = 1.0;
  for (int k = 0; k < d.dimension; ++k) filled *= comm.max(high[k]) - comm.min(low[k]);
  edge_ = std::pow(pointsOfCube[d.dimension - 1] * filled / static_cast<double>(d.nGlobal), 1.0 / d.dimension);
  for (double& value : nearest) value = comm.min(value);
  axis_ = static_cast<std::size_t>(std::min_element(nearest, nearest + 3) - nearest);
  spacing_ = std::min(nearest[axis_], edge_);
}

void TwoLevelPreconditioner::gatherPoints(Model& model, const std::vector<int>& ids, const std::vector<char>& isFree) {
  const double* x = model.field("Model_Coordinates");
  cubeAt_.clear();
  for (const int i : points_) cubeOf_[static_cast<std::size_t>(i)] = slotOf_[static_cast<std::size_t>(i)] = -1;
  struct Place {
    long long first, second;
    double along;
    int point;
  };
  std::vector<Place> places;
  const auto grid = [&](int i, std::size_t axis) {
    return std::llround(4.0 * x[3 * static_cast<std::size_t>(i) + axis] / spacing_ + 0.37);
  };
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (isFree[k] == 0) continue;
    const int i = ids[k];
    cubeOf_[static_cast<std::size_t>(i)] =
        cubeAt_.emplace(keyOf(x + 3 * i), static_cast<int>(cubeAt_.size())).first->second;
    places.push_back(
        {grid(i, (axis_ + 1) % 3), grid(i, (axis_ + 2) % 3), x[3 * static_cast<std::size_t>(i) + axis_], i});
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return std::tie(a.first, a.second, a.along) < std::tie(b.first, b.second, b.along);
  });
  points_.clear();
  lineOf_.clear();
  int line = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (k > 0 && std::tie(places[k].first, places[k].second) != std::tie(places[k - 1].first, places[k - 1].second))
      ++line;
    slotOf_[static_cast<std::size_t>(places[k].point)] = static_cast<int>(k);
    points_.push_back(places[k].point);
    lineOf_.push_back(line);
  }
  // Rows behind the last, which those before it look at.
  lines_.assign((points_.size() + lineBand) * (lineBand + 1), 0.0);
  usedBand_ = 0;
}

/// L D L^T in place. Where a pivot is not positive (a rate that grows quickly with C), the diagonal stands for the row.
void TwoLevelPreconditioner::factorLines() {
  constexpr int width = lineBand + 1;
  for (int slot = 0; slot < static_cast<int>(points_.size()); ++slot) {
    double* row = &lines_[static_cast<std::size_t>(slot * width)];
    const double diagonal = row[0];
    for (int k = std::min(lineBand, slot); k >= 1; --k) {
      const double* other = &lines_[static_cast<std::size_t>((slot - k) * width)];
      // row[k] holds A(slot, slot - k); subtract what earlier slots contribute, as L D L^T.
      for (int m = k + 1; m <= std::min(lineBand, slot); ++m)
        if (m - k <= lineBand) row[k] -= row[m] * lines_[static_cast<std::size_t>((slot - m) * width)] * other[m - k];
      row[k] /= other[0];
    }
    for (int k = 1; k <= std::min(lineBand, slot); ++k)
      row[0] -= row[k] * row[k] * lines_[static_cast<std::size_t>((slot - k) * width)];
    if (row[0] > 1e-8 * std::abs(diagonal)) continue;
    std::fill(row, row + width, 0.0);
    row[0] = std::max(std::abs(diagonal), 1e-300);
  }
  for (std::size_t slot = 0; slot < points_.size(); ++slot) lines_[slot * width] = 1.0 / lines_[slot * width];
}

template <int used>
void TwoLevelPreconditioner::solveLines(double* values) const {
  constexpr int width = lineBand + 1;
  const auto n = static_cast<std::ptrdiff_t>(points_.size());
  for (std::ptrdiff_t slot = 0; slot < n; ++slot) {
    const double* row = lines_.data() + slot * width;
    double value = values[slot];
    for (int k = used; k >= 1; --k) value -= row[k] * values[slot - k];  // what was found last comes last
    values[slot] = value;
  }
  for (std::ptrdiff_t slot = n - 1; slot >= 0; --slot) {
    const double* row = lines_.data() + slot * width;
    double value = values[slot] * row[0];
    // Rows ahead hold what they take from this one.
    for (int k = used; k >= 1; --k) value -= row[k + k * width] * values[slot + k];
    values[slot] = value;
  }
}

/// Gathers the coarse matrix on every rank and factors it there.
void TwoLevelPreconditioner::makeCoarse(const Communicator& comm, const Entries& own) {
  std::vector<double> numbers;
  for (const auto& [pair, value] : own) {
    for (const Key& key : {pair.first, pair.second}) numbers.insert(numbers.end(), key.begin(), key.end());
    numbers.push_back(value);
  }
  Entries all;
  std::map<Key, int> numberOf;
  const std::vector<double> gathered = comm.gather(numbers);
  for (std::size_t k = 0; k < gathered.size(); k += 7) {
    Key from, to;
    for (std::size_t d = 0; d < 3; ++d) {
      from[d] = static_cast<int>(gathered[k + d]);
      to[d] = static_cast<int>(gathered[k + 3 + d]);
    }
    all[{from, to}] += gathered[k + 6];
    numberOf[from] = 0;
  }
  nCoarse_ = 0;
  for (auto& item : numberOf) item.second = nCoarse_++;
  band_ = 0;
  for (const auto& item : all) {
    const auto to = numberOf.find(item.first.second);
    if (to != numberOf.end()) band_ = std::max(band_, std::abs(numberOf[item.first.first] - to->second));
  }
  const int height = 3 * band_ + 1;
  coarse_.assign(static_cast<std::size_t>(height) * static_cast<std::size_t>(nCoarse_), 0.0);
  pivots_.resize(static_cast<std::size_t>(nCoarse_));
  for (const auto& [pair, value] : all) {
    const auto to = numberOf.find(pair.second);
    if (to == numberOf.end()) continue;
    const int row = numberOf[pair.first], column = to->second;
    coarse_[static_cast<std::size_t>(column) * static_cast<std::size_t>(height) +
            static_cast<std::size_t>(2 * band_ + row - column)] += value;
  }
  const Teuchos::LAPACK<int, double> lapack;
  int info = 0;
  if (nCoarse_ > 0) lapack.GBTRF(nCoarse_, nCoarse_, band_, band_, coarse_.data(), height, pivots_.data(), &info);
  if (info != 0) nCoarse_ = 0;  // without it the cubes must do
  coarseOf_.assign(cubeAt_.size(), 0);
  for (const auto& [key, cube] : cubeAt_)
    coarseOf_[static_cast<std::size_t>(cube)] = nCoarse_ > 0 ? numberOf.at(key) : 0;
}

void TwoLevelPreconditioner::build(Model& model, const std::vector<int>& ids, const std::vector<char>& isFree,
                                   double h) {
  if (edge_ == 0.0) measure(model);
  double* unknown = model.field("Transport_Unknown");
  for (const int i : points_) unknown[i] = 0.0;
  for (std::size_t k = 0; k < ids.size(); ++k) unknown[ids[k]] = isFree[k] != 0 ? 1.0 : 0.0;
  model.importGhosts("Transport_Unknown");
  gatherPoints(model, ids, isFree);
  PeridigmNS::DegreesOfFreedomManager::self().setUnknowns(false, true);
  Collector collector(*this, model, h);
  model.assembleJacobian(h, collector);
  const double* volume = model.field("Volume");
  largestDiagonal_ = 1.0;
  for (std::size_t slot = 0; slot < points_.size(); ++slot)
    largestDiagonal_ = std::max(largestDiagonal_, lines_[slot * (lineBand + 1)] / volume[points_[slot]]);
  largestDiagonal_ = model.comm().max(largestDiagonal_);
  makeCoarse(model.comm(), collector.entries());
  factorLines();
  isBuilt_ = true;
}

void TwoLevelPreconditioner::apply(Model& model, const std::vector<int>& ids, const std::vector<char>& isFree,
                                   const std::vector<double>& r, std::vector<double>& z) {
  const double* volume = model.field("Volume");
  lineValues_.assign(points_.size() + 2 * lineBand, 0.0);
  double* lineValues = lineValues_.data() + lineBand;
  partial_.assign(static_cast<std::size_t>(nCoarse_), 0.0);
  const auto coarseOf = [&](int i) {
    return static_cast<std::size_t>(coarseOf_[static_cast<std::size_t>(cubeOf_[static_cast<std::size_t>(i)])]);
  };
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const int slot = slotOf_[static_cast<std::size_t>(ids[k])];
    if (slot < 0) continue;
    const double value = volume[ids[k]] * r[k];
    lineValues[slot] = value;
    if (nCoarse_ > 0) partial_[coarseOf(ids[k])] += value;
  }
  if (usedBand_ <= 2)
    solveLines<2>(lineValues);
  else if (usedBand_ <= 4)
    solveLines<4>(lineValues);
  else
    solveLines<lineBand>(lineValues);
  if (nCoarse_ > 0) {
    coarseValues_.resize(partial_.size());
    model.comm().SumAll(partial_.data(), coarseValues_.data(), nCoarse_);
    const Teuchos::LAPACK<int, double> lapack;
    int info = 0;
    lapack.GBTRS('N', nCoarse_, band_, band_, 1, coarse_.data(), 3 * band_ + 1, pivots_.data(), coarseValues_.data(),
                 nCoarse_, &info);
  }
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const int slot = slotOf_[static_cast<std::size_t>(ids[k])];
    if (isFree[k] == 0)
      z[k] = 0.0;
    else if (slot < 0)  // was not free when this was built
      z[k] = r[k] / largestDiagonal_;
    else
      z[k] = lineValues[slot] + (nCoarse_ > 0 ? coarseValues_[coarseOf(ids[k])] : 0.0);
  }
}

}  // namespace pd
