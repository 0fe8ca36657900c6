// The dissolving surface of the last step, for output.
#ifndef PD_SURFACE_RECORD_HPP
#define PD_SURFACE_RECORD_HPP

#include <array>
#include <vector>

#include "../../model/model.hpp"

namespace pd {

/// Fields Current_Density and Interface_Area_Density as the last step had them. The change of phases after it evaluates
/// them anew, for currents that no surface has.
class SurfaceRecord {
 public:
  /// Of these points, after the transport of a step.
  void take(Model& model, const std::vector<int>& liquid);
  /// Puts them into the fields, to be seen until hide() puts back what the material works with.
  void show(Model& model);
  void hide(Model& model);

 private:
  struct Row {
    int point;
    std::array<double, 2> values;
  };
  std::vector<Row> rows_;
  std::array<std::vector<double>, 2> hidden_;  ///< [nOwned]; empty: nothing is shown
};

}  // namespace pd

#endif
