#include "spring_kernels.hpp"

#include <algorithm>
#include <array>
#include <experimental/simd>
#include <type_traits>

#include "broken_bonds.hpp"
#include "spring_measure.hpp"

namespace pd {

namespace {

namespace stdx = std::experimental;
using Family = SpringNetwork::Family;

/// `isProportional`: SpringShape::acrossPerRadial is not 0.
template <class Real, int D, Family family, bool hasAcross, bool isProportional>
class Loops {
 public:
  explicit Loops(const SpringNetwork& network)
      : network_(network), ratio_(static_cast<Real>(network.acrossPerRadial())) {}

  void addFamilies(const PointVector<Real>& x, PointVector<Real>& s) const {
    forEachBlockOfRuns([&](auto width, int first, const SpringPattern& pattern) {
      addFamiliesOfBlock<decltype(width)::value>(first, pattern, x, s);
    });
    forEachBlockOfStrips([&](auto width, int first, int count, std::size_t column, const SpringStrip& strip) {
      addFamiliesOfStrip<decltype(width)::value>(first, count, column, strip, x, s);
    });
    addFamiliesOfList<true>(network_.pairs(), x, s);
    addFamiliesOfList<false>(network_.singles(), x, s);
    for (const BrokenStretch& stretch : network_.brokenStretches())
      BrokenBonds<Real, D, family>(network_, stretch).takeFromFamilies(x, s);
    addFamiliesOfList<true>(network_.corrections(), x, s);
    addFamiliesOfList<false>(network_.singleCorrections(), x, s);
  }
  void forces(const PointVector<Real>& x, const PointVector<Real>& t, PointVector<Real>& y) const {
    y.zero();
    forEachBlockOfRuns([&](auto width, int first, const SpringPattern& pattern) {
      forcesOfBlock<decltype(width)::value>(first, pattern, x, t, y);
    });
    forEachBlockOfStrips([&](auto width, int first, int count, std::size_t column, const SpringStrip& strip) {
      forcesOfStrip<decltype(width)::value>(first, count, column, strip, x, t, y);
    });
    addForcesOfList<true>(network_.pairs(), x, t, y);
    addForcesOfList<false>(network_.singles(), x, t, y);
    for (const BrokenStretch& stretch : network_.brokenStretches())
      BrokenBonds<Real, D, family>(network_, stretch).takeFromForces(x, t, y);
    addForcesOfList<true>(network_.corrections(), x, t, y);
    addForcesOfList<false>(network_.singleCorrections(), x, t, y);
  }

 private:
  using Vector = stdx::native_simd<Real>;
  static constexpr int lanes = static_cast<int>(Vector::size());
  using M = SpringMeasure<D, family>;
  static constexpr int nStiffness = D * (D + 1) / 2;
  static constexpr std::size_t nArrays = M::width > 0 ? M::width : 1;

  static Vector load(const Real* from) { return Vector(from, stdx::element_aligned); }

  /// work(number of vectors, first point, pattern): blocks of a run may overlap, since they write what they compute.
  template <class Work>
  void forEachBlockOfRuns(const Work& work) const {
    constexpr int most = D < 3 ? 4 : 2;
    for (const SpringRun& run : network_.runs()) {
      const SpringPattern& pattern = network_.patterns()[static_cast<std::size_t>(run.pattern)];
      int at = 0;
      for (; at + most * lanes <= run.count; at += most * lanes)
        work(std::integral_constant<int, most>(), run.first + at, pattern);
      for (; at < run.count; at += lanes)
        work(std::integral_constant<int, 1>(), run.first + std::min(at, run.count - lanes), pattern);
    }
  }

