// The fields that a plug-in reads and writes, for people.
#ifndef PD_EXPLAIN_FIELDS_HPP
#define PD_EXPLAIN_FIELDS_HPP

#include <string>
#include <vector>

#include "../../materials/registry/fields.hpp"

namespace pd {

/// A row of a table of fields.
struct ExplainedField {
  std::string label;    ///< "<Key>" where the deck names the field by this key
  std::string use;      ///< "reads", "writes", "adds to", ...
  std::string unit;     ///< empty of a pure number
  std::string meaning;  ///< a sentence, with what the field is of where that is not points
};

/// Those that are read first.
std::vector<ExplainedField> explainedFields(const FieldTable& fields);

/// As text: "reads Volume (m3): Volume of the point's cell.", a line each, unwrapped.
std::vector<std::string> fieldLines(const FieldTable& fields);

}  // namespace pd

#endif
