// How much of each point's metal has dissolved: what the computes of loss and depth have in common.
#ifndef PD_DISSOLVED_METAL_HPP
#define PD_DISSOLVED_METAL_HPP

#include <algorithm>

#include "field_variable.hpp"

namespace pd {

/// Of points that were metal at the start: 1 once they are liquid (Damage 1), before that the share
///   (C_solid - C)/(C_solid - C_sat)
/// of which a front within the point would have passed, electrolyte at C_sat behind it. Its sum over volume therefore
/// follows the metal that is gone without steps.
class DissolvedMetal {
 public:
  explicit DissolvedMetal(bool countsPartly = true);

  std::vector<int> fieldIds() const;
  /// Throws std::invalid_argument where no material of the run dissolves.
  void initialize(const Blocks& blocks);

  /// One block's fields.
  class View {
   public:
    bool wasMetal(int id) const { return solid_[id] > 0.0; }
    bool isGone(int id) const { return wasMetal(id) && damage_[id] >= 1.0; }
    /// Within 0 and 1; 0 for what was electrolyte at the start.
    double share(int id) const {
      if (!wasMetal(id)) return 0.0;
      if (damage_[id] >= 1.0) return 1.0;
      if (!countsPartly_) return 0.0;
      return std::clamp((solid_[id] - concentration_[id]) / (solid_[id] - saturation_[id]), 0.0, 1.0);
    }
    double solidConcentration(int id) const { return solid_[id]; }  ///< mol/m3
    double volume(int id) const { return volume_[id]; }             ///< m3

   private:
    friend class DissolvedMetal;
    const double *damage_, *concentration_, *solid_, *saturation_, *volume_;
    bool countsPartly_;
  };
  View of(PeridigmNS::Block& block) const;

 private:
  FieldVariable damage_, concentration_;
  int solidField_ = -1, saturationField_ = -1, volumeField_;
  bool countsPartly_;
};

/// The id of a field that a dissolving metal keeps, or -1 where no material of this run has registered it.
int corrosionField(const std::string& label);
/// Throws std::invalid_argument, naming the material to choose, where a block lacks one of these fields.
void requireCorrosionFields(const Blocks& blocks, const std::vector<std::string>& labels);

}  // namespace pd

#endif
