// A scalar that a flow carries along and that diffuses in it.
#include <algorithm>
#include <array>
#include <optional>

#include "Peridigm_Material.hpp"
#include "advection.hpp"
#include "asymmetric_rate.hpp"
#include "bond_family.hpp"
#include "diffusivity_field.hpp"
#include "flow_fields.hpp"
#include "plugins.hpp"
#include "unknowns.hpp"

namespace pd {

using PeridigmNS::DataManager;

/// Of a point i of the flow,
///   dC_i/dt = - sum_j U_ij C_ij + sum_j w_ij (C_j - C_i)/s_ij,
/// U_ij the Bond_Flow to neighbour j, that a solver of flow has balanced, C_ij what the bond carries
/// (kernels/advection.hpp), s_ij its Bond_Opening: bonds that meet a wall end there, with the value of the point beyond
/// it; w_ij = 2 d D V_j/(V_H |xi|^2), d the dimension, V_H the mean volume of both neighbourhoods, in bodies of
/// revolution those of the plane, times the share of the rings (kernels/rings.hpp). What leaves one end of a bond
/// arrives at the other. Bonds between two points beyond the flow carry nothing, nor do those to points in which the
/// scalar does not diffuse: walls of another block.
///
/// C_ij of Limited has kinks, but is homogeneous: the sum of its derivatives times the values that it is made of. Where
/// a solver has the field <label>_Limited_At, derivatives are those at its values, so that the solver may hold them:
/// C_ij is linear then, and the same wherever both fields agree.
class AdvectionDiffusion : public PeridigmNS::Material, public FieldUser, public AsymmetricRate {
 public:
  struct Fields : FieldTable {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle fluid = reads(pd::fields::fluidShare());
    FieldHandle flow = reads(pd::fields::bondFlow());
    FieldHandle opening = reads(pd::fields::bondOpening());
    FieldHandle value, rate, diffusivity, familyVolume, limitedAt;
    std::string label;
    Fields(const std::string& field, bool diffuses, bool isLimited) : label(field) {
      value = reads(pd::fields::diffusingScalar(label));
      rate = adds(pd::fields::fluxDivergence(label));
      if (isLimited) limitedAt = readsIfThere(pd::fields::limitedAt(label));
      if (!diffuses) return;
      diffusivity = writes(diffusivityOf(label), Ghosts::AfterInitialize);
      familyVolume = writes(pd::fields::pointScalar(label + "_Family_Volume", "m3", "What bonds of the point reach."),
                            Ghosts::AfterInitialize);
    }
  };

  static void declareParameters(ParameterDeclarations& declare) {
    declare.text("Material Model", "Name of this model.").defaultTo("Advection Diffusion");
    declare.text("Field", "Label of the scalar that the flow carries; its rate goes to <label>_Flux_Divergence.")
        .defaultTo("Concentration");
    declare
        .real("Diffusivity", "m2/s",
              "Diffusivity in the fluid; 0 where another material of the block sees to that, as Corrosion Dissolution.")
        .defaultTo(0.0)
        .atLeast(0.0);
    declare
        .text("Scheme",
              "What a bond carries: the value of the end that the flow comes from and as much of the slope there as "
              "makes no new extremes (Limited, of second order), or a fixed mean of its ends (Upwind Biased).")
        .oneOf({"Limited", "Upwind Biased"})
        .defaultTo("Limited")
        .from("Limited: van Leer, J. Comput. Phys. 14 (1974) 361");
    declare
        .real(
            "Upwind Share", "1",
            "Of Upwind Biased: 1 takes the end that the flow comes from (first order, no new extremes), 0 the mean of "
            "both ends (second order, with wiggles where U |xi|/D > 2).")
        .between(0.0, 1.0)
        .defaultTo(1.0);
    declare
        .real("Gradient Horizon", "m",
              "Reach of the slopes of Limited, at most half of the horizon, which is the default.")
        .positive();
    declare.real("Horizon", "m", "Radius of the neighbourhood; given by the block.").positive();
    BondFamily::declareSection(declare);
    BondFamily::declareAxis(declare);
    declare.text("Volume Correction", "As of PDHE; by default none.")
        .oneOf({"Ramp Beyond Horizon", "Ramp To Horizon", "None", "Every Neighbor"})
        .defaultTo("None");
  }

