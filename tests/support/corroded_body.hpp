// A body of metal under electrolyte whose points dissolve by hand.
#ifndef PD_TESTS_CORRODED_BODY_HPP
#define PD_TESTS_CORRODED_BODY_HPP

#include <algorithm>

#include "small_body.hpp"

namespace pdtest {

constexpr double solidConcentration = 100.0, saturation = 20.0;

/// Metal where z, or in a plane body (all z alike) y, is above 0.
class CorrodedBody : public SmallBody {
 public:
  CorrodedBody(const std::vector<Point>& points, BodyOptions options, std::size_t axis)
      : SmallBody(points, std::move(options)), axis_(axis) {
    using namespace PeridigmNS::PeridigmField;
    auto& fields = PeridigmNS::FieldManager::self();
    std::vector<int> ids = {fields.getFieldId(ELEMENT, SCALAR, TWO_STEP, "Damage"),
                            fields.getFieldId(NODE, SCALAR, TWO_STEP, "Concentration")};
    for (const char* label :
         {"Solid_Concentration", "Saturation_Concentration", "Current_Density", "Interface_Area_Density"})
      ids.push_back(fields.getFieldId(NODE, SCALAR, CONSTANT, label));
    allocate(ids);
    for (int i = 0; i < nPoints(); ++i) {
      field("Saturation_Concentration")[i] = saturation;
      field("Solid_Concentration")[i] = point(i)[axis_] > 0.0 ? solidConcentration : 0.0;
    }
    dissolve([](const Point&) { return 0.0; });
  }

  /// share(point): how much of a point of metal is gone; from 1 on it is liquid.
  void dissolve(const std::function<double(const Point&)>& share) {
    for (int i = 0; i < nPoints(); ++i) {
      const double gone = point(i)[axis_] > 0.0 ? std::clamp(share(point(i)), 0.0, 1.0) : 1.0;
      field("Damage")[i] = gone;
      // Electrolyte holds anything below saturation.
      field("Concentration")[i] =
          gone < 1.0 ? solidConcentration - gone * (solidConcentration - saturation) : 0.3 * saturation;
    }
  }

  double run(const std::string& name, const Teuchos::ParameterList& parameters, int component = 0,
             Teuchos::RCP<const Epetra_Comm> comm = Teuchos::rcp(new SerialComm)) {
    makeCompute(*this, name, parameters, comm)->compute(blocks());
    return value(parameters.isParameter("Output Label") ? parameters.get<std::string>("Output Label") : name,
                 component);
  }

 private:
  std::size_t axis_;
};

/// Points of a lattice with its own spacing along each axis, x fastest; the first is at `origin`.
inline std::vector<Point> stretchedLattice(const std::array<int, 3>& counts, const Point& spacing,
                                           const Point& origin) {
  std::vector<Point> points = lattice(counts[0], counts[1], counts[2], 1.0);
  for (Point& point : points)
    for (std::size_t k = 0; k < 3; ++k) point[k] = origin[k] + spacing[k] * point[k];
  return points;
}

}  // namespace pdtest

#endif
