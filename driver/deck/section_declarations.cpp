// What the sections of a deck may hold, as far as no plug-in decides it.
#include <map>
#include <stdexcept>

#include "../../materials/kernels/rings.hpp"
#include "sections.hpp"

namespace pd {

namespace {

using Declarations = ParameterDeclarations;

void declareMeshFile(Declarations& declare) {
  declare.text("Input Mesh File", "Name of the mesh file, seen from the folder of the deck.").required();
}

void declareGenerator(Declarations& declare) {
  declare.text("Type", "As Peridigm's decks have it.").oneOf({"PdQuickGrid"});
}

void declareBox(Declarations& declare) {
  declareGenerator(declare);
  for (const char* axis : {"X", "Y", "Z"}) {
    const std::string name(axis);
    declare.real(name + " Origin", "m", "Lowest coordinate of the box.").required();
    declare.real(name + " Length", "m", "Edge of the box.").positive().required();
    declare.integer("Number Points " + name, "Cells along it; points are at their centres.").atLeast(1).required();
  }
}

void declareCylinder(Declarations& declare) {
  declareGenerator(declare);
  declare.real("Inner Radius", "m", "Radius of the hole.").atLeast(0.0).required();
  declare.real("Outer Radius", "m", "Radius of the cylinder.").positive().required();
  declare.real("Cylinder Length", "m", "Length along z.").positive().required();
  declare.integer("Number Points Radius", "Cells along the radius.").atLeast(1).required();
  declare.real("Ring Center x", "m", "Place of the axis.").required();
  declare.real("Ring Center y", "m", "Place of the axis.").required();
  declare.real("Z Origin", "m", "Lower end of the cylinder.").required();
}

void declareQuickGrid(Declarations& declare) {
  declare
      .text("NeighborhoodType",
            "Spherical: points within the horizon; Box: cells within the rounded number of cells that the horizon "
            "reaches over, along each axis (default: Spherical; Box, Peridigm's way, in decks with the root key "
            "Peridigm).")
      .oneOf({"Spherical", "Box"});
  declareBox(declare.sublist("TensorProduct3DMeshGenerator", "A box of equal cells."));
  declareCylinder(declare.sublist("TensorProductCylinderMeshGenerator",
                                  "A hollow cylinder along z; cells around and along it are as long as they are "
                                  "thick, at the mean radius."));
  declare.exactlyOneOf({"TensorProduct3DMeshGenerator", "TensorProductCylinderMeshGenerator"});
}

Declarations declareDiscretization(const std::string& type) {
  Declarations declare;
  declare
      .text("Type",
            "Form of the mesh: a text file of one point a line, \"x y z block volume\"; finite elements in an Exodus "
            "file, a point an element; or a box or cylinder of cells that the deck describes.")
      .oneOf(discretizationTypes())
      .required();
  if (type == "PdQuickGrid")
    declareQuickGrid(declare);
  else
    declareMeshFile(declare);
  declare
      .text("Influence Function",
            "Weight of a bond over its length: One, Parabolic Decay, Gaussian, or a function of zeta and horizon.")
      .defaultTo("One");
  declare.text("Omit Bonds Between Blocks", "All: no bond joins points of different blocks.")
      .oneOf({"None", "All"})
      .defaultTo("None");
  declare.flag("Include Partial Neighbors",
               "Keep pairs up to half a point spacing beyond the horizon, whose volumes lie partly within it (default: "
               "true; false in decks with the root key Peridigm).");
  declare.real("Thickness", "m", "Of a plane scene: turns volumes into areas.").positive();
  declare.real("Cross Section Area", "m2", "Of a scene along one line: turns volumes into lengths.").positive();
  declare.sublist("Bond Filters", "Surfaces that cut bonds (pre-cracks), by names of your choice.");
  declare.sublist(
      "Cracks",
      "Cracks that take a part of the bonds between cells that they meet, by names of your choice; the mesh "
      "knows nothing of them.");
  declare.sublist(
      "Voids",
      "Holes and pores that take a part of cells and bonds, by names of your choice; the mesh knows nothing "
      "of them, and they may be far smaller than its cells.");
  declareBondDecomposition(declare.sublist("Bond Decomposition", "How Cracks and Voids are brought to the bonds."));
  declare.sublist("Symmetry",
                  "Planes of symmetry, by names of your choice: the mesh is the part of the body beside one plane, or "
                  "in the corner of two or three that are perpendicular to each other.");
  declare
      .text(axisOfRevolution,
            "The mesh, in the x-y plane, is half of a section of a body of revolution about this axis (x: at y > 0; y: "
            "at x > 0). Points become rings: volumes of the mesh are areas, those of the run 2 pi r x area.")
      .oneOf({"x", "y"});
  declare.atMostOneOf({"Thickness", "Cross Section Area"});
  return declare;
}

Declarations declareSymmetryPlane() {
  Declarations declare;
  declare.reals("Point", "m", "A point of the plane, [x, y, z].").required();
  declare
      .reals(
          "Normal", "1",
          "Direction across the plane, [x, y, z], of any length and sign. Points of the mesh are on one side, half a "
          "spacing or so away from it.")
      .required();
  return declare;
}

void declareFilterType(Declarations& declare, const std::string& type) {
  declare.text("Type", "Form of the surface.").oneOf({type}).required();
  declare
      .flag("Count In Damage",
            "true: the cut bonds count as broken in Damage; false: as if they had never been (Peridigm's way).")
      .defaultTo(false);
}

void declareVector(Declarations& declare, const std::string& name, const std::string& unit,
                   const std::string& meaning) {
  for (const char* axis : {"_X", "_Y", "_Z"}) declare.real(name + axis, unit, meaning).required();
}

std::map<std::string, Declarations> declareBondFilters() {
  std::map<std::string, Declarations> filters;
  Declarations& plane = filters["Rectangular_Plane"];
  declareFilterType(plane, "Rectangular_Plane");
  declareVector(plane, "Normal", "1", "Normal of the plane.");
  declareVector(plane, "Lower_Left_Corner", "m", "A corner of the rectangle.");
  declareVector(plane, "Bottom_Unit_Vector", "1", "Direction of the bottom side, within the plane.");
  plane.real("Bottom_Length", "m", "Length of the bottom side.").positive().required();
  plane.real("Side_Length", "m", "Length of the other side.").positive().required();

  Declarations& disk = filters["Disk"];
  declareFilterType(disk, "Disk");
  declareVector(disk, "Center", "m", "Centre of the disk.");
  declareVector(disk, "Normal", "1", "Normal of the disk.");
  disk.real("Radius", "m", "Radius of the disk.").positive().required();

  Declarations& pair = filters["Node Set Pair"];
  declareFilterType(pair, "Node Set Pair");
  pair.text("First Node Set", "Points of one crack lip.").required();
  pair.text("Second Node Set", "Points of the other; every bond between the two sets is cut.").required();

  Declarations& surface = filters["Exodus Mesh"];
  declareFilterType(surface, "Exodus Mesh");
  surface.text("File Name", "Exodus file of triangles and quadrilaterals, seen from the folder of the deck.")
      .required();
  return filters;
}

const std::map<std::string, Declarations>& bondFilters() {
  static const std::map<std::string, Declarations> filters = declareBondFilters();
  return filters;
}

Declarations declareNodeSet() {
  Declarations declare;
  declare.reals("Box", "m", "Two corners, lowest first: [[x, y, z], [x, y, z]]; points within or on the box.");
  declare.function("Expression", "1", "A condition on x, y, z, such as \"x < 0.005 && y > 0\".");
  declare.exactlyOneOf({"Box", "Expression"});
  return declare;
}

Declarations declareBlock() {
  Declarations declare;
  declare.text("Block Names", "Blocks of the mesh, as in \"block_1 block_2\", or \"default\" for all others.")
      .required();
  declare
      .texts("Material",
             "Name of an entry of Materials, or a list of them: each does its own physics and adds to shared fields.")
      .orOne()
      .required();
  declare
      .texts("Damage Model",
             "Name of an entry of Damage Models, or None, or a list of names: bonds have one state, which each may "
             "only make worse.")
      .orOne()
      .defaultTo("None");
  declare.function("Horizon", "m", "Radius of the neighbourhood of a point; may depend on x, y, z.")
      .positive()
      .required();
  return declare;
}

Declarations declareOutput() {
  Declarations declare;
  declare
      .text("Output Filename",
            "Name of the result files, without extension; a path below the folder of the run (pdrun --output-folder).")
      .defaultTo("dump");
  declare.texts("Output Variables", "Fields and computes to write: a list, or Peridigm's {name: true, ...}.")
      .required();
  declare.integer("Output Frequency", "Increments from one output of fields to the next; -1: none but Output Steps.")
      .atLeast(-1)
      .defaultTo(-1);
  declare.reals("Output Steps", "1", "Numbers of further increments whose fields are written.").atLeast(0.0);
  declare
      .integer("Initial Output Step",
               "Increment before which nothing is written (default: 0, the initial state; in decks with the root "
               "key Peridigm that is output 1).")
      .atLeast(0);
  declare.integer("Final Output Step", "Increment after which nothing is written (default: none).").atLeast(0);
  declare
      .integer("History Frequency",
               "Increments from one line of the time history to the next; -1: none (default: 1; in decks with the "
               "root key Peridigm the Output Frequency).")
      .atLeast(-1);
  declare.integer("Checkpoint Frequency", "Increments from one checkpoint to the next; -1: none.")
      .atLeast(-1)
      .defaultTo(-1);
  return declare;
}

Declarations declareExactSolution() {
  Declarations declare;
  declare.text("Field", "Point field that is compared.").required();
  declare.text("Coordinate", "Component of a vector field.").oneOf({"x", "y", "z"});
  declare.function("Value", "unit of the field", "Exact value.").required();
  declare.text("Node Set", "Points that are compared (default: all).");
  return declare;
}

Declarations declareSolver() {
  Declarations declare;
  declare.real("Initial Time", "s", "Time at which this solver starts.").defaultTo(0.0);
  declare.real("Final Time", "s", "Time at which this solver ends.").required();
  declare.flag("Verbose", "Log every increment.").defaultTo(false);
  return declare;
}

}  // namespace

std::vector<std::string> discretizationTypes() { return {"Text File", "Exodus", "PdQuickGrid"}; }

const Declarations& discretizationDeclarations(const std::string& type) {
  static const std::map<std::string, Declarations> declarations = [] {
    std::map<std::string, Declarations> all;
    for (const std::string& name : discretizationTypes()) all[name] = declareDiscretization(name);
    return all;
  }();
  const auto it = declarations.find(type);
  if (it == declarations.end()) throw std::invalid_argument("unknown type of discretization \"" + type + "\"");
  return it->second;
}

std::vector<std::string> bondFilterTypes() { return {"Rectangular_Plane", "Disk", "Node Set Pair", "Exodus Mesh"}; }

const Declarations& bondFilterDeclarations(const std::string& type) {
  const auto it = bondFilters().find(type);
  if (it == bondFilters().end()) throw std::invalid_argument("unknown type of bond filter \"" + type + "\"");
  return it->second;
}

const Declarations& symmetryPlaneDeclarations() {
  static const Declarations declarations = declareSymmetryPlane();
  return declarations;
}

const Declarations& nodeSetDeclarations() {
  static const Declarations declarations = declareNodeSet();
  return declarations;
}

const Declarations& blockDeclarations() {
  static const Declarations declarations = declareBlock();
  return declarations;
}

const Declarations& outputDeclarations() {
  static const Declarations declarations = declareOutput();
  return declarations;
}

const Declarations& exactSolutionDeclarations() {
  static const Declarations declarations = declareExactSolution();
  return declarations;
}

const Declarations& solverDeclarations() {
  static const Declarations declarations = declareSolver();
  return declarations;
}

}  // namespace pd