  explicit AdvectionDiffusion(const Teuchos::ParameterList& given)
      : AdvectionDiffusion(given, completed<AdvectionDiffusion>(given, "material Advection Diffusion")) {}
  static FieldTable describeFields() { return Fields("Concentration", true, true); }

  std::string Name() const override { return "Advection Diffusion"; }
  double Density() const override {
    throw std::invalid_argument("material Advection Diffusion has no mechanics, which this solver needs");
  }
  double BulkModulus() const override { return 0.0; }
  double ShearModulus() const override { return 0.0; }
  bool isAsymmetric(const std::string& label) const override { return label == fields_.label; }
  const FieldTable& fields() const override { return fields_; }
  std::vector<int> FieldIds() const override { return fields_.ids(); }
  std::vector<int> FieldIdsForSynchronizationAfterInitialize() const override {
    return fields_.ids(Ghosts::AfterInitialize);
  }

  void initialize(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  DataManager& dataManager) override {
    if (diffusivity_ == 0.0) return;
    const double* x = fields_.modelCoordinates.of(dataManager);
    const std::vector<double> volume =
        family_.rings.planeVolumes(x, fields_.volume.of(dataManager), fields_.volume.length(dataManager));
    double *diffusivity = fields_.diffusivity.of(dataManager), *family = fields_.familyVolume.of(dataManager);
    const Call call{numOwnedPoints, ownedIDs, neighborhoodList};
    for (int p = 0; p < numOwnedPoints; ++p) {
      diffusivity[ownedIDs[p]] = diffusivity_;
      family[ownedIDs[p]] = 0.0;
    }
    forEachBond(call, [&](int i, int j, std::size_t) {
      const std::size_t own = static_cast<std::size_t>(i), other = static_cast<std::size_t>(j);
      family[i] += volume[other] * family_.share(ReferenceBond(x, i, j).length, volume[own], volume[other]);
    });
  }

  void computeForce(const double, const int, const int*, const int*, DataManager&) const override {}

  void computeFluxDivergence(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                             DataManager& dataManager) const override {
    const Views views(fields_, dataManager);
    std::fill(views.rate, views.rate + fields_.rate.length(dataManager), 0.0);
    forEachPoint({numOwnedPoints, ownedIDs, neighborhoodList}, [&](const Family& family) {
      const int i = family.point;
      const auto carry = [&](int j, double flux) {
        views.rate[i] -= flux;
        views.rate[j] += flux * views.volume[i] / views.volume[j];
      };
      if (views.fluid[i] == 0.0) return;
      diffuse(views, family, [&](int j, double weight, bool isBoth) {
        const double flux = weight * (views.value[j] - views.value[i]);
        views.rate[i] += flux;
        if (isBoth) views.rate[j] -= flux * views.volume[i] / views.volume[j];
      });
      advect(views, family, [&](const Carried& carried) { carry(carried.to, carried.flow * carried.value.value); });
    });
  }

