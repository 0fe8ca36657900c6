#include "transport_step.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "field_names.hpp"
#include "flow_fields.hpp"

namespace pd {

TransportFields::TransportFields(Model& model, const std::string& concentrationField)
    : label(concentrationField),
      rateLabel(fluxDivergenceField(label)),
      nOwned(model.nOwned()),
      nPoints(model.nPoints()),
      concentration(model.field(label)),
      rate(model.field(rateLabel)),
      salt(model.field("Salt_Coverage")),
      dissolution(model.field("Dissolution_Rate")),
      slope(model.field("Dissolution_Rate_Slope")),
      saturation(model.field("Saturation_Concentration")),
      volume(model.field("Volume")),
      area(model.field("Interface_Area_Density")),
      limitedAt(model.field(fields::limitedAt(label).label)) {}

void TransportFields::limitHere() const { std::copy_n(concentration, nPoints, limitedAt); }

void TransportFields::coverWithSalt(const std::vector<int>& ids, double coverage) const {
  for (const int i : ids) salt[i] = coverage;
  std::fill(salt + nOwned, salt + nPoints, coverage);
}

void TransportFields::setSalt(Model& model, const std::vector<int>& ids, const std::vector<double>& coverage) const {
  for (std::size_t k = 0; k < ids.size(); ++k) salt[ids[k]] = coverage[k];
  model.importGhosts("Salt_Coverage");
}

void TransportStep::findPaused(const Fields& fields, std::vector<double>& coverage) const {
  constexpr double rounding = 1e-9;  // points that turn liquid have C_sat but for it
  coverage.resize(ids_.size());
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const int i = ids_[k];
    coverage[k] = fields.concentration[i] >= (1.0 - rounding) * fields.saturation[i] ? 1.0 : 0.0;
  }
}

void TransportStep::begin(Simulation& simulation, const Fields& fields, double end) {
  const std::vector<char>& isHeld = simulation.conditions.valueIsPrescribed(label_);
  const std::size_t n = ids_.size();
  for (auto* values : {&before_, &rate_, &inflow_}) values->resize(n);
  isUnknown_.resize(n);
  for (std::size_t k = 0; k < n; ++k) isUnknown_[k] = isHeld[static_cast<std::size_t>(ids_[k])] == 0;
  setBoundary(simulation, end);
  for (std::size_t k = 0; k < n; ++k) before_[k] = fields.concentration[ids_[k]];
}

void TransportStep::setBoundary(Simulation& simulation, double time) {
  simulation.conditions.applyPrescribedValue(label_, time);
  simulation.conditions.applyPrescribedValue(fields::filmCoverage().label, time);
  const BoundaryConditions::FarField& far = simulation.conditions.farField(label_, time);
  exchange_.assign(ids_.size(), 0.0);
  farValue_.assign(ids_.size(), 0.0);
  for (std::size_t k = 0; k < ids_.size() && !far.coefficient.empty(); ++k) {
    if (isUnknown_[k] == 0) continue;
    exchange_[k] = far.coefficient[static_cast<std::size_t>(ids_[k])];
    farValue_[k] = far.value[static_cast<std::size_t>(ids_[k])];
  }
}

bool TransportStep::solve(Simulation& simulation, const PhaseLists& lists, double t, double h) {
  Model& model = simulation.model;
  const Fields fields(model, label_);
  ids_ = lists.liquid();
  trouble_.clear();
  solidBefore_.clear();
  solidIds_ = lists.dissolving();
  for (const int i : solidIds_) solidBefore_.push_back(fields.concentration[i]);
  begin(simulation, fields, t + h);
  model.importGhosts(label_);
  fields.limitHere();
  model.importGhosts("Salt_Coverage");
  model.evaluateFluxDivergence(h, fields.rateLabel);  // takes up the phases
  if (!advance(simulation, fields, t, h)) {
    if (trouble_.empty()) trouble_ = fmt::format("a step of {:.3g} s does not converge", h);
    return false;
  }
  // A surface all under salt has no current; the material leaves that of before.
  double* current = model.field("Current_Density");
  for (const int i : ids_)
    if (fields.salt[i] >= 1.0) current[i] = 0.0;
  return true;
}

}  // namespace pd
