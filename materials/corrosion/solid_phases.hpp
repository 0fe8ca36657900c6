// The solid phases of a metal (grains, their boundaries, second phases), each with its own kinetics.
#ifndef PD_SOLID_PHASES_HPP
#define PD_SOLID_PHASES_HPP

#include <cstddef>
#include <string>
#include <vector>

#include "current_density.hpp"

namespace pd {

class SolidPhases {
 public:
  struct Phase {
    int block;  ///< number of the block of the mesh; -1: every other
    CurrentDensity currentDensity;
    double solidConcentration;  ///< mol/m3
    double filmShare = 1.0;     ///< of what Film_Coverage covers of a surface, what it covers of this phase
    double atSaturation = 0.0;  ///< current density, A/m2
    double open(double filmCoverage) const { return 1.0 - filmShare * filmCoverage; }  ///< share without a film
  };

  static void declareParameters(ParameterDeclarations& declare);
  /// `params`: completed; `saturation` in mol/m3. Throws std::invalid_argument, naming `owner`.
  SolidPhases(const Teuchos::ParameterList& params, double saturation, const std::string& owner);

  std::size_t count() const { return phases_.size(); }
  const Phase& operator[](std::size_t phase) const { return phases_[phase]; }
  /// Phase of the points of a block, by the value of the field Block_Id.
  std::size_t ofBlock(double blockId) const;
  /// What a phase gives of a flux that no current of its own takes, over what the fastest gives; at least 1e-6. It is
  /// as the currents are at saturation that a film leaves, or those of bare metal where it leaves next to nothing of
  /// any.
  double pace(std::size_t phase, double filmCoverage) const;
  /// Share of the second phase that a front through the first takes along, 0 to 1.
  double keepsUp(std::size_t first, std::size_t second, double filmCoverage) const;
  /// Whether a front passes through both alike, to a thousandth of its speed.
  bool areAlike(std::size_t a, std::size_t b, double filmCoverage) const;
  /// Whether phases bear different shares of a film.
  bool filmsDiffer() const { return filmsDiffer_; }

 private:
  double paceUnder(std::size_t phase, double filmCoverage) const;
  double fastestUnder(double filmCoverage) const;

  bool filmsDiffer_ = false;
  std::vector<Phase> phases_;  ///< that of all other blocks first
};

}  // namespace pd

#endif