  void computeJacobian(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                       DataManager& dataManager, PeridigmNS::SerialMatrix& jacobian, JacobianType) const override {
    const UnknownPlace place = unknownPlace(fields_.label);
    if (!place.isUnknown) return;
    const Views views(fields_, dataManager);
    const auto& map = *dataManager.getOverlapScalarPointMap();
    const auto row = [&](int i) { return place.row(map.GID(i)); };
    forEachPoint({numOwnedPoints, ownedIDs, neighborhoodList}, [&](const Family& family) {
      const int i = family.point, own = row(i);
      if (views.fluid[i] == 0.0) return;
      diffuse(views, family, [&](int j, double weight, bool isBoth) {
        const double w = weight * views.volume[i];
        const int other = row(j);
        jacobian.addValue(own, other, w);
        jacobian.addValue(own, own, -w);
        if (!isBoth) return;
        jacobian.addValue(other, own, w);
        jacobian.addValue(other, other, -w);
      });
      advect(views, family, [&](const Carried& carried) {
        const int to = row(carried.to);
        const auto add = [&](int column, double derivative) {
          const double value = carried.flow * views.volume[i] * derivative;
          if (value == 0.0) return;
          jacobian.addValue(own, column, -value);
          jacobian.addValue(to, column, value);
        };
        add(row(carried.upwind), carried.value.byUpwind);
        add(to, carried.value.byDownwind);
        if (carried.value.byFar == 0.0) return;
        carried.far->forEach([&](int k, double weight) { add(row(k), carried.value.byFar * weight); });
      });
    });
  }

 private:
  struct Views {
    const double *x, *volume, *fluid, *flow, *opening, *value, *diffusivity, *familyVolume;
    const double* limitedAt;  ///< null: at `value`
    double* rate;
    Views(const Fields& fields, DataManager& data)
        : x(fields.modelCoordinates.of(data)),
          volume(fields.volume.of(data)),
          fluid(fields.fluid.of(data)),
          flow(fields.flow.of(data)),
          opening(fields.opening.of(data)),
          value(fields.value.of(data)),
          diffusivity(fields.diffusivity.isUsed() ? fields.diffusivity.of(data) : nullptr),
          familyVolume(fields.familyVolume.isUsed() ? fields.familyVolume.of(data) : nullptr),
          limitedAt(fields.limitedAt.ifIn(data)),
          rate(fields.rate.of(data)) {}
    const double* slopesOf() const { return limitedAt == nullptr ? value : limitedAt; }
  };
  struct Family {
    int point, count;
    const int* neighbors;
    std::size_t firstBond;
  };
  /// The value upwind of a point, as a sum over points around it.
  struct FarValue {
    double value = 0.0;
    std::vector<std::pair<int, double>> weights;
    /// Of a value that a bond from i to j carries, by its derivatives.
    double linear(const kernels::CarriedValue& carried, const double* values, int i, int j) const {
      double sum = carried.byUpwind * values[i] + carried.byDownwind * values[j];
      if (carried.byFar != 0.0)
        for (const auto& [point, weight] : weights) sum += carried.byFar * weight * values[point];
      return sum;
    }
    template <class Visit>
    void forEach(Visit visit) const {
      for (const auto& [point, weight] : weights) visit(point, weight);
    }
  };
  /// What a bond carries from the point to its end `to`; `upwind`: whose value it is.
  struct Carried {
    int to, upwind;
    double flow;  ///< of the point, 1/s
    kernels::CarriedValue value;
    const FarValue* far;
  };
  /// Fits the slopes at a point, and finds the extremes around it.
  class Slopes;

  AdvectionDiffusion(const Teuchos::ParameterList& given, const Teuchos::ParameterList& params)
      : Material(given),
        family_(params, "material Advection Diffusion"),
        diffusivity_(params.get<double>("Diffusivity")),
        upwindShare_(params.get<double>("Upwind Share")),
        isLimited_(params.get<std::string>("Scheme") == "Limited"),
        fields_(params.get<std::string>("Field"), diffusivity_ > 0.0, isLimited_) {
    const double half = 0.5 * family_.horizon;
    gradientHorizon_ = params.isParameter("Gradient Horizon") ? params.get<double>("Gradient Horizon") : half;
    if (gradientHorizon_ > half)
      throw std::invalid_argument("material Advection Diffusion: \"Gradient Horizon\" " +
                                  std::to_string(gradientHorizon_) + " m is more than half of the horizon, " +
                                  std::to_string(family_.horizon) +
                                  " m; slopes at neighbours must lie within the neighbourhood");
    if (isLimited_ && upwindShare_ != 1.0)
      throw std::invalid_argument(
          "material Advection Diffusion: \"Upwind Share\" has no meaning with Scheme: Limited (it belongs to Upwind "
          "Biased)");
  }

