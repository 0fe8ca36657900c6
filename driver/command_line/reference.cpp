#include "reference.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "../../materials/registry/plugins.hpp"
#include "../boundary/condition.hpp"
#include "../deck/sections.hpp"
#include "../solvers/diffusion/rate_integrator.hpp"
#include "../solvers/solver.hpp"
#include "../study/fit_file.hpp"
#include "../study/study_file.hpp"

namespace pd {

namespace {

template <class Registry>
std::vector<ReferenceTopic> pluginsOf() {
  std::vector<ReferenceTopic> topics;
  for (const std::string& name : Registry::self().names()) {
    const auto* entry = Registry::self().find(name);
    topics.push_back({name, entry->brief, entry->declare(), entry->fields});
  }
  return topics;
}

std::vector<ReferenceTopic> typesOf(const std::vector<std::string>& names,
                                    const ParameterDeclarations& (*declarations)(const std::string&)) {
  std::vector<ReferenceTopic> topics;
  for (const std::string& name : names) topics.push_back({name, "", declarations(name)});
  return topics;
}

/// What a section takes whatever its type: the keys that all topics have.
ParameterDeclarations sharedKeys(const std::vector<ReferenceTopic>& topics) {
  ParameterDeclarations shared;
  const auto haveAll = [&](const auto& isThere) { return std::all_of(topics.begin(), topics.end(), isThere); };
  for (const Parameter& parameter : topics.front().declarations.parameters())
    if (haveAll([&](const ReferenceTopic& topic) { return topic.declarations.find(parameter.name) != nullptr; }))
      shared.real(parameter.name, "", "") = parameter;
  for (const auto& sublist : topics.front().declarations.sublists())
    if (haveAll([&](const ReferenceTopic& topic) { return topic.declarations.findSublist(sublist.name) != nullptr; }))
      shared.sublist(sublist.name, sublist.meaning) = sublist.declarations.front();
  return shared;
}

ReferenceChapter ownKeysOnly(const std::string& section, const std::string& brief,
                             const ParameterDeclarations& declarations) {
  return {section, brief, declarations, "", "", {}};
}

ReferenceChapter discretization() {
  std::vector<ReferenceTopic> types = typesOf(discretizationTypes(), discretizationDeclarations);
  const ParameterDeclarations shared = sharedKeys(types);
  return {"Discretization",
          "The mesh, and which pairs of points are bonds.",
          shared,
          "Meshes",
          "Discretization with \"Type: {}\"",
          std::move(types)};
}

std::vector<ReferenceChapter> sectionsOfBodies() {
  return {
      {"Bond Filters",
       "In Discretization: surfaces that cut bonds (pre-cracks), entries by names of your choice.",
       {},
       "Bond filters",
       "an entry of Discretization/Bond Filters with \"Type: {}\"",
       typesOf(bondFilterTypes(), bondFilterDeclarations)},
      {"Cracks",
       "In Discretization: cracks that take a part of bonds (Bond Decomposition), entries by names of your choice.",
       {},
       "Cracks",
       "an entry of Discretization/Cracks with \"Type: {}\"",
       typesOf(crackTypes(), crackDeclarations)},
      {"Voids",
       "In Discretization: holes and pores that take a part of cells and bonds (Bond Decomposition), entries by names "
       "of your choice.",
       {},
       "Voids",
       "an entry of Discretization/Voids with \"Type: {}\"",
       typesOf(voidTypes(), voidDeclarations)},
      ownKeysOnly("Bond Decomposition", "In Discretization: how Cracks and Voids are brought to the bonds.",
                  bondDecompositionDeclarations()),
      ownKeysOnly("Symmetry", "In Discretization: planes of symmetry, entries by names of your choice.",
                  symmetryPlaneDeclarations()),
      {"Materials",
       "Entries by names of your choice, each with a Material Model and its keys.",
       {},
       "Materials",
       "an entry of Materials with \"Material Model: {}\"",
       pluginsOf<MaterialRegistry>()},
      {"Damage Models",
       "Entries by names of your choice, each with a Damage Model, by which bonds break, and its keys.",
       {},
       "Damage models",
       "an entry of Damage Models with \"Damage Model: {}\"",
       pluginsOf<DamageModelRegistry>()},
      ownKeysOnly("Blocks", "Each entry gives blocks of the mesh a material, a damage model and a horizon.",
                  blockDeclarations())};
}

std::vector<ReferenceChapter> sectionsOfConditions() {
  return {
      ownKeysOnly("Node Set",
                  "In Boundary Conditions: a name that contains \"Node Set\", with node numbers from 1, a file of "
                  "them, or a region.",
                  nodeSetDeclarations()),
      {"Boundary Conditions",
       "Node sets, and entries by names of your choice, each with a Type: initial values, prescribed values, loads.",
       {},
       "Initial and boundary conditions",
       "an entry of Boundary Conditions with \"Type: {}\"",
       pluginsOf<ConditionRegistry>()}};
}

std::vector<ReferenceChapter> sectionsOfSolvers() {
  return {{"Solver", "Times and one solver, a section of its own. Sections Solver1, Solver2 ... run one after another.",
           solverDeclarations(), "Solvers", "a section \"{}:\" in Solver", pluginsOf<SolverRegistry>()},
          {"",
           "What Method chooses in the solver Diffusion.",
           {},
           "Methods of the solver Diffusion",
           "\"Method: {}\" in Diffusion",
           pluginsOf<RateIntegratorRegistry>()}};
}

std::vector<ReferenceChapter> sectionsOfResults() {
  return {
      {"Compute Class Parameters",
       "Quantities derived from fields: entries by names of your choice, each with a Compute Class and its keys.",
       {},
       "Computes",
       "an entry of Compute Class Parameters with \"Compute Class: {}\"",
       pluginsOf<ComputeRegistry>()},
      ownKeysOnly("Output",
                  "What is written, and when. Every section whose name contains \"Output\" writes its own files.",
                  outputDeclarations()),
      ownKeysOnly("Exact Solution", "Entries that the result is compared with at the end of the run.",
                  exactSolutionDeclarations()),
      ownKeysOnly("Study",
                  "A file of its own for pdrun --study: a deck, what is asked of its runs, and Series, a list of "
                  "what they change in it.",
                  studyDeclarations()),
      ownKeysOnly("Series", "In a study: each entry of this list is a row of runs.", studySeriesDeclarations()),
      ownKeysOnly("Fit",
                  "A file of its own for pdrun --fit: a deck; Values that are adjusted; Overrides, paths of the deck "
                  "whose texts name these values in braces; and Series of measurements, a list.",
                  fitDeclarations()),
      ownKeysOnly("Values", "In a fit: values that are adjusted, entries by names of your choice.",
                  fitValueDeclarations()),
      ownKeysOnly("Fit Series", "In a fit, each entry of Series: measurements, and the history they are compared with.",
                  fitSeriesDeclarations())};
}

}  // namespace

std::string ReferenceChapter::useOf(const ReferenceTopic& topic) const {
  return fmt::format(fmt::runtime(use), topic.name);
}

std::vector<ReferenceChapter> reference() {
  std::vector<ReferenceChapter> chapters{discretization()};
  for (const auto& part : {sectionsOfBodies(), sectionsOfConditions(), sectionsOfSolvers(), sectionsOfResults()})
    chapters.insert(chapters.end(), part.begin(), part.end());
  return chapters;
}

std::string ruleText(const ParameterDeclarations::Rule& rule) {
  switch (rule.kind) {
    case ParameterDeclarations::Rule::ExactlyOne:
      return "Give exactly one of " + quotedList(rule.names) + ".";
    case ParameterDeclarations::Rule::AtMostOne:
      return "Give at most one of " + quotedList(rule.names) + ".";
    case ParameterDeclarations::Rule::AtLeastOne:
      return "Give at least one of " + quotedList(rule.names) + ".";
    case ParameterDeclarations::Rule::Needs:
      return "\"" + rule.names.front() + "\" needs " + quotedList({rule.names.begin() + 1, rule.names.end()}) + ".";
  }
  return "";
}

}  // namespace pd
