// Films over metal that dissolves.
#include "../condition.hpp"

namespace pd {

namespace {

/// Of the surface near the points of the electrolyte in the node set. Acts in blocks of Corrosion Dissolution, by
/// solvers that ask for prescribed values of Film_Coverage.
class FilmCoverage : public Condition {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declare
        .text("Node Set",
              "Name of a node set with points of the electrolyte: the film is on the surface beside them. At its "
              "points of "
              "metal it acts once they have dissolved.")
        .required();
    declare
        .function("Value", "1",
                  "Share of the surface that the film keeps from dissolving, 0 to 1, of place and time: a film that "
                  "grows, such as \"0.9*(1 - exp(-t/3600))\" or \"1 - 1/(1 + sqrt(t/600))\", or one that breaks up, "
                  "\"exp(-t/3600)\".")
        .required();
  }
  explicit FilmCoverage(const ConditionSection& section) : Condition(section, fields::filmCoverage().label, 1) {}

  std::string claim() const override { return "prescribe"; }
  std::string obstacle(const RunContents& run) const override {
    return run.solverFields.count("Salt_Coverage") != 0 ? ""
                                                        : "no solver of this deck dissolves metal, as Corrosion does";
  }
  bool isPrescription() const override { return true; }
  void markPrescribed(std::vector<char>& isPrescribed) const override {
    for (const int point : points()) isPrescribed[static_cast<std::size_t>(point)] = 1;
  }
  void applyPrescribed(Model& model, double t) override {
    const std::vector<double>& coverage = evaluate(model.discretization(), t);
    for (std::size_t k = 0; k < coverage.size(); ++k)
      if (!(coverage[k] >= 0.0 && coverage[k] <= 1.0))
        throw DeckError(node()["Value"].place() + ": " + node()["Value"].path() + " is " + std::to_string(coverage[k]) +
                        " at t = " + std::to_string(t) + " s; a share lies between 0 and 1");
    write(model, coverage);
  }
};

}  // namespace

PD_REGISTER_CONDITION(FilmCoverage, "Film Coverage", "A film that keeps metal from dissolving")

}  // namespace pd
