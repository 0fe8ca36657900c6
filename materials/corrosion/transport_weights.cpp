#include "transport_weights.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "trial_calibration.hpp"

namespace pd {

namespace {

std::vector<double> numbers(const Teuchos::ParameterList& params, const char* key) {
  if (!params.isParameter(key)) return {};
  return params.get<Teuchos::Array<double>>(key).toVector();
}

kernels::HorizonShape shapeFrom(const Teuchos::ParameterList& params, const std::string& owner) {
  if (!params.isParameter("Horizon Axes")) return {};
  try {
    return {numbers(params, "Horizon Axes"), numbers(params, "Horizon Rotation"),
            params.get<std::string>("Horizon Shape") == "Box"};
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(owner + ": " + error.what());
  }
}

std::string placeOf(const double* x, int point) {
  char text[80];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", x[3 * point], x[3 * point + 1], x[3 * point + 2]);
  return text;
}

}  // namespace

void TransportWeights::declareParameters(ParameterDeclarations& declare) {
  declare.real("Diffusivity", "m2/s", "Of metal ions in the electrolyte.").positive().required();
  declare
      .text(
          "Interface Kernel",
          "What a bond between solid and electrolyte dissolves: c/|xi| within the Dissolution Range, by the direction "
          "of the front such that a plane one passes i/(z F) exactly (Flux Exact); or k/|xi|^2 within the horizon, k "
          "such that a plane front along the grid moves at i/(z F C_solid) in a trial simulation on a grid of this "
          "kind, which runs as the material is initialized (Trial Calibration; grids of one spacing).")
      .oneOf({"Flux Exact", "Trial Calibration"})
      .defaultTo("Flux Exact")
      .from("Jafarzadeh et al., Electrochim. Acta 401 (2022) 139512, section 2.2.3");
  declare
      .real(
          "Dissolution Range", "m",
          "How far apart solid and liquid points may be that exchange metal; by default 0.375 horizons, 0.6 are better "
          "for points far from a grid. Where salt covers the surface, the electrolyte is saturated as far as that. "
          "With Horizon Axes, along the longest. Not with a Trial Calibration, whose range is the horizon.")
      .positive();
  declare
      .reals("Horizon Axes", "m",
             "Half axes of the horizon along x, y, z where it is no ball; the block's Horizon is the longest. For "
             "grids whose spacings have the same ratios.")
      .from("Jafarzadeh et al., Electrochim. Acta 401 (2022) 139512, section 4");
  declare.reals("Horizon Rotation", "degrees",
                "Of these axes: one angle, about z, or three, about x, y and z in turn.");
  declare.text("Horizon Shape", "Of a horizon with axes.").oneOf({"Ellipsoid", "Box"}).defaultTo("Ellipsoid");
  declare.needs("Horizon Rotation", {"Horizon Axes"});
  BondFamily::declareGeometry(declare);
}

TransportWeights::TransportWeights(const Teuchos::ParameterList& params, const std::string& owner)
    : family_(params, owner),
      shape_(shapeFrom(params, owner)),
      owner_(owner),
      diffusivity_(params.get<double>("Diffusivity")) {
  if (!shape_.isBall()) {
    if (std::abs(family_.horizon / shape_.radius() - 1.0) > 1e-9)
      throw std::invalid_argument(owner + ": the block's \"Horizon\" must be the longest of \"Horizon Axes\", " +
                                  std::to_string(shape_.radius()) + " m");
    if (numbers(params, "Horizon Axes").size() != static_cast<std::size_t>(dimension()))
      throw std::invalid_argument(owner + ": \"Horizon Axes\" takes " + std::to_string(dimension()) +
                                  " half axes here (see \"Plane Strain\" and \"One Dimensional\")");
  }
  isByTrial_ = params.get<std::string>("Interface Kernel") == "Trial Calibration";
  if (isByTrial_ && params.isParameter("Dissolution Range"))
    throw std::invalid_argument(owner +
                                ": \"Dissolution Range\" is of the interface kernel Flux Exact; with Trial Calibration "
                                "bonds dissolve over the whole horizon: leave it out");
  if (isByTrial_ && family_.volumeCorrection == kernels::VolumeCorrection::EveryNeighbor)
    throw std::invalid_argument(owner +
                                ": a Trial Calibration needs neighbourhoods that end at the horizon: another \"Volume "
                                "Correction\" than Every Neighbor, or the interface kernel Flux Exact");
  range_ = params.isParameter("Dissolution Range") ? params.get<double>("Dissolution Range")
           : isByTrial_                            ? family_.horizon
                                                   : 0.375 * family_.horizon;
  if (range_ > family_.horizon)
    throw std::invalid_argument(owner + ": \"Dissolution Range\" must not exceed the horizon");
  setWindow();
  diffusionFactor_.fill(kernels::microDiffusivity(family_.section, kernels::DiffusionKernel::InverseSquare,
                                                  diffusivity_, family_.horizon));
  dissolutionFactor_.fill(kernels::interfaceFluxConstant(family_.section, range_));
}

void TransportWeights::setWindow() {
  constexpr double corner = 1.12, deviation = 0.375;  // horizons; neighbourhoods end half a spacing behind the horizon
  constexpr double longest = 2.0;                     // the ratio of edges
  double norm = 0.0;
  window_.fill(1.0);
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimension()); ++d) {
    window_[d] = std::min(stretch(d), longest);
    norm += window_[d] * window_[d];
  }
  for (double& edge : window_) edge *= corner * family_.horizon / std::sqrt(norm);
  windowSharpness_ = 0.5 / std::pow(deviation * family_.horizon, 2);
  // Integrals of the Gaussian over a ball.
  const double x = std::sqrt(windowSharpness_) * family_.horizon, scale = M_PI / windowSharpness_;
  const double plane = scale * (1.0 - std::exp(-x * x));
  const double solid = std::pow(scale, 1.5) * (std::erf(x) - 2.0 / std::sqrt(M_PI) * x * std::exp(-x * x));
  const double bar = std::sqrt(scale) * std::erf(x);
  gaussianSum_ = family_.section.size * (dimension() == 1 ? bar : dimension() == 2 ? plane : 1.0);
  if (dimension() == 3) gaussianSum_ = solid;
}

