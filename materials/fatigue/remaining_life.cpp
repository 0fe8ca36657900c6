#include "remaining_life.hpp"

#include <Teuchos_Array.hpp>
#include <stdexcept>

#include "plugins.hpp"

namespace pd {

using PeridigmNS::DataManager;

namespace {

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
}

/// Throws std::invalid_argument where the Fatigue Limit, or the flag beside it, would do nothing.
void requireUseOfLimit(const Teuchos::ParameterList& params, const std::string& owner) {
  const bool hasLimit = params.get<double>("Fatigue Limit") > 0.0,
             isOfGrowth = params.get<bool>("Fatigue Limit In Growth");
  const bool hasInitiation = params.isParameter("Initiation Coefficient") || params.isParameter("Lives");
  if (hasLimit && !hasInitiation && !isOfGrowth)
    throw std::invalid_argument(
        owner +
        ": \"Fatigue Limit\" is of bonds away from cracks, which lose no life here: give their Initiation "
        "Coefficient or Lives, or, of Paris' law, \"Paris Threshold\" in its place" +
        (params.isParameter("Growth Coefficient") ? ", or set \"Fatigue Limit In Growth: true\"" : ""));
  if (isOfGrowth && !hasLimit)
    throw std::invalid_argument(owner + ": \"Fatigue Limit In Growth\" does nothing without a \"Fatigue Limit\"");
  if (isOfGrowth && !params.isParameter("Growth Coefficient") && !params.isParameter("Paris Coefficient"))
    throw std::invalid_argument(owner + ": \"Fatigue Limit In Growth\" does nothing without a Growth Coefficient");
}

}  // namespace

void RemainingLife::declareParameters(ParameterDeclarations& declare) {
  declareInitiation(declare);
  declareGrowth(declare);
  declareCommonParameters(declare);
}

RemainingLife::RemainingLife(const Teuchos::ParameterList& given)
    : CyclicDamage(completed<RemainingLife>(given, "damage model Remaining Life"), Fields(), "Remaining Life") {
  const Teuchos::ParameterList params = completed<RemainingLife>(given, owner());
  const double limit = params.get<double>("Fatigue Limit");
  const double growthLimit = params.get<bool>("Fatigue Limit In Growth") ? limit : 0.0;
  requireUseOfLimit(params, owner());
  if (params.isParameter("Initiation Coefficient"))
    initiation_ = kernels::LifeLaw::power(params.get<double>("Initiation Coefficient"),
                                          params.get<double>("Initiation Exponent"), limit);
  if (params.isParameter("Lives")) {
    try {
      initiation_ = kernels::LifeLaw::table(params.get<Teuchos::Array<double>>("Lives").toVector(),
                                            params.get<Teuchos::Array<double>>("Strain Ranges").toVector(), limit);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(owner() + ": " + error.what());
    }
  }
  if (params.isParameter("Paris Coefficient")) {
    if (growthLimit > 0.0)
      throw std::invalid_argument(owner() +
                                  ": \"Fatigue Limit In Growth\" makes another law of growth than Paris'; give "
                                  "Growth Coefficient and Growth Exponent with it");
    paris_ = std::make_unique<GrowthCoefficient>(params, owner());
    growth_ = paris_->law();
  }
  if (params.isParameter("Growth Coefficient"))
    growth_ = kernels::LifeLaw::power(params.get<double>("Growth Coefficient"), params.get<double>("Growth Exponent"),
                                      growthLimit);
  haveLaws(params.isParameter("Initiation Coefficient") || params.isParameter("Lives"),
           paris_ != nullptr || params.isParameter("Growth Coefficient"), limit, growth_.limit());
}

std::vector<std::string> RemainingLife::runNotes() const {
  return paris_ == nullptr ? std::vector<std::string>() : paris_->notes();
}

void RemainingLife::initialize(const double dt, const int numOwnedPoints, const int* ownedIDs,
                               const int* neighborhoodList, DataManager& data) const {
  if (paris_ != nullptr)
    paris_->lattice().requireSpacing({numOwnedPoints, ownedIDs, neighborhoodList}, fields().modelCoordinates.of(data));
  CyclicDamage::initialize(dt, numOwnedPoints, ownedIDs, neighborhoodList, data);
}

void RemainingLife::worsen(double dt, const Call& call, DataManager& data) const {
  loseLife(dt, call, data, [this](bool isNearTip, double strainRange, int, int) {
    return (isNearTip ? growth_ : initiation_).rate(strainRange);
  });
}

PD_REGISTER_DAMAGE_MODEL(RemainingLife, "Remaining Life",
                         "Bonds lose life by powers of their strain ranges, and break without it: fatigue.")

}  // namespace pd
