#include "nodal_energy.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "Peridigm_InfluenceFunction.hpp"
#include "plugins.hpp"
#include "principal_direction.hpp"
#include "rotation.hpp"

namespace pd {

using PeridigmNS::DataManager;

namespace {

using kernels::Matrix3;

/// What a point can lose in one direction before it has no strength there: more than the half that a crack beside it
/// cuts.
constexpr double wholeShare = 0.8;
/// Of a point that has lost more than that.
constexpr double leastShare = 0.05;
/// What a bond has of its own energy at least, over k.
constexpr double ownShare = 0.6;

/// k in the plane and in space. Calibrated with slow growth over four horizons in clamped strips, without and with
/// tension along the crack of 0.8 of the strain across it, the bond that needs the least load breaking first, on
/// squares of 3 and 4 spacings a horizon, turned by 0 and 20 degrees, on jittered ones and on triangles, with a
/// constant influence function and bonds without k_t: the largest energy on the way is within 6 % of the fracture
/// energy in the plane with a ramp beyond the horizon, within 10 % with other rules and in space, where the lattice was
/// stacked along the front. Then lowered by 1.5 %, to the middle of what decks/fracture_energy finds in three bodies.
double breakageConstant(kernels::VolumeCorrection rule, int dimension) {
  const bool isPlane = dimension == 2;
  switch (rule) {
    case kernels::VolumeCorrection::RampBeyondHorizon:
      return isPlane ? 0.277 : 0.297;
    case kernels::VolumeCorrection::RampToHorizon:
      return isPlane ? 0.293 : 0.300;
    default:
      return isPlane ? 0.290 : 0.315;
  }
}

}  // namespace

void NodalEnergy::declareCommonParameters(ParameterDeclarations& declare) {
  declare.text("Damage Model", "Name of this model.");
  declare
      .real("Fracture Energy", "J/m2",
            "Energy at which a unit area of crack opens, within 10 % on lattices of 3 to 5 spacings a horizon.")
      .positive()
      .required();
  declare.real("Young's Modulus", "Pa", "As in the material.").positive().required();
  declare.real("Poisson's Ratio", "1", "As in the material.").strictlyBetween(-1.0, 0.5).required();
  BondFamily::declareParameters(declare);
  declare.needs("Fracture Energy", {"Horizon"});
}

void NodalEnergy::declareParameters(ParameterDeclarations& declare) { declareCommonParameters(declare); }

NodalEnergy::NodalEnergy(const Teuchos::ParameterList& given)
    : NodalEnergy(completed<NodalEnergy>(given, "damage model Nodal Energy"), Fields(), "damage model Nodal Energy") {}

NodalEnergy::NodalEnergy(const Teuchos::ParameterList& params, const Fields& fields, const std::string& owner)
    : BondDamageModel(params),
      fields_(fields),
      owner_(owner),
      family_(params, owner),
      youngsModulus_(params.get<double>("Young's Modulus")),
      poissonsRatio_(params.get<double>("Poisson's Ratio")),
      fractureEnergy_(params.get<double>("Fracture Energy")),
      constant_(breakageConstant(family_.volumeCorrection, family_.dimension())),
      constants_(family_.elasticConstants(youngsModulus_, poissonsRatio_)) {
  degradation_.stretch = 1.0;
  if (family_.dimension() == 1)
    throw std::invalid_argument(owner + ": a bar has no crack that grows; use Critical Stretch");
  const auto influence = PeridigmNS::InfluenceFunction::self().getInfluenceFunction();
  for (const double part : {0.25, 0.5, 0.75, 1.0})
    if (influence(part * family_.horizon, family_.horizon) != influence(0.0, family_.horizon))
      throw std::invalid_argument(owner +
                                  ": its constant is known for a constant influence function only; leave out "
                                  "\"Influence Function\", or use Critical Stretch or Bilinear");
}

kernels::ElasticConstants NodalEnergy::constantsOf(double volume) const {
  if (!family_.rescalesToLattice) return constants_;
  if (volume != lastVolume_)
    lastConstants_ =
        family_.latticeElasticConstants(youngsModulus_, poissonsRatio_, family_.spacing(lastVolume_ = volume));
  return lastConstants_;
}

/// Arrays by local id.
struct NodalEnergy::Views {
  const double *x, *y, *volume;
  double *criticalStretch, *utilisation;
  const double* surfaceFactor;  ///< null where the material has none
  int dimension;
  const double* bondDamage;
  const kernels::PointArrays* coverage;
  /// Square of the critical stretch of a point's bonds, as stiff as the material makes them there.
  double limit2(int i) const {
    const double limit = criticalStretch[i];
    if (surfaceFactor == nullptr) return limit * limit;
    double factor = 0.0;
    for (int d = 0; d < dimension; ++d) factor += surfaceFactor[3 * i + d] / dimension;
    return limit * limit / factor;
  }
  /// Square of the factor of hydrogen on it.
  double degradation2(const kernels::CriticalStretchLaw& law, int i, int j) const {
    if (coverage == nullptr) return 1.0;
    const double factor = law.at(0.5 * ((*coverage)[0][i] + (*coverage)[0][j]));
    return factor * factor;
  }
};

/// A point with its bonds.
struct NodalEnergy::Family {
  int point;
  const int* neighbors;
  int count;
  std::size_t firstBond;
};

namespace {

/// Calls visit(point, its neighbours, their number, its first bond).
template <class Visit>
void forEachFamily(const Call& call, const Visit& visit) {
  const int* entry = call.neighborhoodList;
  std::size_t bond = 0;
  for (int p = 0; p < call.nOwned; ++p) {
    visit(call.ownedIds[p], entry + 1, *entry, bond);
    bond += static_cast<std::size_t>(*entry);
    entry += *entry + 1;
  }
}

}  // namespace

NodalEnergy::Cache& NodalEnergy::cacheOf(const Call& call, DataManager& data, Views& views) const {
  views.x = fields_.modelCoordinates.of(data);
  views.y = fields_.coordinates.of(data);
  views.volume = fields_.volume.of(data);
  views.criticalStretch = fields_.criticalStretch.of(data);
  views.utilisation = fields_.utilisation.of(data);
  views.bondDamage = fields_.bondDamage.before(data);
  views.surfaceFactor = fields_.surfaceFactor.ifIn(data);
  views.dimension = family_.dimension();
  Cache& cache = caches_.of(call, views.x, [&](const Call& c) {
    Cache made;
    made.neighborhood = kernels::ChunkedNeighborhood(c.nOwned, c.ownedIds, c.neighborhoodList);
    made.weight.resize(made.neighborhood.nBonds());
    forEachBond(c, [&](int i, int j, std::size_t bond) {
      const double length = ReferenceBond(views.x, i, j).length;
      made.weight[bond] = family_.share(length, views.volume[i], views.volume[j]) * length * views.volume[j];
    });
    return made;
  });
  views.coverage = coverage(data, cache.coverage) ? &cache.coverage : nullptr;
  return cache;
}

void NodalEnergy::initialize(const double dt, const int numOwnedPoints, const int* ownedIDs,
                             const int* neighborhoodList, DataManager& data) const {
  if (fields_.interactionShare.isIn(data))
    throw std::invalid_argument(
        owner_ +
        ": its constant is known for whole bonds only, not for those of which Cracks and Voids "
        "of the deck take a part; cut the crack by Bond Filters with \"Count In Damage: true\", "
        "or use Critical Stretch, Bilinear or Remaining Life");
  caches_.clear();
  prepared_.clear();
  BondDamageModel::initialize(dt, numOwnedPoints, ownedIDs, neighborhoodList, data);
  const Call call{numOwnedPoints, ownedIDs, neighborhoodList};
  Views views{};
  const Cache& cache = cacheOf(call, data, views);
  forEachFamily(call, [&](int i, const int* neighbors, int count, std::size_t bond) {
    double moment = 0.0;
    for (int k = 0; k < count; ++k)
      moment += cache.weight[bond + static_cast<std::size_t>(k)] * ReferenceBond(views.x, i, neighbors[k]).length;
    views.criticalStretch[i] =
        kernels::criticalStretchOfPoint(family_.section, constantsOf(views.volume[i]).normal, fractureEnergy_, moment);
  });
}

namespace {

/// Rotation of the point's unbroken bonds, as the material sees it (kernels/two_parameter_bond.hpp).
Matrix3<double> rotationOf(const double* x, const double* y, int point, const int* neighbors, int count,
                           const double* weight, const double* bondDamage, int dimension) {
  Matrix3<double> b{};
  for (int k = 0; k < count; ++k) {
    const ReferenceBond reference(x, point, neighbors[k]), current(y, point, neighbors[k]);
    const double w = weight[k] * (1.0 - bondDamage[k]) / (reference.length * reference.length);
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) b[3 * r + c] += w * current.xi[r] * reference.xi[c];
  }
  if (dimension == 3) return kernels::solidRotation(b);
  const auto plane = kernels::planeRotation(b[0] + b[4], b[3] - b[1]);
  return {plane.cosine, -plane.sine, 0.0, plane.sine, plane.cosine, 0.0, 0.0, 0.0, 1.0};
}

/// |Y - R xi|^2 / |xi|^2
double turnedStrain2(const ReferenceBond& reference, const ReferenceBond& current, const Matrix3<double>& r) {
  double sum = 0.0;
  for (std::size_t d = 0; d < 3; ++d) {
    const double difference =
        current.xi[d] - (r[3 * d] * reference.xi[0] + r[3 * d + 1] * reference.xi[1] + r[3 * d + 2] * reference.xi[2]);
    sum += difference * difference;
  }
  return sum / (reference.length * reference.length);
}

/// Adds w n n^T of the bond's direction in the reference configuration.
void addAlong(const ReferenceBond& bond, double w, Matrix3<double>& tensor) {
  const double perLength2 = w / (bond.length * bond.length);
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) tensor[3 * r + c] += perLength2 * bond.xi[r] * bond.xi[c];
}

