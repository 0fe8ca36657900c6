// Energy and tangent of the two-parameter bond model (formulas: kernels/two_parameter_bond.hpp).
#include <cmath>
#include <vector>

#include "bond_mechanics.hpp"
#include "bond_mechanics_views.hpp"
#include "rotation.hpp"
#include "unknowns.hpp"

namespace pd {

namespace {

using kernels::Matrix3;
using Vector3 = std::array<double, 3>;

/// One unbroken bond of a family in the current state.
struct CurrentBond {
  int neighbor;
  Vector3 xi, y;
  double length;    ///< |xi|
  double strength;  ///< g (1 - bond damage)
  double volume;    ///< of the neighbour
};

Matrix3<double> familyRotation(const std::vector<CurrentBond>& family, int dimension) {
  if (dimension == 1) return {1, 0, 0, 0, 1, 0, 0, 0, 1};
  Matrix3<double> b{};
  for (const CurrentBond& bond : family)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        b[3 * i + j] += bond.strength * bond.volume / bond.length * bond.y[i] * bond.xi[j];
  if (dimension == 3) return kernels::solidRotation(b);
  const auto r = kernels::planeRotation(b[0] + b[4], b[3] - b[1]);
  return {r.cosine, -r.sine, 0, r.sine, r.cosine, 0, 0, 0, 1};
}

Vector3 rotated(const Matrix3<double>& r, const Vector3& v) {
  return {r[0] * v[0] + r[1] * v[1] + r[2] * v[2], r[3] * v[0] + r[4] * v[1] + r[5] * v[2],
          r[6] * v[0] + r[7] * v[1] + r[8] * v[2]};
}

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// [v]_x w = v x w
Matrix3<double> crossMatrix(const Vector3& v) { return {0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0}; }

Matrix3<double> inverseOf(const Matrix3<double>& m) {
  Matrix3<double> result;
  const double determinant =
      m[0] * (m[4] * m[8] - m[5] * m[7]) + m[1] * (m[5] * m[6] - m[3] * m[8]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t r = (j + 1) % 3, s = (j + 2) % 3, t = (i + 1) % 3, u = (i + 2) % 3;
      result[3 * i + j] = (m[3 * r + t] * m[3 * s + u] - m[3 * r + u] * m[3 * s + t]) / determinant;
    }
  return result;
}

/// Second derivative of half the bond's energy with respect to Y, per volume of both ends.
Matrix3<double> bondStiffness(const CurrentBond& bond, const kernels::ElasticConstants& k, bool isLinear) {
  const double half = 0.5 * bond.strength, difference = k.normal - k.tangential;
  Matrix3<double> h{};
  const Vector3& direction = isLinear ? bond.xi : bond.y;
  const double length = isLinear ? bond.length : std::sqrt(dot(bond.y, bond.y));
  const double stretch = isLinear ? 0.0 : (length - bond.length) / bond.length;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const double n = direction[i] * direction[j] / (length * length), identity = i == j ? 1.0 : 0.0;
      h[3 * i + j] = half * (difference * (n / bond.length + stretch * (identity - n) / length) +
                             k.tangential * identity / bond.length);
    }
  return h;
}

/// Adds the dense block `k` (3 a point of `ids`) as d(force)/d(displacement).
void addBlock(const std::vector<double>& k, const std::vector<int>& globalIds, int dimension,
              PeridigmNS::SerialMatrix& jacobian) {
  const UnknownPlace place = unknownPlace(fields::displacement().label);
  const std::size_t n = globalIds.size(), d = static_cast<std::size_t>(dimension);
  std::vector<int> indices;
  for (const int id : globalIds)
    for (int c = 0; c < dimension; ++c) indices.push_back(place.row(id) + c);
  std::vector<double> values(n * d * n * d);
  std::vector<const double*> rows(n * d);
  for (std::size_t row = 0; row < n * d; ++row) {
    for (std::size_t column = 0; column < n * d; ++column)
      values[row * n * d + column] = -k[(3 * (row / d) + row % d) * 3 * n + 3 * (column / d) + column % d];
    rows[row] = &values[row * n * d];
  }
  jacobian.addValues(static_cast<int>(n * d), indices.data(), rows.data());
}

/// Adds sign * block to the (a, b) block of the dense matrix of n points.
void addTo(std::vector<double>& k, std::size_t n, std::size_t a, std::size_t b, const Matrix3<double>& block,
           double sign) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) k[(3 * a + i) * 3 * n + 3 * b + j] += sign * block[3 * i + j];
}

