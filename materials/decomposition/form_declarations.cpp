// What may be said of forms of cracks and voids, and of the rule by which they are brought to bonds.
#include "discontinuity_forms.hpp"

namespace pd::decomposition {

namespace {

using Forms = std::map<std::string, FormType>;

ParameterDeclarations& addForm(Forms& forms, const std::string& type, int dimension) {
  FormType& form = forms[type];
  form.dimension = dimension;
  declareType(form.declarations, type);
  return form.declarations;
}

Forms declareCracks() {
  Forms cracks;
  ParameterDeclarations& line = addForm(cracks, "Polyline", 2);
  line.reals("Points", "m",
             "In a plane: x and y of each of its points in turn, [x1, y1, x2, y2 ...], two points or more.")
      .required();
  ParameterDeclarations& polygon = addForm(cracks, "Polygon", 3);
  polygon
      .reals("Corners", "m",
             "In space: x, y and z of the corners of a flat, convex polygon in turn, three corners or more.")
      .required();
  ParameterDeclarations& disk = addForm(cracks, "Disk", 3);
  disk.reals("Center", "m", "In space: centre of a round crack, [x, y, z].").required();
  disk.reals("Normal", "1", "Direction across it, [x, y, z], of any length.").required();
  disk.real("Radius", "m", "Radius of the crack.").positive().required();
  return cracks;
}

Forms declareVoids() {
  Forms voids;
  ParameterDeclarations& circle = addForm(voids, "Circle", 2);
  circle.reals("Center", "m", "In a plane: centre of the hole, [x, y].").required();
  circle.real("Radius", "m", "Radius of the hole.").positive().required();
  ParameterDeclarations& ellipse = addForm(voids, "Ellipse", 2);
  ellipse.reals("Center", "m", "In a plane: centre of the hole, [x, y].").required();
  ellipse.reals("Half Axes", "m", "Its half axes, [a, b].").required();
  constexpr double fullTurn = 6.2831853071795864769;  // what is more was meant in degrees
  ellipse.real("Angle", "rad", "From x to the first axis; 30 deg is read, too.")
      .between(-fullTurn, fullTurn)
      .defaultTo(0.0);
  ParameterDeclarations& polygon = addForm(voids, "Polygon", 2);
  polygon
      .reals("Corners", "m",
             "In a plane: x and y of the corners in turn, three corners or more; convex or not, without crossings.")
      .required();
  ParameterDeclarations& sphere = addForm(voids, "Sphere", 3);
  sphere.reals("Center", "m", "In space: centre of the pore, [x, y, z].").required();
  sphere.real("Radius", "m", "Radius of the pore.").positive().required();
  ParameterDeclarations& ellipsoid = addForm(voids, "Ellipsoid", 3);
  ellipsoid.reals("Center", "m", "In space: centre of the pore, [x, y, z].").required();
  ellipsoid.reals("Half Axes", "m", "Its half axes, [a, b, c].").required();
  ellipsoid.reals("First Axis", "1", "Direction of the first of them, [x, y, z], of any length (default: x).");
  ellipsoid.reals(
      "Second Axis", "1",
      "Direction of the second, of which what is across the first counts (default: y). The third is across both.");
  ellipsoid.needs("First Axis", {"Second Axis"});
  ellipsoid.needs("Second Axis", {"First Axis"});
  ParameterDeclarations& cylinder = addForm(voids, "Cylinder", 3);
  cylinder.reals("Center", "m", "In space: a point of the axis of a hole through the whole body, [x, y, z].")
      .required();
  cylinder.reals("Axis", "1", "Direction of the axis, [x, y, z], of any length.").required();
  cylinder.real("Radius", "m", "Radius of the hole.").positive().required();
  return voids;
}

}  // namespace

void declareType(ParameterDeclarations& declare, const std::string& type) {
  declare.text("Type", "Form of the discontinuity.").oneOf({type}).required();
}

const Forms& crackForms() {
  static const Forms forms = declareCracks();
  return forms;
}

const Forms& voidForms() {
  static const Forms forms = declareVoids();
  return forms;
}

void declareRule(ParameterDeclarations& declare) {
  declare
      .text(
          "Rule",
          "Adaptive: the share of connections between two cells that meet no crack and no void, in a plane by "
          "lines through both, in space by lines of one as seen from places of the other, as many as it takes to know "
          "it to about Tolerance, 8192 places at most, which pores smaller than a cell may need more of. "
          "Uniform: the same by all pairs of Partitions^D middles of equal parts of each cell. For comparison, cells "
          "and bonds keep all or nothing: Intersection cuts bonds where the line between their points meets a crack or "
          "void; Both and Either do so too, but cut bonds that cross the line of a crack in a plane where both of "
          "their ends are beside the crack, or one of them.")
      .oneOf({"Adaptive", "Uniform", "Intersection", "Both", "Either"})
      .defaultTo("Adaptive")
      .from("Liu & Bao, Aerospace 9 (2022) 641, sections 2.3.1 and 3.1");
  declare.real("Tolerance", "1", "Of the share of a bond that is left, by the rule Adaptive.")
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

DecompositionRule ruleFrom(const Teuchos::ParameterList& params) {
  using Kind = DecompositionRule::Kind;
  static const std::map<std::string, Kind> kinds{{"Adaptive", Kind::Adaptive},
                                                 {"Uniform", Kind::Uniform},
                                                 {"Intersection", Kind::Intersection},
                                                 {"Both", Kind::Both},
                                                 {"Either", Kind::Either}};
  DecompositionRule rule;
  if (params.isParameter("Rule")) rule.kind = kinds.at(params.get<std::string>("Rule"));
  if (params.isParameter("Tolerance")) rule.tolerance = params.get<double>("Tolerance");
  if (params.isParameter("Partitions")) rule.partitions = params.get<int>("Partitions");
  return rule;
}

}  // namespace pd::decomposition