/// (n . direction)^2
double alongness(const ReferenceBond& bond, const std::array<double, 3>& direction) {
  const double part = (bond.xi[0] * direction[0] + bond.xi[1] * direction[1] + bond.xi[2] * direction[2]) / bond.length;
  return part * part;
}

double along(const Matrix3<double>& tensor, const std::array<double, 3>& direction) {
  double sum = 0.0;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) sum += direction[r] * tensor[3 * r + c] * direction[c];
  return sum;
}

}  // namespace

/// Sum of w n n^T over the unbroken, stretched bonds of a point; per volume, in parts of the normal micromodulus.
kernels::Matrix3<double> NodalEnergy::storedEnergy(const Family& family, const Views& views, const Cache& cache) const {
  const double* weight = cache.weight.data() + family.firstBond;
  const double* bondDamage = views.bondDamage + family.firstBond;
  const kernels::ElasticConstants constants = constantsOf(views.volume[family.point]);
  const double tangential = constants.tangential / constants.normal;
  Matrix3<double> rotation{}, stored{};
  if (tangential != 0.0)
    rotation = rotationOf(views.x, views.y, family.point, family.neighbors, family.count, weight, bondDamage,
                          family_.dimension());
  for (int k = 0; k < family.count; ++k) {
    const double w = weight[k] * (1.0 - bondDamage[k]);
    if (w == 0.0) continue;
    const ReferenceBond reference(views.x, family.point, family.neighbors[k]);
    const ReferenceBond current(views.y, family.point, family.neighbors[k]);
    const double stretch = current.length / reference.length - 1.0;
    if (stretch <= 0.0) continue;
    double strain2 = (1.0 - tangential) * stretch * stretch;
    if (tangential != 0.0) strain2 += tangential * turnedStrain2(reference, current, rotation);
    addAlong(reference, w * strain2, stored);
  }
  return stored;
}

