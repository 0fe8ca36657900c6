#include "acidity.hpp"

#include "expression.hpp"

namespace pd {

Acidity::Acidity(const Teuchos::ParameterList& params, double saturation, const std::string& owner) {
  if (!params.isParameter("pH")) return;
  const Expression expression(params.get<std::string>("pH"), {"C"}, owner);
  ph_ = SampledFunction(saturation, SampledFunction::samples(saturation, [&](double concentration) {
                          return expression({concentration / litresPerCubicMetre});
                        }));
}

}  // namespace pd
