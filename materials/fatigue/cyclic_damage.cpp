#include "cyclic_damage.hpp"

#include <limits>
#include <stdexcept>

#include "parameters.hpp"

namespace pd {

using PeridigmNS::DataManager;

void CyclicDamage::declareCommonParameters(ParameterDeclarations& declare) {
  declare.text("Damage Model", "Name of this model.");
  declare
      .real(
          "Growth Damage", "1",
          "A point beside which the law near crack tips holds has lost this part of its bonds. A plane cut takes 0.39 "
          "to 0.42 of the row beside it on squares of 3 and 4 spacings a horizon; 0.5 in the continuum.")
      .defaultTo(0.35)
      .strictlyBetween(0.0, 1.0);
  declare
      .text("Bonds That Tire",
            "Opening: those that are longer than at rest at the largest load; cracks in compression do not grow. All: "
            "those that are shorter, too.")
      .oneOf({"Opening", "All"})
      .defaultTo("Opening");
  declare
      .real("Life Tolerance", "1",
            "A bond with no more than this part of its life left is broken: those that fail nearly together break "
            "together; the solver Fatigue lets cycles pass until what some have left is what others have overdrawn, "
            "none by more than this.")
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

CyclicDamage::CyclicDamage(const Teuchos::ParameterList& params, const Fields& fields, const std::string& name)
    : BondDamageModel(params),
      name_(name),
      fields_(fields),
      hasOwnCycles_(params.isParameter("Cycles Per Step")),
      seesOpeningAlone_(params.get<std::string>("Bonds That Tire") == "Opening"),
      growthDamage_(params.get<double>("Growth Damage")),
      lifeTolerance_(params.get<double>("Life Tolerance")),
      criticalStretch_(params.isParameter("Critical Stretch") ? params.get<double>("Critical Stretch")
                                                              : std::numeric_limits<double>::infinity()) {
  if (hasOwnCycles_)
    own_ = {params.get<double>("Cycles Per Step"),
            1.0 - (params.isParameter("Load Ratio") ? params.get<double>("Load Ratio") : 0.0), 1.0};
}

void CyclicDamage::initialize(const double dt, const int numOwnedPoints, const int* ownedIDs,
                              const int* neighborhoodList, DataManager& data) const {
  prepared_.clear();
  points_.clear();
  const bool hostCounts = fields_.cycles.isIn(data);
  if (hostCounts && hasOwnCycles_)
    throw std::invalid_argument(owner() +
                                ": the solver counts the cycles; remove \"Cycles Per Step\" and \"Load Ratio\" "
                                "(the solver has a Load Ratio)");
  if (!hostCounts && !hasOwnCycles_)
    throw std::invalid_argument(owner() +
                                ": nothing says how many cycles a step has; give \"Cycles Per Step\", or use the "
                                "solver Fatigue");
  BondDamageModel::initialize(dt, numOwnedPoints, ownedIDs, neighborhoodList, data);
  const double* bondDamage = fields_.bondDamage.of(data);
  double *before = fields_.lostLife.before(data), *lost = fields_.lostLife.of(data);
  for (int bond = 0; bond < fields_.lostLife.length(data); ++bond)
    if (bondDamage[bond] >= 1.0) before[bond] = lost[bond] = 1.0;
}

CyclicDamage::Cycles CyclicDamage::cyclesOf(DataManager& data) const {
  if (!fields_.cycles.isIn(data)) return own_;
  return {*fields_.cycles.of(data), *fields_.range.of(data), *fields_.peak.of(data)};
}

double CyclicDamage::restingStretch(const Cycles& cycles) const {
  constexpr double none = std::numeric_limits<double>::infinity();
  if (!seesOpeningAlone_ || cycles.peak < 0.0) return -none;
  const double range = std::abs(cycles.range);
  const double ofLaws = range > 0.0 ? std::min(restingRange_, restingNearTips_) / range : none;
  return cycles.peak > 0.0 ? std::min(ofLaws, criticalStretch_ / cycles.peak) : ofLaws;
}

void CyclicDamage::precompute(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                              DataManager& data) const {
  prepared_.insert(&data);
  double* nearTip = fields_.nearTip.of(data);
  if (!hasGrowth_) return;
  pointsOf({numOwnedPoints, ownedIDs, neighborhoodList}, data)
      .markTips(fields_.damage.before(data), fields_.damage.length(data), growthDamage_, nearTip);
}

TiringPoints& CyclicDamage::pointsOf(const Call& call, DataManager& data) const {
  const auto found = points_.find(&data);
  if (found != points_.end() && found->second.isFor(call)) return found->second;
  return points_.insert_or_assign(&data, TiringPoints(call)).first->second;
}

std::map<int, std::vector<BondRange>> CyclicDamage::bondsWritten(DataManager& data) const {
  const auto found = points_.find(&data);
  if (found == points_.end()) return {};
  std::vector<BondRange> bonds;
  for (const std::size_t p : found->second.lastFound()) {
    const std::size_t first = found->second.firstBond(p);
    bonds.push_back({first, first + static_cast<std::size_t>(found->second.nBonds(p))});
  }
  return {{fields_.lostLife.id(), bonds}};
}

void CyclicDamage::requirePrecompute(double dt, const Call& call, DataManager& data) const {
  if (prepared_.erase(&data) != 0) return;
  if (hasGrowth_ && fields_.damage.length(data) != call.nOwned)
    throw std::runtime_error(owner() +
                             ": this host does not exchange which points are near crack tips (it calls no "
                             "precompute); run it on one rank with one block, or with pdrun");
  precompute(dt, call.nOwned, call.ownedIds, call.neighborhoodList, data);
  prepared_.erase(&data);
}

}  // namespace pd
