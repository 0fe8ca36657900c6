#include "condition.hpp"

#include <numeric>

#include "../discretization/node_sets.hpp"

namespace pd {

Condition::Condition(const ConditionSection& section, std::string field, int width)
    : name_(section.name), field_(std::move(field)), node_(section.node), width_(width) {
  if (width_ == 3 && section.list.isParameter("Coordinate"))
    component_ = static_cast<int>(std::string("xyz").find(section.list.get<std::string>("Coordinate")));
  if (node_["Value"]) value_ = Function::fromDeck(node_["Value"]);
}

void Condition::findPoints(const Discretization& mesh) {
  const DeckNode setNode = node_["Node Set"];
  if (!setNode) {
    points_.resize(static_cast<std::size_t>(mesh.firstImage()));
    std::iota(points_.begin(), points_.end(), 0);
    return;
  }
  if (const std::vector<int>* points = findNodeSet(mesh.nodeSets, setNode.text())) {
    points_ = *points;
    return;
  }
  std::vector<std::string> known;
  for (const auto& entry : mesh.nodeSets) known.push_back(entry.first);
  throw DeckError(setNode.place() + ": no node set \"" + setNode.text() +
                  "\" (node sets: " + (known.empty() ? "none" : quotedList(known)) + ")");
}

void Condition::requireMotionAlong(int axis, const Discretization& mesh) const {
  // Peridigm's points move along all axes, so that its decks may well say what they do out of the plane.
  if (axis < mesh.dimension || node().isPeridigms()) return;
  throw DeckError(
      node().keyPlace() + ": " + title() + " acts along " + "xyz"[axis] + ", but the points of this mesh " +
      (mesh.dimension == 2 ? "are in one plane and move along x and y" : "are on one line and move along x") +
      " alone");
}

const std::vector<double>& Condition::evaluate(const Discretization& mesh, double t) const {
  if (!values_.empty() && (!value_.dependsOnTime() || t == evaluatedAt_)) return values_;
  values_.resize(points_.size());
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const auto point = static_cast<std::size_t>(points_[k]);
    values_[k] = value_.at(mesh.x.data() + 3 * point, t, mesh.globalIds[point]);
  }
  evaluatedAt_ = t;
  return values_;
}

void Condition::write(Model& model, const std::vector<double>& values) const {
  double* field = model.field(field_);
  for (std::size_t k = 0; k < values.size(); ++k) field[width_ * points_[k] + component_] = values[k];
  model.fillImages(field_);
}

void declareNodeSet(ParameterDeclarations& declare) {
  declare.text("Node Set", "Name of the node set it acts on.").required();
}

void declareCoordinate(ParameterDeclarations& declare) {
  declare.text("Coordinate", "Component of the vector.").oneOf({"x", "y", "z"}).defaultTo("x");
}

void declareField(ParameterDeclarations& declare) {
  declare.text("Field", "Scalar point field, such as Concentration.").required();
}

double volumeOf(const std::vector<int>& points, const Discretization& mesh, const Communicator& comm) {
  double volume = 0.0;
  for (const int point : points)
    if (point < mesh.nOwned) volume += mesh.volume[static_cast<std::size_t>(point)];
  return comm.sum(volume);
}

}  // namespace pd