double NodalEnergy::utilisationOf(const Family& family, const Views& views, const Cache& cache) const {
  const double* weight = cache.weight.data() + family.firstBond;
  const double* bondDamage = views.bondDamage + family.firstBond;
  const Matrix3<double> stored = storedEnergy(family, views, cache);
  if (stored[0] + stored[4] + stored[8] == 0.0) return 0.0;
  const std::array<double, 3> direction = kernels::principalDirection(stored);
  double all = 0.0, unbroken = 0.0, critical = 0.0;
  for (int k = 0; k < family.count; ++k) {
    const int j = family.neighbors[k];
    const double w = weight[k] * alongness(ReferenceBond(views.x, family.point, j), direction);
    all += w;
    unbroken += w * (1.0 - bondDamage[k]);
    critical += w * (1.0 - bondDamage[k]) * views.degradation2(degradation_, family.point, j);
  }
  // Hydrogen may leave bonds without any strength: then any stretch is enough.
  constexpr double strengthless = 1e-12;
  const double lost = 1.0 - unbroken / all;
  return along(stored, direction) / (std::max(critical, strengthless * unbroken) * views.limit2(family.point)) *
         (1.0 - lost) / (std::max(wholeShare - lost, leastShare) * constant_);
}

void NodalEnergy::precompute(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                             DataManager& data) const {
  const Call call{numOwnedPoints, ownedIDs, neighborhoodList};
  Views views{};
  const Cache& cache = cacheOf(call, data, views);
  forEachFamily(call, [&](int i, const int* neighbors, int count, std::size_t bond) {
    views.utilisation[i] = utilisationOf({i, neighbors, count, bond}, views, cache);
  });
  prepared_.insert(&data);
}

