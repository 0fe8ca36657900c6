// What planes of symmetry make of the values of point fields.
#ifndef PD_FIELD_REFLECTIONS_HPP
#define PD_FIELD_REFLECTIONS_HPP

#include <map>
#include <optional>

#include "fields.hpp"

namespace pd {

class FieldReflections {
 public:
  /// Takes over what a plug-in declares.
  void include(const FieldUse& use);

  /// The rule of a point field: that of the plug-in that declares it, else by what it is, a scalar or a vector. Fields
  /// of other widths have none: they are written at owned points and read by nobody at neighbours.
  std::optional<Reflection> of(const PeridigmNS::FieldSpec& field) const;

 private:
  std::map<int, Reflection> declared_;  ///< by field id
};

}  // namespace pd

#endif
