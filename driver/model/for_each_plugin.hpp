// The plug-ins of a block in turn, and the fields in their tables.
#ifndef PD_FOR_EACH_PLUGIN_HPP
#define PD_FOR_EACH_PLUGIN_HPP

#include "Peridigm_Block.hpp"
#include "Peridigm_Field.hpp"
#include "fields.hpp"

namespace pd {

/// work(plugin) for the material of a block and the damage model, where it has one.
template <class Work>
void forEachPlugin(PeridigmNS::Block& block, const Work& work) {
  work(*block.getMaterialModel());
  if (!block.getDamageModel().is_null()) work(*block.getDamageModel());
}

/// work(FieldUse) for the tables of a block's plug-ins; those without a table are left out.
template <class Work>
void forEachFieldUse(PeridigmNS::Block& block, const Work& work) {
  forEachPlugin(block, [&](const auto& plugin) {
    if (const FieldTable* table = fieldTableOf(plugin))
      for (const FieldUse& use : table->uses()) work(use);
  });
}

inline bool isOfPoints(PeridigmNS::PeridigmField::Relation relation) {
  return relation == PeridigmNS::PeridigmField::NODE || relation == PeridigmNS::PeridigmField::ELEMENT;
}

}  // namespace pd

#endif