double TransportWeights::share(double length, double range, double volume, double neighborVolume) const {
  double spacing = spacingOf(volume);
  if (neighborVolume != volume) spacing = 0.5 * (spacing + spacingOf(neighborVolume));
  if (length > range + spacing && family_.volumeCorrection != kernels::VolumeCorrection::EveryNeighbor) return 0.0;
  const double value = kernels::volumeShare(family_.volumeCorrection, length, range, spacing);
  constexpr double roundOff = 1e-4;  // of points that lie where the share ends, but for rounded coordinates
  return value > roundOff ? value : 0.0;
}

/// Calls visit(bond) for the bonds of a point inside the grid.
template <class Visit>
void TransportWeights::forGrid(double volume, Visit visit) const {
  const double spacing = spacingOf(volume);
  const int reach = static_cast<int>(family_.horizon / spacing) + 2;
  int n[3];
  const auto range = [&](int axis) { return axis < dimension() ? reach : 0; };
  for (n[0] = -range(0); n[0] <= range(0); ++n[0])
    for (n[1] = -range(1); n[1] <= range(1); ++n[1])
      for (n[2] = -range(2); n[2] <= range(2); ++n[2]) {
        Bond bond{};
        for (std::size_t d = 0; d < 3; ++d) {
          bond.mapped[d] = n[d] * spacing;
          bond.along[d] = bond.mapped[d] * shape_.halfAxis(d) / shape_.radius();
        }
        bond.length = shape_.length(bond.mapped);
        bond.kind = kindOf(bond.mapped);
        if (bond.length > 0.0 && share(bond.length, family_.horizon, volume, volume) > 0.0) visit(bond);
      }
}

