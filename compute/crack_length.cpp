// Crack_Length: distance from the mouth of a crack to its tip, along its direction or straight.
#include <algorithm>
#include <cmath>

#include "crack_front.hpp"
#include "plugins.hpp"

namespace pd {

class CrackLength : public TabledCompute {
 public:
  struct Fields : CrackFront::Fields {
    FieldHandle result;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : CrackFront::Fields(parameters),
          result(writes(
              outputField(parameters, pd::fields::globalScalar, "m", "From the mouth of the crack to its tip."))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Crack_Length");
    declarations
        .text("Measure", "The tip's advance from the start along the direction, or its straight distance from there.")
        .oneOf({"Projected", "Distance"})
        .defaultTo("Projected");
    CrackFront::declareParameters(declarations);
  }
  CrackLength(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<CrackLength>(params, "Crack_Length"), params, comm, globalData),
        front_(parameters_, globalData),
        isProjected_(parameters_.get<std::string>("Measure") == "Projected"),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  void initialize(Blocks blocks) override { front_.initialize(blocks); }
  int compute(Blocks blocks) const override {
    const Vector3 tip = front_.locate(blocks, *epetraComm);
    const Vector3& start = front_.start();
    const double advance[3] = {tip[0] - start[0], tip[1] - start[1], tip[2] - start[2]};
    const double length =
        isProjected_ ? std::max(0.0, dot(front_.direction(), advance)) : std::hypot(advance[0], advance[1], advance[2]);
    setGlobal(blocks, fields_.result, length);
    return 0;
  }

 private:
  CrackFront front_;
  bool isProjected_;
  Fields fields_;
};

}  // namespace pd

using pd::CrackLength;
PD_REGISTER_COMPUTE(CrackLength, "Crack_Length", "Distance from the mouth of a crack to its tip.")
