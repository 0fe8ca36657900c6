#include "two_level_preconditioner.hpp"

#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "../diffusion/scalar_unknown.hpp"
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
    cubeOfGhost_.assign(static_cast<std::size_t>(d.firstImage() - d.nOwned), Key{});
    nOwned_ = d.nOwned;
    for (int i = d.nOwned; i < d.firstImage(); ++i)
      cubeOfGhost_[static_cast<std::size_t>(i - d.nOwned)] = owner.keyOf(x + 3 * i);
    couplings_.resize(owner.cubeAt_.size());
    inRow_.resize(owner.cubeAt_.size());
    keys_.resize(owner.cubeAt_.size());
    for (const auto& [key, number] : owner.cubeAt_) keys_[static_cast<std::size_t>(number)] = key;
    const double* volume = model.field("Volume");
    for (const int i : owner.points_) add(i, i, volume[i]);
  }

  void addValue(int row, int column, double value) override {
    if (row != row_) {
      row_ = row;
      own_ = owner_.localId_[static_cast<std::size_t>(row)];
    }
    add(own_, owner_.localId_[static_cast<std::size_t>(column)], -h_ * value);
  }
  void addValues(int n, const int* ids, const double* const* values) override {
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) addValue(ids[a], ids[b], values[a][b]);
  }
  void addBlockDiagonalValues(int n, const int* ids, const double* const* values) override {
    for (int a = 0; a < n; ++a) addValue(ids[a], ids[a], values[a][a]);
  }
  void putScalar(double) override {}

  /// Sums over pairs of cubes, those with ghosts included: keys of both, and the sum.
  std::vector<double> entries() const {
    std::vector<double> result;
    const auto append = [&](const Key& from, const Key& to, double value) {
      for (const Key* key : {&from, &to}) result.insert(result.end(), key->begin(), key->end());
      result.push_back(value);
    };
    for (std::size_t cube = 0; cube < keys_.size(); ++cube)
      for (const auto& [other, value] : couplings_[cube]) {
        append(keys_[cube], keys_[other], value);
        if (other != cube) append(keys_[other], keys_[cube], value);
      }
    for (const auto& [pair, value] : betweenRanks_) append(pair.first, pair.second, value);
    return result;
  }

 private:
  void add(int i, int j, double value) {
    const Place& own = owner_.places_[static_cast<std::size_t>(i)];
    const int cube = own.cube;
    if (cube < 0) return;
    if (j >= nOwned_) {
      if (free_[j] == 0.0) return;
      betweenRanks_[{keys_[static_cast<std::size_t>(cube)], cubeOfGhost_[static_cast<std::size_t>(j - nOwned_)]}] +=
          value;
      return;
    }
    const Place& far = owner_.places_[static_cast<std::size_t>(j)];
    if (far.cube < 0) return;
    // The matrix is symmetric: its lower half will do.
    const int back = own.slot - far.slot;
    if (back < 0) return;
    if (own.line == far.line && back <= lineBand) {
      owner_.lines_[static_cast<std::size_t>(own.slot * (lineBand + 1) + back)] += value;
      owner_.usedBand_ = std::max(owner_.usedBand_, back);
    }
    couplings_[static_cast<std::size_t>(cube)]
              [positionOf(i, static_cast<std::size_t>(cube), static_cast<std::size_t>(far.cube))]
                  .second += back > 0 && far.cube == cube ? 2.0 * value : value;
  }

  /// Where the row of `cube` keeps `other`: looked for once in each row of points.
  std::size_t positionOf(int i, std::size_t cube, std::size_t other) {
    InRow& found = inRow_[other];
    if (found.row == i) return found.position;
    auto& row = couplings_[cube];
    std::size_t at = 0;
    while (at < row.size() && row[at].first != other) ++at;
    if (at == row.size()) row.emplace_back(other, 0.0);
    found.row = i;
    return found.position = at;
  }

  TwoLevelPreconditioner& owner_;
  const double h_;
  const double* free_;
  int nOwned_;
  std::vector<Key> cubeOfGhost_, keys_;
  std::vector<std::vector<std::pair<std::size_t, double>>> couplings_;  ///< by cube: other cubes, and sums
  struct InRow {
    int row = -1;
    std::size_t position = 0;
  };
  std::vector<InRow> inRow_;  ///< by other cube: where it is in the row of the cube of the last point that asked
  int row_ = -1, own_ = -1;   ///< last row: global and local id
  std::map<std::pair<Key, Key>, double> betweenRanks_;
};

