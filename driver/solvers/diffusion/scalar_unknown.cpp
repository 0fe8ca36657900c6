#include "scalar_unknown.hpp"

#include <algorithm>
#include <cmath>

#include "../../model/rates.hpp"
#include "asymmetric_rate.hpp"
#include "flow_fields.hpp"

namespace pd {

double assembleFluxMatrix(Model& model, const std::string& field, double dt, double factor, bool addsVolumes,
                          const std::vector<char>& isHeld, std::unique_ptr<LinearSystem>& system) {
  if (!system) system = std::make_unique<LinearSystem>(model.comm(), model.discretization(), 1, false);
  system->putScalar(0.0);
  {
    const ScalarUnknown unknown(field);
    model.assembleJacobian(dt, *system);
  }
  const Timers::Scope timer(model.timers(), "matrix assembly");
  system->scale(factor);
  const double* volume = model.field("Volume");
  for (int i = 0; addsVolumes && i < model.nOwned(); ++i) system->addToDiagonal(i, 0, volume[i]);
  system->finish(isHeld);
  std::vector<double> diagonal = system->diagonal();
  for (std::size_t i = 0; i < diagonal.size(); ++i)
    if (isHeld[i]) diagonal[i] = 0.0;
  return normOverRanks(model.comm(), diagonal);
}

double normOverRanks(const Communicator& comm, const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(comm.sum(sum));
}

void requireFluxDivergence(Model& model, const std::string& field, const std::string& solver) {
  const std::vector<std::string> given = fieldsWithRates(*model.blocks());
  if (std::find(given.begin(), given.end(), field) == given.end())
    throw RunError(solver + ": no material of this run gives a flux divergence of \"" + field +
                   "\"; give a block a material that diffuses it, or name another Field");
}

bool rateIsAsymmetric(Model& model, const std::string& field) {
  return std::any_of(model.blocks()->begin(), model.blocks()->end(), [&](PeridigmNS::Block& block) {
    const auto* rate = dynamic_cast<const AsymmetricRate*>(block.getMaterialModel().get());
    return rate != nullptr && rate->isAsymmetric(field);
  });
}

void requireFlow(Model& model, const std::string& field, const std::string& solver) {
  if (!rateIsAsymmetric(model, field)) return;
  const int opening = fields::bondOpening().id();
  bool isFound = false;
  for (PeridigmNS::Block& block : *model.blocks()) {
    if (!block.hasData(opening, PeridigmNS::PeridigmField::STEP_NONE)) continue;
    const auto data = block.getData(opening, PeridigmNS::PeridigmField::STEP_NONE);
    double* values = nullptr;
    data->ExtractView(&values);
    isFound = isFound || std::any_of(values, values + data->MyLength(), [](double value) { return value > 0.0; });
  }
  if (!model.comm().any(isFound))
    throw RunError(solver + ": a flow carries \"" + field +
                   "\", and none has been found yet; put Steady Flow before this solver, and in Staggered let it run "
                   "in the first load step (When: {At Start: true})");
}

}  // namespace pd
