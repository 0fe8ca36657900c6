#include "cumulative_fatigue.hpp"

#include <sstream>

#include "plugins.hpp"

namespace pd {

using PeridigmNS::DataManager;

namespace {

bool scattersBetweenBonds(const Teuchos::ParameterList& params) {
  return params.isParameter("Scatter Between") && params.get<std::string>("Scatter Between") == "Bonds";
}

kernels::StrainLife strainLifeOf(const Teuchos::ParameterList& params) {
  kernels::StrainLife life;
  life.measure = params.get<std::string>("Strain Measure") == "Range" ? kernels::StrainMeasure::Range
                                                                      : kernels::StrainMeasure::Amplitude;
  life.ductility = params.get<double>("Ductility Coefficient");
  life.exponent = params.get<double>("Ductility Exponent");
  life.limit = params.get<double>("Strain Limit");
  return life;
}

}  // namespace

void CumulativeFatigue::declareParameters(ParameterDeclarations& declare) {
  declare.real("Ductility Coefficient", "1", "eps_f' of the strain-life relation.")
      .positive()
      .required()
      .from("Coffin (1954), Manson (1953)");
  declare.real("Ductility Exponent", "1", "c of the strain-life relation.").between(-1.0, -0.1).required();
  declare
      .real("Strain Limit", "1",
            "Strain, by the Strain Measure, that takes no life; the relation is of what exceeds it.")
      .defaultTo(0.0)
      .atLeast(0.0);
  declare
      .text("Strain Measure",
            "Amplitude: half the strain range less the limit is eps_f' (2 N)^c. Range: the strain range less the limit "
            "is eps_f' N^c.")
      .oneOf({"Amplitude", "Range"})
      .defaultTo("Amplitude");
  FatigueElement::declareParameters(declare);
  LifeScatter::declareParameters(declare);
  declareCommonParameters(declare);
}

CumulativeFatigue::CumulativeFatigue(const Teuchos::ParameterList& given)
    : CyclicDamage(completed<CumulativeFatigue>(given, "damage model Cumulative Fatigue"),
                   Fields(scattersBetweenBonds(given)), "Cumulative Fatigue"),
      ownFields_(scattersBetweenBonds(given)) {
  const Teuchos::ParameterList params = completed<CumulativeFatigue>(given, owner());
  const kernels::StrainLife median = strainLifeOf(params);
  scatter_ = LifeScatter(params, owner());
  life_ = scatter_.ofSpecimen(median);
  if (params.isParameter("Element Length")) element_ = std::make_unique<FatigueElement>(params, median, owner());
  haveLaws(true, element_ != nullptr, scatter_.isBetweenBonds() ? 0.0 : life_.limitOfRange());
}

std::vector<std::string> CumulativeFatigue::runNotes() const {
  std::vector<std::string> notes;
  if (scatter_.isBetweenSpecimens()) {
    std::ostringstream text;
    text.precision(10);
    text << Name() << ": this specimen has Strain Limit " << life_.limit << ", Ductility Coefficient "
         << life_.ductility << ", Ductility Exponent " << life_.exponent;
    notes.push_back(text.str());
  }
  if (element_ != nullptr) notes.push_back(element_->note(life_));
  return notes;
}

void CumulativeFatigue::initialize(const double dt, const int numOwnedPoints, const int* ownedIDs,
                                   const int* neighborhoodList, DataManager& data) const {
  if (element_ != nullptr)
    element_->lattice().requireSpacing({numOwnedPoints, ownedIDs, neighborhoodList},
                                       fields().modelCoordinates.of(data));
  CyclicDamage::initialize(dt, numOwnedPoints, ownedIDs, neighborhoodList, data);
}

void CumulativeFatigue::worsen(double dt, const Call& call, DataManager& data) const {
  const auto lossRate = [this](bool isNearTip, double strainRange, const kernels::StrainLife& life) {
    return isNearTip ? element_->lossRate(strainRange, life) : life.lossRate(strainRange);
  };
  if (!scatter_.isBetweenBonds()) {
    loseLife(dt, call, data,
             [&](bool isNearTip, double strainRange, int, int) { return lossRate(isNearTip, strainRange, life_); });
    return;
  }
  const auto& ids = *data.getOverlapScalarPointMap();
  const double* imageShift = ownFields_.imageShift.ifIn(data);
  loseLife(dt, call, data, [&](bool isNearTip, double strainRange, int i, int j) {
    const int shift = imageShift == nullptr ? 0 : static_cast<int>(imageShift[j]);
    return lossRate(isNearTip, strainRange, scatter_.ofBond(life_, ids.GID(i), ids.GID(j), shift));
  });
}

PD_REGISTER_DAMAGE_MODEL(CumulativeFatigue, "Cumulative Fatigue",
                         "Bonds lose life by a strain-life relation, cracks grow by it, too: fatigue.")

}  // namespace pd
