// A compute of the depth of a surface: all but what it makes of the depths.
#ifndef PD_SURFACE_COMPUTE_HPP
#define PD_SURFACE_COMPUTE_HPP

#include "surface_columns.hpp"

namespace pd {

class SurfaceCompute : public TabledCompute {
 public:
  struct Fields : SurfaceColumns::Fields {
    FieldHandle result;
    /// `make`: what the result is, fields::globalScalar or another.
    Fields(const Teuchos::ParameterList& parameters,
           FieldDescription (*make)(const std::string&, const std::string&, const std::string&),
           const std::string& unit, const std::string& meaning)
        : SurfaceColumns::Fields(parameters), result(writes(outputField(parameters, make, unit, meaning))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations, const char* defaultLabel) {
    declareCommonParameters(declarations, defaultLabel);
    SurfaceColumns::declareParameters(declarations);
  }
  const Fields& fields() const override = 0;
  void initialize(Blocks blocks) override { columns_.initialize(blocks, *epetraComm); }

 protected:
  SurfaceCompute(const Teuchos::ParameterList& completed, ComputeParameters params, ComputeComm comm,
                 ComputeParameters globalData)
      : TabledCompute(completed, params, comm, globalData), columns_(completed, globalData) {}

  SurfaceColumns::Profile profile(const Blocks& blocks) const { return columns_.profile(blocks, *epetraComm); }

  SurfaceColumns columns_;
};

}  // namespace pd

#endif
