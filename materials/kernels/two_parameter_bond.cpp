#include "two_parameter_bond.hpp"

#include "rotation.hpp"

namespace pd::kernels {

namespace {

/// Arrays that all chunks read and write.
struct Fields {
  const PointArrays& reference;
  const PointArrays& displacement;
  const double* volume;
  PointArrays& force;
};

/// One bond a lane.
template <int D>
struct Bonds {
  Vector xi[D], eta[D], inverseLength, strength, volume;
};

/// Bonds of a chunk of a uniform lattice: constants broadcast, neighbours contiguous.
template <int D>
struct UniformChunk {
  static constexpr bool isContiguous = true;
  const Chunk& chunk;
  const int* indices;
  const double *strength, *geometry;
  const Fields& fields;
  Vector own[D], volume;

  Bonds<D> operator()(int k) const {
    Bonds<D> bonds;
    const double* constants = geometry + k * (D + 2);
    const int at = chunk.firstPoint + indices[k];
    for (int d = 0; d < D; ++d) {
      bonds.xi[d] = constants[d];
      bonds.eta[d] = load(fields.displacement[d] + at) - own[d];
    }
    bonds.inverseLength = constants[D];
    bonds.volume = constants[D + 1];
    bonds.strength = strength[k];
    return bonds;
  }
};

/// Any other chunk: geometry from the reference coordinates.
template <int D, bool contiguous>
struct GeneralChunk {
  static constexpr bool isContiguous = contiguous;
  const Chunk& chunk;
  const int* indices;
  const double* strength;
  bool hasUniformStrength;
  const Fields& fields;
  Vector own[D], volume, ownReference[D];