/// The block of d2E/dY_a dY_b as second derivatives with respect to the displacements of the two points each bond joins
/// (point 0 is the centre).
void addBondPair(std::vector<double>& k, std::size_t n, std::size_t a, std::size_t b, const Matrix3<double>& block) {
  addTo(k, n, a, b, block, 1.0);
  addTo(k, n, 0, b, block, -1.0);
  addTo(k, n, a, 0, block, -1.0);
  addTo(k, n, 0, 0, block, 1.0);
}

/// Adds the family's coupling by its rotation: -sum_ab B_a A^-1 B_b^T, with A the second derivative of the energy with
/// respect to the rotation and B_a the mixed one.
void addRotationCoupling(std::vector<double>& k, const std::vector<CurrentBond>& family, const Matrix3<double>& r,
                         double tangential, double ownVolume, int dimension) {
  const std::size_t n = family.size() + 1;
  Matrix3<double> a{};
  std::vector<Matrix3<double>> mixed;
  for (const CurrentBond& bond : family) {
    const Vector3 q = rotated(r, bond.xi);
    const double c = ownVolume * bond.volume * 0.5 * bond.strength * tangential / bond.length;
    Matrix3<double> b = crossMatrix(q);
    for (double& value : b) value *= c;
    mixed.push_back(b);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        a[3 * i + j] += c * ((i == j ? dot(bond.y, q) : 0.0) - 0.5 * (bond.y[i] * q[j] + q[i] * bond.y[j]));
  }
  if (a[8] == 0.0) return;
  Matrix3<double> inverse{};
  if (dimension == 2)
    inverse[8] = 1.0 / a[8];
  else
    inverse = inverseOf(a);
  for (std::size_t p = 0; p < family.size(); ++p) {
    Matrix3<double> left{};  // B_p A^-1
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t s = 0; s < 3; ++s) left[3 * i + j] += mixed[p][3 * i + s] * inverse[3 * s + j];
    for (std::size_t q = 0; q < family.size(); ++q) {
      Matrix3<double> block{};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          for (std::size_t s = 0; s < 3; ++s) block[3 * i + j] -= left[3 * i + s] * mixed[q][3 * j + s];
      addBondPair(k, n, p + 1, q + 1, block);
    }
  }
}

}  // namespace

template <class Visit>
void BondMechanics::forEachFamily(const Call& call, const Views& views, Visit visit) const {
  std::vector<CurrentBond> family;
  std::size_t at = 0, bondIndex = 0;
  for (int p = 0; p < call.nOwned; ++p) {
    const int i = call.ownedIds[p];
    const int count = call.neighborhoodList[at++];
    family.clear();
    for (int k = 0; k < count; ++k, ++bondIndex) {
      const int j = call.neighborhoodList[at++];
      const ReferenceBond reference(views.x, i, j);
      CurrentBond bond{
          j, reference.xi, {}, reference.length, strength(views, reference, i, j, bondIndex), views.volume[j]};
      if (views.damaged.bondDamage != nullptr) bond.strength *= 1.0 - views.damaged.bondDamage[bondIndex];
      if (bond.strength == 0.0) continue;
      for (std::size_t d = 0; d < 3; ++d)
        bond.y[d] = views.y[3 * static_cast<std::size_t>(j) + d] - views.y[3 * static_cast<std::size_t>(i) + d];
      family.push_back(bond);
    }
    visit(i, family);
  }
}

