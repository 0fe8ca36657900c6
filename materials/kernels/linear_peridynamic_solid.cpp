#include "linear_peridynamic_solid.hpp"

#include <algorithm>
#include <cmath>

namespace pd::kernels {

namespace {

/// Constants of a bond of a uniform chunk: xi, w, V_j, |xi|.
struct UniformSolidBond {
  static constexpr int width = 6;
  const double* c;
  PD_EACH_BOND double xi(int d) const { return c[d]; }
  PD_EACH_BOND double influence() const { return c[3]; }
  PD_EACH_BOND double volume() const { return c[4]; }
  PD_EACH_BOND double length() const { return c[5]; }
};
struct OfUniform {
  PD_EACH_BOND UniformSolidBond operator()(const double* c) const { return {c}; }
};

/// The same of one bond a lane.
template <class Bond>
struct SolidBondOfLanes {
  Bond bond;  ///< GatheredBond<3>, or a reference to one that is kept
  PD_EACH_BOND Vector xi(int d) const { return bond.xi[d]; }
  PD_EACH_BOND Vector eta(int d) const { return bond.eta[d]; }
  PD_EACH_BOND Vector influence() const { return bond.perLength * bond.length; }
  PD_EACH_BOND Vector volume() const { return bond.volume; }
  PD_EACH_BOND Vector length() const { return bond.length; }
};
struct OfLanes {
  PD_EACH_BOND SolidBondOfLanes<const GatheredBond<3>&> operator()(const GatheredBond<3>& bond) const { return {bond}; }
  PD_EACH_BOND SolidBondOfLanes<GatheredBond<3>> operator()(GatheredBond<3>&& bond) const { return {bond}; }
};

struct CurrentBond {
  Vector y[3], inverseLength, elongation;  ///< Y, 1/|Y|, e
};

template <class BondsOf, class Bond>
PD_EACH_BOND CurrentBond currentBond(const BondsOf& bondsOf, const Bond& bond, int k) {
  CurrentBond current;
  Vector length2 = 0.0;
  unrolled<3>([&](auto d) PD_INLINED {
    current.y[d] = bondsOf.eta(k, bond, d) + bond.xi(d);
    length2 += current.y[d] * current.y[d];
  });
  current.inverseLength = inverseSquareRoot(length2);
  current.elongation = length2 * current.inverseLength - bond.length();
  return current;
}

/// theta of every lane in `dimension` dimensions; 0 where m is (no bonds).
template <bool isWhole, class BondsOf>
PD_EACH_BOND Vector dilatationOf(const Chunk& chunk, const unsigned char* bits, const BondsOf& bondsOf,
                                 const Vector& weightedVolume, double dimension) {
  Vector sum = 0.0;
  const int nNeighbors = chunk.nNeighbors;
  for (int k = 0; k < nNeighbors; ++k) {
    const auto bond = bondsOf(k);
    const Vector weight = Vector(bond.influence() * bond.length() * bond.volume());
    sum += keepUnbroken<isWhole>(weight * currentBond(bondsOf, bond, k).elongation, bits[k]);
  }
  return wherePositive(weightedVolume, dimension * sum / weightedVolume, 0.0);
}

template <bool isWhole, class BondsOf>
void addForceOfChunk(const ChunkedNeighborhood& neighborhood, const Chunk& chunk, const SolidBondData& data,
                     const unsigned char* bits, const BondsOf& bondsOf, const double* weightedVolume,
                     double* dilatation, PointArrays& force) {
  const int* ids = neighborhood.pointIds(chunk);
  const Vector m = gather(weightedVolume, ids);
  const Vector theta = dilatationOf<isWhole>(chunk, bits, bondsOf, m, data.constants.dimension);
  const Vector perM = wherePositive(m, 1.0 / m, 0.0);
  const Vector volumetric = data.constants.volumetric * theta * perM;
  const Vector deviatoric = data.constants.deviatoric * perM;

  Vector sum[3];
  unrolled<3>([&](auto d) PD_INLINED { sum[d] = 0.0; });
  const int nNeighbors = chunk.nNeighbors;
  const Vector volume = bondsOf.volume;
  // In this order for the sake of the stores (two_parameter_bond.cpp).
  for (int first = 0; first < lanes; ++first)
    for (int k = first; k < nNeighbors; k += lanes) {
      const auto bond = bondsOf(k);
      const CurrentBond current = currentBond(bondsOf, bond, k);
      const Vector perY = keepUnbroken<isWhole>(
          bond.influence() * current.inverseLength * (volumetric * bond.length() + deviatoric * current.elongation),
          bits[k]);
      const Vector own = perY * bond.volume(), opposite = -perY * volume;
      Vector value[3];
      unrolled<3>([&](auto d) PD_INLINED {
        sum[d] += own * current.y[d];
        value[d] = opposite * current.y[d];
      });
      addToNeighbors<3, isWhole>(bondsOf, k, bits[k], value);
    }
  for (int d = 0; d < 3; ++d) addToPoints(neighborhood, chunk, sum[d], force[d]);
  for (int lane = 0; lane < chunk.nLanes; ++lane) dilatation[ids[lane]] = theta[static_cast<std::size_t>(lane)];
}

}  // namespace

SolidConstants solidConstants(Geometry geometry, double bulkModulus, double shearModulus) {
  const double K = bulkModulus, G = shearModulus;
  if (geometry == Geometry::Solid) return {3.0, K, 3.0 * K - 5.0 * G, 15.0 * G};
  const double bulk = geometry == Geometry::PlaneStrain ? K + G / 3.0 : 9.0 * K * G / (3.0 * K + 4.0 * G);
  return {2.0, bulk, 2.0 * bulk - 4.0 * G, 8.0 * G};
}

BondConstants solidCoefficients(const ChunkedNeighborhood& neighborhood,
                                const std::function<void(int, int, std::size_t, double*)>& geometry) {
  // From the rounded xi: else an undeformed bond would be strained by as much as the tolerance.
  const DerivedConstants length{UniformSolidBond::width,
                                [](double* c) { c[5] = std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]); }};
  return BondConstants(neighborhood, 5, geometry, BondConstants::Keep::OnlyUniform, 1e-12, length);
}

void addSolidForce(const ChunkedNeighborhood& neighborhood, const SolidBondData& data, const AliveBonds& alive,
                   const BondPoints& points, const double* weightedVolume, double* dilatation, PointArrays& force) {
  forEachChunkOfBonds<3, UniformSolidBond::width, false>(
      neighborhood, data.influence, data.coefficients, alive, points, force, OfUniform(), OfLanes(),
      [&](auto isWhole, const Chunk& chunk, const auto& bondsOf) {
        addForceOfChunk<decltype(isWhole)::value>(neighborhood, chunk, data, alive.of(chunk), bondsOf, weightedVolume,
                                                  dilatation, force);
      });
}

}  // namespace pd::kernels
