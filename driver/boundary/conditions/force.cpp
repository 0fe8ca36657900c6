// A force on a node set as a whole.
#include "../load.hpp"

namespace pd {

namespace {

/// Force density = value / (volume of the set): the sum over the points is the value, or, where it is a function of
/// place, its mean over the volume.
class Force : public AxialLoad {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declareLoad(
        declare, "N",
        "Force on the node set as a whole, which its points share in proportion to their volumes (a function of "
        "place counts by its mean over them).");
  }
  using AxialLoad::AxialLoad;

 private:
  double scale(double volume) const override { return 1.0 / volume; }
  std::string effect() const override { return "force shared by"; }
};

}  // namespace

PD_REGISTER_CONDITION(Force, "Force", "A force on a node set as a whole, along one axis")

}  // namespace pd
