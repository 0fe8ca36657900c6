// Crack_Tip: position of the crack tip, the foremost place along a direction where damage reaches a threshold.
#include "crack_front.hpp"
#include "plugins.hpp"

namespace pd {

class CrackTip : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Crack_Tip");
    CrackFront::declareParameters(declarations);
  }
  CrackTip(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : CrackTip(completeParameters<CrackTip>(params, "Crack_Tip"), params, comm, globalData) {}

  std::vector<int> FieldIds() const override {
    std::vector<int> ids = front_.fieldIds();
    ids.push_back(outputField_);
    return ids;
  }
  void initialize(Blocks blocks) override { front_.initialize(blocks); }
  int compute(Blocks blocks) const override {
    setGlobal(blocks, outputField_, front_.locate(blocks, *epetraComm).data(), 3);
    return 0;
  }

 private:
  CrackTip(const Teuchos::ParameterList& parameters, ComputeParameters params, ComputeComm comm,
           ComputeParameters globalData)
      : Compute(params, comm, globalData),
        front_(parameters, globalData),
        outputField_(globalField(parameters.get<std::string>("Output Label"), PeridigmNS::PeridigmField::VECTOR)) {}

  CrackFront front_;
  int outputField_;
};

}  // namespace pd

using pd::CrackTip;
PD_REGISTER_COMPUTE(CrackTip, "Crack_Tip", "Position of the crack tip along a direction, in the reference shape.")
