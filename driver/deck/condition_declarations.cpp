// What the initial and boundary conditions of a deck may hold (driver/boundary/boundary_conditions.hpp).
#include <algorithm>
#include <map>
#include <stdexcept>

#include "sections.hpp"

namespace pd {

namespace {

using Declarations = ParameterDeclarations;

void declareCommon(Declarations& declare, const std::string& unit, const std::string& valueMeaning) {
  declare.text("Type", "What the condition does.").oneOf(boundaryConditionTypes()).required();
  declare.text("Node Set", "Name of the node set it acts on.").required();
  declare.function("Value", unit, valueMeaning).required();
}

void declareCoordinate(Declarations& declare) {
  declare.text("Coordinate", "Component of the vector.").oneOf({"x", "y", "z"}).defaultTo("x");
}

void declareFieldName(Declarations& declare) {
  declare.text("Field", "Scalar point field, such as Concentration.").required();
}

std::map<std::string, Declarations> declareConditions() {
  std::map<std::string, Declarations> all;
  const auto vector = [&](const std::string& type, const std::string& unit, const std::string& meaning) {
    declareCommon(all[type], unit, meaning);
    declareCoordinate(all[type]);
  };
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
  for (const char* kind : {"Initial", "Prescribed"}) {
    const std::string prefix = std::string(kind) + " ";
    const std::string when = prefix == "Initial " ? "Value at the start." : "Value at all times.";
    declareCommon(all[prefix + "Temperature"], "K", when);
    declareCommon(all[prefix + "Concentration"], "unit of the field", when);
    declareCommon(all[prefix + "Value"], "unit of the field", when);
    declareFieldName(all[prefix + "Value"]);
  }

  Declarations& noFailure = all["No Failure"];
  noFailure.text("Type", "What the condition does.").oneOf(boundaryConditionTypes()).required();
  noFailure.text("Node Set", "Points whose bonds never break.").required();

  Declarations& faces = all["Saturated Crack Faces"];
  faces.text("Type", "What the condition does.").oneOf(boundaryConditionTypes()).required();
  faces.text("Node Set", "Points that may become sources (default: all).");
  declareFieldName(faces);
  faces.function("Value", "unit of the field", "Value that a point holds once its Damage exceeds the threshold.")
      .required();
  faces.real("Threshold", "1", "Damage above which a point becomes a source.").strictlyBetween(0.0, 1.0).required();
  return all;
}

const std::map<std::string, Declarations>& conditions() {
  static const std::map<std::string, Declarations> all = declareConditions();
  return all;
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
          "Saturated Crack Faces"};
}

const Declarations& boundaryConditionDeclarations(const std::string& type) {
  const auto it = conditions().find(type);
  if (it == conditions().end()) throw std::invalid_argument("unknown type of condition \"" + type + "\"");
  return it->second;
}

}  // namespace pd
