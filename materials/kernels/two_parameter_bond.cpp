#include "two_parameter_bond.hpp"

#include <algorithm>
#include <cmath>

#include "chunk_bonds.hpp"
#include "rotation.hpp"

namespace pd::kernels {

namespace {

enum class Form { BondBased, Linear, Objective };

Form formOf(const BondForceData& data) {
  if (data.form == TangentialForm::Linear) return Form::Linear;
  return data.constants.tangential == 0.0 ? Form::BondBased : Form::Objective;
}

// The force density that a bond gives to its point is
//   linear     a eta + b (eta.xi) xi                   a = k_t g V_j/|xi|,  b = (k_n - k_t) g V_j/|xi|^3
//   otherwise  (a - b/|Y|) Y - turned V_j (R_i + R_j)  a = k_n g V_j/|xi|,  b = (k_n - k_t) g V_j
// with turned = k_t/2 g xi/|xi|. The rotation is that of sum_j weighted Y^T, weighted = g V_j xi/|xi|.

/// Constants of a bond of a uniform chunk: xi, a, b, weighted, turned.
template <int D>
struct UniformBond {
  static constexpr int width = 3 * D + 2;
  const double* c;
  PD_EACH_BOND double xi(int d) const { return c[d]; }
  PD_EACH_BOND double a() const { return c[D]; }
  PD_EACH_BOND double b() const { return c[D + 1]; }
  PD_EACH_BOND double weighted(int d) const { return c[D + 2 + d]; }
  PD_EACH_BOND double turned(int d) const { return c[2 * D + 2 + d]; }

