// Stress_Intensity: K_I and K_II of a crack in a plane body, Pa m^0.5, by interaction integrals over a ring around the
// tip.
//
// With the fields of Williams for K_I = 1 or K_II = 1 (a) beside those of the body, and q falling from 1 at the inner
// to 0 at the outer radius of the ring (Yau, Wang and Corten 1980, in domain form),
//   M = (1/h) sum of V [(sigma_ij u^a_i,d + sigma^a_ij u_i,d) q_,j - sigma_ij e^a_ij q_,d],   K = E' M / 2,
// d the direction of growth. Stress and gradients are those of Bond_Stress. The crack must leave the ring along -d, and
// be free of traction. Beside planes of symmetry the ring is that of the whole body.
#include <cmath>

#include "plugins.hpp"
#include "run_notes.hpp"
#include "tip_ring.hpp"
#include "whole_body.hpp"

namespace pd {

namespace {

/// K of the auxiliary fields over the shear modulus, m^0.5: strains far above the rounding of a deformation gradient.
constexpr double auxiliary = 1e-4;

/// u_i,j near a tip at the origin whose crack lies along -x, for this K of a mode (1 or 2), at (x, y).
std::array<double, 4> williamsGradient(int mode, double x, double y, double kappa) {
  const double r = std::hypot(x, y), t = std::atan2(y, x), scale = 0.5 * auxiliary / std::sqrt(2.0 * M_PI * r);
  const double c = std::cos(0.5 * t), s = std::sin(0.5 * t), cosine = std::cos(t), sine = std::sin(t);
  // u = scale' sqrt(r) g(t)
  std::array<double, 2> g{}, slope{};
  if (mode == 1) {
    g = {c * (kappa - cosine), s * (kappa - cosine)};
    slope = {-0.5 * s * (kappa - cosine) + c * sine, 0.5 * c * (kappa - cosine) + s * sine};
  } else {
    g = {s * (kappa + 2.0 + cosine), -c * (kappa - 2.0 + cosine)};
    slope = {0.5 * c * (kappa + 2.0 + cosine) - s * sine, 0.5 * s * (kappa - 2.0 + cosine) + c * sine};
  }
  std::array<double, 4> gradient{};
  for (std::size_t i = 0; i < 2; ++i) {
    gradient[2 * i] = scale * (0.5 * cosine * g[i] - sine * slope[i]);
    gradient[2 * i + 1] = scale * (0.5 * sine * g[i] + cosine * slope[i]);
  }
  return gradient;
}

}  // namespace

class StressIntensity : public TabledCompute, public RunNotes {
 public:
  struct Fields : TipFields {
    FieldHandle intensities;
    explicit Fields(const Teuchos::ParameterList& parameters) : TipFields(parameters) {
      intensities = writes(outputField(parameters, pd::fields::globalVector, "Pa m^0.5", "K_I, K_II and 0."));
    }
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    TipRing::declareParameters(declarations, "Stress_Intensity");
  }
  StressIntensity(ComputeParameters params, ComputeComm comm, ComputeParameters globalData);

  const Fields& fields() const override { return fields_; }
  void initialize(Blocks blocks) override { ring_.requireTip(blocks->front(), fields_.tip); }
  int compute(Blocks blocks) const override;
  std::vector<std::string> runNotes() const override {
    return ring_.notes(parameters_.get<std::string>("Output Label"));
  }

 private:
  /// What a copy of a point adds to E' M/2 of both modes, per volume and thickness.
  std::array<double, 2> contribution(const Tensor& deformationGradient, const PeridigmNS::Material& material,
                                     const Vector3& place, const TipRing::Tip& tip) const;