  template <class Visit>
  static void forEachPoint(const Call& call, Visit visit) {
    const int* list = call.neighborhoodList;
    std::size_t bond = 0;
    for (int p = 0; p < call.nOwned; ++p) {
      const int count = *list++;
      visit(Family{call.ownedIds[p], count, list, bond});
      list += count;
      bond += static_cast<std::size_t>(count);
    }
  }

  /// visit(neighbour, rate constant, whether the neighbour is beyond the flow and leaves its part to this point).
  template <class Visit>
  void diffuse(const Views& views, const Family& family, Visit visit) const {
    if (diffusivity_ == 0.0) return;
    const int i = family.point;
    for (int k = 0; k < family.count; ++k) {
      const int j = family.neighbors[k];
      const double opening = views.opening[family.firstBond + static_cast<std::size_t>(k)];
      const double diffusivity = views.diffusivity[j];
      if (opening == 0.0 || diffusivity == 0.0) continue;
      const double length = ReferenceBond(views.x, i, j).length;
      const bool isBeyond = views.fluid[j] == 0.0;
      const double whole = isBeyond ? views.familyVolume[i] : 0.5 * (views.familyVolume[i] + views.familyVolume[j]);
      const double both = 2.0 * diffusivity_ * diffusivity / (diffusivity_ + diffusivity);
      const double here = family_.rings.planeVolume(views.x, views.volume, i);
      const double there = family_.rings.planeVolume(views.x, views.volume, j);
      const double volume =
          there * family_.share(length, here, there) * family_.ringShare(views.x, i, j, here, there, opening);
      visit(j, 2.0 * family_.dimension() * both * volume / (whole * length * length * opening), isBeyond);
    }
  }

  /// visit(Carried) for all that leaves the point, and for what enters it from beyond the flow.
  template <class Visit>
  void advect(const Views& views, const Family& family, Visit visit) const;

  BondFamily family_;
  double diffusivity_, upwindShare_, gradientHorizon_ = 0.0;
  bool isLimited_;
  Fields fields_;
};

class AdvectionDiffusion::Slopes {
 public:
  Slopes(const AdvectionDiffusion& material, const Views& views, const Family& family)
      : dimension_(static_cast<std::size_t>(material.family_.dimension())),
        value_(views.slopesOf()),
        point_(family.point) {
    lowest_ = highest_ = value_[point_];
    atLowest_ = atHighest_ = point_;
    std::array<double, 9> moments{};
    for (int k = 0; k < family.count; ++k) {
      const int j = family.neighbors[k];
      const std::size_t bond = family.firstBond + static_cast<std::size_t>(k);
      // Beyond an inlet there is a value, beyond an outflow or a wall there is none.
      if (views.fluid[j] == 0.0 ? !(views.flow[bond] < 0.0) : views.opening[bond] != 1.0) continue;
      const ReferenceBond geometry(views.x, point_, j);
      if (geometry.length > material.gradientHorizon_ * (1.0 + 1e-9)) continue;
      const double weight = views.volume[j] / (geometry.length * geometry.length);
      bonds_.push_back({j, weight, geometry.xi});
      for (std::size_t a = 0; a < dimension_; ++a)
        for (std::size_t b = 0; b < dimension_; ++b) moments[3 * a + b] += weight * geometry.xi[a] * geometry.xi[b];
      include(j);
    }
    invert(moments);
  }

