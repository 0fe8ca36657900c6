// The bonds of a body as springs between points: what resists small displacements of its reference configuration.
#ifndef PD_SPRING_NETWORK_HPP
#define PD_SPRING_NETWORK_HPP

#include <array>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

#include "../../../materials/registry/linear_bonds.hpp"
#include "../../discretization/discretization.hpp"
#include "point_vector.hpp"

namespace pd {

/// A spring in the units of a network: it resists by radial (xi.eta) xi + across eta, and gives `own` and `others` to
/// the families of its two ends (LinearSprings).
template <class Real>
struct SpringConstants {
  Real radial, across, own, others;
  /// False of a neighbour beyond the reach of the material.
  bool acts() const { return radial != 0 || across != 0 || own != 0 || others != 0; }
};

/// Which constants the columns of a network hold.
struct SpringShape {
  bool hasAcross = false, hasFamily = false;
  /// Where every spring resists across in one proportion, and gives both families half of that: across is this, times
  /// radial |xi|^2, and only radial is held. 0: otherwise.
  double acrossPerRadial = 0.0;
};

/// The same of many springs; columns that nothing needs are empty.
template <class Real>
struct SpringColumns {
  std::vector<Real> radial, across, own, others;
  void add(const SpringConstants<double>& c, const SpringShape& shape) {
    resize(radial.size() + 1, shape);
    set(radial.size() - 1, c);
  }
  void resize(std::size_t size, const SpringShape& shape) {
    radial.resize(size, Real(0));
    if (shape.acrossPerRadial != 0.0) return;
    if (shape.hasAcross) across.resize(size, Real(0));
    if (!shape.hasFamily) return;
    own.resize(size, Real(0));
    others.resize(size, Real(0));
  }
  void set(std::size_t k, const SpringConstants<double>& c) {
    radial[k] = static_cast<Real>(c.radial);
    if (!across.empty()) across[k] = static_cast<Real>(c.across);
    if (own.empty()) return;
    own[k] = static_cast<Real>(c.own);
    others[k] = static_cast<Real>(c.others);
  }
  bool acts(std::size_t k) const {
    return radial[k] != 0 || (!across.empty() && across[k] != 0) || (!own.empty() && (own[k] != 0 || others[k] != 0));
  }
  std::size_t bytes() const { return (radial.size() + across.size() + own.size() + others.size()) * sizeof(Real); }
};

/// Springs at the points of `rows`: those of row r lead to other[k], start[r] <= k < start[r + 1].
struct SpringList {
  std::vector<int> rows, other;
  std::vector<std::size_t> start{0};
  std::vector<float> alive;  ///< 1 - damage of the bond
  std::tuple<SpringColumns<double>, SpringColumns<float>> columns;

  template <class Real>
  const SpringColumns<Real>& in() const {
    return std::get<SpringColumns<Real>>(columns);
  }
  void add(int point, int neighbor, float unbroken, const SpringConstants<double>& c, const SpringShape& shape);
  std::size_t bytes() const;
};

/// What the points of a run have in common: the offsets of their neighbours' local ids, and the springs to them.
struct SpringPattern {
  /// As the loops want it.
  template <class Real>
  struct Tables {
    std::vector<int> offsets;       ///< of neighbours within the reach of the material
    std::vector<Real> stiffness;    ///< [neighbours][D (D + 1)/2] upper triangle of radial xi xi^T + across 1
    std::vector<Real> own, others;  ///< [neighbours][D] what the spring gives to the two families, times xi
    std::array<Real, 3> sumOfOwn{};
  };
  std::vector<int> offsets;
  std::vector<SpringConstants<double>> constants;
  std::vector<double> xi;  ///< [neighbours][D]
  std::tuple<Tables<double>, Tables<float>> tables;
};

/// Consecutive points of one pattern.
struct SpringRun {
  int first, count, pattern;
};

/// Consecutive points whose springs differ, as near the faces of a lattice or in one whose points have moved: a spring
/// of each point to each of the offsets, without constants where it has none.
struct SpringStrip {
  static constexpr int lanes = 16;  ///< that a loop may read from a column on, whatever it makes of them
  int first, count;
  std::vector<int> offsets;                                         ///< rising
  std::tuple<SpringColumns<double>, SpringColumns<float>> columns;  ///< [offsets][count], and `lanes` more

