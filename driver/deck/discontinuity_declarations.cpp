// What a deck may say of cracks and voids that the points of its mesh do not resolve.
#include <map>
#include <stdexcept>

#include "discontinuity_forms.hpp"
#include "sections.hpp"

namespace pd {

namespace {

using Declarations = ParameterDeclarations;

Declarations typed(const std::string& type) {
  Declarations declare;
  decomposition::declareType(declare, type);
  return declare;
}

std::map<std::string, Declarations> plain(const std::map<std::string, decomposition::FormType>& forms) {
  std::map<std::string, Declarations> all;
  for (const auto& [type, form] : forms) all[type] = form.declarations;
  return all;
}

std::map<std::string, Declarations> declareVoids() {
  std::map<std::string, Declarations> voids = plain(decomposition::voidForms());
  Declarations& polygons = voids["Polygon List"] = typed("Polygon List");
  polygons
      .text(
          "File Name",
          "In a plane: text file with the corners of one hole or more, a line \"polygon x y\" each (m), seen from the "
          "folder of the deck; `pdmesh outline` makes it of an image.")
      .required();
  Declarations& spheres = voids["Sphere List"] = typed("Sphere List");
  spheres
      .text("File Name",
            "In space: text file of pores, a line \"x y z radius\" each (m), seen from the folder of the deck.")
      .required();
  Declarations& surface = voids["Surface"] = typed("Surface");
  surface
      .text("File Name",
            "In space: STL file, in text or binary, of one closed surface or more, seen from the folder of the deck. "
            "Corners of triangles follow each other against the clock as seen from outside of the pore.")
      .required();
  surface.real("Scale", "1", "Factor on its coordinates: 1e-3 where they are in mm.").positive().defaultTo(1.0);
  surface.reals("Shift", "m", "Added to them after that, [x, y, z] (default: 0).");
  return voids;
}

const std::map<std::string, Declarations>& cracks() {
  static const std::map<std::string, Declarations> declarations = plain(decomposition::crackForms());
  return declarations;
}

const std::map<std::string, Declarations>& voids() {
  static const std::map<std::string, Declarations> declarations = declareVoids();
  return declarations;
}

const Declarations& found(const std::map<std::string, Declarations>& all, const std::string& what,
                          const std::string& type) {
  const auto it = all.find(type);
  if (it == all.end()) throw std::invalid_argument("unknown type of " + what + " \"" + type + "\"");
  return it->second;
}

std::vector<std::string> typeNames(const std::map<std::string, Declarations>& all) {
  std::vector<std::string> types;
  for (const auto& entry : all) types.push_back(entry.first);
  return types;
}

}  // namespace

std::vector<std::string> crackTypes() { return typeNames(cracks()); }
std::vector<std::string> voidTypes() { return typeNames(voids()); }
const Declarations& crackDeclarations(const std::string& type) { return found(cracks(), "crack", type); }
const Declarations& voidDeclarations(const std::string& type) { return found(voids(), "void", type); }

void declareBondDecomposition(Declarations& declare) { decomposition::declareRule(declare); }

Declarations bondDecompositionDeclarations() {
  Declarations declare;
  declareBondDecomposition(declare);
  return declare;
}

}  // namespace pd
