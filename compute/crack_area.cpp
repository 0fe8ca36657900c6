// Crack_Area: area of all cracks, from the bonds that are broken, whichever way the cracks run.
//
// The work to break every bond that crosses a plane is, with a bond energy proportional to the bond's length xi,
//   G = (c s0^2 / 2) N,   N = sum of xi V_i V_j over the bonds that cross a unit area
//     = pi horizon^5 / 5 in 3D, thickness horizon^4 / 2 in 2D
// (Silling and Askari 2005, eq. 25; its 2D form G = c s0^2 h horizon^4 / 4). So the area is the sum of xi V_i V_j over
// broken bonds, divided by N.
#include <algorithm>
#include <cmath>

#include "compute_support.hpp"
#include "plugins.hpp"

namespace pd {

class CrackArea : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle bondDamage = readsIfThere(pd::fields::bondDamage());
    FieldHandle interactionShare = readsIfThere(pd::fields::interactionShare());
    FieldHandle area;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : area(writes(outputField(parameters, pd::fields::globalScalar, "m2", "Area of all cracks."))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Crack_Area");
    declarations.real("Horizon", "m", "Horizon of the material that cracks.").positive().required();
    declarations.real("Thickness", "m", "Thickness of a plane body (default: the body is three-dimensional).")
        .positive();
  }
  CrackArea(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<CrackArea>(params, "Crack_Area"), params, comm, globalData),
        horizon_(parameters_.get<double>("Horizon")),
        thickness_(parameters_.isParameter("Thickness") ? parameters_.get<double>("Thickness") : 0.0),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  void initialize(Blocks blocks) override;
  int compute(Blocks blocks) const override;

 private:
  double shareWithinHorizon(double length, double volume) const;

  double horizon_, thickness_;
  bool hasPartialNeighbors_ = false;
  Fields fields_;
};

namespace {

double bondLength(const double* x, int i, int j) {
  return std::hypot(x[3 * j] - x[3 * i], x[3 * j + 1] - x[3 * i + 1], x[3 * j + 2] - x[3 * i + 2]);
}

}  // namespace

/// Neighbourhoods either end at the horizon or hold all points that reach into it.
void CrackArea::initialize(Blocks blocks) {
  double longest = 0.0;
  for (PeridigmNS::Block& block : *blocks) {
    const double* x = view(block, fields_.modelCoordinates);
    const auto neighborhood = block.getNeighborhoodData();
    const int* list = neighborhood->NeighborhoodList();
    for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i)
      for (int n = *list++; n > 0; --n)
        longest = std::max(longest, bondLength(x, neighborhood->OwnedIDs()[i], *list++));
  }
  hasPartialNeighbors_ = maxOverRanks(*epetraComm, longest) > horizon_ * (1.0 + 1e-6);
}

/// Share of a neighbour's volume that lies within the horizon: a ramp over one spacing around it.
double CrackArea::shareWithinHorizon(double length, double volume) const {
  if (!hasPartialNeighbors_) return 1.0;
  const double spacing = thickness_ > 0.0 ? std::sqrt(volume / thickness_) : std::cbrt(volume);
  return std::clamp((horizon_ + 0.5 * spacing - length) / spacing, 0.0, 1.0);
}

int CrackArea::compute(Blocks blocks) const {
  double sum = 0.0;
  for (PeridigmNS::Block& block : *blocks) {
    const double* bondDamage = fields_.bondDamage.ifIn(*block.getDataManager());
    if (bondDamage == nullptr) continue;
    const double* share = fields_.interactionShare.ifIn(*block.getDataManager());
    const double* volume = view(block, fields_.volume);
    const auto neighborhood = block.getNeighborhoodData();
    const double* x = view(block, fields_.modelCoordinates);
    const int* list = neighborhood->NeighborhoodList();
    std::size_t bond = 0;
    for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
      const int id = neighborhood->OwnedIDs()[i];
      for (int n = *list++; n > 0; --n, ++list, ++bond) {
        if (bondDamage[bond] <= 0.0) continue;
        const double length = bondLength(x, id, *list);
        sum += bondDamage[bond] * (share == nullptr ? 1.0 : share[bond]) * length * volume[id] * volume[*list] *
               shareWithinHorizon(length, 0.5 * (volume[id] + volume[*list]));
      }
    }
  }
  const double pi = 3.14159265358979323846;
  const double perArea = thickness_ > 0.0 ? 0.5 * thickness_ * std::pow(horizon_, 4) : 0.2 * pi * std::pow(horizon_, 5);
  // Every bond was met from both of its ends.
  setGlobal(blocks, fields_.area, 0.5 * sumOverRanks(*epetraComm, sum) / perArea);
  return 0;
}

}  // namespace pd

using pd::CrackArea;
PD_REGISTER_COMPUTE(CrackArea, "Crack_Area", "Area of all cracks, from the broken bonds.")
