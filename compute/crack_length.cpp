// Crack_Length: distance from the mouth of a crack to its tip, along its direction, straight or along its path.
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
        .text(
            "Measure",
            "The tip's advance from the start along the direction (default of a straight path), its straight distance "
            "from there, or the way along a curved path (default of one).")
        .oneOf({"Projected", "Distance", "Along Path"});
    CrackFront::declareParameters(declarations);
  }
  CrackLength(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<CrackLength>(params, "Crack_Length"), params, comm, globalData),
        front_(parameters_, globalData),
        measure_(parameters_.isParameter("Measure") ? parameters_.get<std::string>("Measure")
                                                    : (front_.isCurved() ? "Along Path" : "Projected")),
        fields_(parameters_) {
    if (measure_ == "Along Path" && !front_.isCurved())
      throw std::invalid_argument("Crack_Length: \"Measure\" Along Path needs \"Path\" Curved");
  }

  const Fields& fields() const override { return fields_; }
  void initialize(Blocks blocks) override { front_.initialize(blocks); }
  int compute(Blocks blocks) const override {
    const CrackFront::Tip tip = front_.locate(blocks, *epetraComm);
    const Vector3& start = front_.start();
    const double advance[3] = {tip.place[0] - start[0], tip.place[1] - start[1], tip.place[2] - start[2]};
    double length = tip.length;
    if (measure_ == "Projected") length = std::max(0.0, dot(front_.direction(), advance));
    if (measure_ == "Distance") length = std::hypot(advance[0], advance[1], advance[2]);
    setGlobal(blocks, fields_.result, length);
    return 0;
  }

 private:
  CrackFront front_;
  std::string measure_;
  Fields fields_;
};

}  // namespace pd

using pd::CrackLength;
PD_REGISTER_COMPUTE(CrackLength, "Crack_Length", "Distance from the mouth of a crack to its tip.")
