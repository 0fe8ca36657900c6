// Initial and boundary conditions of a deck.
#ifndef PD_BOUNDARY_CONDITIONS_HPP
#define PD_BOUNDARY_CONDITIONS_HPP

#include <memory>
#include <string>
#include <vector>

#include "../deck/deck.hpp"
#include "../model/model.hpp"

namespace pd {

/// Types: Initial Displacement, Initial Velocity, Initial Value, Prescribed Displacement, Prescribed Value
/// (any scalar point field: `Field: Concentration`; Initial/Prescribed Temperature and Concentration are the same with
/// the field fixed), Body Force (N/m3), Traction (N/m2, spread over the node set's points by area), No Failure (sets
/// the field No_Failure), Saturated Crack Faces (points whose Damage exceeds Threshold hold Value in Field).
class BoundaryConditions {
 public:
  BoundaryConditions(const Deck& deck, Model& model);
  ~BoundaryConditions();

  /// Fields that the conditions need beyond the plug-ins'. Call before the Model is made.
  static std::vector<int> fieldIds(const Deck& deck);

  void applyInitial();
  /// Sets prescribed displacements (and velocities) and values for time t in the fields' NP1, ghosts included.
  void applyPrescribed(double t);
  /// Sets the prescribed values of one scalar field alone (what a diffusion solver asks for in each stage).
  void applyPrescribedValue(const std::string& field, double t);
  /// Whether a prescribed value of this field changes with time.
  bool prescribedValueDependsOnTime(const std::string& field) const;
  /// Adds External_Force_Density (body force, traction) at time t to `forceDensity` [3 nOwned].
  void addExternalForce(double t, double* forceDensity) const;
  bool hasExternalForce() const;

  /// Turns points whose Damage exceeds the threshold into sources and sets their value. Returns how many new ones
  /// (all ranks).
  long long updateDamageSources();

  /// [3 nPoints] 1 where that displacement component is prescribed.
  const std::vector<char>& displacementIsPrescribed() const;
  /// [nPoints] 1 where the scalar field is prescribed (sources included).
  const std::vector<char>& valueIsPrescribed(const std::string& field) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pd

#endif
