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
    const bool isNewTime = last_.wasApplied && t != last_.time;
    if (addsIncrements_) findOffsets(model, t, isNewTime);
    std::vector<double> now = evaluate(model.discretization(), t);
    for (std::size_t k = 0; k < last_.offsets.size(); ++k) now[k] += last_.offsets[k];
    write(model, now);
    if (isNewTime && model.hasField("Velocity")) {
      double* velocity = model.field("Velocity");
      for (std::size_t k = 0; k < now.size(); ++k)
        velocity[indexOf(points()[k])] = (now[k] - last_.values[k]) / (timeScale() * (t - last_.time));
    }
    last_.values = std::move(now);
    last_.time = t;
    last_.wasApplied = true;
  }

  void beginStep() override { beforeStep_ = last_; }
  void takeBackStep(Model&, std::vector<char>&) override { last_ = beforeStep_; }

  void resume(Model& model, double t, std::vector<char>&) override {
    const double* displacement = model.field(field());
    last_.values.resize(points().size());
    for (std::size_t k = 0; k < last_.values.size(); ++k) last_.values[k] = displacement[indexOf(points()[k])];
    last_.time = t;
    last_.wasApplied = true;
    if (!addsIncrements_) return;
    last_.offsets = evaluate(model.discretization(), t);
    for (std::size_t k = 0; k < last_.values.size(); ++k) last_.offsets[k] = last_.values[k] - last_.offsets[k];
  }

 private:
  /// The last call of applyPrescribed().
  struct Applied {
    bool wasApplied = false;
    double time = 0.0;            ///< s
    std::vector<double> values;   ///< displacements, by point of the condition
    std::vector<double> offsets;  ///< of the displacements over the values; empty where there are none
  };

  std::size_t indexOf(int point) const { return 3 * static_cast<std::size_t>(point) + component(); }

  /// At first what the displacement has over the value; 0 from when the value does not change in a step.
  void findOffsets(Model& model, double t, bool isNewTime) {
    std::vector<double>& offsets = last_.offsets;
    if (!last_.wasApplied) {
      const double* displacement = model.field(field());
      offsets = evaluate(model.discretization(), t);
      for (std::size_t k = 0; k < offsets.size(); ++k) offsets[k] = displacement[indexOf(points()[k])] - offsets[k];
    } else if (isNewTime) {
      const std::vector<double> before = evaluate(model.discretization(), last_.time);
      const std::vector<double>& now = evaluate(model.discretization(), t);
      for (std::size_t k = 0; k < offsets.size(); ++k)
        if (now[k] == before[k]) offsets[k] = 0.0;
    }
  }

  bool addsIncrements_;
  Applied last_, beforeStep_;
};

}  // namespace

PD_REGISTER_CONDITION(PrescribedDisplacement, "Prescribed Displacement", "Displacement along one axis at all times")

}  // namespace pd