TwoLevelPreconditioner::Key TwoLevelPreconditioner::keyOf(const double* x) const {
  Key key;
  for (std::size_t d = 0; d < 3; ++d) key[d] = static_cast<int>(std::floor((x[d] - corner_[d]) / edges_[d]));
  return key;
}

/// What does not change in a run: edge of cubes, the axis along which the nearest neighbours lie, arrays of all points.
void TwoLevelPreconditioner::measure(Model& model) {
  const Discretization& d = model.discretization();
  const Communicator& comm = model.comm();
  const double* x = model.field("Model_Coordinates");
  localId_.assign(static_cast<std::size_t>(d.nGlobal * d.symmetry.nCopies()), -1);
  for (int i = 0; i < d.nPoints; ++i)
    localId_[static_cast<std::size_t>(d.globalIds[static_cast<std::size_t>(i)])] = d.sourceOf(i);
  places_.assign(static_cast<std::size_t>(d.nOwned), Place{});
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
  for (double& value : nearest) value = comm.min(value);
  axis_ = static_cast<std::size_t>(std::min_element(nearest, nearest + 3) - nearest);
  setCubes(d, comm, low, high, nearest);
  spacing_ = std::min(nearest[axis_], edges_[axis_]);
}

/// On a grid, whole cells, however much of it there is; else by the mean volume of a point.
void TwoLevelPreconditioner::setCubes(const Discretization& d, const Communicator& comm, const double (&low)[3],
                                      const double (&high)[3], const double (&nearest)[3]) {
  double filled = 1.0, cell = 1.0;
  for (int k = 0; k < d.dimension; ++k) {
    corner_[static_cast<std::size_t>(k)] = comm.min(low[k]);
    filled *= comm.max(high[k]) - comm.min(low[k]);
    cell *= nearest[k];
  }
  const bool isGrid = cell < filled;
  const double share = isGrid ? cell : filled / static_cast<double>(d.nGlobal);
  edges_.fill(std::pow(pointsOfCube[d.dimension - 1] * share, 1.0 / d.dimension));
  for (std::size_t k = 0; k < static_cast<std::size_t>(d.dimension) && isGrid; ++k) {
    edges_[k] = std::max(1.0, std::round(edges_[k] / nearest[k])) * nearest[k];
    corner_[k] -= 0.5 * nearest[k];
  }
}

