// The bonds of a chunk for loops that run several times over them: displacements, and constants that are broadcast on a
// uniform lattice or computed from gathered points elsewhere.
#ifndef PD_CHUNK_BONDS_HPP
#define PD_CHUNK_BONDS_HPP

#include <algorithm>
#include <memory>
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

/// Where forces at the neighbours of a chunk's points go.
struct NeighborForce {
  double* ofChunk[3];  ///< contiguous: component by component, from the chunk's first point on
  double* scattered;   ///< else: [4 n], all components of a point together
};

/// Bonds of a chunk of a uniform lattice: constants broadcast, neighbours contiguous.
template <int D, int width, class ConstantsOf>
struct UniformChunk {
  static constexpr bool isContiguous = true;
  const Chunk& chunk;
  const int* indices;
  const double* coefficients;
  ConstantsOf constantsOf;
  NeighborForce force;
  const double* displacement[3];  ///< of the chunk's first point
  Vector own[D], volume;

  template <class Bond>
  PD_EACH_BOND Vector eta(int k, const Bond&, int d) const {
    return load(displacement[d] + indices[k]) - own[d];
  }
  PD_EACH_BOND auto operator()(int k) const { return constantsOf(coefficients + k * width); }
};

/// What bonds of chunks whose neighbours lie anywhere need of their points, a cache line each, and the forces that they
/// add at them. Memory of other points is not touched.
class ScatteredPoints {
 public:
  ScatteredPoints(const ChunkedNeighborhood& neighborhood, const BondPoints& points, int dimension)
      : ids_(neighborhood.scatteredPoints()), dimension_(dimension) {
    const std::size_t n = ids_.empty() ? 0 : static_cast<std::size_t>(ids_.back()) + 1;
    values_.reset(new double[8 * n]);
    forces_.reset(new double[4 * n]);
    for (const int i : ids_) {
      double* line = &values_[8 * static_cast<std::size_t>(i)];
      for (int d = 0; d < dimension; ++d) {
        line[d] = points.reference[d][i];
        line[4 + d] = points.displacement[d][i];
      }
      line[3] = points.volume[i];
      std::fill_n(&forces_[4 * static_cast<std::size_t>(i)], 4, 0.0);
    }
  }
  const double* values() const { return values_.get(); }  ///< [8 n]: reference place, volume, displacement
  double* forces() { return forces_.get(); }              ///< [4 n]
  void addForcesTo(PointArrays& force) const {
    for (const int i : ids_)
      for (int d = 0; d < dimension_; ++d) force[d][i] += forces_[4 * static_cast<std::size_t>(i) + std::size_t(d)];
  }

 private:
  const std::vector<int>& ids_;
  int dimension_;
  std::unique_ptr<double[]> values_, forces_;
};

/// Makes the bonds of a chunk that is not uniform.
template <int D, bool contiguous>
struct BondMaker {
  const Chunk& chunk;
  const int* indices;
  const BondPoints& points;
  const double* packed;
  const double* strength;
  bool hasUniformStrength;
  Vector own[D], ownReference[D];

  PD_EACH_BOND Vector atNeighbors(const double* values, int k) const {
    return load(values + chunk.firstPoint + indices[k]);
  }
  PD_EACH_BOND GatheredBond<D> operator()(int k) const {
    GatheredBond<D> bond;
    Vector place[4], moved[4];
    if constexpr (contiguous) {
      unrolled<D>([&](auto d) PD_INLINED {
        place[d] = atNeighbors(points.reference[d], k);
        moved[d] = atNeighbors(points.displacement[d], k);
      });
      place[3] = atNeighbors(points.volume, k);
    } else {
      gatherFour<8>(packed, indices + k * lanes, place);
      gatherFour<8>(packed + 4, indices + k * lanes, moved);
    }
    Vector length2 = 0.0;
    unrolled<D>([&](auto d) PD_INLINED {
      bond.xi[d] = place[d] - ownReference[d];
      bond.eta[d] = moved[d] - own[d];
      length2 += bond.xi[d] * bond.xi[d];
    });
    bond.inverseLength = inverseSquareRoot(length2);
    bond.length = length2 * bond.inverseLength;
    bond.volume = place[3];
    bond.perLength = (hasUniformStrength ? Vector(strength[k]) : load(strength + k * lanes)) * bond.inverseLength;
    return bond;
  }
};

/// Bonds that are made as they are asked for.
template <int D, bool contiguous, class ConstantsOf>
struct FreshChunk {
  static constexpr bool isContiguous = contiguous;
  const Chunk& chunk;
  const int* indices;
  const BondMaker<D, contiguous>& bonds;
  ConstantsOf constantsOf;
  NeighborForce force;
  Vector volume;

  template <class Bond>
  PD_EACH_BOND Vector eta(int, const Bond& bond, int d) const {
    return bond.eta(d);
  }
  PD_EACH_BOND auto operator()(int k) const { return constantsOf(bonds(k)); }
};

/// Bonds that are kept, for forces that pass several times over them.
template <int D, bool contiguous, class ConstantsOf>
struct KeptChunk {
  static constexpr bool isContiguous = contiguous;
  const Chunk& chunk;
  const int* indices;
  const GatheredBond<D>* bonds;
  ConstantsOf constantsOf;
  NeighborForce force;
  Vector volume;

