#include "load_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <stdexcept>

#include "../model/model.hpp"
#include "declarations.hpp"

namespace pd {

namespace {

std::vector<double> timesOf(const std::string& text, const std::string& solver) {
  std::istringstream stream(text);
  std::vector<double> times;
  for (double time = 0.0; stream >> time;) times.push_back(time);
  const bool isRising = std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) == times.end();
  if (!stream.eof() || times.size() < 2 || !isRising)
    throw std::invalid_argument(solver + ": \"Time Steps\" must be two or more rising numbers separated by blanks");
  return times;
}

}  // namespace

void LoadSteps::declareParameters(ParameterDeclarations& declare) {
  declare.integer("Load Steps", "Increments of the run, of equal length; 1 where nothing is given.").atLeast(1);
  declare.integer("Number of Load Steps", "Peridigm's name of Load Steps.").atLeast(1);
  declare.text("Time Steps", "Times (s) at which the load steps end, the initial time first, separated by blanks.");
  declare.atMostOneOf({"Load Steps", "Number of Load Steps", "Time Steps"});
}

LoadSteps::LoadSteps(const Teuchos::ParameterList& parameters, const std::string& solver)
    : solver_(solver), nSteps_(either(parameters, "Load Steps", "Number of Load Steps", 1)) {
  if (parameters.isParameter("Time Steps")) times_ = timesOf(parameters.get<std::string>("Time Steps"), solver);
}

int LoadSteps::count(double t0, double t1) const {
  if (times_.empty()) return nSteps_;
  const double margin = 1e-9 * (t1 - t0);
  if (std::abs(times_.front() - t0) > margin || std::abs(times_.back() - t1) > margin)
    throw RunError(fmt::format(
        "{}: \"Time Steps\" go from {:g} to {:g} s, the run from {:g} to {:g} s; make Initial Time and Final Time the "
        "same as the first and the last of them",
        solver_, times_.front(), times_.back(), t0, t1));
  return static_cast<int>(times_.size()) - 1;
}

double LoadSteps::end(int step, int nSteps, double t0, double t1) const {
  if (times_.empty()) return t0 + (t1 - t0) * step / nSteps;
  return times_[static_cast<std::size_t>(step)];
}

}  // namespace pd