  template <int width>
  void addFamiliesOfBlock(int first, const SpringPattern& pattern, const PointVector<Real>& x,
                          PointVector<Real>& s) const {
    if constexpr (M::width > 0) {
      const auto& tables = std::get<SpringPattern::Tables<Real>>(pattern.tables);
      Vector own[width][D], sum[width][nArrays];
      for (int w = 0; w < width; ++w) {
        for (int d = 0; d < D; ++d) own[w][d] = load(x[d] + first + w * lanes);
        for (int m = 0; m < M::width; ++m) sum[w][m] = Real(0);
      }
      const Real* gives = tables.own.data();
      for (const int offset : tables.offsets) {
        for (int w = 0; w < width; ++w) {
          Vector eta[D];
          for (int d = 0; d < D; ++d) eta[d] = load(x[d] + first + w * lanes + offset) - own[w][d];
          M::add(gives, eta, sum[w]);
        }
        gives += D;
      }
      for (int w = 0; w < width; ++w)
        for (int m = 0; m < M::width; ++m) sum[w][m].copy_to(s[m] + first + w * lanes, stdx::element_aligned);
    }
  }

  template <int width>
  void forcesOfBlock(int first, const SpringPattern& pattern, const PointVector<Real>& x, const PointVector<Real>& t,
                     PointVector<Real>& y) const {
    const auto& tables = std::get<SpringPattern::Tables<Real>>(pattern.tables);
    Vector own[width][D], sum[width][D], ownResponse[width][nArrays];
    for (int w = 0; w < width; ++w) {
      for (int d = 0; d < D; ++d) {
        own[w][d] = load(x[d] + first + w * lanes);
        sum[w][d] = Real(0);
      }
      for (int m = 0; m < M::width; ++m) ownResponse[w][m] = load(t[m] + first + w * lanes);
    }
    const Real *k = tables.stiffness.data(), *takes = tables.others.data();
    for (const int offset : tables.offsets) {
      for (int w = 0; w < width; ++w) {
        Vector eta[D];
        for (int d = 0; d < D; ++d) eta[d] = load(x[d] + first + w * lanes + offset) - own[w][d];
        if constexpr (D == 1) {
          sum[w][0] += k[0] * eta[0];
        } else if constexpr (D == 2) {
          sum[w][0] += k[0] * eta[0];
          sum[w][1] += k[1] * eta[0];
          sum[w][0] += k[1] * eta[1];
          sum[w][1] += k[2] * eta[1];
        } else {
          sum[w][0] += k[0] * eta[0];
          sum[w][1] += k[1] * eta[0];
          sum[w][2] += k[2] * eta[0];
          sum[w][0] += k[1] * eta[1];
          sum[w][1] += k[3] * eta[1];
          sum[w][2] += k[4] * eta[1];
          sum[w][0] += k[2] * eta[2];
          sum[w][1] += k[4] * eta[2];
          sum[w][2] += k[5] * eta[2];
        }
        if constexpr (M::width > 0) {
          Vector other[nArrays];
          for (int m = 0; m < M::width; ++m) other[m] = load(t[m] + first + w * lanes + offset);
          M::addGradient(takes, other, sum[w]);
        }
      }
      k += nStiffness;
      takes += D;
    }
    if constexpr (M::width > 0)
      for (int w = 0; w < width; ++w) M::addGradient(tables.sumOfOwn.data(), ownResponse[w], sum[w]);
    for (int w = 0; w < width; ++w)
      for (int d = 0; d < D; ++d) (-sum[w][d]).copy_to(y[d] + first + w * lanes, stdx::element_aligned);
  }

  /// work(number of vectors, first point, number of points, first column, strip)
  template <class Work>
  void forEachBlockOfStrips(const Work& work) const {
    constexpr int most = D < 3 ? 2 : 1;
    static_assert(most * lanes <= 2 * SpringStrip::lanes);
    for (const SpringStrip& strip : network_.strips())
      for (int at = 0; at < strip.count;) {
        const int left = strip.count - at, first = strip.first + at;
        if (most > 1 && left > lanes) {
          work(std::integral_constant<int, most>(), first, std::min(most * lanes, left), static_cast<std::size_t>(at),
               strip);
          at += most * lanes;
        } else {
          work(std::integral_constant<int, 1>(), first, std::min(lanes, left), static_cast<std::size_t>(at), strip);
          at += lanes;
        }
      }
  }
  /// Lanes beyond `count` belong to other points.
  static void store(const Vector& value, Real* to, int count) {
    if (count >= lanes) return value.copy_to(to, stdx::element_aligned);
    std::array<Real, static_cast<std::size_t>(lanes)> all;
    value.copy_to(all.data(), stdx::element_aligned);
    std::copy_n(all.begin(), std::max(count, 0), to);
  }