  std::size_t at(std::size_t offset, int point) const {
    return offset * static_cast<std::size_t>(count) + static_cast<std::size_t>(point - first);
  }
  template <class Real>
  const SpringColumns<Real>& in() const {
    return std::get<SpringColumns<Real>>(columns);
  }
};

/// Broken bonds of consecutive points of runs over one of the offsets of their pattern, to points of larger numbers
/// that are in runs or strips, too.
struct BrokenStretch {
  int first, count, pattern, neighbor;
};

/// Every bond between two owned points is here once: in the runs and strips, seen from a point that belongs to one, and
/// else in `pairs`, which act on both ends. Between a point of neither and one of either a `single` acts on the former.
/// A bond to a ghost or an image acts on its owned end alone, as a whole, since its other end's rank (or copy) has it,
/// too; where hasHalves(), it is a pair of which each rank has its own end's share. What is broken of runs and strips,
/// `brokenStretches` and `corrections` take away, from both ends, and where the other end is in neither,
/// `singleCorrections` from their rows alone.
///
/// Lengths and stiffnesses are in units of their own, so that single precision will do wherever the body is and
/// whatever it is made of.
class SpringNetwork {
 public:
  using Family = LinearSprings::Family;

  /// What bonds to ghosts and images have in the lists of their other ends, in the order in which they come in those of
  /// this rank's points (BorderBonds).
  struct OtherEnds {
    bool areKnown = false;
    std::vector<double> along, across;
  };

  /// `along`, `across` (empty: none) [bonds, in the order of the discretization] N/m, `dilatational` [nOwned] 1/(N m):
  /// LinearSprings. Without known `others` springs to ghosts and images are halves. Refers to `points`. Collective.
  SpringNetwork(const Communicator& comm, const Discretization& points, Family family, const std::vector<double>& along,
                const std::vector<double>& across, const std::vector<double>& dilatational, const OtherEnds& others);

  /// Takes up the bond damage of the owned points `changed`; damageOf(point): of its bonds, in the order of its list.
  void setDamage(const std::vector<int>& changed, const std::function<const double*(int)>& damageOf);
  /// Whether the ends of every bond that the last setDamage() has broken are known to hang together still, by unbroken
  /// bonds around them. Of bonds to ghosts and images it is not known.
  bool hasKeptTogether() const { return hasKeptTogether_; }
  /// Two owned points of which one has broken their bond and the other has not, since the last setDamage(); {-1, -1}:
  /// none. A spring is broken as a whole, as the one end has it that it is kept with.
  std::pair<int, int> brokenFromOneEnd() const { return brokenFromOneEnd_; }
  /// The same of bonds to points of other ranks, and to images: a ghost or an image that has broken its bond to an
  /// owned point of this rank, and that. `changed`: those of the last setDamage(). Collective.
  std::pair<int, int> brokenFromOtherSide(const Communicator& comm, const std::vector<int>& changed) const;

  const Discretization& points() const { return points_; }
  int dimension() const { return points_.dimension; }
  Family family() const { return family_; }
  int familyWidth() const {
    return family_ == Family::None ? 0 : (family_ == Family::Rotation && dimension() == 3 ? 3 : 1);
  }
  bool hasAcross() const { return shape_.hasAcross; }
  double acrossPerRadial() const { return shape_.acrossPerRadial; }  ///< of SpringShape
  bool hasNegative() const { return hasNegative_; }                  ///< some spring pushes where it should pull
  bool hasHalves() const { return hasHalves_; }                      ///< those to ghosts and images, if there are any
  /// Whether the spring is one of which another rank, or a copy of the body, has the like: both are the bond.
  bool isTwice(int neighbor) const { return !hasHalves_ && neighbor >= points_.nOwned; }
  /// Whether the spring has the share of this end, too.
  bool hasOtherShare(int neighbor) const { return !hasHalves_ || neighbor < points_.nOwned; }
  double stiffnessUnit() const { return stiffnessUnit_; }  ///< N/m, the same on all ranks
  double lengthUnit() const { return lengthUnit_; }        ///< m
  const std::vector<double>& dilatational() const { return dilatational_; }

  const std::vector<SpringRun>& runs() const { return runs_; }
  const std::vector<SpringPattern>& patterns() const { return patterns_; }
  const std::vector<SpringStrip>& strips() const { return strips_; }
  const SpringList& pairs() const { return pairs_; }
  const SpringList& singles() const { return singles_; }
  const std::vector<BrokenStretch>& brokenStretches() const { return brokenStretches_; }
  const SpringList& corrections() const { return corrections_; }
  const SpringList& singleCorrections() const { return singleCorrections_; }
  /// Whether a run or a strip has all springs of the point.
  bool isComplete(int point) const { return isComplete_[static_cast<std::size_t>(point)] != 0; }
  /// Of all local points, in units of length.
  template <class Real>
  const PointVector<Real>& places() const {
    return std::get<PointVector<Real>>(places_);
  }
  const int* neighbors(int point) const { return &points_.neighborhoodList[listStart(point) + 1]; }
  int nNeighbors(int point) const { return points_.neighborhoodList[listStart(point)]; }
  bool isDamaged(int point) const { return !aliveOfPoint_[static_cast<std::size_t>(point)].empty(); }
  /// 1 - damage of bond k of a point.
  float alive(int point, int k) const {
    const std::vector<float>& own = aliveOfPoint_[static_cast<std::size_t>(point)];
    return own.empty() ? 1.0F : own[static_cast<std::size_t>(k)];
  }
  std::size_t bytes() const;

