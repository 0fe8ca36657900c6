// Most_Lost_Life: what the most tired bond of the body has lost of its life.
#include <algorithm>

#include "compute_support.hpp"
#include "fields.hpp"
#include "plugins.hpp"

namespace {

class MostLostLife : public PeridigmNS::Compute {
 public:
  static void declareParameters(pd::ParameterDeclarations& declare) {
    pd::declareCommonParameters(declare, "Most_Lost_Life");
  }
  MostLostLife(pd::ComputeParameters params, pd::ComputeComm comm, pd::ComputeParameters globalData)
      : Compute(params, comm, globalData) {
    const auto list = pd::completeParameters<MostLostLife>(params, "Most_Lost_Life");
    output_ = pd::globalField(list.get<std::string>("Output Label"), PeridigmNS::PeridigmField::SCALAR);
    const auto field = pd::fields::bondScalar("Lost_Life", "1", "Share of a bond's life that is gone.");
    lostLife_ = pd::FieldHandle(field.id(), field.temporal);
  }
  std::vector<int> FieldIds() const override { return {output_}; }

  /// Called on every rank, also on one without points: all of them meet in maxOverRanks.
  int compute(pd::Blocks blocks) const override {
    double most = 0.0;
    for (PeridigmNS::Block& block : *blocks) {
      PeridigmNS::DataManager& data = *block.getDataManager();
      if (!lostLife_.isIn(data)) continue;
      const double* lost = lostLife_.of(data);
      for (int bond = 0; bond < lostLife_.length(data); ++bond) most = std::max(most, lost[bond]);
    }
    pd::setGlobal(blocks, output_, pd::maxOverRanks(*epetraComm, most));
    return 0;
  }

 private:
  int output_;
  pd::FieldHandle lostLife_;
};

PD_REGISTER_COMPUTE(MostLostLife, "Most_Lost_Life", "Life that the most tired bond of the body has lost.")

}  // namespace
