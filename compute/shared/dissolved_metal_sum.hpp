// Dissolved metal summed over chosen points: what the computes of losses have in common.
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

  /// Calls visit(block number, local id, fields of the block) for every chosen point of this rank that was metal.
  template <class Visit>
  void forEachMetal(const Blocks& blocks, Visit&& visit) const {
    std::vector<DissolvedMetal::View> metal;
    for (PeridigmNS::Block& block : *blocks) metal.push_back(metal_.of(block));
    points_.forEach(blocks, [&](std::size_t b, int id) {
      if (metal[b].wasMetal(id)) visit(b, id, metal[b]);
    });
  }

  struct Sums {
    double dissolved, whole;
  };
  /// what(metal, id) summed over the volume of metal that has dissolved, and over that of all metal at the start.
  /// Throws std::runtime_error where there was none. Collective.
  template <class What>
  Sums sums(const Blocks& blocks, What&& what) const {
    std::vector<double> sums(2, 0.0);
    forEachMetal(blocks, [&](std::size_t, int id, const DissolvedMetal::View& metal) {
      const double whole = metal.volume(id) * what(metal, id);
      sums[0] += metal.share(id) * whole;
      sums[1] += whole;
    });
    sums = sumOverRanks(*epetraComm, sums);
    requireMetal(sums[1] > 0.0);
    return {sums[0], sums[1]};
  }
  /// m3
  Sums volumes(const Blocks& blocks) const {
    return sums(blocks, [](const DissolvedMetal::View&, int) { return 1.0; });
  }

  /// mol
  Sums amounts(const Blocks& blocks) const {
    return sums(blocks, [](const DissolvedMetal::View& metal, int id) { return metal.solidConcentration(id); });
  }

  void requireMetal(bool isThere) const;

 private:
  PointSelection points_;
  DissolvedMetal metal_;
};

}  // namespace pd

#endif