  /// visit(i, j, xi [D], constants) for each spring of this rank once, as damage has left it.
  template <class Visit>
  void forEachSpring(const Visit& visit) const {
    forEachSpringIn([](int) { return true; }, visit);
  }
  /// Of those of rows that isWanted(point), in the same order. A spring is in the row of one of its ends.
  template <class IsWanted, class Visit>
  void forEachSpringIn(const IsWanted& isWanted, const Visit& visit) const;
  /// Those of all rows; of runs and strips offset after offset, so that what one spring and the next lead from and to
  /// lies side by side.
  template <class Visit>
  void forEachSpringByOffset(const Visit& visit) const;
  /// [nPoints] 1 for `points` and their neighbours.
  std::vector<char> around(const std::vector<int>& points) const;

 private:
  struct Row;
  struct StripRows;
  class RowReader;
  /// Of the point, or of the one that an image mirrors.
  int globalIdOf(int point) const { return points_.globalIds[static_cast<std::size_t>(points_.sourceOf(point))]; }
  /// Unbroken bonds of the owned point to a point with this global id, or to images of it.
  int nUnbroken(int point, int globalId) const;
  void add(SpringList& list, int i, int j, float unbroken, const SpringConstants<double>& c) const {
    list.add(i, j, unbroken, c, shape_);
  }
  std::size_t listStart(int point) const {
    return static_cast<std::size_t>(points_.neighborhoodStart[static_cast<std::size_t>(point)]);
  }
  bool follows(const Row& row, const SpringPattern& pattern) const;
  struct Proportion;
  void look(const Row& row, Proportion& proportion) const;
  /// Of spring k of these columns, which leads to j over xi.
  SpringConstants<double> constantsOf(const SpringColumns<double>& columns, std::size_t k,
                                      const std::array<double, 3>& xi, int j) const;
  void endRun(SpringRun& run, SpringPattern& pattern);
  void findRuns(RowReader reader, Proportion& proportion);
  void findStrips(RowReader reader);
  void endStrip(StripRows& rows);
  void makeLists(RowReader reader);
  /// visit(point, number of the neighbour, place in the columns) for each spring of those points of a strip that
  /// isWanted(point).
  template <class IsWanted, class Visit>
  void forEachOf(const SpringStrip& strip, const IsWanted& isWanted, const Visit& visit) const;
  std::array<double, 3> difference(int i, int j) const {
    std::array<double, 3> xi{};
    const PointVector<double>& x = places<double>();
    for (int c = 0; c < dimension(); ++c) xi[static_cast<std::size_t>(c)] = x[c][j] - x[c][i];
    return xi;
  }
  void setAlive(SpringList& list, int row, int point);
  void makeCorrections();
  void addCorrection(int i, int j, float left, const SpringConstants<double>& c);
  /// Of the points of a run from `first` to before `last`.
  void correctRun(const SpringRun& run, int first, int last);
  template <class IsWanted, class Visit>
  void forEachOfLists(const IsWanted& isWanted, const Visit& visit) const;
  /// alive() of a neighbour that is not known by its place in the list.
  float aliveTo(int point, int neighbor) const;
  static SpringConstants<double> scaled(const SpringConstants<double>& c, double share) {
    return {share * c.radial, share * c.across, share * c.own, share * c.others};
  }
  bool areJoined(int i, int j);
  std::pair<int, int> findBrokenFromOneEnd(const std::vector<int>& changed) const;

