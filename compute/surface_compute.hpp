// A compute of the depth of a surface: all but what it makes of the depths.
#ifndef PD_SURFACE_COMPUTE_HPP
#define PD_SURFACE_COMPUTE_HPP

#include "surface_columns.hpp"

namespace pd {

class SurfaceCompute : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations, const char* defaultLabel) {
    declareCommonParameters(declarations, defaultLabel);
    SurfaceColumns::declareParameters(declarations);
  }
  std::vector<int> FieldIds() const override {
    std::vector<int> ids = columns_.fieldIds();
    ids.push_back(outputField_);
    return ids;
  }
  void initialize(Blocks blocks) override { columns_.initialize(blocks, *epetraComm); }

 protected:
  /// `parameters`: completed. The result has its field from `fieldOf(label)`.
  template <class FieldOf>
  SurfaceCompute(const Teuchos::ParameterList& parameters, ComputeParameters params, ComputeComm comm,
                 ComputeParameters globalData, FieldOf&& fieldOf)
      : Compute(params, comm, globalData),
        columns_(parameters, globalData),
        outputField_(fieldOf(parameters.get<std::string>("Output Label"))) {}

  SurfaceColumns::Profile profile(const Blocks& blocks) const { return columns_.profile(blocks, *epetraComm); }
  static int scalarResult(const std::string& label) { return globalField(label, PeridigmNS::PeridigmField::SCALAR); }
  static int placeResult(const std::string& label) { return globalField(label, PeridigmNS::PeridigmField::VECTOR); }

  SurfaceColumns columns_;
  int outputField_;
};

}  // namespace pd

#endif
