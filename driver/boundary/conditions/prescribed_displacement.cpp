// Displacement at all times, along one axis.
#include "../condition.hpp"

namespace pd {

namespace {

/// u = value(x, t); where there is a Velocity, it is the mean one since the time before. In decks of Peridigm, as
/// there, u keeps its initial value at first, changes by what the value changes in a step, and is the value where that
/// is nothing.
class PrescribedDisplacement : public Condition {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declareNodeSet(declare);
    declare.function("Value", "m", "Displacement at all times.").required();
    declareCoordinate(declare);
  }
  explicit PrescribedDisplacement(const ConditionSection& section)
      : Condition(section, "Displacement", 3), addsIncrements_(section.node.isPeridigms()) {}

  std::string claim() const override { return "prescribe"; }
  bool isPrescription() const override { return true; }
  void markPrescribed(std::vector<char>& isPrescribed) const override {
    for (const int point : points()) isPrescribed[indexOf(point)] = 1;
  }

  void applyPrescribed(Model& model, double t) override {
    const bool isNewTime = wasApplied_ && t != appliedAt_;
    if (addsIncrements_) findOffsets(model, t, isNewTime);
    std::vector<double> now = evaluate(model.discretization(), t);
    for (std::size_t k = 0; k < offsets_.size(); ++k) now[k] += offsets_[k];
    write(model, now);
    if (isNewTime && model.hasField("Velocity")) {
      double* velocity = model.field("Velocity");
      for (std::size_t k = 0; k < now.size(); ++k)
        velocity[indexOf(points()[k])] = (now[k] - previous_[k]) / (timeScale() * (t - appliedAt_));
    }
    previous_ = std::move(now);
    appliedAt_ = t;
    wasApplied_ = true;
  }

  void resume(Model& model, double t, std::vector<char>&) override {
    const double* displacement = model.field(field());
    previous_.resize(points().size());
    for (std::size_t k = 0; k < previous_.size(); ++k) previous_[k] = displacement[indexOf(points()[k])];
    appliedAt_ = t;
    wasApplied_ = true;
    if (!addsIncrements_) return;
    offsets_ = evaluate(model.discretization(), t);
    for (std::size_t k = 0; k < previous_.size(); ++k) offsets_[k] = previous_[k] - offsets_[k];
  }

 private:
  std::size_t indexOf(int point) const { return 3 * static_cast<std::size_t>(point) + component(); }

  /// At first what the displacement has over the value; 0 from when the value does not change in a step.
  void findOffsets(Model& model, double t, bool isNewTime) {
    if (!wasApplied_) {
      const double* displacement = model.field(field());
      offsets_ = evaluate(model.discretization(), t);
      for (std::size_t k = 0; k < offsets_.size(); ++k) offsets_[k] = displacement[indexOf(points()[k])] - offsets_[k];
    } else if (isNewTime) {
      const std::vector<double> before = evaluate(model.discretization(), appliedAt_);
      const std::vector<double>& now = evaluate(model.discretization(), t);
      for (std::size_t k = 0; k < offsets_.size(); ++k)
        if (now[k] == before[k]) offsets_[k] = 0.0;
    }
  }

  bool addsIncrements_;
  bool wasApplied_ = false;
  double appliedAt_ = 0.0;        ///< s, time of the last call
  std::vector<double> previous_;  ///< displacements of the last call, by point of the condition
  std::vector<double> offsets_;   ///< of the displacements over the values; empty where there are none
};

}  // namespace

PD_REGISTER_CONDITION(PrescribedDisplacement, "Prescribed Displacement", "Displacement along one axis at all times")

}  // namespace pd
