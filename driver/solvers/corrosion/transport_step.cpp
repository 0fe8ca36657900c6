#include "transport_step.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "field_names.hpp"

namespace pd {

TransportStep::Fields::Fields(Model& model)
    : nOwned(model.nOwned()),
      nPoints(model.nPoints()),
      concentration(model.field("Concentration")),
      rate(model.field(fluxDivergenceField("Concentration"))),
      salt(model.field("Salt_Coverage")),
      dissolution(model.field("Dissolution_Rate")),
      slope(model.field("Dissolution_Rate_Slope")),
      saturation(model.field("Saturation_Concentration")),
      volume(model.field("Volume")),
      area(model.field("Interface_Area_Density")) {}

void TransportStep::coverWithSalt(const Fields& fields, double coverage) const {
  for (const int i : ids_) fields.salt[i] = coverage;
  std::fill(fields.salt + fields.nOwned, fields.salt + fields.nPoints, coverage);
}

void TransportStep::findPaused(const Fields& fields, std::vector<double>& coverage) const {
  constexpr double rounding = 1e-9;  // points that turn liquid have C_sat but for it
  coverage.resize(ids_.size());
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const int i = ids_[k];
    coverage[k] = fields.concentration[i] >= (1.0 - rounding) * fields.saturation[i] ? 1.0 : 0.0;
  }
}

void TransportStep::setSalt(Model& model, const Fields& fields, const std::vector<double>& coverage) const {
  for (std::size_t k = 0; k < ids_.size(); ++k) fields.salt[ids_[k]] = coverage[k];
  model.importGhosts("Salt_Coverage");
}

void TransportStep::begin(Simulation& simulation, const Fields& fields, double end) {
  const std::vector<char>& isHeld = simulation.conditions.valueIsPrescribed("Concentration");
  const BoundaryConditions::FarField& far = simulation.conditions.farField("Concentration", end);
  const std::size_t n = ids_.size();
  for (auto* values : {&before_, &saltBefore_, &rate_, &inflow_}) values->resize(n);
  exchange_.assign(n, 0.0);
  farValue_.assign(n, 0.0);
  isUnknown_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const int i = ids_[k];
    before_[k] = fields.concentration[i];
    saltBefore_[k] = fields.salt[i];
    isUnknown_[k] = isHeld[static_cast<std::size_t>(i)] == 0;
    if (isUnknown_[k] == 0 || far.coefficient.empty()) continue;
    exchange_[k] = far.coefficient[static_cast<std::size_t>(i)];
    farValue_[k] = far.value[static_cast<std::size_t>(i)];
  }
}

void TransportStep::takeBack(Model& model) const {
  double* concentration = model.field("Concentration");
  double* salt = model.field("Salt_Coverage");
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    concentration[ids_[k]] = before_[k];
    salt[ids_[k]] = saltBefore_[k];
  }
  for (std::size_t k = 0; k < solidBefore_.size(); ++k) concentration[solidIds_[k]] = solidBefore_[k];
  model.importGhosts("Concentration");
}

bool TransportStep::solve(Simulation& simulation, const PhaseLists& lists, double t, double h) {
  Model& model = simulation.model;
  const Fields fields(model);
  ids_ = lists.liquid();
  trouble_.clear();
  solidBefore_.clear();
  solidIds_ = lists.dissolving();
  for (const int i : solidIds_) solidBefore_.push_back(fields.concentration[i]);
  begin(simulation, fields, t + h);
  model.evaluateFluxDivergence(h, fluxDivergenceField("Concentration"));  // takes up the phases
  if (!advance(model, fields, h)) {
    if (trouble_.empty()) trouble_ = fmt::format("a step of {:.3g} s does not converge", h);
    takeBack(model);
    return false;
  }
  // A surface all under salt has no current; the material leaves that of before.
  double* current = model.field("Current_Density");
  for (const int i : ids_)
    if (fields.salt[i] >= 1.0) current[i] = 0.0;
  return true;
}

}  // namespace pd
