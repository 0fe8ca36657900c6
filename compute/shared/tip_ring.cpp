#include "tip_ring.hpp"

#include <cmath>
#include <sstream>

#include "ring_cover.hpp"

namespace pd {

void TipRing::declareParameters(ParameterDeclarations& declarations, const char* compute) {
  TipPlace::declareParameters(declarations, compute);
  HookesLaw::declareParameters(declarations);
  declarations.real("Inner Radius", "m", "Inner radius of the ring; one horizon at least.").positive().required();
  declarations.real("Outer Radius", "m", "Outer radius of the ring.").positive().required();
}

TipRing::TipRing(const Teuchos::ParameterList& parameters, std::string compute)
    : TipPlace(parameters, std::move(compute)),
      innerRadius_(parameters.get<double>("Inner Radius")),
      outerRadius_(parameters.get<double>("Outer Radius")),
      isPlaneStress_(parameters.get<bool>("Plane Stress")) {
  if (!(outerRadius_ > innerRadius_))
    throw std::invalid_argument(compute_ + ": \"Outer Radius\" must be larger than \"Inner Radius\"");
}

void TipRing::watchCover(const Blocks& blocks, const TipFields& fields, const WholeBody& whole, const Tip& tip,
                         const Epetra_Comm& comm) const {
  if (!gap_.empty() || watched_ == tip.place) return;
  watched_ = tip.place;
  const auto forEachPoint = [&](const auto& visit) {
    for (PeridigmNS::Block& block : *blocks) {
      const double *x = view(block, fields.modelCoordinates), *volume = view(block, fields.volume);
      const auto points = block.getNeighborhoodData();
      for (int p = 0; p < points->NumOwnedPoints(); ++p)
        visit(x + 3 * points->OwnedIDs()[p], volume[points->OwnedIDs()[p]]);
    }
  };
  double spacing = 0.0;
  forEachPoint([&](const double*, double volume) { spacing = std::max(spacing, std::sqrt(volume / thickness())); });
  RingCover cover(innerRadius_, outerRadius_, maxOverRanks(comm, spacing));
  const auto [c, s] = std::array<double, 2>{tip.direction[0], tip.direction[1]};
  forEachPoint([&, c = c, s = s](const double* x, double volume) {
    for (int copy = 0; copy < whole.nCopies(); ++copy) {
      const Vector3 place = whole.place(copy, x);
      const double dx = place[0] - tip.place[0], dy = place[1] - tip.place[1];
      cover.add(c * dx + s * dy, c * dy - s * dx, volume / thickness());
    }
  });
  const auto gap = cover.gap(comm);
  if (!gap) return;
  const auto [a, b] = *gap;
  std::ostringstream text;
  text
      << "with the tip at (" << tip.place[0] << ", " << tip.place[1]
      << ") m the body does not fill the ring, as around (" << tip.place[0] + a * c - b * s << ", "
      << tip.place[1] + a * s + b * c
      << ") m: across an end of the body, or over a hole, the integral is not that of the crack; make the ring smaller";
  gap_ = text.str();
}

std::vector<std::string> TipRing::notes(const std::string& label) const {
  return gap_.empty() ? std::vector<std::string>() : std::vector<std::string>{label + ": " + gap_};
}

}  // namespace pd
