#include "two_level_preconditioner.hpp"

#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <cmath>

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
    localId_.assign(static_cast<std::size_t>(d.nGlobal), -1);
    for (int i = 0; i < d.nPoints; ++i)
      localId_[static_cast<std::size_t>(d.globalIds[static_cast<std::size_t>(i)])] = i;
    x_ = model.field("Model_Coordinates");
    free_ = model.field("Transport_Unknown");
    cubeOfGhost_.assign(static_cast<std::size_t>(d.nPoints - d.nOwned), Key{});
    nOwned_ = d.nOwned;
    for (int i = d.nOwned; i < d.nPoints; ++i)
      cubeOfGhost_[static_cast<std::size_t>(i - d.nOwned)] = owner.keyOf(x_ + 3 * i);
    couplings_.resize(owner.cubes_.size());
    keys_.resize(owner.cubes_.size());
    for (const auto& [key, number] : owner.cubeAt_) keys_[number] = key;
    const double* volume = model.field("Volume");
    for (const Cube& cube : owner.cubes_)
      for (std::size_t k = cube.first; k < cube.first + cube.nPoints; ++k)
        add(owner.points_[k], owner.points_[k], volume[owner.points_[k]]);
  }

  void addValue(int row, int column, double value) override {
    add(localId_[static_cast<std::size_t>(row)], localId_[static_cast<std::size_t>(column)], -h_ * value);
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
      for (const auto& [other, value] : couplings_[number]) result[{key, keys_[other]}] += value;
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
    if (cube == other) {
      const Cube& c = owner_.cubes_[static_cast<std::size_t>(cube)];
      owner_.inverses_[c.inverse + static_cast<std::size_t>(owner_.slotOf_[static_cast<std::size_t>(i)]) * c.nPoints +
                       static_cast<std::size_t>(owner_.slotOf_[static_cast<std::size_t>(j)])] += value;
    }
    auto& row = couplings_[static_cast<std::size_t>(cube)];
    for (auto& [number, sum] : row)
      if (number == static_cast<std::size_t>(other)) {
        sum += value;
        return;
      }
    row.emplace_back(static_cast<std::size_t>(other), value);
  }

  TwoLevelPreconditioner& owner_;
  const double h_;
  const double *x_, *free_;
  int nOwned_;
  std::vector<int> localId_;
  std::vector<Key> cubeOfGhost_, keys_;
  std::vector<std::vector<std::pair<std::size_t, double>>> couplings_;
  Entries betweenRanks_;
};

TwoLevelPreconditioner::Key TwoLevelPreconditioner::keyOf(const double* x) const {
  Key key;
  for (std::size_t d = 0; d < 3; ++d) key[d] = static_cast<int>(std::floor(x[d] / edge_));
  return key;
}

void TwoLevelPreconditioner::makeCubes(Model& model, const std::vector<int>& ids, const std::vector<char>& isFree) {
  const Discretization& d = model.discretization();
  const double* x = model.field("Model_Coordinates");
  if (edge_ == 0.0) {
    double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300};
    for (int i = 0; i < d.nOwned; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], x[3 * i + static_cast<int>(k)]);
        high[k] = std::max(high[k], x[3 * i + static_cast<int>(k)]);
      }
    // Cells of the points, by what they fill: the thickness of a plane problem is no length of it.
    const Communicator& comm = model.comm();
    double filled = 1.0;
    for (int k = 0; k < d.dimension; ++k) filled *= comm.max(high[k]) - comm.min(low[k]);
    const auto n = static_cast<double>(d.nGlobal);
    edge_ = std::pow(pointsOfCube[d.dimension - 1] * filled / n, 1.0 / d.dimension);
  }
  cubes_.clear();
  cubeAt_.clear();
  cubeOf_.assign(static_cast<std::size_t>(d.nOwned), -1);
  slotOf_.assign(static_cast<std::size_t>(d.nOwned), 0);
  std::vector<int> members;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (isFree[k] == 0) continue;
    const auto i = static_cast<std::size_t>(ids[k]);
    const auto [at, isNew] = cubeAt_.emplace(keyOf(x + 3 * ids[k]), cubes_.size());
    if (isNew) cubes_.push_back({0, 0, 0, -1});
    cubeOf_[i] = static_cast<int>(at->second);
    slotOf_[i] = static_cast<int>(cubes_[at->second].nPoints++);
    members.push_back(ids[k]);
  }
  std::size_t first = 0, inverse = 0;
  for (Cube& cube : cubes_) {
    cube.first = first;
    cube.inverse = inverse;
    first += cube.nPoints;
    inverse += cube.nPoints * cube.nPoints;
  }
  points_.resize(first);
  inverses_.assign(inverse, 0.0);
  for (const int i : members) {
    const auto at = static_cast<std::size_t>(i);
    points_[cubes_[static_cast<std::size_t>(cubeOf_[at])].first + static_cast<std::size_t>(slotOf_[at])] = i;
  }
}