void NodalEnergy::worsen(double dt, const Call& call, DataManager& data) const {
  if (prepared_.erase(&data) == 0) {
    if (fields_.volume.length(data) != call.nOwned)
      throw std::runtime_error(owner_ +
                               ": this host does not exchange the energy of neighbours (it calls no precompute); run "
                               "it on one rank with one block, or with pdrun");
    precompute(dt, call.nOwned, call.ownedIds, call.neighborhoodList, data);
    prepared_.erase(&data);
  }
  Views views{};
  cacheOf(call, data, views);
  const double* noFailure = fields_.noFailure.ifIn(data);
  double* bondDamage = fields_.bondDamage.of(data);
  bool hasBroken = false;
  forEachBond(call, [&](int i, int j, std::size_t bond) {
    if (bondDamage[bond] >= 1.0 || 0.5 * (views.utilisation[i] + views.utilisation[j]) < 1.0) return;
    if (noFailure != nullptr && (noFailure[i] != 0.0 || noFailure[j] != 0.0)) return;
    const double stretch = ReferenceBond(views.y, i, j).length / ReferenceBond(views.x, i, j).length - 1.0;
    const double limit2 = 0.5 * (views.limit2(i) + views.limit2(j));
    const double least2 = ownShare * constant_ * limit2 * views.degradation2(degradation_, i, j);
    if (stretch <= 0.0 || stretch * stretch < least2) return;
    bondDamage[bond] = 1.0;
    hasBroken = true;
  });
  if (hasBroken) countBrokenBonds(call, bondDamage, fields_.damage.of(data));
}

PD_REGISTER_DAMAGE_MODEL(NodalEnergy, "Nodal Energy",
                         "Bonds break by the energy of their ends, so that the lattice does not hold cracks up.")

}  // namespace pd