  /// Writes xi and eta of the neighbours of `lanes` points from `first` on.
  void findBonds(int first, int offset, const PointVector<Real>& x, const Vector* place, const Vector* own, Vector* xi,
                 Vector* eta) const {
    const PointVector<Real>& places = network_.places<Real>();
    for (int d = 0; d < D; ++d) {
      xi[d] = load(places[d] + first + offset) - place[d];
      eta[d] = load(x[d] + first + offset) - own[d];
    }
  }
  /// What a spring across resists by, over Ratio.
  static Vector perRatio(const Vector& radial, const Vector* xi) {
    Vector length2 = xi[0] * xi[0];
    for (int d = 1; d < D; ++d) length2 += xi[d] * xi[d];
    return radial * length2;
  }

  template <int width>
  void addFamiliesOfStrip(int first, int count, std::size_t column, const SpringStrip& strip,
                          const PointVector<Real>& x, PointVector<Real>& s) const {
    if constexpr (M::width > 0) {
      const PointVector<Real>& places = network_.places<Real>();
      Vector own[width][D], place[width][D], sum[width][nArrays];
      for (int w = 0; w < width; ++w) {
        for (int d = 0; d < D; ++d) own[w][d] = load(x[d] + first + w * lanes);
        for (int d = 0; d < D; ++d) place[w][d] = load(places[d] + first + w * lanes);
        for (int m = 0; m < M::width; ++m) sum[w][m] = Real(0);
      }
      const SpringColumns<Real>& c = strip.in<Real>();
      const Real* gives = (isProportional ? c.radial : c.own).data() + column;
      for (const int offset : strip.offsets) {
        for (int w = 0; w < width; ++w) {
          Vector xi[D], eta[D];
          findBonds(first + w * lanes, offset, x, place[w], own[w], xi, eta);
          Vector share = load(gives + w * lanes);
          if constexpr (isProportional) share = perRatio(share, xi);
          for (int d = 0; d < D; ++d) xi[d] *= share;
          M::add(xi, eta, sum[w]);
        }
        gives += strip.count;
      }
      const Real factor = isProportional ? Real(0.5) * ratio_ : Real(1);
      for (int w = 0; w < width; ++w)
        for (int m = 0; m < M::width; ++m) store(factor * sum[w][m], s[m] + first + w * lanes, count - w * lanes);
    }
  }

  template <int width>
  void forcesOfStrip(int first, int count, std::size_t column, const SpringStrip& strip, const PointVector<Real>& x,
                     const PointVector<Real>& t, PointVector<Real>& y) const {
    const PointVector<Real>& places = network_.places<Real>();
    const SpringColumns<Real>& c = strip.in<Real>();
    Vector own[width][D], place[width][D], sum[width][D], turned[width][D], ownResponse[width][nArrays];
    for (int w = 0; w < width; ++w) {
      const int at = first + w * lanes;
      for (int d = 0; d < D; ++d) {
        own[w][d] = load(x[d] + at);
        place[w][d] = load(places[d] + at);
        sum[w][d] = turned[w][d] = Real(0);
      }
      for (int m = 0; m < M::width; ++m) ownResponse[w][m] = load(t[m] + at);
    }
    std::size_t k = column;
    for (const int offset : strip.offsets) {
      for (int w = 0; w < width; ++w) {
        const int at = first + w * lanes;
        const std::size_t kw = k + static_cast<std::size_t>(w * lanes);
        Vector xi[D], eta[D], force[D], along = Real(0);
        findBonds(at, offset, x, place[w], own[w], xi, eta);
        const Vector radial = load(c.radial.data() + kw);
        for (int d = 0; d < D; ++d) along += xi[d] * eta[d];
        along *= radial;
        for (int d = 0; d < D; ++d) force[d] = along * xi[d];
        if constexpr (isProportional) {
          const Vector unit = perRatio(radial, xi), across = ratio_ * unit;
          for (int d = 0; d < D; ++d) force[d] += across * eta[d];
          if constexpr (M::width > 0) {
            Vector response[nArrays];
            for (int m = 0; m < M::width; ++m) response[m] = unit * (ownResponse[w][m] + load(t[m] + at + offset));
            M::addGradient(xi, response, turned[w]);
          }
        } else {
          if constexpr (hasAcross) {
            const Vector across = load(c.across.data() + kw);
            for (int d = 0; d < D; ++d) force[d] += across * eta[d];
          }
          if constexpr (M::width > 0) {
            const Vector gives = load(c.own.data() + kw), takes = load(c.others.data() + kw);
            Vector response[nArrays];
            for (int m = 0; m < M::width; ++m)
              response[m] = gives * ownResponse[w][m] + takes * load(t[m] + at + offset);
            M::addGradient(xi, response, turned[w]);
          }
        }
        for (int d = 0; d < D; ++d) sum[w][d] += force[d];
      }
      k += static_cast<std::size_t>(strip.count);
    }
    const Real factor = isProportional ? Real(-0.5) * ratio_ : Real(-1);
    for (int w = 0; w < width; ++w)
      for (int d = 0; d < D; ++d)
        store(M::width > 0 ? factor * turned[w][d] - sum[w][d] : -sum[w][d], y[d] + first + w * lanes,
              count - w * lanes);
  }

