#include "point_deformation.hpp"

#include <Teuchos_LAPACK.hpp>
#include <numeric>

#include "list_starts.hpp"

namespace pd {

namespace {

Tensor product(const Tensor& a, const Tensor& b) {
  Tensor result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) result[3 * i + j] += a[3 * i + k] * b[3 * k + j];
  return result;
}

void addOuterProduct(Tensor& sum, double weight, const double* a, const double* b) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) sum[3 * i + j] += weight * a[i] * b[j];
}

}  // namespace

Tensor pseudoInverse(const Tensor& symmetric) {
  Tensor vectors = symmetric;
  double values[3] = {0.0, 0.0, 0.0}, work[16];
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('V', 'L', 3, vectors.data(), 3, values, work, 16, &info);
  Tensor result{};
  for (std::size_t k = 0; k < 3; ++k)
    if (values[k] > 1e-8 * values[2])
      addOuterProduct(result, 1.0 / values[k], vectors.data() + 3 * k, vectors.data() + 3 * k);
  return result;
}

std::vector<Tensor> DeformationGradients::of(PeridigmNS::Block& block, double leastIntact) const {
  const std::vector<std::size_t> starts = listStarts(*block.getNeighborhoodData());
  std::vector<std::size_t> all(starts.size());
  std::iota(all.begin(), all.end(), 0U);
  return at(block, leastIntact, all, starts);
}

std::vector<Tensor> DeformationGradients::at(PeridigmNS::Block& block, double leastIntact,
                                             const std::vector<std::size_t>& places,
                                             const std::vector<std::size_t>& starts) const {
  const double* volume = view(block, fields_.volume);
  const double* x = view(block, fields_.modelCoordinates);
  const double* y = view(block, fields_.coordinates);
  const double* bondDamage = fields_.bondDamage.ifIn(*block.getDataManager());
  const double* share = fields_.interactionShare.ifIn(*block.getDataManager());
  const auto neighborhood = block.getNeighborhoodData();

  std::vector<Tensor> result(places.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const int id = neighborhood->OwnedIDs()[places[i]];
    const int* list = neighborhood->NeighborhoodList() + starts[places[i]];
    std::size_t bond = starts[places[i]] - places[i];
    for (std::size_t k = 0; k < 9; k += 4) result[i][k] = 1.0;
    Tensor shape{}, deformed{};
    double intact = 0.0, all = 0.0;
    for (int n = *list++; n > 0; --n, ++list, ++bond) {
      const double whole = volume[*list] * (share == nullptr ? 1.0 : share[bond]);
      const double weight = whole * (bondDamage == nullptr ? 1.0 : 1.0 - bondDamage[bond]);
      intact += weight;
      all += whole;
      double xi[3], eta[3];
      for (int k = 0; k < 3; ++k) {
        xi[k] = x[3 * *list + k] - x[3 * id + k];
        eta[k] = y[3 * *list + k] - y[3 * id + k] - xi[k];
      }
      addOuterProduct(shape, weight, xi, xi);
      addOuterProduct(deformed, weight, eta, xi);
    }
    // With the displacement in place of the deformed bond the identity needs no extra terms.
    if (!(intact >= leastIntact * all)) continue;
    result[i] = product(deformed, pseudoInverse(shape));
    for (std::size_t k = 0; k < 9; k += 4) result[i][k] += 1.0;
  }
  return result;
}

Tensor reflected(const Tensor& tensor, const Tensor& reflection) {
  return product(product(reflection, tensor), reflection);
}

void declareStrainMeasure(ParameterDeclarations& declarations) {
  declarations.text("Strain Measure", "Linear strain, or the Green-Lagrange strain, which rotation leaves alone.")
      .oneOf({"Small", "Green-Lagrange"})
      .defaultTo("Small");
}

Tensor strainOf(const Tensor& deformationGradient, bool isGreenLagrange) {
  Tensor h = deformationGradient;  // gradient of the displacement
  for (std::size_t k = 0; k < 9; k += 4) h[k] -= 1.0;
  Tensor result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      double value = h[3 * i + j] + h[3 * j + i];
      if (isGreenLagrange)
        for (std::size_t k = 0; k < 3; ++k) value += h[3 * k + i] * h[3 * k + j];
      result[3 * i + j] = 0.5 * value;
    }
  return result;
}

void HookesLaw::declareParameters(ParameterDeclarations& declarations) {
  declarations.flag("Plane Stress", "The body is a thin plate in the x-y plane (otherwise: plane strain or a 3D body).")
      .defaultTo(false);
}

HookesLaw::HookesLaw(const PeridigmNS::Material& material, bool isPlaneStress)
    : lambda_(material.BulkModulus() - 2.0 / 3.0 * material.ShearModulus()),
      shearModulus_(material.ShearModulus()),
      isPlaneStress_(isPlaneStress) {
  if (isPlaneStress) lambda_ = 2.0 * shearModulus_ * lambda_ / (lambda_ + 2.0 * shearModulus_);
}

Tensor HookesLaw::stress(const Tensor& strain) const {
  const double pressure = lambda_ * (strain[0] + strain[4] + (isPlaneStress_ ? 0.0 : strain[8]));
  Tensor result;
  for (std::size_t k = 0; k < 9; ++k) result[k] = 2.0 * shearModulus_ * strain[k];
  for (std::size_t k = 0; k < 9; k += 4) result[k] += pressure;
  if (isPlaneStress_) result[2] = result[5] = result[6] = result[7] = result[8] = 0.0;
  return result;
}

}  // namespace pd