  const Discretization& points_;
  Family family_;
  SpringShape shape_;
  bool hasNegative_ = false, hasHalves_;
  double stiffnessUnit_ = 1.0, lengthUnit_ = 1.0;
  std::tuple<PointVector<double>, PointVector<float>> places_;
  std::vector<double> dilatational_;
  std::vector<SpringRun> runs_;
  std::vector<SpringPattern> patterns_;
  std::vector<SpringStrip> strips_;
  std::vector<char> isComplete_;  ///< [nPoints]
  SpringList pairs_, singles_, corrections_, singleCorrections_;
  std::vector<BrokenStretch> brokenStretches_;
  std::vector<int> pairRow_, singleRow_;          ///< [nOwned] -1: none
  std::vector<std::vector<float>> aliveOfPoint_;  ///< of points with damaged bonds; else empty
  bool hasKeptTogether_ = true;
  std::pair<int, int> brokenFromOneEnd_{-1, -1};
  std::vector<int> visitedBy_;  ///< [nOwned] by which search of areJoined()
  int nVisits_ = 0;
};

template <class IsWanted, class Visit>
void SpringNetwork::forEachOf(const SpringStrip& strip, const IsWanted& isWanted, const Visit& visit) const {
  for (int i = strip.first; i < strip.first + strip.count; ++i) {
    if (!isWanted(i)) continue;
    std::size_t offset = 0;
    for (int k = 0; k < nNeighbors(i); ++k) {
      while (strip.offsets[offset] < neighbors(i)[k] - i) ++offset;
      const std::size_t at = strip.at(offset, i);
      if (strip.in<double>().acts(at)) visit(i, k, at);
    }
  }
}

template <class IsWanted, class Visit>
void SpringNetwork::forEachSpringIn(const IsWanted& isWanted, const Visit& visit) const {
  const auto d = static_cast<std::size_t>(dimension());
  for (const SpringRun& run : runs_) {
    const SpringPattern& pattern = patterns_[static_cast<std::size_t>(run.pattern)];
    for (int i = run.first; i < run.first + run.count; ++i) {
      if (!isWanted(i)) continue;
      for (std::size_t k = 0; k < pattern.offsets.size(); ++k) {
        const int j = i + pattern.offsets[k];
        if (j < i && isComplete(j)) continue;
        const float share = alive(i, static_cast<int>(k));
        if (share != 0.0F && pattern.constants[k].acts())
          visit(i, j, &pattern.xi[k * d], scaled(pattern.constants[k], share));
      }
    }
  }
  for (const SpringStrip& strip : strips_)
    forEachOf(strip, isWanted, [&](int i, int k, std::size_t at) {
      const int j = neighbors(i)[k];
      if ((j < i && isComplete(j)) || alive(i, k) == 0.0F) return;
      const auto xi = difference(i, j);
      visit(i, j, xi.data(), scaled(constantsOf(strip.in<double>(), at, xi, j), alive(i, k)));
    });
  forEachOfLists(isWanted, visit);
}

template <class IsWanted, class Visit>
void SpringNetwork::forEachOfLists(const IsWanted& isWanted, const Visit& visit) const {
  const auto forEachOf = [&](const SpringList& list, const auto& isOf) {
    for (std::size_t r = 0; r < list.rows.size(); ++r) {
      if (!isWanted(list.rows[r])) continue;
      for (std::size_t k = list.start[r]; k < list.start[r + 1]; ++k) {
        const int i = list.rows[r], j = list.other[k];
        if (list.alive[k] == 0.0F || !isOf(j)) continue;
        const auto xi = difference(i, j);
        visit(i, j, xi.data(), scaled(constantsOf(list.in<double>(), k, xi, j), list.alive[k]));
      }
    }
  };
  forEachOf(pairs_, [](int) { return true; });
  forEachOf(singles_, [this](int j) { return isTwice(j); });  // others are in the rows of their other ends
}

template <class Visit>
void SpringNetwork::forEachSpringByOffset(const Visit& visit) const {
  const auto d = static_cast<std::size_t>(dimension());
  for (const SpringRun& run : runs_) {
    const SpringPattern& pattern = patterns_[static_cast<std::size_t>(run.pattern)];
    for (std::size_t k = 0; k < pattern.offsets.size(); ++k) {
      if (!pattern.constants[k].acts()) continue;
      for (int i = run.first; i < run.first + run.count; ++i) {
        const int j = i + pattern.offsets[k];
        if (j < i && isComplete(j)) continue;
        const float share = alive(i, static_cast<int>(k));
        if (share != 0.0F) visit(i, j, &pattern.xi[k * d], scaled(pattern.constants[k], share));
      }
    }
  }
  for (const SpringStrip& strip : strips_)
    for (std::size_t offset = 0; offset < strip.offsets.size(); ++offset)
      for (int i = strip.first; i < strip.first + strip.count; ++i) {
        const int j = i + strip.offsets[offset];
        const std::size_t at = strip.at(offset, i);
        if (!strip.in<double>().acts(at) || (j < i && isComplete(j))) continue;
        const float share = isDamaged(i) ? aliveTo(i, j) : 1.0F;
        if (share == 0.0F) continue;
        const auto xi = difference(i, j);
        visit(i, j, xi.data(), scaled(constantsOf(strip.in<double>(), at, xi, j), share));
      }
  forEachOfLists([](int) { return true; }, visit);
}

}  // namespace pd

#endif