  /// As far behind the point as the end of `xi` is before it, within the values around the point.
  void findFar(int to, const std::array<double, 3>& xi, FarValue& far) const {
    std::array<double, 3> along{};  // of the slope, its inverse moments times xi
    for (std::size_t a = 0; a < dimension_; ++a)
      for (std::size_t b = 0; b < dimension_; ++b) along[a] += inverse_[3 * a + b] * xi[b];
    far.weights.clear();
    far.value = value_[to];
    double ofPoint = 0.0;
    for (const Bond& bond : bonds_) {
      double weight = 0.0;
      for (std::size_t a = 0; a < dimension_; ++a) weight -= 2.0 * bond.weight * along[a] * bond.xi[a];
      if (weight == 0.0) continue;
      ofPoint -= weight;
      far.value += weight * (value_[bond.neighbor] - value_[point_]);
      far.weights.emplace_back(bond.neighbor, weight);
    }
    far.weights.emplace_back(to, 1.0);
    far.weights.emplace_back(point_, ofPoint);
    if (far.value >= lowest_ && far.value <= highest_) return;
    const bool isLow = far.value < lowest_;
    far.value = isLow ? lowest_ : highest_;
    far.weights.assign(1, {isLow ? atLowest_ : atHighest_, 1.0});
  }

 private:
  struct Bond {
    int neighbor;
    double weight;
    std::array<double, 3> xi;
  };

  void include(int j) {
    const double value = value_[j];
    if (value < lowest_) {
      lowest_ = value;
      atLowest_ = j;
    }
    if (value > highest_) {
      highest_ = value;
      atHighest_ = j;
    }
  }

  /// Where points lie on a line, or there are none, there is no slope.
  void invert(std::array<double, 9> m) {
    inverse_ = {};
    double size = 0.0;
    for (std::size_t a = 0; a < dimension_; ++a) size += m[4 * a];
    for (std::size_t a = dimension_; a < 3; ++a) m[4 * a] = size;
    const auto minor = [&](std::size_t r, std::size_t c) {
      const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
      return m[3 * r1 + c1] * m[3 * r2 + c2] - m[3 * r1 + c2] * m[3 * r2 + c1];
    };
    const double determinant = m[0] * minor(0, 0) + m[1] * minor(0, 1) + m[2] * minor(0, 2);
    if (!(determinant > 1e-6 * size * size * size)) return;
    for (std::size_t a = 0; a < dimension_; ++a)
      for (std::size_t b = 0; b < dimension_; ++b) inverse_[3 * a + b] = minor(b, a) / determinant;
  }

  std::size_t dimension_;
  const double* value_;  ///< by local id
  int point_;
  double lowest_, highest_;
  int atLowest_, atHighest_;
  std::vector<Bond> bonds_;
  std::array<double, 9> inverse_{};
};

template <class Visit>
void AdvectionDiffusion::advect(const Views& views, const Family& family, Visit visit) const {
  const int i = family.point;
  const double* flow = views.flow + family.firstBond;
  const bool leaves = std::any_of(flow, flow + family.count, [](double value) { return value > 0.0; });
  std::optional<Slopes> slopes;
  if (isLimited_ && leaves) slopes.emplace(*this, views, family);
  FarValue far;
  for (int k = 0; k < family.count; ++k) {
    const int j = family.neighbors[k];
    const bool isBeyond = views.fluid[j] == 0.0;
    if (flow[k] == 0.0 || (flow[k] < 0.0 && !isBeyond)) continue;
    if (isBeyond) {
      const int upwind = flow[k] > 0.0 ? i : j;
      visit(Carried{j, upwind, flow[k], {views.value[upwind], 1.0, 0.0, 0.0}, nullptr});
    } else if (!isLimited_) {
      visit(Carried{j, i, flow[k], kernels::upwindBiasedValue(views.value[i], views.value[j], upwindShare_), nullptr});
    } else {
      const double* at = views.slopesOf();
      slopes->findFar(j, ReferenceBond(views.x, i, j).xi, far);
      Carried carried{j, i, flow[k], kernels::limitedValue(far.value, at[i], at[j]), &far};
      if (at != views.value) carried.value.value = far.linear(carried.value, views.value, i, j);
      visit(carried);
    }
  }
}

PD_REGISTER_MATERIAL(AdvectionDiffusion, "Advection Diffusion", "A scalar that a flow carries and that diffuses in it.")

}  // namespace pd