void TransportWeights::fitToGrid(double volume) {
  gridVolume_ = volume;
  gridSpacing_ = family_.spacing(shape_.volumeFactor() * volume);
  if (shape_.isBall()) return;
  // By kind of bond and axis: second moments, and first moments of one side.
  double second[3][3] = {}, first[3][3] = {};
  nNeighbors_ = 0;
  forGrid(volume, [&](const Bond& b) {
    ++nNeighbors_;
    const double far = share(b.length, family_.horizon, volume, volume) * volume / (b.length * b.length);
    const double near = share(b.length, range_, volume, volume) * volume * byLength(b.length);
    for (std::size_t d = 0; d < 3; ++d) {
      second[b.kind][d] += far * b.along[d] * b.along[d];
      first[b.kind][d] += 0.5 * near * std::abs(b.along[d]);
    }
  });
  double missing[3] = {2.0 * diffusivity_, 2.0 * diffusivity_, 2.0 * diffusivity_}, blocked[3] = {1.0, 1.0, 1.0};
  for (const std::size_t kind : shape_.longestFirst()) {
    if (kind >= static_cast<std::size_t>(dimension())) continue;
    diffusionFactor_[kind] = missing[kind] / second[kind][kind];
    dissolutionFactor_[kind] = blocked[kind] / first[kind][kind];
    if (!(std::min(diffusionFactor_[kind], dissolutionFactor_[kind]) > 0.0) || !std::isfinite(dissolutionFactor_[kind]))
      throw std::invalid_argument(owner_ + ": the horizon and \"Dissolution Range\" must reach over more spacings (" +
                                  std::to_string(nNeighbors_) + " neighbours a point); usually four, and 1.5");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      missing[axis] -= diffusionFactor_[kind] * second[kind][axis];
      blocked[axis] -= dissolutionFactor_[kind] * first[kind][axis];
    }
  }
}

/// Over bonds of several kinds, the constant of a front that stays plane, which is that of fitToGrid, is multiplied by
/// what the trial finds besides.
void TransportWeights::calibrateByTrial(bool breaksBondsAtRandom) {
  // Lest what volumes are rounded to makes a case of its own.
  constexpr double digits = 1e6;
  const TrialCase trial{dimension(), std::round(digits * family_.horizon / gridSpacing_) / digits, shape_.isBox(),
                        family_.volumeCorrection, breaksBondsAtRandom};
  TrialResult result;
  try {
    result = trialCalibration(trial);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(owner_ + ": " + error.what());
  }
  if (shape_.isBall())
    dissolutionFactor_.fill(result.dissolvability * gridSpacing_ / gridVolume_);
  else
    for (double& factor : dissolutionFactor_) factor *= result.dissolvability * result.firstMoment;
  char text[200];
  std::snprintf(
      text, sizeof text,
      ": k = %.6g (spacings, cells), %.5f of what a front that stays plane takes; measured over %.0f spacings",
      result.dissolvability, result.dissolvability * result.firstMoment, result.spacings);
  trialOutcome_ = "trial calibration, " + trial.description() + text;
}

void TransportWeights::checkGrid(const double* x, const double* volume, int point, const int* neighbors,
                                 int count) const {
  constexpr double rounding = 1e-5;
  for (int k = 0; k < count && isByTrial_; ++k)
    if (std::abs(volume[neighbors[k]] / gridVolume_ - 1.0) > rounding)
      throw std::invalid_argument(owner_ + ": a Trial Calibration is of one grid, but volumes of points near " +
                                  placeOf(x, point) + " differ, " + std::to_string(volume[neighbors[k]] / gridVolume_) +
                                  " of the first; use the interface kernel Flux Exact on such meshes");
  if (shape_.isBall() || count < nNeighbors_) return;
  double moment[3] = {};
  for (int k = 0; k < count; ++k) {
    const Bond b = bond(x, point, neighbors[k]);
    const double weight = diffusion(b, volume[point], volume[neighbors[k]]) * volume[neighbors[k]];
    for (std::size_t d = 0; d < 3; ++d) moment[d] += 0.5 * weight * b.along[d] * b.along[d];
  }
  for (int d = 0; d < dimension(); ++d)
    if (std::abs(moment[d] / diffusivity_ - 1.0) > 0.05)
      throw std::invalid_argument(
          owner_ + ": bonds near " + placeOf(x, point) + " diffuse " + std::to_string(moment[d] / diffusivity_) +
          " D along axis " + std::to_string(d + 1) +
          " of the horizon; \"Horizon Axes\" are for points on a grid along these axes, with spacings of their ratio");
}

}  // namespace pd
