// A point field that the deck names as the `Variable` of a compute.
#ifndef PD_FIELD_VARIABLE_HPP
#define PD_FIELD_VARIABLE_HPP

#include <string>
#include <vector>

#include "compute_support.hpp"

namespace pd {

class FieldVariable {
 public:
  /// The field need not be registered yet if it is one of the usual ones (Displacement, Damage, Concentration ...).
  /// Throws std::invalid_argument for another unknown label, and for a field that is not a scalar or vector of points.
  explicit FieldVariable(const std::string& label);

  const std::string& label() const { return label_; }
  int width() const { return width_; }  ///< 1 or 3
  PeridigmNS::PeridigmField::Length length() const;

  /// The field's id where some plug-in or the host has registered it, else empty: a compute of a field does not bring
  /// the field to life.
  std::vector<int> fieldIds() const;

  /// Throws std::invalid_argument where no plug-in of this run uses the field.
  void initialize(const Blocks& blocks);

  /// Values at the end of the step, `width()` a point. Call initialize() first.
  const double* values(PeridigmNS::Block& block) const;

 private:
  std::string label_;
  int id_ = -1;
  int width_ = 1;
  PeridigmNS::PeridigmField::Step step_ = PeridigmNS::PeridigmField::STEP_NP1;
};

/// A scalar field, or one component or the magnitude of a vector field ("Variable" and "Component").
class ScalarVariable {
 public:
  static void declareParameters(ParameterDeclarations& declarations);
  explicit ScalarVariable(const Teuchos::ParameterList& parameters);

  std::vector<int> fieldIds() const { return variable_.fieldIds(); }
  void initialize(const Blocks& blocks) { variable_.initialize(blocks); }
  const double* values(PeridigmNS::Block& block) const { return variable_.values(block); }
  /// The scalar at a point, given values() of its block.
  double at(const double* values, int localId) const;

 private:
  FieldVariable variable_;
  int component_ = 0;  ///< 3: magnitude
};

}  // namespace pd

#endif
