// What the initial and boundary conditions of a deck may hold (driver/boundary/boundary_conditions.hpp).
#include <algorithm>
#include <map>
#include <stdexcept>

#include "sections.hpp"

namespace pd {

namespace {

using Declarations = ParameterDeclarations;

class ConditionDeclarations {
 public:
  ConditionDeclarations() {
    vector("Initial Displacement", "m", "Displacement at the start.");
    vector("Initial Velocity", "m/s", "Velocity at the start.");
    vector("Prescribed Displacement", "m", "Displacement at all times.");
    vector("Body Force", "N/m3", "Force per volume.");
    vector("Traction", "N/m2", "Force per area of the loaded face.");
    all["Traction"]
        .real("Area", "m2",
              "Area of the loaded face; its points share the force Value * Area in proportion to their volumes.")
        .positive()
        .required();
    scalars("Initial ", "Value at the start.");
    scalars("Prescribed ", "Value at all times.");
    withType("No Failure").text("Node Set", "Points whose bonds never break.").required();
    saturatedCrackFaces();
    farField();
  }

  std::map<std::string, Declarations> all;

 private:
  Declarations& withType(const std::string& type) {
    all[type].text("Type", "What the condition does.").oneOf({type}).required();
    return all[type];
  }

  Declarations& withValue(const std::string& type, const std::string& unit, const std::string& meaning) {
    Declarations& declare = withType(type);
    declare.text("Node Set", "Name of the node set it acts on.").required();
    declare.function("Value", unit, meaning).required();
    return declare;
  }

  void vector(const std::string& type, const std::string& unit, const std::string& meaning) {
    withValue(type, unit, meaning).text("Coordinate", "Component of the vector.").oneOf({"x", "y", "z"}).defaultTo("x");
  }

  void scalars(const std::string& prefix, const std::string& meaning) {
    withValue(prefix + "Temperature", "K", meaning);
    withValue(prefix + "Concentration", "unit of the field", meaning);
    declareField(withValue(prefix + "Value", "unit of the field", meaning));
  }

  void saturatedCrackFaces() {
    Declarations& declare = withType("Saturated Crack Faces");
    declare.text("Node Set", "Points that may become sources (default: all).");
    declareField(declare);
    declare.function("Value", "unit of the field", "Value that a point holds once its Damage exceeds the threshold.")
        .required();
    declare.real("Threshold", "1", "Damage above which a point becomes a source.").strictlyBetween(0.0, 1.0).required();
  }

  void farField() {
    Declarations& declare =
        withValue("Far Field Concentration", "mol/m3", "Concentration where the electrolyte beyond the mesh ends.");
    declare
        .real(
            "Distance", "m",
            "From the end of the mesh to there; of an electrolyte without end in all directions the radius of the half "
            "sphere at which the mesh ends.")
        .atLeast(0.0)
        .required();
    declare.real("Diffusivity", "m2/s", "Of metal ions on the way.").positive().required();
    declare
        .real("Area", "m2",
              "Of the open face; the node set is a layer of electrolyte behind it, about a horizon thick.")
        .positive()
        .required();
  }

  static void declareField(Declarations& declare) {
    declare.text("Field", "Scalar point field, such as Concentration.").required();
  }
};

const std::map<std::string, Declarations>& conditions() {
  static const ConditionDeclarations declarations;
  return declarations.all;
}

}  // namespace

std::vector<std::string> boundaryConditionTypes() {
  return {"Initial Displacement",
          "Initial Velocity",
          "Initial Temperature",
          "Initial Concentration",
          "Initial Value",
          "Prescribed Displacement",
          "Prescribed Temperature",
          "Prescribed Concentration",
          "Prescribed Value",
          "Body Force",
          "Traction",
          "No Failure",
          "Saturated Crack Faces",
          "Far Field Concentration"};
}

const Declarations& boundaryConditionDeclarations(const std::string& type) {
  const auto it = conditions().find(type);
  if (it == conditions().end()) throw std::invalid_argument("unknown type of condition \"" + type + "\"");
  return it->second;
}

}  // namespace pd
