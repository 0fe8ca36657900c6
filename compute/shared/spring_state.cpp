#include "spring_state.hpp"

#include <stdexcept>

#include "point_deformation.hpp"

namespace pd {

namespace {

const LinearBonds* bondsOf(PeridigmNS::Block& block) {
  return dynamic_cast<const LinearBonds*>(block.getMaterialModel().get());
}

/// An unbroken bond of a point.
struct Spring {
  Vector3 xi, eta;       ///< m
  double along, across;  ///< N/m
};

/// The rotation that makes the energy of a family least.
Vector3 rotationOf(const std::vector<Spring>& family) {
  Tensor inertia{};
  Vector3 moment{};
  for (const Spring& bond : family) {
    const Vector3 part = cross(bond.xi, bond.eta);
    const double length2 = dot(bond.xi, bond.xi.data());
    for (std::size_t k = 0; k < 3; ++k) {
      moment[k] += bond.across * part[k];
      inertia[4 * k] += bond.across * length2;
      for (std::size_t l = 0; l < 3; ++l) inertia[3 * k + l] -= bond.across * bond.xi[k] * bond.xi[l];
    }
  }
  const Tensor inverse = pseudoInverse(inertia);
  Vector3 rotation{};
  for (std::size_t k = 0; k < 3; ++k) rotation[k] = dot(moment, inverse.data() + 3 * k);
  return rotation;
}

}  // namespace

void SpringState::require(PeridigmNS::Block& block, const std::string& compute) {
  const LinearBonds* bonds = bondsOf(block);
  const std::string obstacle = bonds == nullptr ? "its material has none" : bonds->springsObstacle();
  if (!obstacle.empty())
    throw std::invalid_argument(
        compute + ": block \"" + block.getName() +
        "\" has no bonds that are springs (PDHE, Elastic, Elastic Bond Based have): " + obstacle + "; use J_Integral");
}

LinearSprings SpringState::springsOf(PeridigmNS::Block& block) {
  const auto list = block.getNeighborhoodData();
  return bondsOf(block)->springs({list->NumOwnedPoints(), list->OwnedIDs(), list->NeighborhoodList()},
                                 *block.getDataManager());
}

SpringState::SpringState(PeridigmNS::Block& block, const Fields& fields, const LinearSprings& springs,
                         const std::vector<std::size_t>& places, const std::vector<std::size_t>& starts) {
  PeridigmNS::DataManager& data = *block.getDataManager();
  const auto list = block.getNeighborhoodData();
  const double *x = fields.modelCoordinates.of(data), *y = fields.coordinates.of(data);
  const double* damage = fields.bondDamage.ifIn(data);
  std::vector<Spring> family;
  for (const std::size_t p : places) {
    const int i = list->OwnedIDs()[p];
    const int* neighbor = list->NeighborhoodList() + starts[p];
    std::size_t bond = starts[p] - p;
    family.clear();
    for (int n = *neighbor++; n > 0; --n, ++neighbor, ++bond) {
      Spring spring{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto from = static_cast<std::size_t>(3 * i) + k, to = static_cast<std::size_t>(3 * *neighbor) + k;
        spring.xi[k] = x[to] - x[from];
        spring.eta[k] = y[to] - y[from] - spring.xi[k];
      }
      const double intact = damage == nullptr ? 1.0 : 1.0 - damage[bond];
      spring.along = intact * springs.along[bond];
      spring.across = springs.across.empty() ? 0.0 : intact * springs.across[bond];
      family.push_back(spring);
    }
    const Vector3 rotation =
        springs.family == LinearSprings::Family::Rotation && !springs.across.empty() ? rotationOf(family) : Vector3{};
    double pressure = 0.0, sum = 0.0;
    if (springs.family == LinearSprings::Family::Dilatation) {
      for (const Spring& spring : family) pressure += spring.along * dot(spring.xi, spring.eta.data());
      sum = 0.5 * springs.dilatational[p] * pressure * pressure;
      pressure *= springs.dilatational[p];
    }
    for (const Spring& spring : family) {
      const Vector3 turned = cross(rotation, spring.xi);
      const double share = dot(spring.xi, spring.eta.data()) / dot(spring.xi, spring.xi.data());
      Vector3 f{};
      for (std::size_t k = 0; k < 3; ++k) {
        const double aside = spring.eta[k] - turned[k] - share * spring.xi[k];
        f[k] = spring.along * (share + pressure) * spring.xi[k] + spring.across * aside;
        sum += 0.5 * (spring.along * share * share * spring.xi[k] * spring.xi[k] + spring.across * aside * aside);
      }
      force.push_back(f);
    }
    energy.push_back(sum);
  }
}

}  // namespace pd