void TwoLevelPreconditioner::invertCubes() {
  const Teuchos::LAPACK<int, double> lapack;
  for (const Cube& cube : cubes_) {
    double* a = inverses_.data() + cube.inverse;
    const auto n = static_cast<int>(cube.nPoints);
    const std::size_t m = cube.nPoints;
    std::vector<double> diagonal(m);
    for (std::size_t i = 0; i < m; ++i) diagonal[i] = a[i * m + i];
    int info = 0;
    lapack.POTRF('L', n, a, n, &info);
    if (info == 0) lapack.POTRI('L', n, a, n, &info);
    if (info != 0) {  // a rate that grows quickly with C: the diagonal must do
      std::fill(a, a + m * m, 0.0);
      for (std::size_t i = 0; i < m; ++i) a[i * m + i] = 1.0 / std::max(std::abs(diagonal[i]), 1e-300);
      continue;
    }
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = i + 1; j < m; ++j) a[j * m + i] = a[i * m + j];
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
  for (const auto& [key, cube] : cubeAt_) cubes_[cube].coarse = nCoarse_ > 0 ? numberOf.at(key) : -1;
}

void TwoLevelPreconditioner::build(Model& model, const std::vector<int>& ids, const std::vector<char>& isFree,
                                   double h) {
  double* unknown = model.field("Transport_Unknown");
  std::fill(unknown, unknown + model.nPoints(), 0.0);
  for (std::size_t k = 0; k < ids.size(); ++k) unknown[ids[k]] = isFree[k] != 0 ? 1.0 : 0.0;
  model.importGhosts("Transport_Unknown");
  makeCubes(model, ids, isFree);
  auto& unknowns = PeridigmNS::DegreesOfFreedomManager::self();
  unknowns.setUnknowns(false, true);
  Collector collector(*this, model, h);
  model.assembleJacobian(h, collector);
  const double* volume = model.field("Volume");
  largestDiagonal_ = 1.0;
  for (const Cube& cube : cubes_)
    for (std::size_t k = 0; k < cube.nPoints; ++k)
      largestDiagonal_ =
          std::max(largestDiagonal_, inverses_[cube.inverse + k * cube.nPoints + k] / volume[points_[cube.first + k]]);
  largestDiagonal_ = model.comm().max(largestDiagonal_);
  makeCoarse(model.comm(), collector.entries());
  invertCubes();
  full_.assign(static_cast<std::size_t>(model.nOwned()), 0.0);
  isBuilt_ = true;
}

void TwoLevelPreconditioner::apply(Model& model, const std::vector<int>& ids, const std::vector<char>& isFree,
                                   const std::vector<double>& r, std::vector<double>& z) {
  const double* volume = model.field("Volume");
  for (std::size_t k = 0; k < ids.size(); ++k) full_[static_cast<std::size_t>(ids[k])] = volume[ids[k]] * r[k];
  coarseValues_.assign(static_cast<std::size_t>(nCoarse_), 0.0);
  if (nCoarse_ > 0) {
    std::vector<double>& partial = local_;
    partial.assign(coarseValues_.size(), 0.0);
    for (const Cube& cube : cubes_)
      for (std::size_t k = 0; k < cube.nPoints; ++k)
        partial[static_cast<std::size_t>(cube.coarse)] += full_[static_cast<std::size_t>(points_[cube.first + k])];
    model.comm().SumAll(partial.data(), coarseValues_.data(), nCoarse_);
    const Teuchos::LAPACK<int, double> lapack;
    int info = 0;
    lapack.GBTRS('N', nCoarse_, band_, band_, 1, coarse_.data(), 3 * band_ + 1, pivots_.data(), coarseValues_.data(),
                 nCoarse_, &info);
  }
  // Points that were not free when this was built.
  for (std::size_t k = 0; k < ids.size(); ++k)
    z[k] = cubeOf_[static_cast<std::size_t>(ids[k])] < 0 ? r[k] / largestDiagonal_ : 0.0;
  std::vector<double>& solution = full_;
  for (const Cube& cube : cubes_) {
    const double* a = inverses_.data() + cube.inverse;
    const double constant = cube.coarse >= 0 ? coarseValues_[static_cast<std::size_t>(cube.coarse)] : 0.0;
    local_.assign(cube.nPoints, constant);
    for (std::size_t j = 0; j < cube.nPoints; ++j) {
      const double value = solution[static_cast<std::size_t>(points_[cube.first + j])];
      const double* column = a + j * cube.nPoints;
      for (std::size_t i = 0; i < cube.nPoints; ++i) local_[i] += column[i] * value;
    }
    for (std::size_t j = 0; j < cube.nPoints; ++j)
      solution[static_cast<std::size_t>(points_[cube.first + j])] = local_[j];
  }
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const auto i = static_cast<std::size_t>(ids[k]);
    if (cubeOf_[i] >= 0) z[k] = solution[i];
    if (isFree[k] == 0) z[k] = 0.0;
    full_[i] = 0.0;
  }
}

}  // namespace pd
