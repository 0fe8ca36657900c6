#include "tip_ring.hpp"

namespace pd {

namespace {

constexpr const char* tipKey = "Tip Field";

bool isGlobalVector(const PeridigmNS::FieldSpec& spec) {
  namespace Field = PeridigmNS::PeridigmField;
  return spec.getRelation() == Field::GLOBAL && spec.getLength() == Field::VECTOR &&
         spec.getTemporal() == Field::CONSTANT;
}

}  // namespace

TipRingFields::TipRingFields(const Teuchos::ParameterList& parameters) {
  if (!parameters.isParameter(tipKey)) return;
  const FieldDescription position =
      pd::fields::globalVector(parameters.get<std::string>(tipKey), "m", "Position of the crack tip.");
  auto& known = PeridigmNS::FieldManager::self();
  if (!known.hasField(position.label) || isGlobalVector(known.getFieldSpec(position.label)))
    tip = readsIfThere(position);
}

void TipRing::declareParameters(ParameterDeclarations& declarations, const char* compute) {
  declareCommonParameters(declarations, compute);
  HookesLaw::declareParameters(declarations);
  declarations.real("Thickness", "m", "Thickness of the plane body.").positive().required();
  declarations.real("Inner Radius", "m", "Inner radius of the ring; at least two horizons.").positive().required();
  declarations.real("Outer Radius", "m", "Outer radius of the ring.").positive().required();
  declareVector(declarations, "Direction", "1", "Direction in which the crack grows (default: x).");
  declareVector(declarations, "Tip", "m", "Position of the crack tip; what is not given is 0.");
  declarations.text(tipKey, "Label of a Crack_Tip compute whose position is used instead of \"Tip X, Y, Z\".");
}

TipRing::TipRing(const Teuchos::ParameterList& parameters, std::string compute)
    : compute_(std::move(compute)),
      tipField_(parameters.isParameter(tipKey) ? parameters.get<std::string>(tipKey) : ""),
      tip_(vectorOf(parameters, "Tip")),
      direction_(directionOf(parameters, "Direction")),
      innerRadius_(parameters.get<double>("Inner Radius")),
      outerRadius_(parameters.get<double>("Outer Radius")),
      thickness_(parameters.get<double>("Thickness")),
      isPlaneStress_(parameters.get<bool>("Plane Stress")) {
  if (!(outerRadius_ > innerRadius_))
    throw std::invalid_argument(compute_ + ": \"Outer Radius\" must be larger than \"Inner Radius\"");
}

void TipRing::requireTip(PeridigmNS::Block& block, const FieldHandle& tip) const {
  if (!tipField_.empty() && !tip.isIn(*block.getDataManager()))
    throw std::invalid_argument(compute_ + ": \"Tip Field\" \"" + tipField_ + "\" is not the result of a Crack_Tip");
}

Vector3 TipRing::tip(const double* position) const {
  return position == nullptr ? tip_ : Vector3{position[0], position[1], position[2]};
}

}  // namespace pd
