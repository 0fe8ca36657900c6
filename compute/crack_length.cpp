// Crack_Length: distance from the mouth of a crack to its tip, along its direction or straight.
#include <algorithm>
#include <cmath>

#include "crack_front.hpp"
#include "plugins.hpp"

namespace pd {

class CrackLength : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Crack_Length");
    declarations
        .text("Measure", "The tip's advance from the start along the direction, or its straight distance from there.")
        .oneOf({"Projected", "Distance"})
        .defaultTo("Projected");
    CrackFront::declareParameters(declarations);
  }
  CrackLength(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : CrackLength(completeParameters<CrackLength>(params, "Crack_Length"), params, comm, globalData) {}

  std::vector<int> FieldIds() const override {
    std::vector<int> ids = front_.fieldIds();
    ids.push_back(outputField_);
    return ids;
  }
  void initialize(Blocks blocks) override { front_.initialize(blocks); }
  int compute(Blocks blocks) const override {
    const Vector3 tip = front_.locate(blocks, *epetraComm);
    const Vector3& start = front_.start();
    const double advance[3] = {tip[0] - start[0], tip[1] - start[1], tip[2] - start[2]};
    const double length =
        isProjected_ ? std::max(0.0, dot(front_.direction(), advance)) : std::hypot(advance[0], advance[1], advance[2]);
    setGlobal(blocks, outputField_, length);
    return 0;
  }

 private:
  CrackLength(const Teuchos::ParameterList& parameters, ComputeParameters params, ComputeComm comm,
              ComputeParameters globalData)
      : Compute(params, comm, globalData),
        front_(parameters, globalData),
        isProjected_(parameters.get<std::string>("Measure") == "Projected"),
        outputField_(globalField(parameters.get<std::string>("Output Label"), PeridigmNS::PeridigmField::SCALAR)) {}

  CrackFront front_;
  bool isProjected_;
  int outputField_;
};

}  // namespace pd

using pd::CrackLength;
PD_REGISTER_COMPUTE(CrackLength, "Crack_Length", "Distance from the mouth of a crack to its tip.")
