// Dissolved metal summed over chosen points: what Volume_Loss, Dissolved_Amount and Mass_Loss have in common.
#ifndef PD_DISSOLVED_METAL_SUM_HPP
#define PD_DISSOLVED_METAL_SUM_HPP

#include "dissolved_metal.hpp"
#include "point_selection.hpp"

namespace pd {

class DissolvedMetalSum : public TabledCompute {
 public:
  struct Fields : DissolvedMetal::Fields {
    FieldHandle result;
    Fields(const Teuchos::ParameterList& parameters, const std::string& unit, const std::string& meaning)
        : DissolvedMetal::Fields(parameters),
          result(writes(outputField(parameters, pd::fields::globalScalar, unit, meaning))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations, const char* defaultLabel);
  const Fields& fields() const override = 0;
  void initialize(Blocks blocks) override;

 protected:
  DissolvedMetalSum(const Teuchos::ParameterList& completed, ComputeParameters params, ComputeComm comm,
                    ComputeParameters globalData);

  /// Stores `factor` times the sum of what(metal, id) over dissolved volume. Collective.
  template <class What>
  void sum(const Blocks& blocks, double factor, What&& what) const {
    std::vector<DissolvedMetal::View> metal;
    for (PeridigmNS::Block& block : *blocks) metal.push_back(metal_.of(block));
    double sum = 0.0;
    points_.forEach(
        blocks, [&](std::size_t b, int id) { sum += metal[b].share(id) * metal[b].volume(id) * what(metal[b], id); });
    setGlobal(blocks, fields().result, factor * sumOverRanks(*epetraComm, sum));
  }

  /// m3, at the start. Collective.
  double volumeOfMetal(const Blocks& blocks) const {
    std::vector<DissolvedMetal::View> metal;
    for (PeridigmNS::Block& block : *blocks) metal.push_back(metal_.of(block));
    double volume = 0.0;
    points_.forEach(blocks,
                    [&](std::size_t b, int id) { volume += metal[b].wasMetal(id) ? metal[b].volume(id) : 0.0; });
    return sumOverRanks(*epetraComm, volume);
  }

 private:
  PointSelection points_;
  DissolvedMetal metal_;
};

}  // namespace pd

#endif
