// J_Integral: energy release rate of a crack in a plane body, J/m2, as an integral over a ring around the tip.
//
// Domain form (Li, Shih and Needleman 1985): with q falling from 1 at the inner to 0 at the outer radius of the ring,
//   J = (1/h) sum of V (sigma_ij u_i,d q_,j - W q_,d),   d the direction of growth, W the strain energy density.
// Stress and gradients are those of Bond_Stress. The crack must leave the ring along -d, and be free of traction.
// Beside planes of symmetry the ring is that of the whole body.
#include <cmath>

#include "plugins.hpp"
#include "point_deformation.hpp"
#include "whole_body.hpp"

namespace pd {

namespace {

constexpr const char* tipKey = "Tip Field";

bool isGlobalVector(const PeridigmNS::FieldSpec& spec) {
  namespace Field = PeridigmNS::PeridigmField;
  return spec.getRelation() == Field::GLOBAL && spec.getLength() == Field::VECTOR &&
         spec.getTemporal() == Field::CONSTANT;
}

}  // namespace

class JIntegral : public TabledCompute {
 public:
  struct Fields : DeformationGradients::Fields {
    FieldHandle tip;  ///< unused where the deck gives a position, or the label of no such field
    FieldHandle energyReleaseRate;
    explicit Fields(const Teuchos::ParameterList& parameters);
  };
  static void declareParameters(ParameterDeclarations& declarations);
  JIntegral(ComputeParameters params, ComputeComm comm, ComputeParameters globalData);

  const Fields& fields() const override { return fields_; }
  void initialize(Blocks blocks) override;
  int compute(Blocks blocks) const override;

 private:
  double contribution(const Tensor& gradientOfPart, int copy, const HookesLaw& law, const double* x,
                      const Vector3& tip) const;

  DeformationGradients gradients_;
  Fields fields_;
  Vector3 tip_, direction_;
  double innerRadius_, outerRadius_, thickness_;
  bool isPlaneStress_;
  Teuchos::RCP<const WholeBody> whole_;
};

void JIntegral::declareParameters(ParameterDeclarations& declarations) {
  declareCommonParameters(declarations, "J_Integral");
  HookesLaw::declareParameters(declarations);
  declarations.real("Thickness", "m", "Thickness of the plane body.").positive().required();
  declarations.real("Inner Radius", "m", "Inner radius of the ring; at least two horizons.").positive().required();
  declarations.real("Outer Radius", "m", "Outer radius of the ring.").positive().required();
  declareVector(declarations, "Direction", "1", "Direction in which the crack grows (default: x).");
  declareVector(declarations, "Tip", "m", "Position of the crack tip; what is not given is 0.");
  declarations.text(tipKey, "Label of a Crack_Tip compute whose position is used instead of \"Tip X, Y, Z\".");
}

JIntegral::Fields::Fields(const Teuchos::ParameterList& parameters) {
  if (parameters.isParameter(tipKey)) {
    const FieldDescription position =
        pd::fields::globalVector(parameters.get<std::string>(tipKey), "m", "Position of the crack tip.");
    auto& known = PeridigmNS::FieldManager::self();
    if (!known.hasField(position.label) || isGlobalVector(known.getFieldSpec(position.label)))
      tip = readsIfThere(position);
  }
  energyReleaseRate = writes(outputField(parameters, pd::fields::globalScalar, "J/m2", "Energy release rate."));
}

JIntegral::JIntegral(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
    : TabledCompute(completeParameters<JIntegral>(params, "J_Integral"), params, comm, globalData),
      fields_(parameters_),
      tip_(vectorOf(parameters_, "Tip")),
      direction_(directionOf(parameters_, "Direction")),
      innerRadius_(parameters_.get<double>("Inner Radius")),
      outerRadius_(parameters_.get<double>("Outer Radius")),
      thickness_(parameters_.get<double>("Thickness")),
      isPlaneStress_(parameters_.get<bool>("Plane Stress")),
      whole_(WholeBody::of(globalData)) {
  if (!(outerRadius_ > innerRadius_))
    throw std::invalid_argument("J_Integral: \"Outer Radius\" must be larger than \"Inner Radius\"");
}

void JIntegral::initialize(Blocks blocks) {
  if (parameters_.isParameter(tipKey) && !fields_.tip.isIn(*blocks->front().getDataManager()))
    throw std::invalid_argument("J_Integral: \"Tip Field\" \"" + parameters_.get<std::string>(tipKey) +
                                "\" is not the result of a Crack_Tip");
}

/// The integrand in a copy of the point at x, per volume and thickness; 0 outside the ring.
double JIntegral::contribution(const Tensor& gradientOfPart, int copy, const HookesLaw& law, const double* x,
                               const Vector3& tip) const {
  const Vector3 place = whole_->place(copy, x);
  const double fromTip[2] = {place[0] - tip[0], place[1] - tip[1]};
  const double radius = std::hypot(fromTip[0], fromTip[1]);
  if (radius <= innerRadius_ || radius >= outerRadius_) return 0.0;
  const Tensor deformationGradient = reflected(gradientOfPart, whole_->reflection(copy));
  const Tensor strain = strainOf(deformationGradient, false);
  const Tensor stress = law.stress(strain);
  double energy = 0.0;
  for (std::size_t k = 0; k < 9; ++k) energy += 0.5 * stress[k] * strain[k];

  const double slope = -1.0 / ((outerRadius_ - innerRadius_) * radius);
  double result = 0.0;
  for (std::size_t j = 0; j < 2; ++j) {
    const double gradientOfQ = slope * fromTip[j];
    result -= energy * direction_[j] * gradientOfQ;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t d = 0; d < 2; ++d) {
        const double displacementGradient = deformationGradient[3 * i + d] - (i == d ? 1.0 : 0.0);
        result += stress[3 * i + j] * displacementGradient * direction_[d] * gradientOfQ;
      }
  }
  return result;
}

int JIntegral::compute(Blocks blocks) const {
  Vector3 tip = tip_;
  if (fields_.tip.isUsed()) {
    const double* position = view(blocks->front(), fields_.tip);
    tip = {position[0], position[1], position[2]};
  }
  double sum = 0.0;
  for (PeridigmNS::Block& block : *blocks) {
    const double* volume = view(block, fields_.volume);
    const double* x = view(block, fields_.modelCoordinates);
    const std::vector<Tensor> gradients = gradients_.of(block);
    const HookesLaw law(*block.getMaterialModel(), isPlaneStress_);
    for (std::size_t i = 0; i < gradients.size(); ++i) {
      const int id = block.getNeighborhoodData()->OwnedIDs()[i];
      for (int copy = 0; copy < whole_->nCopies(); ++copy)
        sum += volume[id] * contribution(gradients[i], copy, law, x + 3 * id, tip);
    }
  }
  setGlobal(blocks, fields_.energyReleaseRate, sumOverRanks(*epetraComm, sum) / thickness_);
  return 0;
}

}  // namespace pd

using pd::JIntegral;
PD_REGISTER_COMPUTE(JIntegral, "J_Integral",
                    "Energy release rate of a crack in a plane body, over a ring around its tip.")
