// What a deck may say of cracks and voids that the points of its mesh do not resolve.
#include <map>
#include <stdexcept>

#include "sections.hpp"

namespace pd {

namespace {

using Declarations = ParameterDeclarations;

Declarations typed(const std::string& type) {
  Declarations declare;
  declare.text("Type", "Form of the discontinuity.").oneOf({type}).required();
  return declare;
}

std::map<std::string, Declarations> declareCracks() {
  std::map<std::string, Declarations> cracks;
  Declarations& line = cracks["Polyline"] = typed("Polyline");
  line.reals("Points", "m",
             "In a plane: x and y of each of its points in turn, [x1, y1, x2, y2 ...], two points or more.")
      .required();
  Declarations& polygon = cracks["Polygon"] = typed("Polygon");
  polygon
      .reals("Corners", "m",
             "In space: x, y and z of the corners of a flat, convex polygon in turn, three corners or more.")
      .required();
  Declarations& disk = cracks["Disk"] = typed("Disk");
  disk.reals("Center", "m", "In space: centre of a round crack, [x, y, z].").required();
  disk.reals("Normal", "1", "Direction across it, [x, y, z], of any length.").required();
  disk.real("Radius", "m", "Radius of the crack.").positive().required();
  return cracks;
}

std::map<std::string, Declarations> declareVoids() {
  std::map<std::string, Declarations> voids;
  Declarations& circle = voids["Circle"] = typed("Circle");
  circle.reals("Center", "m", "In a plane: centre of the hole, [x, y].").required();
  circle.real("Radius", "m", "Radius of the hole.").positive().required();
  Declarations& ellipse = voids["Ellipse"] = typed("Ellipse");
  ellipse.reals("Center", "m", "In a plane: centre of the hole, [x, y].").required();
  ellipse.reals("Half Axes", "m", "Its half axes, [a, b].").required();
  ellipse.real("Angle", "rad", "From x to the first axis; 30 deg is read, too.").defaultTo(0.0);
  Declarations& polygon = voids["Polygon"] = typed("Polygon");
  polygon
      .reals("Corners", "m",
             "In a plane: x and y of the corners in turn, three corners or more; convex or not, without crossings.")
      .required();
  Declarations& polygons = voids["Polygon List"] = typed("Polygon List");
  polygons
      .text(
          "File Name",
          "In a plane: text file with the corners of one hole or more, a line \"polygon x y\" each (m), seen from the "
          "folder of the deck; `pdmesh outline` makes it of an image.")
      .required();
  Declarations& sphere = voids["Sphere"] = typed("Sphere");
  sphere.reals("Center", "m", "In space: centre of the pore, [x, y, z].").required();
  sphere.real("Radius", "m", "Radius of the pore.").positive().required();
  Declarations& ellipsoid = voids["Ellipsoid"] = typed("Ellipsoid");
  ellipsoid.reals("Center", "m", "In space: centre of the pore, [x, y, z].").required();
  ellipsoid.reals("Half Axes", "m", "Its half axes, [a, b, c].").required();
  ellipsoid.reals("First Axis", "1", "Direction of the first of them, [x, y, z], of any length (default: x).");
  ellipsoid.reals(
      "Second Axis", "1",
      "Direction of the second, of which what is across the first counts (default: y). The third is across both.");
  ellipsoid.needs("First Axis", {"Second Axis"});
  ellipsoid.needs("Second Axis", {"First Axis"});
  Declarations& cylinder = voids["Cylinder"] = typed("Cylinder");
  cylinder.reals("Center", "m", "In space: a point of the axis of a hole through the whole body, [x, y, z].")
      .required();
  cylinder.reals("Axis", "1", "Direction of the axis, [x, y, z], of any length.").required();
  cylinder.real("Radius", "m", "Radius of the hole.").positive().required();
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
  static const std::map<std::string, Declarations> declarations = declareCracks();
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

void declareBondDecomposition(Declarations& declare) {
  declare
      .text(
          "Rule",
          "Adaptive: the share of connections between two cells that meet no crack and no void, in a plane by "
          "lines through both, as many as it takes to know it to about Tolerance; in space by 64 lines of one as seen "
          "from 512 places of the other. "
          "Uniform: the same by all pairs of Partitions^D middles of equal parts of each cell. For comparison, cells "
          "and bonds keep all or nothing: Intersection cuts bonds where the line between their points meets a crack or "
          "void; Both and Either do so too, but cut bonds that cross the line of a crack in a plane where both of "
          "their ends are beside the crack, or one of them.")
      .oneOf({"Adaptive", "Uniform", "Intersection", "Both", "Either"})
      .defaultTo("Adaptive")
      .from("Liu & Bao, Aerospace 9 (2022) 641, sections 2.3.1 and 3.1");
  declare.real("Tolerance", "1", "Of the share of a bond that is left, by the rule Adaptive in a plane.")
      .between(1e-6, 0.1)
      .defaultTo(1e-3);
  declare
      .integer(
          "Partitions",
          "Parts of a cell along each of its edges, by the rule Uniform: work goes as their third power in a plane, "
          "as their fifth in space.")
      .between(1, 64)
      .defaultTo(20);
  declare
      .flag("Cracks Count In Damage",
            "true: what Cracks take of a point's bonds counts as broken in its Damage; false: as if it had never been. "
            "What Voids take never counts.")
      .defaultTo(true);
}

Declarations bondDecompositionDeclarations() {
  Declarations declare;
  declareBondDecomposition(declare);
  return declare;
}

}  // namespace pd
