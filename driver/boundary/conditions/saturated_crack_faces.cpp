// Crack faces that an environment keeps saturated.
#include "../condition.hpp"
#include "Peridigm_Field.hpp"

namespace pd {

namespace {

/// A point whose Damage has exceeded a threshold holds a value from then on, unless something else prescribes it. Such
/// points are marked by 1 in the field <Field>_Source.
class SaturatedCrackFaces : public Condition {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declare.text("Node Set", "Points that may become sources (default: all).");
    declareField(declare);
    declare.function("Value", "unit of the field", "Value that a point holds once its Damage exceeds the threshold.")
        .required();
    declare.real("Threshold", "1", "Damage above which a point becomes a source.").strictlyBetween(0.0, 1.0).required();
  }
  explicit SaturatedCrackFaces(const ConditionSection& section)
      : Condition(section, section.list.get<std::string>("Field"), 1),
        threshold_(section.list.get<double>("Threshold")) {}

  std::vector<int> fieldIds() const override {
    using namespace PeridigmNS::PeridigmField;
    return {PeridigmNS::FieldManager::self().getFieldId(NODE, SCALAR, CONSTANT, sourceField())};
  }
  std::string obstacle(const RunContents& run) const override {
    return run.hasDamageModel ? "" : "no block has a Damage Model";
  }
  std::string claim() const override { return "hold cracked points at"; }
  bool isPrescription() const override { return true; }
  bool followsDamage() const override { return true; }

  void applyPrescribed(Model& model, double t) override {
    if (sources_.empty()) return;
    const std::vector<double>& given = evaluate(model.discretization(), t);
    double* values = model.field(field());
    for (const std::size_t k : sources_) values[points()[k]] = given[k];
    model.fillImages(field());
  }

  long long damageHasChanged(Model& model, double t, std::vector<char>& isPrescribed) override {
    const double* damage = model.field("Damage");
    double* isSource = model.field(sourceField());
    long long nNew = 0;
    for (std::size_t k = 0; k < points().size(); ++k) {
      const int point = points()[k];
      if (damage[point] <= threshold_ || isPrescribed[static_cast<std::size_t>(point)] != 0) continue;
      isSource[point] = 1.0;
      add(k, isPrescribed);
      if (point < model.nOwned()) ++nNew;
    }
    applyPrescribed(model, t);
    return nNew;
  }

  void beginStep() override { nBeforeStep_ = sources_.size(); }

  void takeBackStep(Model& model, std::vector<char>& isPrescribed) override {
    double* isSource = model.field(sourceField());
    for (std::size_t s = nBeforeStep_; s < sources_.size(); ++s) {
      const int point = points()[sources_[s]];
      isSource[point] = 0.0;
      isPrescribed[static_cast<std::size_t>(point)] = 0;
    }
    sources_.resize(nBeforeStep_);
  }

  void resume(Model& model, double, std::vector<char>& isPrescribed) override {
    const double* isSource = model.field(sourceField());
    sources_.clear();
    for (std::size_t k = 0; k < points().size(); ++k) {
      const int point = points()[k];
      if (isSource[point] != 0.0 && isPrescribed[static_cast<std::size_t>(point)] == 0) add(k, isPrescribed);
    }
  }

 private:
  std::string sourceField() const { return field() + "_Source"; }
  void add(std::size_t k, std::vector<char>& isPrescribed) {
    sources_.push_back(k);
    isPrescribed[static_cast<std::size_t>(points()[k])] = 1;
  }

  double threshold_;                  ///< of Damage
  std::vector<std::size_t> sources_;  ///< which of points() are sources, in the order in which they became so
  std::size_t nBeforeStep_ = 0;
};

}  // namespace

PD_REGISTER_CONDITION(SaturatedCrackFaces, "Saturated Crack Faces",
                      "Points that hold a value of a scalar field once they are damaged")

}  // namespace pd
