// A point field that the deck names as the `Variable` of a compute.
#ifndef PD_FIELD_VARIABLE_HPP
#define PD_FIELD_VARIABLE_HPP

#include <string>

#include "compute_support.hpp"

namespace pd {

class FieldVariable {
 public:
  /// One that the deck has not named yet: for the description of a compute.
  FieldVariable() = default;
  /// The field need not be registered yet if it is one of the usual ones (Displacement, Damage, Concentration ...).
  /// Throws std::invalid_argument for another unknown label, and for a field that is not a scalar or vector of points.
  explicit FieldVariable(const std::string& label) : fields_(label) {}
  /// That of key "Variable".
  static FieldVariable of(const Teuchos::ParameterList& parameters);

  /// The field where some plug-in or the host brings it: a compute of a field does not bring the field to life.
  const FieldTable& fields() const { return fields_; }
  const std::string& label() const { return fields_.description.label; }
  const std::string& unit() const { return fields_.description.unit; }
  int width() const { return fields_.description.length == PeridigmNS::PeridigmField::VECTOR ? 3 : 1; }

  /// Throws std::invalid_argument where no plug-in of this run uses the field.
  void initialize(const Blocks& blocks) const;

  /// Values at the end of the step, `width()` a point.
  const double* values(PeridigmNS::Block& block) const { return view(block, fields_.values); }

 private:
  struct Fields : FieldTable {
    FieldDescription description = pd::fields::namedBy("Variable", pd::fields::unitOfDeck, "What it is taken of.");
    FieldHandle values;
    Fields() { reads(description); }
    explicit Fields(const std::string& label);
  };
  Fields fields_;
};

/// A scalar field, or one component or the magnitude of a vector field ("Variable" and "Component").
class ScalarVariable {
 public:
  static void declareParameters(ParameterDeclarations& declarations);
  explicit ScalarVariable(const Teuchos::ParameterList& parameters);

  const FieldTable& fields() const { return variable_.fields(); }
  const std::string& unit() const { return variable_.unit(); }
  void initialize(const Blocks& blocks) const { variable_.initialize(blocks); }
  const double* values(PeridigmNS::Block& block) const { return variable_.values(block); }
  /// The scalar at a point, given values() of its block.
  double at(const double* values, int localId) const;

 private:
  FieldVariable variable_;
  int component_ = 0;  ///< 3: magnitude
};

}  // namespace pd

#endif
