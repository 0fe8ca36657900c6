// Fields that are made of the state where somebody looks at them.
#ifndef PD_STATE_FIELDS_HPP
#define PD_STATE_FIELDS_HPP

#include <set>
#include <string>

#include "model.hpp"

namespace pd {

/// Do solvers leave the field as their last evaluation had it, of a state that may not be that of the end of a step?
/// So it is with rates of scalars and with the stored energy.
bool isMadeOfState(const std::string& label);

/// Makes these fields, of which isMadeOfState() is true, of the present state. Collective.
void makeOfState(Model& model, const std::set<std::string>& labels);

}  // namespace pd

#endif
