// Initial and boundary conditions of a deck.
#ifndef PD_BOUNDARY_CONDITIONS_HPP
#define PD_BOUNDARY_CONDITIONS_HPP

#include <memory>
#include <string>
#include <vector>

#include "../deck/deck.hpp"
#include "../model/model.hpp"

namespace pd {

/// The entries of section Boundary Conditions that are no node sets. Value: a number, a function of x, y, z
/// (reference place, m) and t (s), or a table in time. Types:
///  - Initial Displacement, Initial Velocity {Node Set, Coordinate, Value}
///  - Initial Value {Node Set, Field, Value}; Initial Temperature and Initial Concentration with the field fixed
///  - Prescribed Displacement {Node Set, Coordinate, Value}: u = value(x, t). In decks of Peridigm, as there, u
///    keeps its initial value at first, changes by what the value changes in a step, and is the value where that is
///    nothing
///  - Prescribed Value {Node Set, Field, Value}; Prescribed Temperature and Prescribed Concentration
///  - Body Force {Node Set, Coordinate, Value}: force density, N/m3
///  - Traction {Node Set, Coordinate, Value, Area}: force per area, N/m2, on a face of `Area` m2, whose force is
///    carried by the points of the set in proportion to their volumes: force density = value * Area / (volume of the
///    set). A constant traction thus gives the total force value * Area whatever the mesh and the depth of the set.
///  - No Failure {Node Set}: sets the field No_Failure, whose bonds damage models leave alone
///  - Saturated Crack Faces {Field, Value, Threshold, Node Set (default: all points)}: points whose Damage exceeds
///    Threshold hold Value from then on. They are marked by 1 in the field <Field>_Source.
///  - Far Field Concentration {Node Set, Value, Distance, Diffusivity, Area}: the electrolyte goes on beyond the open
///    face of `Area` m2 behind the node set, for `Distance` m, to where its concentration is Value: in steady state the
///    flux out of the set is Diffusivity (C - Value) / (Distance + thickness of the set), to about 0.2 horizons of that
///    way. Acts through the solvers that ask for farField().
class BoundaryConditions {
 public:
  /// Allocates the fields that the conditions need in `model`. Throws DeckError naming both conditions where two of
  /// them prescribe one degree of freedom differently (in Peridigm's decks the later one holds, as there), or where a
  /// condition acts on a field that nothing in the run uses. Collective.
  BoundaryConditions(const Deck& deck, Model& model);
  ~BoundaryConditions();

  /// Initial displacements, velocities and values; ghosts included.
  void applyInitial();
  /// Sets prescribed displacements and values for time t in the fields' NP1, ghosts included, and, where there is a
  /// Velocity, the mean velocity of prescribed displacements since the time of the last call.
  void applyPrescribed(double t);
  /// Sets the prescribed values of one scalar field alone (what a diffusion solver asks for in each stage).
  void applyPrescribedValue(const std::string& field, double t);
  /// What is beyond the mesh: a rate coefficient_i (value_i - field_i) at owned point i.
  struct FarField {
    std::vector<double> coefficient;  ///< [nOwned] 1/s, 0 where there is nothing; empty without any such condition
    std::vector<double> value;        ///< [nOwned] in the unit of the field
  };
  /// Of a scalar field at time t; valid until the next call.
  const FarField& farField(const std::string& field, double t);
  /// Whether a prescribed value of this field changes with time.
  bool prescribedValueDependsOnTime(const std::string& field) const;
  /// Adds External_Force_Density (body force, traction) at time t to `forceDensity` [3 nOwned].
  void addExternalForce(double t, double* forceDensity) const;
  bool hasExternalForce() const;

  /// Turns points whose Damage exceeds the threshold into sources and sets their value (at the time last applied).
  /// Returns how many new ones (all ranks). Damage of ghosts must be up to date (Model::evaluateDamage does it).
  long long updateDamageSources();

  /// Takes up sources and displacements from fields that a restart at time t has filled.
  void resume(double t);

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
