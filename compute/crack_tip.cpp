// Crack_Tip: position of the crack tip, the foremost place where damage reaches a threshold, along a direction or along
// the path of the crack, and the direction of the crack there.
#include "crack_front.hpp"
#include "plugins.hpp"
#include "tip_ring.hpp"

namespace pd {

class CrackTip : public TabledCompute {
 public:
  struct Fields : CrackFront::Fields {
    FieldHandle result, direction;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : CrackFront::Fields(parameters),
          result(writes(outputField(parameters, pd::fields::globalVector, "m", "Position of the crack tip."))),
          direction(writes(pd::fields::globalVector(crackDirectionLabel(parameters.get<std::string>("Output Label")),
                                                    "1", "Direction of the crack at its tip."))) {}
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
    const CrackFront::Tip tip = front_.locate(blocks, *epetraComm);
    setGlobal(blocks, fields_.result, tip.place.data(), 3);
    setGlobal(blocks, fields_.direction, tip.direction.data(), 3);
    return 0;
  }

 private:
  CrackFront front_;
  Fields fields_;
};

}  // namespace pd

using pd::CrackTip;
PD_REGISTER_COMPUTE(CrackTip, "Crack_Tip",
                    "Position of the crack tip, along a direction or a path, in the reference shape.")
