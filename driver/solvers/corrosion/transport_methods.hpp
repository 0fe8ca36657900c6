// The ways to step transport at given phases that a deck can choose.
#ifndef PD_TRANSPORT_METHODS_HPP
#define PD_TRANSPORT_METHODS_HPP

#include <Teuchos_ParameterList.hpp>
#include <memory>

#include "parameters.hpp"
#include "transport_step.hpp"

namespace pd {

void declareTransportMethods(ParameterDeclarations& declare);
/// `params`: completed. Throws std::invalid_argument where choices do not go together.
std::unique_ptr<TransportStep> makeTransportStep(const Teuchos::ParameterList& params);

}  // namespace pd

#endif
