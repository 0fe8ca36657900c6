// What the materials of a run give the rates of.
#ifndef PD_RATES_HPP
#define PD_RATES_HPP

#include <string>
#include <vector>

#include "Peridigm_Block.hpp"

namespace pd {

/// Labels of the fields that materials zero and add to, in the order of their ids.
std::vector<std::string> summedFields(std::vector<PeridigmNS::Block>& blocks);

/// Labels of the fields whose rates they give, in the order of their ids.
std::vector<std::string> fieldsWithRates(std::vector<PeridigmNS::Block>& blocks);

/// Whether the block's material has forces.
bool computesForces(PeridigmNS::Block& block);

/// Whether the block's material writes fields each time that it computes forces (as Elastic does the dilatation).
bool derivesFields(PeridigmNS::Block& block);

}  // namespace pd

#endif
