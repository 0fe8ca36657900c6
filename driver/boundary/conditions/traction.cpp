// Force per area of a face.
#include <fmt/format.h>

#include "../load.hpp"

namespace pd {

namespace {

/// The points of the set carry value * Area in proportion to their volumes: force density = value * Area / (volume of
/// the set). A constant traction thus gives the same total force whatever the mesh and the depth of the set.
class Traction : public AxialLoad {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declareLoad(declare, "N/m2", "Force per area of the loaded face.");
    declare
        .real("Area", "m2",
              "Area of the loaded face; its points share the force Value * Area in proportion to their volumes.")
        .positive()
        .required();
  }
  explicit Traction(const ConditionSection& section) : AxialLoad(section), area_(section.list.get<double>("Area")) {}

 private:
  double scale(double volume) const override { return area_ / volume; }
  std::string effect() const override { return fmt::format("force on {:.6g} m2 shared by", area_); }

  double area_;  ///< m2
};

}  // namespace

PD_REGISTER_CONDITION(Traction, "Traction", "Force per area of a face, along one axis")

}  // namespace pd
