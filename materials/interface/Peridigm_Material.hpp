// The base class of materials, with the names and signatures of Peridigm's.
// Inside a Peridigm tree Peridigm's own header of this name is found instead.
#ifndef PERIDIGM_MATERIAL_HPP
#define PERIDIGM_MATERIAL_HPP

#include <Teuchos_ParameterList.hpp>
#include <cfloat>
#include <string>
#include <vector>

#include "Peridigm_DataManager.hpp"
#include "Peridigm_SerialMatrix.hpp"

namespace PeridigmNS {

class Material {
 public:
  explicit Material(const Teuchos::ParameterList& params);
  virtual ~Material() = default;

  virtual std::string Name() const = 0;
  virtual double Density() const = 0;
  virtual double BulkModulus() const = 0;
  virtual double ShearModulus() const = 0;
  virtual double lookupMaterialProperty(const std::string keyname) const;
  virtual std::vector<int> FieldIds() const = 0;
  virtual std::vector<int> FieldIdsForSynchronizationAfterInitialize() const { return {}; }
  virtual std::vector<int> FieldIdsForSynchronizationAfterPrecompute() const { return {}; }

  virtual void initialize(const double, const int, const int*, const int*, DataManager&) {}
  virtual void precompute(const double, const int, const int*, const int*, DataManager&) const {}
  /// Zeroes Force_Density at STEP_NP1, then adds to it at owned points and, where the model needs it, at neighbours
  /// (ghosts too; the host sums those into their owners). The same holds for the flux divergence.
  virtual void computeForce(const double, const int, const int*, const int*, DataManager&) const {}
  virtual void computeFluxDivergence(const double, const int, const int*, const int*, DataManager&) const {}
  virtual void computeStoredElasticEnergyDensity(const double, const int, const int*, const int*, DataManager&) const {}

  enum JacobianType { UNDEFINED = 0, NONE = 1, FULL_MATRIX = 2, BLOCK_DIAGONAL = 3 };
  enum FiniteDifferenceScheme { FORWARD_DIFFERENCE = 0, CENTRAL_DIFFERENCE = 1 };

  /// Adds the derivatives of the rates that the material gives (force density; of a field: its flux divergence) by the
  /// unknowns of the DegreesOfFreedomManager, each row multiplied by the volume of its point (as Peridigm does: the
  /// tangent of a force, symmetric for pairwise forces), to `jacobian`.
  /// The default probes computeForce and computeFluxDivergence by central differences.
  virtual void computeJacobian(const double dt, const int numOwnedPoints, const int* ownedIDs,
                               const int* neighborhoodList, DataManager& dataManager, SerialMatrix& jacobian,
                               JacobianType jacobianType = FULL_MATRIX) const;

  double calculateBulkModulus(const Teuchos::ParameterList& params) const;
  double calculateShearModulus(const Teuchos::ParameterList& params) const;

 protected:
  void computeFiniteDifferenceJacobian(const double dt, const int numOwnedPoints, const int* ownedIDs,
                                       const int* neighborhoodList, DataManager& dataManager, SerialMatrix& jacobian,
                                       FiniteDifferenceScheme scheme, JacobianType jacobianType = FULL_MATRIX) const;

  double m_finiteDifferenceProbeLength = DBL_MAX;
};

}  // namespace PeridigmNS

#endif