  DeformationGradients gradients_;
  Fields fields_;
  TipRing ring_;
  Teuchos::RCP<const WholeBody> whole_;
};

StressIntensity::StressIntensity(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
    : TabledCompute(completeParameters<StressIntensity>(params, "Stress_Intensity"), params, comm, globalData),
      fields_(parameters_),
      ring_(parameters_, "Stress_Intensity"),
      whole_(WholeBody::of(globalData)) {}

std::array<double, 2> StressIntensity::contribution(const Tensor& deformationGradient,
                                                    const PeridigmNS::Material& material, const Vector3& place,
                                                    const TipRing::Tip& tip) const {
  const double fromTip[2] = {place[0] - tip.place[0], place[1] - tip.place[1]};
  const double radius = std::hypot(fromTip[0], fromTip[1]);
  if (!ring_.holds(radius)) return {0.0, 0.0};
  const double bulk = material.BulkModulus(), shear = material.ShearModulus();
  const double poisson = (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear));
  const double kappa = ring_.isPlaneStress() ? (3.0 - poisson) / (1.0 + poisson) : 3.0 - 4.0 * poisson;
  const double modulus = 2.0 * shear * (1.0 + poisson) / (ring_.isPlaneStress() ? 1.0 : 1.0 - poisson * poisson);
  const HookesLaw law(material, ring_.isPlaneStress());
  const Tensor stress = law.stress(strainOf(deformationGradient, false));
  const std::array<double, 4> axes{tip.direction[0], -tip.direction[1], tip.direction[1],
                                   tip.direction[0]};  // columns: d, n
  const double x = axes[0] * fromTip[0] + axes[2] * fromTip[1], y = axes[1] * fromTip[0] + axes[3] * fromTip[1];
  const double slope = ring_.slope(radius);
  std::array<double, 2> result{};
  for (int mode = 1; mode <= 2; ++mode) {
    const std::array<double, 4> local = williamsGradient(mode, x, y, kappa);
    Tensor gradient{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};  // a deformation gradient
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j)
        for (std::size_t k = 0; k < 2; ++k)
          for (std::size_t l = 0; l < 2; ++l)
            gradient[3 * i + j] += axes[2 * i + k] * local[2 * k + l] * axes[2 * j + l];
    const Tensor auxiliaryStrain = strainOf(gradient, false), auxiliaryStress = law.stress(auxiliaryStrain);
    double sum = 0.0;
    for (std::size_t j = 0; j < 2; ++j) {
      const double gradientOfQ = slope * fromTip[j];
      for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t d = 0; d < 2; ++d) {
          const double identity = i == d ? 1.0 : 0.0;
          sum += (stress[3 * i + j] * (gradient[3 * i + d] - identity) +
                  auxiliaryStress[3 * i + j] * (deformationGradient[3 * i + d] - identity)) *
                 tip.direction[d] * gradientOfQ;
        }
        for (std::size_t k = 0; k < 2; ++k)
          sum -= stress[3 * i + k] * auxiliaryStrain[3 * i + k] * tip.direction[j] * gradientOfQ;
      }
    }
    result[static_cast<std::size_t>(mode - 1)] = 0.5 * modulus / (auxiliary * shear) * sum;
  }
  return result;
}

int StressIntensity::compute(Blocks blocks) const {
  const TipRing::Tip tip = ring_.tip(blocks->front(), fields_);
  ring_.watchCover(blocks, fields_, *whole_, tip, *epetraComm);
  std::vector<double> sums(2, 0.0);
  for (PeridigmNS::Block& block : *blocks) {
    const double* volume = view(block, fields_.volume);
    const double* x = view(block, fields_.modelCoordinates);
    const std::vector<Tensor> gradients = gradients_.of(block, TipRing::leastIntact);
    for (std::size_t i = 0; i < gradients.size(); ++i) {
      const int id = block.getNeighborhoodData()->OwnedIDs()[i];
      for (int copy = 0; copy < whole_->nCopies(); ++copy) {
        const Vector3 place = whole_->place(copy, x + 3 * id);
        const auto part =
            contribution(reflected(gradients[i], whole_->reflection(copy)), *block.getMaterialModel(), place, tip);
        for (std::size_t mode = 0; mode < 2; ++mode) sums[mode] += volume[id] * part[mode];
      }
    }
  }
  sums = sumOverRanks(*epetraComm, sums);
  const std::array<double, 3> intensities{sums[0] / ring_.thickness(), sums[1] / ring_.thickness(), 0.0};
  setGlobal(blocks, fields_.intensities, intensities.data(), 3);
  return 0;
}

}  // namespace pd

using pd::StressIntensity;
PD_REGISTER_COMPUTE(StressIntensity, "Stress_Intensity",
                    "K_I and K_II of a crack in a plane body, over a ring around its tip.")
