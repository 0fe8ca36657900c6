// The solid phases of a metal (grains, their boundaries, second phases), each with its own kinetics.
#ifndef PD_SOLID_PHASES_HPP
#define PD_SOLID_PHASES_HPP

#include <algorithm>
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
    /// Current density at saturation over that of the fastest phase; at least 1e-6.
    double pace = 1.0;
  };

  static void declareParameters(ParameterDeclarations& declare);
  /// `params`: completed; `saturation` in mol/m3. Throws std::invalid_argument, naming `owner`.
  SolidPhases(const Teuchos::ParameterList& params, double saturation, const std::string& owner);

  std::size_t count() const { return phases_.size(); }
  const Phase& operator[](std::size_t phase) const { return phases_[phase]; }
  /// Phase of the points of a block, by the value of the field Block_Id.
  std::size_t ofBlock(double blockId) const;
  /// Share of the second phase that a front through the first takes along, 0 to 1.
  double keepsUp(std::size_t first, std::size_t second) const {
    return std::min(1.0, phases_[second].pace / phases_[first].pace);
  }
  /// Whether a front passes through both alike.
  bool areAlike(std::size_t a, std::size_t b) const { return phases_[a].pace == phases_[b].pace; }

 private:
  std::vector<Phase> phases_;  ///< that of all other blocks first
};

}  // namespace pd

#endif