  template <class Bond>
  PD_EACH_BOND Vector eta(int, const Bond& bond, int d) const {
    return bond.eta(d);
  }
  PD_EACH_BOND auto operator()(int k) const { return constantsOf(bonds[k]); }
};

template <bool isWhole>
PD_EACH_BOND Vector keepUnbroken(const Vector& value, unsigned char bits) {
  return isWhole ? value : keep(value, bits);
}

/// Adds `value` of each lane's unbroken bond k at its neighbour.
template <int D, bool isWhole, class BondsOf>
PD_EACH_BOND void addToNeighbors(const BondsOf& bondsOf, int k, unsigned char bits, const Vector* value) {
  if constexpr (BondsOf::isContiguous) {
    const int offset = bondsOf.indices[k];
    unrolled<D>([&](auto d) PD_INLINED {
      double* at = bondsOf.force.ofChunk[d] + offset;
      store(load(at) + keepUnbroken<isWhole>(value[d], bits), at);
    });
  } else {
    Vector all[4];
    unrolled<4>([&](auto c) PD_INLINED { all[c] = 0.0; });
    unrolled<D>([&](auto d) PD_INLINED { all[d] = keepUnbroken<isWhole>(value[d], bits); });
    scatterAddFour<4>(all, bondsOf.indices + k * lanes, bondsOf.force.scattered);
  }
}

inline bool areAllWhole(const Chunk& chunk, const unsigned char* bits) {
  unsigned char common = allLanes;
  for (int k = 0; k < chunk.nNeighbors; ++k) common = static_cast<unsigned char>(common & bits[k]);
  return common == allLanes;
}

/// Calls visit(isWhole, chunk, bonds) for every chunk, with a std::true_type where no lane has a broken or missing
/// bond. `strength`: g of bonds; `coefficients`: `width` constants of bonds of uniform chunks, begun with xi.
/// `passesOnce`: the visitor asks for each bond once. What addToNeighbors() adds ends up in `force`. `ofUniform` and
/// `ofLanes` turn a pointer to these, or a GatheredBond, into the constants that bonds(k) gives.
template <int D, int width, bool passesOnce, class OfUniform, class OfLanes, class Visit>
void forEachChunkOfBonds(const ChunkedNeighborhood& neighborhood, const BondConstants& strength,
                         const BondConstants& coefficients, const AliveBonds& alive, const BondPoints& points,
                         PointArrays& force, const OfUniform& ofUniform, const OfLanes& ofLanes, const Visit& visit) {
  std::vector<GatheredBond<D>> gathered;
  const auto& chunks = neighborhood.chunks();
  ScatteredPoints scattered(neighborhood, points, D);
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    const Chunk& chunk = chunks[c];
    const int* ownIds = neighborhood.pointIds(chunk);
    NeighborForce atNeighbors{{}, scattered.forces()};
    for (int d = 0; d < D; ++d) atNeighbors.ofChunk[d] = force[d] + chunk.firstPoint;
    const auto call = [&](const auto& bonds) {
      if (areAllWhole(chunk, alive.of(chunk)))
        visit(std::true_type(), chunk, bonds);
      else
        visit(std::false_type(), chunk, bonds);
    };
    const auto callMade = [&](auto contiguous, const int* indices) {
      constexpr bool isContiguousChunk = decltype(contiguous)::value;
      BondMaker<D, isContiguousChunk> bonds{
          chunk, indices, points, scattered.values(), strength.of(c), strength.isUniform(c), {}, {}};
      for (int d = 0; d < D; ++d) {
        bonds.own[d] = gather(points.displacement[d], ownIds);
        bonds.ownReference[d] = gather(points.reference[d], ownIds);
      }
      const Vector volume = gather(points.volume, ownIds);
      if constexpr (passesOnce) {
        call(FreshChunk<D, isContiguousChunk, OfLanes>{chunk, indices, bonds, ofLanes, atNeighbors, volume});
      } else {
        gathered.resize(static_cast<std::size_t>(chunk.nNeighbors));
        for (int k = 0; k < chunk.nNeighbors; ++k) gathered[static_cast<std::size_t>(k)] = bonds(k);
        call(KeptChunk<D, isContiguousChunk, OfLanes>{chunk, indices, gathered.data(), ofLanes, atNeighbors, volume});
      }
    };
    if (coefficients.isUniform(c)) {
      UniformChunk<D, width, OfUniform> bonds{
          chunk, neighborhood.offsets(chunk), coefficients.of(c), ofUniform, atNeighbors, {}, {}, {}};
      // A contiguous load, so that unused lanes read the points that follow.
      for (int d = 0; d < D; ++d) {
        bonds.displacement[d] = points.displacement[d] + chunk.firstPoint;
        bonds.own[d] = load(bonds.displacement[d]);
      }
      bonds.volume = load(points.volume + chunk.firstPoint);
      call(bonds);
    } else if (chunk.isContiguous) {
      callMade(std::true_type(), neighborhood.offsets(chunk));
    } else {
      callMade(std::false_type(), neighborhood.neighborIds(chunk));
    }
  }
  scattered.addForcesTo(force);
}

}  // namespace pd::kernels

#endif
