#include "crack_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "Peridigm_Field.hpp"

namespace pd {

void CrackControl::declareParameters(ParameterDeclarations& declare) {
  ParameterDeclarations& intensity =
      declare.sublist("Stress Intensity",
                      "Of a crack, from a compute: for histories (its range in the cycles is Stress_Intensity_Range, "
                      "for Output Variables), loads that follow it, and K_c.");
  intensity.text("Energy Release Rate", "Output Label of a J_Integral or Nonlocal_J_Integral.").required();
  intensity.real("Effective Modulus", "Pa", "E' of K = (J E')^0.5: E in plane stress, E/(1 - nu^2) in plane strain.")
      .required()
      .positive();
  intensity
      .function("Range", "unit of K, Pa m^0.5",
                "Range of K that the load is to give, a number or a function of the crack length a (m); without it the "
                "load is that of the conditions.")
      .of({"a"});
  intensity.text("Crack Length", "Output Label of a Crack_Length, for a Range that depends on it.");
  intensity.real("Fracture Toughness", "unit of K, Pa m^0.5", "K at the largest load that ends the run.").positive();
  ParameterDeclarations& load = declare.sublist("Load By Crack Length", "Loads that change as a crack grows.");
  load.function("Peak", "1",
                "Largest load of a cycle in parts of that of the conditions, a function of the crack length a (m).")
      .of({"a"})
      .required();
  load.text("Crack Length", "Output Label of a Crack_Length.").required();
  ParameterDeclarations& stop =
      declare.sublist("Stop When", "The run ends where a value for the whole body is reached.");
  stop.text("Value", "Output Label of a compute for the whole body, such as a Crack_Length.").required();
  stop.real("Reaches", "unit of the deck", "What it must reach from below.").required();
}

CrackControl::CrackControl(const Teuchos::ParameterList& parameters)
    : hasIntensity_(parameters.isSublist("Stress Intensity")), fields_(hasIntensity_) {
  if (hasIntensity_) {
    const Teuchos::ParameterList& list = parameters.sublist("Stress Intensity");
    energyLabel_ = list.get<std::string>("Energy Release Rate");
    modulus_ = list.get<double>("Effective Modulus");
    if (list.isParameter("Fracture Toughness")) toughness_ = list.get<double>("Fracture Toughness");
    if (list.isParameter("Crack Length")) lengthLabel_ = list.get<std::string>("Crack Length");
    if (list.isParameter("Range"))
      wantedRange_ = std::make_unique<FunctionProgram>(list.get<std::string>("Range"), std::vector<std::string>{"a"});
    if (wantedRange_ != nullptr && wantedRange_->uses(0) && lengthLabel_.empty())
      throw std::invalid_argument("Stress Intensity: \"Range\" depends on a; give \"Crack Length\"");
  }
  if (parameters.isSublist("Load By Crack Length")) {
    if (wantedRange_ != nullptr)
      throw std::invalid_argument(
          "\"Load By Crack Length\" and the \"Range\" of \"Stress Intensity\" both say what the load is; remove one");
    const Teuchos::ParameterList& list = parameters.sublist("Load By Crack Length");
    lengthLabel_ = list.get<std::string>("Crack Length");
    peak_ = std::make_unique<FunctionProgram>(list.get<std::string>("Peak"), std::vector<std::string>{"a"});
  }
  if (parameters.isSublist("Stop When")) {
    stopLabel_ = parameters.sublist("Stop When").get<std::string>("Value");
    stopValue_ = parameters.sublist("Stop When").get<double>("Reaches");
  }
  isUsed_ = hasIntensity_ || peak_ != nullptr || !stopLabel_.empty();
}

void CrackControl::requireCompute(Model& model, const std::string& label, const char* key) const {
  const bool isThere = model.hasField(label) && PeridigmNS::FieldManager::self().getFieldSpec(label).relation ==
                                                    PeridigmNS::PeridigmField::GLOBAL;
  if (!isThere || model.fieldWidth(label) != 1)
    throw RunError(
        fmt::format("Fatigue: \"{}\" of {} is no value for the whole body that a compute of this run gives; "
                    "name the Output Label of one in Compute Class Parameters",
                    label, key));
}

void CrackControl::initialize(Model& model) const {
  if (hasIntensity_) requireCompute(model, energyLabel_, "Stress Intensity/Energy Release Rate");
  if (!lengthLabel_.empty()) requireCompute(model, lengthLabel_, "Crack Length");
  if (!stopLabel_.empty()) requireCompute(model, stopLabel_, "Stop When/Value");
}

double CrackControl::lengthOf(Model& model) const { return lengthLabel_.empty() ? 0.0 : *model.field(lengthLabel_); }

double CrackControl::peakForRange(Model& model, double t, double intensity, double loadRatio) const {
  const double a = lengthOf(model), wanted = wantedRange_->evaluate(&a);
  if (!(intensity > 0.0) || !std::isfinite(wanted) || !(wanted > 0.0))
    throw RunError(fmt::format(
        "Fatigue ({:.6g} cycles): no load gives the wanted range of K, {:g} Pa m^0.5: \"{}\" is {:g} J/m2 at the load "
        "of the conditions. Look at the ring or contour of its J_Integral, at \"Range\", and stop before the crack "
        "ends (Stop When)",
        t, wanted, energyLabel_, *model.field(energyLabel_)));
  return wanted / ((1.0 - loadRatio) * intensity);
}

CrackControl::Outcome CrackControl::look(Simulation& simulation, double t, double peak, double loadRatio) const {
  if (!isUsed_) return {peak, ""};
  Model& model = simulation.model;
  model.updateCoordinates();
  simulation.output.evaluateGlobals(model);
  Outcome outcome{peak, ""};
  if (peak_ != nullptr) {
    const double a = lengthOf(model);
    outcome.peak = peak_->evaluate(&a);
    if (!std::isfinite(outcome.peak) || !(outcome.peak > 0.0))
      throw RunError(
          fmt::format("Fatigue ({:.6g} cycles): \"Peak\" of \"Load By Crack Length\" is {:g} at a crack "
                      "length of {:g} m; it must be above 0 at every length that the crack has",
                      t, outcome.peak, a));
  }
  if (hasIntensity_) {
    const double intensity = std::sqrt(std::max(*model.field(energyLabel_), 0.0) * modulus_);
    if (wantedRange_ != nullptr) outcome.peak = peakForRange(model, t, intensity, loadRatio);
    *model.field(fields_.range) = outcome.peak * (1.0 - loadRatio) * intensity;
    if (toughness_ > 0.0 && outcome.peak * intensity >= toughness_)
      outcome.reason =
          fmt::format("K at the largest load is {:.6g} Pa m^0.5 after {:.6g} cycles: the fracture toughness",
                      outcome.peak * intensity, t);
  }
  if (!stopLabel_.empty() && *model.field(stopLabel_) >= stopValue_)
    outcome.reason = fmt::format("{} has reached {:.6g} after {:.6g} cycles", stopLabel_, *model.field(stopLabel_), t);
  return outcome;
}

}  // namespace pd
