// J_Integral: energy release rate of a crack in a plane body, J/m2, as an integral over a ring around the tip.
//
// Domain form (Li, Shih and Needleman 1985): with q falling from 1 at the inner to 0 at the outer radius of the ring,
//   J = (1/h) sum of V (sigma_ij u_i,d q_,j - W q_,d),   d the direction of growth, W the strain energy density.
// Stress and gradients are those of Bond_Stress. The crack must leave the ring along -d, and be free of traction.
// Beside planes of symmetry the ring is that of the whole body.
#include <cmath>

#include "plugins.hpp"
#include "run_notes.hpp"
#include "tip_ring.hpp"
#include "whole_body.hpp"

namespace pd {

class JIntegral : public TabledCompute, public RunNotes {
 public:
  struct Fields : TipFields {
    FieldHandle energyReleaseRate;
    explicit Fields(const Teuchos::ParameterList& parameters) : TipFields(parameters) {
      energyReleaseRate = writes(outputField(parameters, pd::fields::globalScalar, "J/m2", "Energy release rate."));
    }
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    TipRing::declareParameters(declarations, "J_Integral");
  }
  JIntegral(ComputeParameters params, ComputeComm comm, ComputeParameters globalData);

  const Fields& fields() const override { return fields_; }
  void initialize(Blocks blocks) override { ring_.requireTip(blocks->front(), fields_.tip); }
  int compute(Blocks blocks) const override;
  std::vector<std::string> runNotes() const override {
    return ring_.notes(parameters_.get<std::string>("Output Label"));
  }

 private:
  double contribution(const Tensor& gradientOfPart, int copy, const HookesLaw& law, const double* x,
                      const TipRing::Tip& tip) const;

  DeformationGradients gradients_;
  Fields fields_;
  TipRing ring_;
  Teuchos::RCP<const WholeBody> whole_;
};

JIntegral::JIntegral(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
    : TabledCompute(completeParameters<JIntegral>(params, "J_Integral"), params, comm, globalData),
      fields_(parameters_),
      ring_(parameters_, "J_Integral"),
      whole_(WholeBody::of(globalData)) {}

/// The integrand in a copy of the point at x, per volume and thickness; 0 outside the ring.
double JIntegral::contribution(const Tensor& gradientOfPart, int copy, const HookesLaw& law, const double* x,
                               const TipRing::Tip& tip) const {
  const Vector3 place = whole_->place(copy, x);
  const double fromTip[2] = {place[0] - tip.place[0], place[1] - tip.place[1]};
  const double radius = std::hypot(fromTip[0], fromTip[1]);
  if (!ring_.holds(radius)) return 0.0;
  const Tensor deformationGradient = reflected(gradientOfPart, whole_->reflection(copy));
  const Tensor strain = strainOf(deformationGradient, false);
  const Tensor stress = law.stress(strain);
  double energy = 0.0;
  for (std::size_t k = 0; k < 9; ++k) energy += 0.5 * stress[k] * strain[k];

  const double slope = ring_.slope(radius);
  double result = 0.0;
  for (std::size_t j = 0; j < 2; ++j) {
    const double gradientOfQ = slope * fromTip[j];
    result -= energy * tip.direction[j] * gradientOfQ;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t d = 0; d < 2; ++d) {
        const double displacementGradient = deformationGradient[3 * i + d] - (i == d ? 1.0 : 0.0);
        result += stress[3 * i + j] * displacementGradient * tip.direction[d] * gradientOfQ;
      }
  }
  return result;
}

int JIntegral::compute(Blocks blocks) const {
  const TipRing::Tip tip = ring_.tip(blocks->front(), fields_);
  ring_.watchCover(blocks, fields_, *whole_, tip, *epetraComm);
  double sum = 0.0;
  for (PeridigmNS::Block& block : *blocks) {
    const double* volume = view(block, fields_.volume);
    const double* x = view(block, fields_.modelCoordinates);
    const std::vector<Tensor> gradients = gradients_.of(block, TipRing::leastIntact);
    const HookesLaw law(*block.getMaterialModel(), ring_.isPlaneStress());
    for (std::size_t i = 0; i < gradients.size(); ++i) {
      const int id = block.getNeighborhoodData()->OwnedIDs()[i];
      for (int copy = 0; copy < whole_->nCopies(); ++copy)
        sum += volume[id] * contribution(gradients[i], copy, law, x + 3 * id, tip);
    }
  }
  setGlobal(blocks, fields_.energyReleaseRate, sumOverRanks(*epetraComm, sum) / ring_.thickness());
  return 0;
}

}  // namespace pd

using pd::JIntegral;
PD_REGISTER_COMPUTE(JIntegral, "J_Integral",
                    "Energy release rate of a crack in a plane body, over a ring around its tip.")
