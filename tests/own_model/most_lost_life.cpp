// Most_Lost_Life: what the most tired bond of the body has lost of its life.
#include <algorithm>

#include "compute_support.hpp"
#include "fields.hpp"
#include "plugins.hpp"

namespace {

class MostLostLife : public pd::TabledCompute {
 public:
  struct Fields : pd::FieldTable {
    pd::FieldHandle lostLife =
        readsIfThere(pd::fields::bondScalar("Lost_Life", "1", "Share of a bond's life that is gone."));
    pd::FieldHandle result;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : result(writes(pd::outputField(parameters, pd::fields::globalScalar, "1", "Largest lost life of a bond."))) {}
  };
  static void declareParameters(pd::ParameterDeclarations& declare) {
    pd::declareCommonParameters(declare, "Most_Lost_Life");
  }
  MostLostLife(pd::ComputeParameters params, pd::ComputeComm comm, pd::ComputeParameters globalData)
      : TabledCompute(pd::completeParameters<MostLostLife>(params, "Most_Lost_Life"), params, comm, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }

  /// Called on every rank, also on one without points: all of them meet in maxOverRanks.
  int compute(pd::Blocks blocks) const override {
    double most = 0.0;
    for (PeridigmNS::Block& block : *blocks) {
      PeridigmNS::DataManager& data = *block.getDataManager();
      if (!fields_.lostLife.isIn(data)) continue;
      const double* lost = fields_.lostLife.of(data);
      for (int bond = 0; bond < fields_.lostLife.length(data); ++bond) most = std::max(most, lost[bond]);
    }
    pd::setGlobal(blocks, fields_.result, pd::maxOverRanks(*epetraComm, most));
    return 0;
  }

 private:
  Fields fields_;
};

PD_REGISTER_COMPUTE(MostLostLife, "Most_Lost_Life", "Life that the most tired bond of the body has lost.")

}  // namespace
