// The fields of solvers that advance a scalar.
#ifndef PD_SCALAR_FIELDS_HPP
#define PD_SCALAR_FIELDS_HPP

#include <Teuchos_ParameterList.hpp>
#include <string>

#include "../../../materials/registry/fields.hpp"

namespace pd {

/// Of the scalar that key "Field" names.
struct ScalarFields : FieldTable {
  FieldHandle value, rate;
  explicit ScalarFields(const Teuchos::ParameterList& parameters)
      : value(writes(fields::diffusingScalar(parameters.get<std::string>("Field")))),
        rate(reads(fields::fluxDivergence(parameters.get<std::string>("Field")))) {}
};

}  // namespace pd

#endif
