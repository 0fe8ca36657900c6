// Dissolved metal summed over chosen points: what Volume_Loss, Dissolved_Amount and Mass_Loss have in common.
#ifndef PD_METAL_LOSS_HPP
#define PD_METAL_LOSS_HPP

#include "dissolved_metal.hpp"
#include "point_selection.hpp"

namespace pd {

class MetalLoss {
 public:
  static void declareParameters(ParameterDeclarations& declarations, const char* defaultLabel);
  MetalLoss(const Teuchos::ParameterList& parameters, const ComputeParameters& globalData);

  std::vector<int> fieldIds() const;
  void initialize(const Blocks& blocks);

  /// Stores `factor` times the sum of what(metal, id) over dissolved volume. Collective.
  template <class What>
  void sum(const Blocks& blocks, const Epetra_Comm& comm, double factor, What&& what) const {
    std::vector<DissolvedMetal::View> metal;
    for (PeridigmNS::Block& block : *blocks) metal.push_back(metal_.of(block));
    double sum = 0.0;
    points_.forEach(
        blocks, [&](std::size_t b, int id) { sum += metal[b].share(id) * metal[b].volume(id) * what(metal[b], id); });
    setGlobal(blocks, outputField_, factor * sumOverRanks(comm, sum));
  }

 private:
  PointSelection points_;
  DissolvedMetal metal_;
  int outputField_;
};

}  // namespace pd

#endif
