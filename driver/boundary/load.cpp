#include "load.hpp"

#include <fmt/format.h>

namespace pd {

std::string Load::obstacle(const RunContents& run) const {
  if (run.solverFields.count(field()) != 0 || node().isPeridigms()) return "";
  return "no solver of this deck moves points by forces, as QuasiStatic does";
}

std::string Load::spread(double volume, const Discretization& mesh, const Communicator& comm) const {
  long long nOwned = 0;
  for (const int point : points()) nOwned += point < mesh.nOwned ? 1 : 0;
  return fmt::format("{} points of {:.6g} m3 in all", comm.sum(nOwned), volume);
}

void AxialLoad::measure(const Discretization& mesh, const Communicator& comm) {
  requireMotionAlong(component(), mesh);
  const double volume = volumeOf(points(), mesh, comm);
  scale_ = scale(volume);
  note_ = fmt::format("{}: {} {}", title(), effect(), spread(volume, mesh, comm));
}

void AxialLoad::addForceDensity(const Discretization& mesh, double t, double* forceDensity) const {
  const std::vector<double>& given = evaluate(mesh, t);
  for (std::size_t k = 0; k < given.size(); ++k)
    if (points()[k] < mesh.nOwned) forceDensity[3 * points()[k] + component()] += scale_ * given[k];
}

void AxialLoad::declareLoad(ParameterDeclarations& declare, const std::string& unit, const std::string& meaning) {
  declareNodeSet(declare);
  declare.function("Value", unit, meaning).required();
  declareCoordinate(declare);
}

}  // namespace pd
