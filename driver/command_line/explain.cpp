#include "explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <sstream>
#include <vector>

#include "../../materials/registry/plugins.hpp"
#include "../deck/sections.hpp"
#include "../solvers/diffusion/rate_integrator.hpp"
#include "../solvers/solver.hpp"

namespace pd {

namespace {

constexpr std::size_t lineWidth = 100;

/// Something that has a name and parameters.
struct Topic {
  std::string name, brief;
  std::function<ParameterDeclarations()> declare;
};

struct Chapter {
  std::string title;
  std::string use;  ///< how a deck names one of its topics; "{}" stands for the name
  std::vector<Topic> topics;
};

template <class Registry>
Chapter chapterOf(const std::string& title, const std::string& use) {
  Chapter chapter{title, use, {}};
  for (const std::string& name : Registry::self().names()) {
    const auto* entry = Registry::self().find(name);
    chapter.topics.push_back({name, entry->brief, entry->declare});
  }
  return chapter;
}

Chapter sections() {
  Chapter chapter{"Sections of a deck", "", {}};
  const auto add = [&](const char* name, const char* brief, const ParameterDeclarations& declarations) {
    chapter.topics.push_back({name, brief, [&declarations] { return declarations; }});
  };
  add("Discretization", "The mesh, and which pairs of points are bonds.", discretizationDeclarations("Text File"));
  add("Blocks", "Each entry gives blocks of the mesh a material, a damage model and a horizon.", blockDeclarations());
  add("Node Set",
      "In Boundary Conditions: a name that contains \"Node Set\", with node numbers from 1, a file of them, or a "
      "region.",
      nodeSetDeclarations());
  add("Solver", "Times and one solver, a section of its own. Sections Solver1, Solver2 ... run one after another.",
      solverDeclarations());
  add("Output", "What is written, and when. Every section whose name contains \"Output\" writes its own files.",
      outputDeclarations());
  add("Exact Solution", "Entries that the result is compared with at the end of the run.", exactSolutionDeclarations());
  return chapter;
}

Chapter typesOf(const std::string& title, const std::string& use, const std::vector<std::string>& names,
                const ParameterDeclarations& (*declarations)(const std::string&)) {
  Chapter chapter{title, use, {}};
  for (const std::string& name : names)
    chapter.topics.push_back({name, "", [name, declarations] { return declarations(name); }});
  return chapter;
}

std::vector<Chapter> chapters() {
  return {chapterOf<MaterialRegistry>("Materials", "an entry of Materials with \"Material Model: {}\""),
          chapterOf<DamageModelRegistry>("Damage models", "an entry of Damage Models with \"Damage Model: {}\""),
          chapterOf<ComputeRegistry>("Computes", "an entry of Compute Class Parameters with \"Compute Class: {}\""),
          chapterOf<SolverRegistry>("Solvers", "a section \"{}:\" in Solver"),
          chapterOf<RateIntegratorRegistry>("Methods of the solver Diffusion", "\"Method: {}\" in Diffusion"),
          typesOf("Initial and boundary conditions", "an entry of Boundary Conditions with \"Type: {}\"",
                  boundaryConditionTypes(), boundaryConditionDeclarations),
          typesOf("Meshes", "Discretization with \"Type: {}\"", discretizationTypes(), discretizationDeclarations),
          typesOf("Bond filters", "an entry of Discretization/Bond Filters with \"Type: {}\"", bondFilterTypes(),
                  bondFilterDeclarations),
          sections()};
}

/// `text` in lines of at most lineWidth characters, each after `indent`.
std::string wrapped(const std::string& text, const std::string& indent) {
  std::istringstream words(text);
  std::string result, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && indent.size() + line.size() + 1 + word.size() > lineWidth) {
      result += indent + line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return line.empty() ? result : result + indent + line + "\n";
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

std::string declarationsText(const ParameterDeclarations& declarations, const std::string& indent) {
  std::string result;
  for (const Parameter& parameter : declarations.parameters()) {
    std::string use = parameter.isRequired ? "required" : "optional";
    if (const std::string value = parameter.defaultText(); !value.empty()) use = "default: " + value;
    result += wrapped(parameter.name + ": " + parameter.expectation() + "; " + use, indent);
    result +=
        wrapped(parameter.meaning + (parameter.source.empty() ? "" : " [" + parameter.source + "]"), indent + "    ");
  }
  for (const auto& rule : declarations.rules()) result += wrapped(ruleText(rule), indent);
  for (const auto& sublist : declarations.sublists()) {
    result += wrapped(sublist.name + ": a section; optional", indent);
    result += wrapped(sublist.meaning, indent + "    ");
    result += declarationsText(sublist.declarations.front(), indent + "    ");
  }
  return result;
}

}  // namespace

std::string listEverything() {
  std::string result;
  for (const Chapter& chapter : chapters()) {
    if (chapter.topics.empty()) continue;
    result += (result.empty() ? "" : "\n") + chapter.title + "\n";
    std::size_t width = 0;
    for (const Topic& topic : chapter.topics) width = std::max(width, topic.name.size());
    for (const Topic& topic : chapter.topics)
      result += topic.brief.empty() ? "  " + topic.name + "\n"
                                    : fmt::format("  {:<{}}  {}\n", topic.name, width, topic.brief);
  }
  return result + "\npdrun --explain NAME tells the parameters of one.\n";
}

std::string explain(const std::string& name) {
  std::string result;
  std::vector<std::string> known;
  for (const Chapter& chapter : chapters())
    for (const Topic& topic : chapter.topics) {
      known.push_back(topic.name);
      if (topic.name != name) continue;
      const std::string use = chapter.use.empty() ? "" : ": " + fmt::format(fmt::runtime(chapter.use), name);
      result += (result.empty() ? "" : "\n") + name + " (" + chapter.title + use + ")\n";
      result += wrapped(topic.brief, "  ");
      const std::string parameters = declarationsText(topic.declare(), "  ");
      result += "\n" + (parameters.empty() ? "  It takes no parameters.\n" : parameters);
    }
  if (!result.empty()) return result;
  const std::string nearest = nearestWord(name, known);
  throw DeckError("--explain: nothing is called \"" + name + "\"" +
                  (nearest.empty() ? "" : " (did you mean \"" + nearest + "\"?)") + "; pdrun --list names everything");
}

}  // namespace pd
