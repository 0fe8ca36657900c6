#include "remaining_life.hpp"

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bond_family.hpp"
#include "plugins.hpp"

namespace pd {

using PeridigmNS::DataManager;

namespace {

const std::string modelName = "damage model Remaining Life";

void declareInitiation(ParameterDeclarations& declare) {
  declare
      .real("Initiation Coefficient", "1",
            "A1 of d(lost life)/dN = A1 (strain range - Fatigue Limit)^m1, away from cracks. Without it and without a "
            "table bonds lose life near crack tips only.")
      .positive();
  declare.real("Initiation Exponent", "1", "m1.").positive();
  declare.reals(
      "Lives", "1",
      "In place of A1 and m1: cycles to failure of a strain-life line or table, rising; log-log between rows.");
  declare.reals("Strain Ranges", "1", "Strain ranges that go with Lives, falling.");
  declare
      .real(
          "Fatigue Limit", "1",
          "Strain range that takes no life. A1 multiplies a power of what exceeds it; the rows of a table hold as they "
          "stand above it.")
      .defaultTo(0.0)
      .atLeast(0.0);
  declare.needs("Initiation Coefficient", {"Initiation Exponent"});
  declare.needs("Initiation Exponent", {"Initiation Coefficient"});
  declare.needs("Lives", {"Strain Ranges"});
  declare.needs("Strain Ranges", {"Lives"});
  declare.atMostOneOf({"Initiation Coefficient", "Lives"});
}

void declareGrowth(ParameterDeclarations& declare) {
  declare.real("Growth Coefficient", "1", "A2 of d(lost life)/dN = A2 (strain range)^m2, near crack tips.").positive();
  declare.real("Growth Exponent", "1", "m2: the exponent of Paris' law.").positive();
  declare.needs("Growth Coefficient", {"Growth Exponent"});
  declare.needs("Growth Exponent", {"Growth Coefficient"});
  GrowthCoefficient::declareParameters(declare);
  declare.atMostOneOf({"Growth Coefficient", "Paris Coefficient"});
  declare.atLeastOneOf({"Initiation Coefficient", "Lives", "Growth Coefficient", "Paris Coefficient"});
  declare
      .flag(
          "Fatigue Limit In Growth",
          "A2 multiplies a power of what exceeds the Fatigue Limit, too (Zhang & Bobaru, Rom. J. Tech. Sci. 61 (2016) "
          "22).")
      .defaultTo(false);
  declare
      .real(
          "Growth Damage", "1",
          "A point beside which the law near crack tips holds has lost this part of its bonds. A plane cut takes 0.39 "
          "to 0.42 of the row beside it on squares of 3 and 4 spacings a horizon; 0.5 in the continuum.")
      .defaultTo(0.35)
      .strictlyBetween(0.0, 1.0);
}

template <class Value>
Value valueOr(const Teuchos::ParameterList& params, const char* key, Value fallback) {
  return params.isParameter(key) ? params.get<Value>(key) : fallback;
}

}  // namespace

void RemainingLife::declareParameters(ParameterDeclarations& declare) {
  declare.text("Damage Model", "Name of this model.");
  declareInitiation(declare);
  declareGrowth(declare);
  declare
      .text("Bonds That Tire",
            "Opening: those that are longer than at rest at the largest load; cracks in compression do not grow. All: "
            "those that are shorter, too.")
      .oneOf({"Opening", "All"})
      .defaultTo("Opening");
  declare
      .real("Life Tolerance", "1",
            "A bond with no more than this part of its life left is broken: those that fail nearly together break "
            "together.")
      .defaultTo(1e-3)
      .between(1e-12, 0.1);
  declare.real("Critical Stretch", "1", "Largest stretch that a bond bears in any cycle; none where it is not given.")
      .positive();
  declare
      .real("Cycles Per Step", "1",
            "Cycles in a load step, for hosts and solvers that do not count cycles (QuasiStatic).")
      .positive();
  declare
      .real("Load Ratio", "1",
            "R: smallest over largest load of a cycle, with Cycles Per Step. 0 where it is not given.")
      .atLeast(-1.0)
      .atMost(0.99);
  declare.needs("Load Ratio", {"Cycles Per Step"});
}

RemainingLife::RemainingLife(const Teuchos::ParameterList& given) : BondDamageModel(given) {
  const Teuchos::ParameterList params = completed<RemainingLife>(given, modelName);
  const double limit = params.get<double>("Fatigue Limit");
  const double growthLimit = params.get<bool>("Fatigue Limit In Growth") ? limit : 0.0;
  growthDamage_ = params.get<double>("Growth Damage");
  lifeTolerance_ = params.get<double>("Life Tolerance");
  criticalStretch_ = valueOr(params, "Critical Stretch", std::numeric_limits<double>::infinity());
  seesOpeningAlone_ = params.get<std::string>("Bonds That Tire") == "Opening";
  hasOwnCycles_ = params.isParameter("Cycles Per Step");
  if (hasOwnCycles_) own_ = {params.get<double>("Cycles Per Step"), 1.0 - valueOr(params, "Load Ratio", 0.0), 1.0};
  if (params.isParameter("Initiation Coefficient"))
    initiation_ = kernels::LifeLaw::power(params.get<double>("Initiation Coefficient"),
                                          params.get<double>("Initiation Exponent"), limit);
  if (params.isParameter("Lives")) {
    try {
      initiation_ = kernels::LifeLaw::table(params.get<Teuchos::Array<double>>("Lives").toVector(),
                                            params.get<Teuchos::Array<double>>("Strain Ranges").toVector(), limit);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(modelName + ": " + error.what());
    }
  }
  if (params.isParameter("Paris Coefficient")) {
    if (growthLimit > 0.0)
      throw std::invalid_argument(modelName +
                                  ": \"Fatigue Limit In Growth\" makes another law of growth than Paris'; give "
                                  "Growth Coefficient and Growth Exponent with it");
    paris_ = std::make_unique<GrowthCoefficient>(params, modelName);
    growth_ = paris_->law();
  }
  if (params.isParameter("Growth Coefficient"))
    growth_ = kernels::LifeLaw::power(params.get<double>("Growth Coefficient"), params.get<double>("Growth Exponent"),
                                      growthLimit);
  hasInitiation_ = params.isParameter("Initiation Coefficient") || params.isParameter("Lives");
  hasGrowth_ = paris_ != nullptr || params.isParameter("Growth Coefficient");
}

std::vector<std::string> RemainingLife::runNotes() const {
  return paris_ == nullptr ? std::vector<std::string>() : paris_->notes();
}

/// The trial that has found the growth coefficient was one of a lattice of its own.
void RemainingLife::requireSpacing(const Call& call, DataManager& data) const {
  constexpr double tolerance = 0.05;
  const double* x = fields_.modelCoordinates.of(data);
  double shortest = std::numeric_limits<double>::infinity();
  forEachBond(call, [&](int i, int j, std::size_t) { shortest = std::min(shortest, ReferenceBond(x, i, j).length); });
  if (std::isfinite(shortest) && std::abs(shortest / paris_->spacing() - 1.0) > tolerance)
    throw std::invalid_argument(
        modelName + ": \"Spacing\" is " + std::to_string(paris_->spacing()) +
        " m, but the shortest bond of the block has " + std::to_string(shortest) +
        " m; give that, or Growth Coefficient and Growth Exponent on meshes that are no lattice "
        "of squares or cubes");
}

void RemainingLife::initialize(const double dt, const int numOwnedPoints, const int* ownedIDs,
                               const int* neighborhoodList, DataManager& data) const {
  prepared_.clear();
  const bool hostCounts = fields_.cycles.isIn(data);
  if (hostCounts && hasOwnCycles_)
    throw std::invalid_argument(modelName +
                                ": the solver counts the cycles; remove \"Cycles Per Step\" and \"Load Ratio\" "
                                "(the solver has a Load Ratio)");
  if (!hostCounts && !hasOwnCycles_)
    throw std::invalid_argument(modelName +
                                ": nothing says how many cycles a step has; give \"Cycles Per Step\", or use the "
                                "solver Fatigue");
  const Call call{numOwnedPoints, ownedIDs, neighborhoodList};
  if (paris_ != nullptr) requireSpacing(call, data);
  BondDamageModel::initialize(dt, numOwnedPoints, ownedIDs, neighborhoodList, data);
  const double* bondDamage = fields_.bondDamage.of(data);
  double *before = fields_.lostLife.before(data), *lost = fields_.lostLife.of(data);
  for (int bond = 0; bond < fields_.lostLife.length(data); ++bond)
    if (bondDamage[bond] >= 1.0) before[bond] = lost[bond] = 1.0;
}

RemainingLife::Cycles RemainingLife::cyclesOf(DataManager& data) const {
  if (!fields_.cycles.isIn(data)) return own_;
  return {*fields_.cycles.of(data), *fields_.range.of(data), *fields_.peak.of(data)};
}

void RemainingLife::precompute(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                               DataManager& data) const {
  prepared_.insert(&data);
  double* nearTip = fields_.nearTip.of(data);
  if (!hasGrowth_) return;
  const double* damage = fields_.damage.before(data);
  for (int p = 0; p < numOwnedPoints; ++p) nearTip[ownedIDs[p]] = damage[ownedIDs[p]] >= growthDamage_ ? 1.0 : 0.0;
  forEachBond({numOwnedPoints, ownedIDs, neighborhoodList}, [&](int i, int j, std::size_t) {
    if (damage[j] >= growthDamage_) nearTip[i] = 1.0;
  });
}

void RemainingLife::worsen(double dt, const Call& call, DataManager& data) const {
  if (prepared_.erase(&data) == 0) {
    if (hasGrowth_ && fields_.damage.length(data) != call.nOwned)
      throw std::runtime_error(modelName +
                               ": this host does not exchange which points are near crack tips (it calls no "
                               "precompute); run it on one rank with one block, or with pdrun");
    precompute(dt, call.nOwned, call.ownedIds, call.neighborhoodList, data);
    prepared_.erase(&data);
  }
  const Cycles cycles = cyclesOf(data);
  const double *x = fields_.modelCoordinates.of(data), *y = fields_.coordinates.of(data);
  const double *lostBefore = fields_.lostLife.before(data), *nearTip = fields_.nearTip.of(data);
  const double* noFailure = fields_.noFailure.ifIn(data);
  double *lost = fields_.lostLife.of(data), *bondDamage = fields_.bondDamage.of(data);
  double *lossRate = fields_.lossRate.of(data), *overdrawn = fields_.overdrawn.of(data);
  for (int p = 0; p < call.nOwned; ++p) lossRate[call.ownedIds[p]] = overdrawn[call.ownedIds[p]] = 0.0;
  bool hasBroken = false;
  // Away from cracks nothing happens to a bond where neither a law nor a largest stretch holds there.
  const bool isIdleElsewhere = !hasInitiation_ && std::isinf(criticalStretch_);
  // Which bonds have broken in an earlier call of the step cannot be seen: those without life at N are broken.
  forEachBond(call, [&](int i, int j, std::size_t bond) {
    lost[bond] = lostBefore[bond];
    const bool grows = hasGrowth_ && (nearTip[i] != 0.0 || nearTip[j] != 0.0);
    if (!grows && isIdleElsewhere) return;
    if (lost[bond] >= 1.0 || (noFailure != nullptr && (noFailure[i] != 0.0 || noFailure[j] != 0.0))) return;
    const double stretch = ReferenceBond(y, i, j).length / ReferenceBond(x, i, j).length - 1.0;
    double rate = 0.0;
    if (stretch > 0.0 || !seesOpeningAlone_)
      rate = (grows ? growth_ : initiation_).rate(std::abs(cycles.range * stretch));
    lost[bond] += cycles.number * rate;
    if (lost[bond] < 1.0 - lifeTolerance_ && cycles.peak * stretch < criticalStretch_) {
      if (bondDamage[bond] < 1.0) lossRate[i] = std::max(lossRate[i], rate / (1.0 - lost[bond]));
      return;
    }
    overdrawn[i] = std::max(overdrawn[i], lost[bond] - 1.0);
    lost[bond] = bondDamage[bond] = 1.0;
    hasBroken = true;
  });
  if (hasBroken) countBrokenBonds(call, bondDamage, fields_.damage.of(data));
}

PD_REGISTER_DAMAGE_MODEL(RemainingLife, "Remaining Life",
                         "Bonds lose life by cycles of load, and break without it: fatigue.")

}  // namespace pd
