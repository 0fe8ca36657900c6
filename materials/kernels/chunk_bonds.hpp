// The bonds of a chunk for loops that run several times over them: displacements, and constants that are broadcast on a
// uniform lattice or computed from gathered points elsewhere.
#ifndef PD_CHUNK_BONDS_HPP
#define PD_CHUNK_BONDS_HPP

#include <type_traits>
#include <vector>

#include "alive_bonds.hpp"
#include "chunked_neighborhood.hpp"
#include "point_arrays.hpp"

namespace pd::kernels {

/// What bonds are made of, by local id.
struct BondPoints {
  const PointArrays& reference;
  const PointArrays& displacement;
  const double* volume;
};

/// One bond a lane, gathered from the points. g: the caller's strength of the bond.
template <int D>
struct GatheredBond {
  Vector xi[D], eta[D], perLength, length, inverseLength, volume;  ///< perLength = g/|xi|; volume V_j
};

/// Bonds of a chunk of a uniform lattice: constants broadcast, neighbours contiguous.
template <int D, int width, class ConstantsOf>
struct UniformChunk {
  static constexpr bool isContiguous = true;
  const Chunk& chunk;
  const int* indices;
  const double* coefficients;
  ConstantsOf constantsOf;
  const double* displacement[3];  ///< of the chunk's first point
  Vector own[D], volume;

  PD_EACH_BOND Vector eta(int k, int d) const { return load(displacement[d] + indices[k]) - own[d]; }
  PD_EACH_BOND auto operator()(int k) const { return constantsOf(coefficients + k * width); }
  double* valuesAtNeighbors(double* values) const { return values + chunk.firstPoint; }
};

/// Any other chunk.
template <int D, bool contiguous, class ConstantsOf>
struct GatheredChunk {
  static constexpr bool isContiguous = contiguous;
  const Chunk& chunk;
  const int* indices;
  const GatheredBond<D>* bonds;
  ConstantsOf constantsOf;
  Vector volume;

  PD_EACH_BOND const Vector& eta(int k, int d) const { return bonds[k].eta[d]; }
  PD_EACH_BOND auto operator()(int k) const { return constantsOf(bonds[k]); }
  double* valuesAtNeighbors(double* values) const { return values + (contiguous ? chunk.firstPoint : 0); }
};

/// All bonds of a chunk, so that points are gathered once although forces pass several times over the bonds.
template <int D, bool isContiguous>
void gatherBonds(const Chunk& chunk, const int* indices, const int* ownIds, const double* strength,
                 bool hasUniformStrength, const BondPoints& points, std::vector<GatheredBond<D>>& bonds) {
  bonds.resize(static_cast<std::size_t>(chunk.nNeighbors));
  Vector own[D], ownReference[D];
  for (int d = 0; d < D; ++d) {
    own[d] = gather(points.displacement[d], ownIds);
    ownReference[d] = gather(points.reference[d], ownIds);
  }
  const auto neighbors = [&](const double* values, int k) {
    return isContiguous ? load(values + chunk.firstPoint + indices[k]) : gather(values, indices + k * lanes);
  };
  for (int k = 0; k < chunk.nNeighbors; ++k) {
    GatheredBond<D>& bond = bonds[static_cast<std::size_t>(k)];
    Vector length2 = 0.0;
    unrolled<D>([&](auto d) {
      bond.xi[d] = neighbors(points.reference[d], k) - ownReference[d];
      bond.eta[d] = neighbors(points.displacement[d], k) - own[d];
      length2 += bond.xi[d] * bond.xi[d];
    });
    bond.inverseLength = inverseSquareRoot(length2);
    bond.length = length2 * bond.inverseLength;
    bond.volume = neighbors(points.volume, k);
    bond.perLength = (hasUniformStrength ? Vector(strength[k]) : load(strength + k * lanes)) * bond.inverseLength;
  }
}

template <bool isWhole>
PD_EACH_BOND Vector keepUnbroken(const Vector& value, unsigned char bits) {
  return isWhole ? value : keep(value, bits);
}

/// Adds `value` of each lane's unbroken bond k at its neighbour; `at` from valuesAtNeighbors().
template <int D, bool isWhole, class BondsOf>
PD_EACH_BOND void addToNeighbors(const BondsOf& bondsOf, int k, unsigned char bits, const Vector* value,
                                 double* const* at) {
  if constexpr (BondsOf::isContiguous) {
    const int offset = bondsOf.indices[k];
    unrolled<D>([&](auto d) PD_INLINED {
      store(load(at[d] + offset) + keepUnbroken<isWhole>(value[d], bits), at[d] + offset);
    });
  } else {
    const int* ids = bondsOf.indices + k * lanes;
    unrolled<D>([&](auto d) PD_INLINED {
      alignas(64) double values[lanes];
      store(value[d], values);
      for (int lane = 0; lane < lanes; ++lane)
        if (isWhole || ((bits >> lane) & 1)) at[d][ids[lane]] += values[lane];
    });
  }
}

inline bool areAllWhole(const Chunk& chunk, const unsigned char* bits) {
  unsigned char common = allLanes;
  for (int k = 0; k < chunk.nNeighbors; ++k) common = static_cast<unsigned char>(common & bits[k]);
  return common == allLanes;
}

/// Calls visit(isWhole, chunk, bonds) for every chunk, with a std::true_type where no lane has a broken or missing
/// bond. `strength`: g of bonds; `coefficients`: `width` constants of bonds of uniform chunks, begun with xi.
/// `ofUniform` and `ofLanes` turn a pointer to these, or a GatheredBond, into the constants that bonds(k) gives.
template <int D, int width, class OfUniform, class OfLanes, class Visit>
void forEachChunkOfBonds(const ChunkedNeighborhood& neighborhood, const BondConstants& strength,
                         const BondConstants& coefficients, const AliveBonds& alive, const BondPoints& points,
                         const OfUniform& ofUniform, const OfLanes& ofLanes, const Visit& visit) {
  std::vector<GatheredBond<D>> gathered;
  const auto& chunks = neighborhood.chunks();
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    const Chunk& chunk = chunks[c];
    const int* ownIds = neighborhood.pointIds(chunk);
    const auto call = [&](const auto& bonds) {
      if (areAllWhole(chunk, alive.of(chunk)))
        visit(std::true_type(), chunk, bonds);
      else
        visit(std::false_type(), chunk, bonds);
    };
    const auto callGathered = [&](auto isContiguous, const int* indices) {
      constexpr bool contiguous = decltype(isContiguous)::value;
      gatherBonds<D, contiguous>(chunk, indices, ownIds, strength.of(c), strength.isUniform(c), points, gathered);
      call(GatheredChunk<D, contiguous, OfLanes>{chunk, indices, gathered.data(), ofLanes,
                                                 gather(points.volume, ownIds)});
    };
    if (coefficients.isUniform(c)) {
      UniformChunk<D, width, OfUniform> bonds{chunk, neighborhood.offsets(chunk), coefficients.of(c), ofUniform, {}, {},
                                              {}};
      // A contiguous load, so that unused lanes read the points that follow.
      for (int d = 0; d < D; ++d) {
        bonds.displacement[d] = points.displacement[d] + chunk.firstPoint;
        bonds.own[d] = load(bonds.displacement[d]);
      }
      bonds.volume = load(points.volume + chunk.firstPoint);
      call(bonds);
    } else if (chunk.isContiguous) {
      callGathered(std::true_type(), neighborhood.offsets(chunk));
    } else {
      callGathered(std::false_type(), neighborhood.neighborIds(chunk));
    }
  }
}

}  // namespace pd::kernels

#endif
