#include "solid_phases.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fields.hpp"

namespace pd {

namespace {

/// 3 of "block_3", as Peridigm numbers blocks.
int numberOf(const std::string& name, const std::string& owner) {
  const std::string prefix = "block_";
  const std::string digits = name.rfind(prefix, 0) == 0 ? name.substr(prefix.size()) : std::string();
  if (digits.empty() || digits.size() > 9 || digits.find_first_not_of("0123456789") != std::string::npos)
    throw std::invalid_argument(owner + ": \"Phase Blocks\" takes names such as \"block_3\", not \"" + name + "\"");
  return std::stoi(digits);
}

}  // namespace

void SolidPhases::declareParameters(ParameterDeclarations& declare) {
  declare.real("Solid Concentration", "mol/m3", "Metal atoms in the intact solid.").positive().required();
  CurrentDensity::declareParameters(declare);
  declare.texts("Phase Blocks",
                "Blocks of the mesh whose solid has kinetics of its own (grain boundaries, second phases), such as "
                "[block_2, block_3]; Current Density and Solid Concentration are of all others.");
  declare
      .functions("Phase Current Densities", "A/m2",
                 "Of each of these blocks: a number or an expression as Current Density is.")
      .of({"C", "pH"});
  declare.reals("Phase Solid Concentrations", "mol/m3", "Of each of these blocks; by default Solid Concentration.");
  declare
      .reals("Phase Film Shares", "1",
             "Of each of these blocks: the share, 0 to 1, of a film (Film Coverage) that it bears; by default 1. A "
             "phase of 0 dissolves as if there were none.")
      .ofField(fields::filmCoverage().label);
  declare.needs("Phase Film Shares", {"Phase Blocks"});
  declare.needs("Phase Blocks", {"Phase Current Densities"});
  declare.needs("Phase Current Densities", {"Phase Blocks"});
  declare.needs("Phase Solid Concentrations", {"Phase Blocks"});
}

SolidPhases::SolidPhases(const Teuchos::ParameterList& params, double saturation, const std::string& owner) {
  const double solid = params.get<double>("Solid Concentration");
  phases_.push_back({-1, CurrentDensity(params, saturation, owner), solid});
  if (params.isParameter("Phase Blocks")) {
    const auto& blocks = params.get<Teuchos::Array<std::string>>("Phase Blocks");
    const auto& currents = params.get<Teuchos::Array<std::string>>("Phase Current Densities");
    const auto given = [&](const char* key, double otherwise) {
      return params.isParameter(key) ? params.get<Teuchos::Array<double>>(key)
                                     : Teuchos::Array<double>(blocks.size(), otherwise);
    };
    const Teuchos::Array<double> concentrations = given("Phase Solid Concentrations", solid);
    const Teuchos::Array<double> filmShares = given("Phase Film Shares", 1.0);
    for (const auto size : {currents.size(), concentrations.size(), filmShares.size()})
      if (size != blocks.size())
        throw std::invalid_argument(owner +
                                    ": \"Phase Current Densities\", \"Phase Solid Concentrations\" and \"Phase Film "
                                    "Shares\" need one value for each of \"Phase Blocks\"");
    for (const double share : filmShares)
      if (!(share >= 0.0 && share <= 1.0))
        throw std::invalid_argument(owner + ": \"Phase Film Shares\" lie between 0 and 1");
    for (int p = 0; p < blocks.size(); ++p) {
      Teuchos::ParameterList own(params);
      own.remove("Current Density Table", false);
      own.set("Current Density", currents[p]);
      phases_.push_back({numberOf(blocks[p], owner), CurrentDensity(own, saturation, owner + ", phase " + blocks[p]),
                         concentrations[p], filmShares[p]});
    }
  }
  for (Phase& phase : phases_) {
    phase.atSaturation = phase.currentDensity.at(saturation).current;
    filmsDiffer_ = filmsDiffer_ || phase.filmShare != phases_.front().filmShare;
    if (!(phase.solidConcentration > saturation))
      throw std::invalid_argument(owner + ": \"Saturation Concentration\" must be below \"Solid Concentration\"");
  }
}

double SolidPhases::fastestUnder(double filmCoverage) const {
  double fastest = 0.0;
  for (const Phase& phase : phases_) fastest = std::max(fastest, phase.open(filmCoverage) * phase.atSaturation);
  return fastest;
}

/// Current density at saturation that a film leaves, over that of the fastest phase.
double SolidPhases::paceUnder(std::size_t phase, double filmCoverage) const {
  const double film = filmsDiffer_ ? filmCoverage : 0.0;  // one that slows all alike changes no pace
  const double fastest = fastestUnder(film);
  constexpr double least = 1e-6;  // where nothing else is left to give, the slowest gives
  return fastest > 0.0 ? std::max(phases_[phase].open(film) * phases_[phase].atSaturation / fastest, least) : 1.0;
}

double SolidPhases::pace(std::size_t phase, double filmCoverage) const {
  constexpr double nextToNothing = 1e-2;  // of bare metal: what takes such a flux was dissolved under less of a film
  const bool isLeft = filmsDiffer_ && fastestUnder(filmCoverage) > nextToNothing * fastestUnder(0.0);
  return paceUnder(phase, isLeft ? filmCoverage : 0.0);
}

double SolidPhases::keepsUp(std::size_t first, std::size_t second, double filmCoverage) const {
  const double paces = paceUnder(second, filmCoverage) / paceUnder(first, filmCoverage);
  return std::min(1.0, paces * phases_[first].solidConcentration / phases_[second].solidConcentration);
}

bool SolidPhases::areAlike(std::size_t a, std::size_t b, double filmCoverage) const {
  constexpr double nearly = 1.0 - 1e-3;
  return keepsUp(a, b, filmCoverage) > nearly && keepsUp(b, a, filmCoverage) > nearly;
}

std::size_t SolidPhases::ofBlock(double blockId) const {
  const auto block = static_cast<int>(std::lround(blockId));
  for (std::size_t p = 1; p < phases_.size(); ++p)
    if (phases_[p].block == block) return p;
  return 0;
}

}  // namespace pd
