#include "tip_place.hpp"

namespace pd {

namespace {

constexpr const char* tipKey = "Tip Field";

bool isGlobalVector(const PeridigmNS::FieldSpec& spec) {
  namespace Field = PeridigmNS::PeridigmField;
  return spec.getRelation() == Field::GLOBAL && spec.getLength() == Field::VECTOR &&
         spec.getTemporal() == Field::CONSTANT;
}

}  // namespace

TipFields::TipFields(const Teuchos::ParameterList& parameters) {
  if (!parameters.isParameter(tipKey)) return;
  const FieldDescription position =
      pd::fields::globalVector(parameters.get<std::string>(tipKey), "m", "Position of the crack tip.");
  auto& known = PeridigmNS::FieldManager::self();
  if (!known.hasField(position.label) || isGlobalVector(known.getFieldSpec(position.label))) {
    tip = readsIfThere(position);
    direction = readsIfThere(
        pd::fields::globalVector(crackDirectionLabel(position.label), "1", "Direction of the crack at its tip."));
  }
}

void TipPlace::declareParameters(ParameterDeclarations& declarations, const char* compute) {
  declareCommonParameters(declarations, compute);
  declarations.real("Thickness", "m", "Thickness of the plane body.").positive().required();
  declareVector(declarations, "Direction", "1",
                "Direction in which the crack grows (default: that of the Tip Field, else x).");
  declareVector(declarations, "Tip", "m", "Position of the crack tip; what is not given is 0.");
  declarations.text(tipKey, "Label of a Crack_Tip compute whose position is used instead of \"Tip X, Y, Z\".");
}

TipPlace::TipPlace(const Teuchos::ParameterList& parameters, std::string compute)
    : compute_(std::move(compute)),
      tipField_(parameters.isParameter(tipKey) ? parameters.get<std::string>(tipKey) : ""),
      tip_(vectorOf(parameters, "Tip")),
      direction_(directionOf(parameters, "Direction")),
      thickness_(parameters.get<double>("Thickness")) {
  if (direction_[2] != 0.0) throw std::invalid_argument(compute_ + ": \"Direction\" must lie in the x-y plane");
  for (const char* key : {"Direction X", "Direction Y", "Direction Z"})
    isDirectionGiven_ = isDirectionGiven_ || parameters.isParameter(key);
}

void TipPlace::requireTip(PeridigmNS::Block& block, const FieldHandle& tip) const {
  if (!tipField_.empty() && !tip.isIn(*block.getDataManager()))
    throw std::invalid_argument(compute_ + ": \"Tip Field\" \"" + tipField_ + "\" is not the result of a Crack_Tip");
}

TipPlace::Tip TipPlace::tip(PeridigmNS::Block& block, const TipFields& fields) const {
  const auto valueOr = [&](const FieldHandle& field, const Vector3& ofDeck) {
    const double* value = field.ifIn(*block.getDataManager());
    return value == nullptr ? ofDeck : Vector3{value[0], value[1], value[2]};
  };
  Tip tip{valueOr(fields.tip, tip_), direction_};
  if (!isDirectionGiven_) tip.direction = valueOr(fields.direction, direction_);
  return tip;
}

}  // namespace pd
