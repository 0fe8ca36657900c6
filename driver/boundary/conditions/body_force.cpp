// Force per volume.
#include "../load.hpp"

namespace pd {

namespace {

class BodyForce : public AxialLoad {
 public:
  static void declareParameters(ParameterDeclarations& declare) { declareLoad(declare, "N/m3", "Force per volume."); }
  using AxialLoad::AxialLoad;

 private:
  double scale(double) const override { return 1.0; }
  std::string effect() const override { return "force per volume on"; }
};

}  // namespace

PD_REGISTER_CONDITION(BodyForce, "Body Force", "Force per volume along one axis, such as weight")

}  // namespace pd