  /// Of a spring of a list that leads to j over xi: what it resists across by, and gives to the families of both ends.
  struct Sideways {
    Real across, own, others;
  };
  Sideways sidewaysOf(const SpringColumns<Real>& c, std::size_t k, const std::array<Real, D>& xi, bool hasOther) const {
    if constexpr (isProportional) {
      Real length2 = 0;
      for (int d = 0; d < D; ++d) length2 += xi[d] * xi[d];
      const Real across = ratio_ * c.radial[k] * length2;
      return {across, hasOther ? Real(0.5) * across : across, hasOther ? Real(0.5) * across : Real(0)};
    }
    Sideways result{};
    if constexpr (hasAcross) result.across = c.across[k];
    if constexpr (M::width > 0) {
      result.own = c.own[k];
      result.others = hasOther ? c.others[k] : Real(0);
    }
    return result;
  }

  template <bool actsOnBoth>
  void addFamiliesOfList(const SpringList& list, const PointVector<Real>& x, PointVector<Real>& s) const {
    if constexpr (M::width > 0) {
      const PointVector<Real>& places = network_.places<Real>();
      const SpringColumns<Real>& c = list.in<Real>();
      const int nOwned = network_.points().nOwned;
      for (std::size_t r = 0; r < list.rows.size(); ++r) {
        const int i = list.rows[r];
        std::array<Real, nArrays> sum{};
        for (std::size_t k = list.start[r]; k < list.start[r + 1]; ++k) {
          const int j = list.other[k];
          std::array<Real, D> xi, eta;
          for (int d = 0; d < D; ++d) {
            xi[d] = places[d][j] - places[d][i];
            eta[d] = list.alive[k] * (x[d][j] - x[d][i]);
          }
          const Sideways gives = sidewaysOf(c, k, xi, network_.hasOtherShare(j));
          std::array<Real, nArrays> bond{};
          M::add(xi.data(), eta.data(), bond.data());
          for (int m = 0; m < M::width; ++m) sum[m] += gives.own * bond[m];
          if (actsOnBoth && j < nOwned)
            for (int m = 0; m < M::width; ++m) s[m][j] += gives.others * bond[m];
        }
        for (int m = 0; m < M::width; ++m) s[m][i] += sum[m];
      }
    }
  }

