// Crack_Tip: position of the crack tip, the foremost place along a direction where damage reaches a threshold.
#include "crack_front.hpp"
#include "plugins.hpp"

namespace pd {

class CrackTip : public TabledCompute {
 public:
  struct Fields : CrackFront::Fields {
    FieldHandle result;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : CrackFront::Fields(parameters),
          result(writes(outputField(parameters, pd::fields::globalVector, "m", "Position of the crack tip."))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Crack_Tip");
    CrackFront::declareParameters(declarations);
  }
  CrackTip(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<CrackTip>(params, "Crack_Tip"), params, comm, globalData),
        front_(parameters_, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  void initialize(Blocks blocks) override { front_.initialize(blocks); }
  int compute(Blocks blocks) const override {
    setGlobal(blocks, fields_.result, front_.locate(blocks, *epetraComm).data(), 3);
    return 0;
  }

 private:
  CrackFront front_;
  Fields fields_;
};

}  // namespace pd

using pd::CrackTip;
PD_REGISTER_COMPUTE(CrackTip, "Crack_Tip", "Position of the crack tip along a direction, in the reference shape.")
