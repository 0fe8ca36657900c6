// How much of each point's metal has dissolved: what the computes of loss and depth have in common.
#ifndef PD_DISSOLVED_METAL_HPP
#define PD_DISSOLVED_METAL_HPP

#include <algorithm>

#include "compute_support.hpp"

namespace pd {

/// Of points that were metal at the start: 1 once they are liquid (Damage 1), before that the share
///   (C_solid - C)/(C_solid - C_sat)
/// of which a front within the point would have passed, electrolyte at C_sat behind it. Its sum over volume therefore
/// follows the metal that is gone without steps.
class DissolvedMetal {
 public:
  struct Fields : FieldTable {
    FieldHandle damage = readsIfThere(pd::fields::damage());
    FieldHandle solid = readsIfThere(pd::fields::solidConcentration());
    FieldHandle saturation = readsIfThere(pd::fields::saturationConcentration());
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle concentration;
    explicit Fields(const Teuchos::ParameterList& parameters) {
      concentration = readsIfThere(pd::fields::ionConcentration(parameters.get<std::string>("Concentration Field")));
    }
  };
  /// Key "Concentration Field".
  static void declareParameters(ParameterDeclarations& declarations);
  explicit DissolvedMetal(const Teuchos::ParameterList& parameters, bool countsPartly = true)
      : fields_(parameters), countsPartly_(countsPartly) {}

  /// Throws std::invalid_argument where no material of the run dissolves.
  void initialize(const Blocks& blocks) const;

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
  Fields fields_;
  bool countsPartly_;
};

/// For a compute that is about dissolving metal: throws std::invalid_argument, naming the material to choose, where a
/// block lacks a field of its table, which the material of the block brings.
void requireDissolvingMetal(const Blocks& blocks, const FieldTable& fields);

}  // namespace pd

#endif