  template <bool actsOnBoth>
  void addForcesOfList(const SpringList& list, const PointVector<Real>& x, const PointVector<Real>& t,
                       PointVector<Real>& y) const {
    const PointVector<Real>& places = network_.places<Real>();
    const SpringColumns<Real>& c = list.in<Real>();
    for (std::size_t r = 0; r < list.rows.size(); ++r) {
      const int i = list.rows[r];
      std::array<Real, D> sum{};
      for (std::size_t k = list.start[r]; k < list.start[r + 1]; ++k) {
        const int j = list.other[k];
        std::array<Real, D> xi, eta, force;
        Real along = 0;
        for (int d = 0; d < D; ++d) {
          xi[d] = places[d][j] - places[d][i];
          eta[d] = x[d][j] - x[d][i];
          along += xi[d] * eta[d];
        }
        along *= c.radial[k];
        for (int d = 0; d < D; ++d) force[d] = along * xi[d];
        const bool hasOther = network_.hasOtherShare(j);
        const Sideways gives = sidewaysOf(c, k, xi, hasOther);
        if constexpr (hasAcross)
          for (int d = 0; d < D; ++d) force[d] += gives.across * eta[d];
        if constexpr (M::width > 0) {
          std::array<Real, nArrays> response;
          for (int m = 0; m < M::width; ++m)
            response[m] = gives.own * t[m][i] + (hasOther ? gives.others * t[m][j] : Real(0));
          M::addGradient(xi.data(), response.data(), force.data());
        }
        for (int d = 0; d < D; ++d) {
          force[d] *= list.alive[k];
          sum[d] += force[d];
          if (actsOnBoth) y[d][j] += force[d];
        }
      }
      for (int d = 0; d < D; ++d) y[d][i] -= sum[d];
    }
  }

  const SpringNetwork& network_;
  const Real ratio_;  ///< SpringShape::acrossPerRadial
};

/// work(loops of this network).
template <class Real, int D, class Work>
void inDimension(const SpringNetwork& network, const Work& work) {
  const bool isProportional = network.acrossPerRadial() != 0.0;
  if (network.family() == Family::Rotation && D > 1 && isProportional)
    work(Loops<Real, D, Family::Rotation, true, true>(network));
  else if (network.family() == Family::Rotation && D > 1)
    work(Loops<Real, D, Family::Rotation, true, false>(network));
  else if (network.family() == Family::Dilatation)
    work(Loops<Real, D, Family::Dilatation, false, false>(network));
  else if (network.hasAcross())
    work(Loops<Real, D, Family::None, true, false>(network));
  else
    work(Loops<Real, D, Family::None, false, false>(network));
}

template <class Real, class Work>
void withLoops(const SpringNetwork& network, const Work& work) {
  if (network.dimension() == 1) return inDimension<Real, 1>(network, work);
  if (network.dimension() == 2) return inDimension<Real, 2>(network, work);
  inDimension<Real, 3>(network, work);
}

}  // namespace

template <class Real>
void addSpringFamilies(const SpringNetwork& network, const PointVector<Real>& x, PointVector<Real>& families) {
  withLoops<Real>(network, [&](const auto& loops) { loops.addFamilies(x, families); });
}

template <class Real>
void springForces(const SpringNetwork& network, const PointVector<Real>& x, const PointVector<Real>& responses,
                  PointVector<Real>& y) {
  withLoops<Real>(network, [&](const auto& loops) { loops.forces(x, responses, y); });
}

template <class Real>
void stiffSpringForces(const SpringNetwork& network, const PointVector<Real>& x, PointVector<Real>& y) {
  const PointVector<Real> none;
  const auto inDimension = [&](auto dimension) {
    constexpr int D = decltype(dimension)::value;
    if (network.acrossPerRadial() != 0.0) return Loops<Real, D, Family::None, true, true>(network).forces(x, none, y);
    Loops<Real, D, Family::None, true, false>(network).forces(x, none, y);
  };
  if (network.dimension() == 2) return inDimension(std::integral_constant<int, 2>());
  inDimension(std::integral_constant<int, 3>());
}

template void stiffSpringForces(const SpringNetwork&, const PointVector<float>&, PointVector<float>&);
template void addSpringFamilies(const SpringNetwork&, const PointVector<double>&, PointVector<double>&);
template void addSpringFamilies(const SpringNetwork&, const PointVector<float>&, PointVector<float>&);
template void springForces(const SpringNetwork&, const PointVector<double>&, const PointVector<double>&,
                           PointVector<double>&);
template void springForces(const SpringNetwork&, const PointVector<float>&, const PointVector<float>&,
                           PointVector<float>&);

}  // namespace pd