  Vector neighbors(const double* values, int k) const {
    return contiguous ? load(values + chunk.firstPoint + indices[k]) : gather(values, indices + k * lanes);
  }
  Bonds<D> operator()(int k) const {
    Bonds<D> bonds;
    Vector length2 = 0.0;
    for (int d = 0; d < D; ++d) {
      bonds.xi[d] = neighbors(fields.reference[d], k) - ownReference[d];
      bonds.eta[d] = neighbors(fields.displacement[d], k) - own[d];
      length2 += bonds.xi[d] * bonds.xi[d];
    }
    bonds.inverseLength = inverseSquareRoot(length2);
    bonds.volume = neighbors(fields.volume, k);
    bonds.strength = hasUniformStrength ? Vector(strength[k]) : load(strength + k * lanes);
    return bonds;
  }
};

/// Rotation of every lane's neighbourhood, applied to bonds.
template <int D>
struct Rotation;

template <>
struct Rotation<1> {
  Vector apply(const Vector* xi, int) const { return xi[0]; }
};
template <>
struct Rotation<2> {
  PlaneRotation<Vector> r;
  Vector apply(const Vector* xi, int d) const {
    return d == 0 ? r.cosine * xi[0] - r.sine * xi[1] : r.sine * xi[0] + r.cosine * xi[1];
  }
};
template <>
struct Rotation<3> {
  Matrix3<Vector> r;
  Vector apply(const Vector* xi, int d) const {
    const std::size_t row = 3 * static_cast<std::size_t>(d);
    return r[row] * xi[0] + r[row + 1] * xi[1] + r[row + 2] * xi[2];
  }
};

template <int D, class BondsOf>
Rotation<D> rotationOf(const Chunk& chunk, const unsigned char* bits, const BondsOf& bondsOf) {
  if constexpr (D == 1) {
    return {};
  } else if constexpr (D == 2) {
    Vector dot = 0.0, cross = 0.0;
    for (int k = 0; k < chunk.nNeighbors; ++k) {
      if (bits[k] == 0) continue;
      const Bonds<D> b = bondsOf(k);
      const Vector weight = b.strength * b.inverseLength * b.volume;
      const Vector y0 = b.xi[0] + b.eta[0], y1 = b.xi[1] + b.eta[1];
      dot += keep(weight * (y0 * b.xi[0] + y1 * b.xi[1]), bits[k]);
      cross += keep(weight * (b.xi[0] * y1 - b.xi[1] * y0), bits[k]);
    }
    return {planeRotation(dot, cross)};
  } else {
    Matrix3<Vector> sum;
    sum.fill(Vector(0.0));
    for (int k = 0; k < chunk.nNeighbors; ++k) {
      if (bits[k] == 0) continue;
      const Bonds<D> b = bondsOf(k);
      const Vector weight = keep(b.strength * b.inverseLength * b.volume, bits[k]);
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector y = weight * (b.xi[i] + b.eta[i]);
        for (std::size_t j = 0; j < 3; ++j) sum[3 * i + j] += y * b.xi[j];
      }
    }
    // Lanes without a bond: any multiple of the identity.
    const auto isEmpty = !(sum[0] * sum[0] + sum[4] * sum[4] + sum[8] * sum[8] > Vector(0.0));
    for (const std::size_t i : {0, 4, 8}) stdx::where(isEmpty, sum[i]) = Vector(1.0);
    return {solidRotation(sum)};
  }
}

template <class BondsOf>
void subtractAtNeighbors(const Chunk& chunk, const BondsOf& bondsOf, int k, unsigned char bits, const Vector& value,
                         double* force) {
  if constexpr (BondsOf::isContiguous) {
    double* at = force + chunk.firstPoint + bondsOf.indices[k];
    store(load(at) - value, at);
  } else {
    const int* ids = bondsOf.indices + k * lanes;
    for (int lane = 0; lane < lanes; ++lane)
      if ((bits >> lane) & 1) force[ids[lane]] -= value[static_cast<std::size_t>(lane)];
  }
}

enum class Form { BondBased, Linear, Objective };

template <int D, Form form, class BondsOf>
void forceOfChunk(const ChunkedNeighborhood& neighborhood, const Chunk& chunk, const BondForceData& data,
                  const unsigned char* bits, const BondsOf& bondsOf, Fields& fields) {
  const double half = form == Form::Objective ? 0.5 : 1.0;
  const double radial = half * (data.constants.normal - data.constants.tangential);
  const double tangential = half * data.constants.tangential;
  Rotation<D> rotation;
  if constexpr (form == Form::Objective) rotation = rotationOf<D>(chunk, bits, bondsOf);

  Vector sum[D];
  for (int d = 0; d < D; ++d) sum[d] = 0.0;
  for (int k = 0; k < chunk.nNeighbors; ++k) {
    if (bits[k] == 0) continue;
    const Bonds<D> b = bondsOf(k);
    Vector t[D];
    if constexpr (form == Form::Linear) {
      Vector along = 0.0;
      for (int d = 0; d < D; ++d) along += b.eta[d] * b.xi[d];
      const Vector perLength = b.strength * b.inverseLength;
      const Vector normal = radial * perLength * along * b.inverseLength * b.inverseLength;
      for (int d = 0; d < D; ++d) t[d] = normal * b.xi[d] + tangential * perLength * b.eta[d];
    } else {
      Vector y[D], length2 = 0.0;
      for (int d = 0; d < D; ++d) {
        y[d] = b.xi[d] + b.eta[d];
        length2 += y[d] * y[d];
      }
      const Vector alongY = radial * b.strength * (b.inverseLength - inverseSquareRoot(length2));
      if constexpr (form == Form::BondBased) {
        for (int d = 0; d < D; ++d) t[d] = alongY * y[d];
      } else {
        const Vector across = tangential * b.strength * b.inverseLength;
        for (int d = 0; d < D; ++d) t[d] = alongY * y[d] + across * (y[d] - rotation.apply(b.xi, d));
      }
    }
    for (int d = 0; d < D; ++d) {
      sum[d] += keep(t[d] * b.volume, bits[k]);
      if constexpr (form == Form::Objective)
        subtractAtNeighbors(chunk, bondsOf, k, bits[k], keep(t[d] * bondsOf.volume, bits[k]), fields.force[d]);
    }
  }
  const int* points = neighborhood.pointIds(chunk);
  for (int d = 0; d < D; ++d)
    for (int lane = 0; lane < chunk.nLanes; ++lane)
      fields.force[d][points[lane]] += sum[d][static_cast<std::size_t>(lane)];
}

template <int D, Form form>
void addForce(const ChunkedNeighborhood& neighborhood, const BondForceData& data, const AliveBonds& alive,
              Fields fields) {
  const auto& chunks = neighborhood.chunks();
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    const Chunk& chunk = chunks[c];
    const unsigned char* bits = alive.of(chunk);
    const int* points = neighborhood.pointIds(chunk);
    const auto fillOwn = [&](auto& bondsOf) {
      for (int d = 0; d < D; ++d) bondsOf.own[d] = gather(fields.displacement[d], points);
      bondsOf.volume = gather(fields.volume, points);
    };
    const auto fillGeneral = [&](auto& bondsOf) {
      fillOwn(bondsOf);
      for (int d = 0; d < D; ++d) bondsOf.ownReference[d] = gather(fields.reference[d], points);
    };
    const double* strength = data.strength.of(c);
    const bool hasUniformStrength = data.strength.isUniform(c);
    if (hasUniformStrength && data.geometry.isUniform(c)) {
      UniformChunk<D> bondsOf{chunk, neighborhood.offsets(chunk), strength, data.geometry.of(c), fields, {}, {}};
      // A contiguous load, so that unused lanes read the points that follow.
      for (int d = 0; d < D; ++d) bondsOf.own[d] = load(fields.displacement[d] + chunk.firstPoint);
      bondsOf.volume = load(fields.volume + chunk.firstPoint);
      forceOfChunk<D, form>(neighborhood, chunk, data, bits, bondsOf, fields);
    } else if (chunk.isContiguous) {
      GeneralChunk<D, true> bondsOf{chunk, neighborhood.offsets(chunk), strength, hasUniformStrength, fields, {}, {},
                                    {}};
      fillGeneral(bondsOf);
      forceOfChunk<D, form>(neighborhood, chunk, data, bits, bondsOf, fields);
    } else {
      GeneralChunk<D, false> bondsOf{
          chunk, neighborhood.neighborIds(chunk), strength, hasUniformStrength, fields, {}, {}, {}};
      fillGeneral(bondsOf);
      forceOfChunk<D, form>(neighborhood, chunk, data, bits, bondsOf, fields);
    }
  }
}

template <int D>
void addForceOfDimension(const ChunkedNeighborhood& neighborhood, const BondForceData& data, const AliveBonds& alive,
                         const Fields& fields) {
  if (data.form == TangentialForm::Linear)
    addForce<D, Form::Linear>(neighborhood, data, alive, fields);
  else if (data.constants.tangential == 0.0)
    addForce<D, Form::BondBased>(neighborhood, data, alive, fields);
  else
    addForce<D, Form::Objective>(neighborhood, data, alive, fields);
}

}  // namespace

void addTwoParameterForce(const ChunkedNeighborhood& neighborhood, const BondForceData& data, const AliveBonds& alive,
                          const PointArrays& reference, const PointArrays& displacement, const double* volume,
                          PointArrays& force) {
  const Fields fields{reference, displacement, volume, force};
  if (data.dimension == 1)
    addForceOfDimension<1>(neighborhood, data, alive, fields);
  else if (data.dimension == 2)
    addForceOfDimension<2>(neighborhood, data, alive, fields);
  else
    addForceOfDimension<3>(neighborhood, data, alive, fields);
}

}  // namespace pd::kernels