  /// Writes the constants from xi, g and V_j, which `c` begins with.
  static void derive(const ElasticConstants& constants, Form form, double* c) {
    const double g = c[D], volume = c[D + 1];
    double length2 = 0.0;
    for (int d = 0; d < D; ++d) length2 += c[d] * c[d];
    const double perLength = g / std::sqrt(length2), radial = constants.normal - constants.tangential;
    const bool isLinear = form == Form::Linear;
    c[D] = (isLinear ? constants.tangential : constants.normal) * perLength * volume;
    c[D + 1] = radial * (isLinear ? perLength / length2 : g) * volume;
    for (int d = 0; d < D; ++d) {
      c[D + 2 + d] = perLength * volume * c[d];
      c[2 * D + 2 + d] = 0.5 * constants.tangential * perLength * c[d];
    }
  }
};

/// Constants of one bond a lane.
template <int D, Form form, class Bond>
struct BondOfLanes {
  Bond bond;  ///< GatheredBond<D>, or a reference to one that is kept
  const ElasticConstants& constants;
  PD_EACH_BOND Vector xi(int d) const { return bond.xi[d]; }
  PD_EACH_BOND Vector eta(int d) const { return bond.eta[d]; }
  PD_EACH_BOND Vector a() const {
    return (form == Form::Linear ? constants.tangential : constants.normal) * bond.perLength * bond.volume;
  }
  PD_EACH_BOND Vector b() const {
    const Vector radial = (constants.normal - constants.tangential) * bond.perLength * bond.volume;
    return form == Form::Linear ? radial * bond.inverseLength * bond.inverseLength : radial * bond.length;
  }
  PD_EACH_BOND Vector weighted(int d) const { return bond.perLength * bond.volume * bond.xi[d]; }
  PD_EACH_BOND Vector turned(int d) const { return 0.5 * constants.tangential * bond.perLength * bond.xi[d]; }
};

template <int D>
struct ConstantsOfUniform {
  PD_EACH_BOND UniformBond<D> operator()(const double* c) const { return {c}; }
};

template <int D, Form form>
struct ConstantsOfLanes {
  const ElasticConstants& constants;
  PD_EACH_BOND BondOfLanes<D, form, const GatheredBond<D>&> operator()(const GatheredBond<D>& bond) const {
    return {bond, constants};
  }
  PD_EACH_BOND BondOfLanes<D, form, GatheredBond<D>> operator()(GatheredBond<D>&& bond) const {
    return {bond, constants};
  }
};

/// Rotation of every lane's neighbourhood, row by row, and the sum of weighted bonds.
template <int D>
struct Family {
  Vector r[D * D], weighted[D];
};

template <int D, bool isWhole, class BondsOf>
PD_EACH_BOND Family<D> familyOf(const Chunk& chunk, const unsigned char* bits, const BondsOf& bondsOf) {
  Vector product[D * D], weighted[D];  // of Y weighted^T; the plane needs its trace and its skew part
  unrolled<D * D>([&](auto i) PD_INLINED { product[i] = 0.0; });
  unrolled<D>([&](auto d) PD_INLINED { weighted[d] = 0.0; });
  const int nNeighbors = chunk.nNeighbors;
  for (int k = 0; k < nNeighbors; ++k) {
    const auto& bond = bondsOf(k);
    Vector y[D], w[D];
    unrolled<D>([&](auto d) PD_INLINED {
      y[d] = bondsOf.eta(k, bond, d) + bond.xi(d);
      w[d] = keepUnbroken<isWhole>(bond.weighted(d), bits[k]);
      weighted[d] += w[d];
    });
    if constexpr (D == 2) {
      product[0] += w[0] * y[0];
      product[1] += w[0] * y[1];
      product[0] += w[1] * y[1];
      product[1] -= w[1] * y[0];
    } else {
      unrolled<D * D>([&](auto i) PD_INLINED { product[i] += y[i / D] * w[i % D]; });
    }
  }
  Family<D> family;
  unrolled<D>([&](auto d) PD_INLINED { family.weighted[d] = weighted[d]; });
  if constexpr (D == 1) {
    family.r[0] = 1.0;
  } else if constexpr (D == 2) {
    const PlaneRotation<Vector> plane = planeRotation(product[0], product[1]);
    family.r[0] = family.r[3] = plane.cosine;
    family.r[1] = -plane.sine;
    family.r[2] = plane.sine;
  } else {
    Matrix3<Vector> b;
    std::copy(product, product + 9, b.begin());
    // Lanes without a bond: any multiple of the identity.
    const Vector size = b[0] * b[0] + b[4] * b[4] + b[8] * b[8];
    for (const std::size_t i : {0, 4, 8}) b[i] = wherePositive(size, b[i], 1.0);
    b = solidRotation(b);
    std::copy(b.begin(), b.end(), family.r);
  }
  return family;
}

/// Sum over the bonds of their forces at their own points, without rotations.
template <int D, Form form, bool isWhole, class BondsOf>
PD_EACH_BOND void addOwnForces(const Chunk& chunk, const unsigned char* bits, const BondsOf& bondsOf, Vector* sum) {
  Vector force[D];
  unrolled<D>([&](auto d) PD_INLINED { force[d] = 0.0; });
  const int nNeighbors = chunk.nNeighbors;
  for (int k = 0; k < nNeighbors; ++k) {
    if (!isWhole && bits[k] == 0) continue;
    const auto& bond = bondsOf(k);
    Vector eta[D], y[D], square = 0.0, along = 0.0;
    unrolled<D>([&](auto d) PD_INLINED {
      eta[d] = bondsOf.eta(k, bond, d);
      y[d] = eta[d] + bond.xi(d);
      square += y[d] * y[d];
      along += eta[d] * bond.xi(d);
    });
    if constexpr (form == Form::Linear) {
      const Vector a = keepUnbroken<isWhole>(Vector(bond.a()), bits[k]);
      const Vector normal = keepUnbroken<isWhole>(bond.b() * along, bits[k]);
      unrolled<D>([&](auto d) PD_INLINED { force[d] += a * eta[d] + normal * bond.xi(d); });
    } else {
      const Vector perY = keepUnbroken<isWhole>(bond.a() - bond.b() * inverseSquareRoot(square), bits[k]);
      unrolled<D>([&](auto d) PD_INLINED { force[d] += perY * y[d]; });
    }
  }
  unrolled<D>([&](auto d) PD_INLINED { sum[d] += force[d]; });
}

/// Adds V_i R_i turned of all bonds at the neighbours.
template <int D, bool isWhole, class BondsOf>
PD_EACH_BOND void addAtNeighbors(const Chunk& chunk, const unsigned char* bits, const BondsOf& bondsOf,
                                 const Family<D>& family) {
  Vector r[D * D];
  unrolled<D * D>([&](auto i) PD_INLINED { r[i] = family.r[i] * bondsOf.volume; });
  const int nNeighbors = chunk.nNeighbors;
  // Bonds that follow each other share neighbours one lane apart: far between, so that no load waits for a store.
  for (int first = 0; first < lanes; ++first)
    for (int k = first; k < nNeighbors; k += lanes) {
      const auto& bond = bondsOf(k);
      Vector value[D];
      unrolled<D>([&](auto d) PD_INLINED {
        value[d] = r[D * d] * bond.turned(0);
        if constexpr (D > 1) value[d] += r[D * d + 1] * bond.turned(1);
        if constexpr (D > 2) value[d] += r[D * d + 2] * bond.turned(2);
      });
      addToNeighbors<D, isWhole>(bondsOf, k, bits[k], value);
    }
}

template <int D, Form form, bool isWhole, class BondsOf>
void addForceOfChunk(const ChunkedNeighborhood& neighborhood, const Chunk& chunk, double tangential,
                     const unsigned char* bits, const BondsOf& bondsOf, PointArrays& force) {
  Vector sum[D];
  for (int d = 0; d < D; ++d) sum[d] = 0.0;
  addOwnForces<D, form, isWhole>(chunk, bits, bondsOf, sum);
  if constexpr (form == Form::Objective) {
    const Family<D> family = familyOf<D, isWhole>(chunk, bits, bondsOf);
    for (int d = 0; d < D; ++d)
      for (int e = 0; e < D; ++e) sum[d] -= 0.5 * tangential * family.r[D * d + e] * family.weighted[e];
    addAtNeighbors<D, isWhole>(chunk, bits, bondsOf, family);
  }
  for (int d = 0; d < D; ++d) addToPoints(neighborhood, chunk, sum[d], force[d]);
}

template <int D, Form form>
void addForce(const ChunkedNeighborhood& neighborhood, const BondForceData& data, const AliveBonds& alive,
              const BondPoints& points, PointArrays& force) {
  forEachChunkOfBonds<D, UniformBond<D>::width, form != Form::Objective>(
      neighborhood, data.strength, data.coefficients, alive, points, force, ConstantsOfUniform<D>(),
      ConstantsOfLanes<D, form>{data.constants}, [&](auto isWhole, const Chunk& chunk, const auto& bondsOf) {
        addForceOfChunk<D, form, decltype(isWhole)::value>(neighborhood, chunk, data.constants.tangential,
                                                           alive.of(chunk), bondsOf, force);
      });
}

/// Calls visit(integral constants of dimension and form).
template <class Visit>
void withDimensionAndForm(const BondForceData& data, Visit visit) {
  withDimension(data.dimension, [&](auto dimension) {
    switch (formOf(data)) {
      case Form::BondBased:
        return visit(dimension, std::integral_constant<Form, Form::BondBased>());
      case Form::Linear:
        return visit(dimension, std::integral_constant<Form, Form::Linear>());
      case Form::Objective:
        return visit(dimension, std::integral_constant<Form, Form::Objective>());
    }
  });
}

}  // namespace

BondConstants bondCoefficients(const ChunkedNeighborhood& neighborhood, const BondForceData& data,
                               const std::function<void(int, int, std::size_t, double*)>& geometry) {
  BondConstants result;
  withDimensionAndForm(data, [&](auto dimension, auto form) {
    constexpr int D = decltype(dimension)::value;
    // From rounded xi, g and V: else an undeformed bond would be strained by as much as the tolerance.
    const DerivedConstants derived{UniformBond<D>::width, [&](double* values) {
                                     UniformBond<D>::derive(data.constants, decltype(form)::value, values);
                                   }};
    result = BondConstants(neighborhood, D + 2, geometry, BondConstants::Keep::OnlyUniform, 1e-12, derived);
  });
  return result;
}

void addTwoParameterForce(const ChunkedNeighborhood& neighborhood, const BondForceData& data, const AliveBonds& alive,
                          const PointArrays& reference, const PointArrays& displacement, const double* volume,
                          PointArrays& force) {
  const BondPoints points{reference, displacement, volume};
  withDimensionAndForm(data, [&](auto dimension, auto form) {
    addForce<decltype(dimension)::value, decltype(form)::value>(neighborhood, data, alive, points, force);
  });
}

}  // namespace pd::kernels