void BondMechanics::computeStoredElasticEnergyDensity(const Call& call, PeridigmNS::DataManager& dataManager) const {
  const Views views(*this, dataManager);
  double* energy = fields_.energy.of(dataManager);
  forEachFamily(call, views, [&](int i, const auto& family) {
    const bool isLinear = form_ == kernels::TangentialForm::Linear;
    const Matrix3<double> r = isLinear || constants_.tangential == 0.0 ? Matrix3<double>{1, 0, 0, 0, 1, 0, 0, 0, 1}
                                                                       : familyRotation(family, family_.dimension());
    double sum = 0.0;
    for (const CurrentBond& bond : family) {
      const Vector3 q = rotated(r, bond.xi);
      Vector3 difference{};
      for (std::size_t d = 0; d < 3; ++d) difference[d] = bond.y[d] - q[d];
      const double stretch = isLinear ? dot(difference, bond.xi) / (bond.length * bond.length)
                                      : (std::sqrt(dot(bond.y, bond.y)) - bond.length) / bond.length;
      sum += 0.25 * bond.strength * bond.length * bond.volume *
             ((constants_.normal - constants_.tangential) * stretch * stretch +
              constants_.tangential * dot(difference, difference) / (bond.length * bond.length));
    }
    energy[i] = sum;
  });
}

LinearSprings::Family BondMechanics::springFamily() const {
  const bool rotates = form_ == kernels::TangentialForm::Objective && constants_.tangential != 0.0;
  return rotates && family_.dimension() > 1 ? LinearSprings::Family::Rotation : LinearSprings::Family::None;
}

LinearSprings BondMechanics::springs(const Call& call, PeridigmNS::DataManager& dataManager) const {
  const Views views(*this, dataManager);
  LinearSprings result;
  result.family = springFamily();
  std::size_t nBonds = 0;
  const int* entry = call.neighborhoodList;
  for (int p = 0; p < call.nOwned; ++p, entry += *entry + 1) nBonds += static_cast<std::size_t>(*entry);
  result.along.reserve(nBonds);
  if (constants_.tangential != 0.0) result.across.reserve(nBonds);
  forEachBond(call, [&](int i, int j, std::size_t index) {
    const ReferenceBond bond(views.x, i, j);
    const double g = 0.5 * strength(views, bond, i, j, index) * views.volume[i] * views.volume[j] / bond.length;
    result.along.push_back(constants_.normal * g);
    if (constants_.tangential != 0.0) result.across.push_back(constants_.tangential * g);
  });
  return result;
}

void BondMechanics::computeJacobian(const Call& call, PeridigmNS::DataManager& dataManager,
                                    PeridigmNS::SerialMatrix& jacobian) const {
  if (!unknownPlace(fields::displacement().label).isUnknown) return;
  const Views views(*this, dataManager);
  const auto& map = *dataManager.getOverlapScalarPointMap();
  const bool isLinear = form_ == kernels::TangentialForm::Linear;
  const bool couplesFamily = !isLinear && constants_.tangential != 0.0 && family_.dimension() > 1;
  forEachFamily(call, views, [&](int i, const auto& family) {
    if (family.empty()) return;
    const std::size_t n = family.size() + 1;
    std::vector<double> k(couplesFamily ? 9 * n * n : 36, 0.0);
    std::vector<int> ids{map.GID(i)};
    for (const CurrentBond& bond : family) {
      Matrix3<double> h = bondStiffness(bond, constants_, isLinear);
      for (double& value : h) value *= views.volume[i] * bond.volume;
      ids.push_back(map.GID(bond.neighbor));
      if (couplesFamily) {
        addBondPair(k, n, ids.size() - 1, ids.size() - 1, h);
        continue;
      }
      std::fill(k.begin(), k.end(), 0.0);
      addBondPair(k, 2, 1, 1, h);
      addBlock(k, {ids.front(), ids.back()}, family_.dimension(), jacobian);
    }
    if (!couplesFamily) return;
    addRotationCoupling(k, family, familyRotation(family, family_.dimension()), constants_.tangential, views.volume[i],
                        family_.dimension());
    addBlock(k, ids, family_.dimension(), jacobian);
  });
}

}  // namespace pd