void TwoLevelPreconditioner::gatherPoints(Model& model, const std::vector<int>& ids, const std::vector<char>& isFree) {
  const double* x = model.field("Model_Coordinates");
  cubeAt_.clear();
  for (const int i : points_) places_[static_cast<std::size_t>(i)] = Place{};
  struct OnLine {
    long long first, second;
    double along;
    int point;
  };
  std::vector<OnLine> onLines;
  const auto grid = [&](int i, std::size_t axis) {
    return std::llround(4.0 * x[3 * static_cast<std::size_t>(i) + axis] / spacing_ + 0.37);
  };
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (isFree[k] == 0) continue;
    const int i = ids[k];
    places_[static_cast<std::size_t>(i)].cube =
        cubeAt_.emplace(keyOf(x + 3 * i), static_cast<int>(cubeAt_.size())).first->second;
    onLines.push_back(
        {grid(i, (axis_ + 1) % 3), grid(i, (axis_ + 2) % 3), x[3 * static_cast<std::size_t>(i) + axis_], i});
  }
  std::sort(onLines.begin(), onLines.end(), [](const OnLine& a, const OnLine& b) {
    return std::tie(a.first, a.second, a.along) < std::tie(b.first, b.second, b.along);
  });
  points_.clear();
  int line = 0;
  for (std::size_t k = 0; k < onLines.size(); ++k) {
    if (k > 0 && std::tie(onLines[k].first, onLines[k].second) != std::tie(onLines[k - 1].first, onLines[k - 1].second))
      ++line;
    Place& place = places_[static_cast<std::size_t>(onLines[k].point)];
    place.slot = static_cast<int>(k);
    place.line = line;
    points_.push_back(onLines[k].point);
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
void TwoLevelPreconditioner::makeCoarse(const Communicator& comm, const std::vector<double>& own) {
  const std::vector<double> all = comm.gather(own);
  constexpr std::size_t width = 7;
  const auto keyAt = [&](std::size_t k) {
    return Key{static_cast<int>(all[k]), static_cast<int>(all[k + 1]), static_cast<int>(all[k + 2])};
  };
  std::map<Key, int> numberOf;
  for (std::size_t k = 0; k < all.size(); k += width) numberOf[keyAt(k)] = 0;
  nCoarse_ = 0;
  for (auto& item : numberOf) item.second = nCoarse_++;
  band_ = 0;
  struct Entry {
    int row, column;
    double value;
  };
  std::vector<Entry> entries;
  for (std::size_t k = 0; k < all.size(); k += width) {
    const auto to = numberOf.find(keyAt(k + 3));
    if (to == numberOf.end()) continue;
    entries.push_back({numberOf[keyAt(k)], to->second, all[k + 6]});
    band_ = std::max(band_, std::abs(entries.back().row - entries.back().column));
  }
  const int height = 3 * band_ + 1;
  coarse_.assign(static_cast<std::size_t>(height) * static_cast<std::size_t>(nCoarse_), 0.0);
  pivots_.resize(static_cast<std::size_t>(nCoarse_));
  for (const Entry& entry : entries)
    coarse_[static_cast<std::size_t>(entry.column) * static_cast<std::size_t>(height) +
            static_cast<std::size_t>(2 * band_ + entry.row - entry.column)] += entry.value;
  const Teuchos::LAPACK<int, double> lapack;
  int info = 0;
  if (nCoarse_ > 0) lapack.GBTRF(nCoarse_, nCoarse_, band_, band_, coarse_.data(), height, pivots_.data(), &info);
  if (info != 0) nCoarse_ = 0;  // without it the cubes must do
  coarseOf_.assign(cubeAt_.size(), 0);
  for (const auto& [key, cube] : cubeAt_)
    coarseOf_[static_cast<std::size_t>(cube)] = nCoarse_ > 0 ? numberOf.at(key) : 0;
}

void TwoLevelPreconditioner::build(Model& model, const std::string& field, const std::vector<int>& ids,
                                   const std::vector<char>& isFree, double h) {
  if (spacing_ == 0.0) measure(model);
  double* unknown = model.field("Transport_Unknown");
  for (const int i : points_) unknown[i] = 0.0;
  for (std::size_t k = 0; k < ids.size(); ++k) unknown[ids[k]] = isFree[k] != 0 ? 1.0 : 0.0;
  model.importGhosts("Transport_Unknown");
  gatherPoints(model, ids, isFree);
  const ScalarUnknown unknownField(field);
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
    return static_cast<std::size_t>(coarseOf_[static_cast<std::size_t>(places_[static_cast<std::size_t>(i)].cube)]);
  };
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const int slot = places_[static_cast<std::size_t>(ids[k])].slot;
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
    const int slot = places_[static_cast<std::size_t>(ids[k])].slot;
    if (isFree[k] == 0)
      z[k] = 0.0;
    else if (slot < 0)  // was not free when this was built
      z[k] = r[k] / largestDiagonal_;
    else
      z[k] = lineValues[slot] + (nCoarse_ > 0 ? coarseValues_[coarseOf(ids[k])] : 0.0);
  }
}

}  // namespace pd
