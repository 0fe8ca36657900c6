// All that a deck and a study may hold, as data: what `pdrun --list` and `pdrun --explain` tell, and the reference
// pages.
#ifndef PD_REFERENCE_HPP
#define PD_REFERENCE_HPP

#include <functional>
#include <string>
#include <vector>

#include "../../materials/registry/fields.hpp"
#include "../../materials/registry/parameters.hpp"

namespace pd {

/// A plug-in, or a type that an entry of a section chooses.
struct ReferenceTopic {
  std::string name, brief;
  ParameterDeclarations declarations;
  std::function<FieldTable()> fields = [] { return FieldTable(); };  ///< of a plug-in
};

/// A section of a deck with what may stand in it.
struct ReferenceChapter {
  std::string section;  ///< its key, "Damage Models"; empty where the topics have no section of their own
  std::string brief;    ///< what the section is
  ParameterDeclarations declarations;  ///< its keys, or those of each of its entries
  std::string title;                   ///< of the topics, "Damage models"; empty where there are none
  std::string use;                     ///< how a deck names one of the topics; "{}" stands for its name
  std::vector<ReferenceTopic> topics;

  const std::string& name() const { return section.empty() ? title : section; }
  /// "an entry of Materials with "Material Model: PDHE"".
  std::string useOf(const ReferenceTopic& topic) const;
};

/// In the order of a deck. Made from the declarations of all registered plug-ins and of the sections.
std::vector<ReferenceChapter> reference();

/// "Give exactly one of "A", "B"."
std::string ruleText(const ParameterDeclarations::Rule& rule);

}  // namespace pd

#endif
