// An electrolyte that goes on beyond the mesh.
#include "../condition.hpp"

namespace pd {

namespace {

/// Beyond the open face behind the node set the electrolyte goes on for Distance, to where its concentration is Value:
/// in steady state the flux out of the set is Diffusivity (C - Value) / (Distance + thickness of the set), to about 0.2
/// horizons of that way. Acts through the solvers that ask for BoundaryConditions::farField().
class FarFieldConcentration : public Condition {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declareNodeSet(declare);
    declare.text("Field", "Label of the concentration, where the deck gives metal ions another one.")
        .defaultTo("Concentration");
    declare.function("Value", "mol/m3", "Concentration where the electrolyte beyond the mesh ends.").required();
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
  explicit FarFieldConcentration(const ConditionSection& section)
      : Condition(section, section.list.get<std::string>("Field"), 1),
        distance_(section.list.get<double>("Distance")),
        diffusivity_(section.list.get<double>("Diffusivity")),
        area_(section.list.get<double>("Area")) {}

  std::string obstacle(const RunContents& run) const override {
    if (run.fieldsWithFarField.count(field()) != 0) return "";
    return "no solver of this deck takes an electrolyte beyond the mesh into account for \"" + field() +
           "\", as Corrosion does for its Concentration Field; use Prescribed Concentration";
  }
  bool reachesBeyond() const override { return true; }
  void measure(const Discretization& mesh, const Communicator& comm) override {
    rate_ = exchangeRate(diffusivity_, distance_, volumeOf(points(), mesh, comm) / area_);
  }
  void addFarField(const Discretization& mesh, double t, FarField& far) const override {
    const std::vector<double>& given = evaluate(mesh, t);
    for (std::size_t k = 0; k < given.size(); ++k) {
      if (points()[k] >= mesh.nOwned) continue;
      // Where two act, to both.
      const auto i = static_cast<std::size_t>(points()[k]);
      const double sum = far.coefficient[i] + rate_;
      far.value[i] += (given[k] - far.value[i]) * rate_ / sum;
      far.coefficient[i] = sum;
    }
  }

 private:
  double distance_, diffusivity_, area_;  ///< m, m2/s, m2
  double rate_ = 0.0;                     ///< 1/s
};

}  // namespace

PD_REGISTER_CONDITION(FarFieldConcentration, "Far Field Concentration",
                      "An electrolyte that goes on beyond an open face of the mesh")

}  // namespace pd
