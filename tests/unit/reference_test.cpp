// The reference pages hold every plug-in and section, and tell all of every key.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "driver/boundary/condition.hpp"
#include "driver/command_line/explain.hpp"
#include "driver/command_line/markdown.hpp"
#include "driver/deck/quantity.hpp"
#include "driver/deck/sections.hpp"
#include "driver/solvers/diffusion/rate_integrator.hpp"
#include "driver/solvers/solver.hpp"
#include "driver/study/fit_file.hpp"
#include "driver/study/study_file.hpp"
#include "materials/registry/plugins.hpp"

namespace pd {
namespace {

using testing::HasSubstr;

/// What stands in the reference under the heading of a section and, below it, of a topic; empty where it is not there.
std::string partOf(const std::string& section, const std::string& topic = "") {
  std::istringstream lines(markdown(reference()));
  std::string part, sectionHere, topicHere;
  for (std::string line; std::getline(lines, line);) {
    if (line.compare(0, 2, "# ") == 0) {
      sectionHere = line.substr(2);
      topicHere.clear();
    } else if (line.compare(0, 3, "## ") == 0) {
      topicHere = line.substr(3);
    }
    if (sectionHere == section && topicHere == topic) part += line + "\n";
  }
  return part;
}

/// Cells of a row of a table, without blanks around them.
std::vector<std::string> cellsOf(const std::string& row) {
  std::vector<std::string> cells;
  std::string cell;
  for (std::size_t i = 1; i < row.size(); ++i) {
    if (row[i] != '|' || row[i - 1] == '\\') {
      cell += row[i];
      continue;
    }
    const std::size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    cell.clear();
  }
  return cells;
}

/// Each key of `declarations`, and of the sections in it, has a row in `part` that tells everything.
void expectAllKeys(const ParameterDeclarations& declarations, const std::string& part, const std::string& owner) {
  for (const Parameter& parameter : declarations.parameters()) {
    SCOPED_TRACE(owner + ", " + parameter.name);
    const std::size_t at = part.find("| `" + parameter.name + "` |");
    ASSERT_NE(at, std::string::npos);
    const std::vector<std::string> cells = cellsOf(part.substr(at, part.find('\n', at) - at));
    ASSERT_EQ(cells.size(), 6u);  // key, value, unit, range, default, meaning
    for (const std::string& cell : cells) EXPECT_FALSE(cell.empty());
    const bool isNumber = parameter.type == ParameterType::Real || parameter.type == ParameterType::Reals ||
                          parameter.type == ParameterType::Function || parameter.type == ParameterType::Functions;
    EXPECT_EQ(isNumber, cells[2] != "–") << "numbers have a unit (\"1\" where they are pure), nothing else has";
    EXPECT_FALSE(parameter.meaning.empty());
    EXPECT_EQ(parameter.isRequired, cells[4] == "required");
  }
  for (const auto& sublist : declarations.sublists()) {
    EXPECT_FALSE(sublist.meaning.empty()) << owner << ", " << sublist.name;
    const std::size_t at = part.find(sublist.name + "`** – " + sublist.meaning);
    ASSERT_NE(at, std::string::npos) << owner << ", " << sublist.name;
    expectAllKeys(sublist.declarations.front(), part.substr(at), owner + "/" + sublist.name);
  }
}

template <class Registry>
void expectAllPlugins(const std::string& section) {
  EXPECT_FALSE(Registry::self().names().empty());
  for (const std::string& name : Registry::self().names()) {
    const std::string part = partOf(section, name);
    EXPECT_THAT(part, HasSubstr(Registry::self().find(name)->brief)) << name;
    EXPECT_FALSE(Registry::self().find(name)->brief.empty()) << name;
    expectAllKeys(Registry::self().find(name)->declare(), part, name);
  }
}

TEST(Reference, HasEveryRegisteredPluginWithAllOfItsKeys) {
  expectAllPlugins<MaterialRegistry>("Materials");
  expectAllPlugins<DamageModelRegistry>("Damage Models");
  expectAllPlugins<ComputeRegistry>("Compute Class Parameters");
  expectAllPlugins<ConditionRegistry>("Boundary Conditions");
  expectAllPlugins<SolverRegistry>("Solver");
  expectAllPlugins<RateIntegratorRegistry>("Methods of the solver Diffusion");
}

TEST(Reference, HasEveryTypeOfMeshAndFilterWithAllOfItsKeys) {
  for (const std::string& type : discretizationTypes())
    expectAllKeys(discretizationDeclarations(type), partOf("Discretization", type), type);
  for (const std::string& type : bondFilterTypes())
    expectAllKeys(bondFilterDeclarations(type), partOf("Bond Filters", type), type);
  for (const std::string& type : crackTypes()) expectAllKeys(crackDeclarations(type), partOf("Cracks", type), type);
  for (const std::string& type : voidTypes()) expectAllKeys(voidDeclarations(type), partOf("Voids", type), type);
}

TEST(Reference, HasEverySectionOfADeckAndAStudyWithAllOfItsKeys) {
  for (const char* section : {"Discretization", "Materials", "Damage Models", "Blocks", "Boundary Conditions", "Solver",
                              "Compute Class Parameters", "Output", "Exact Solution"}) {
    EXPECT_NE(partOf(section), "") << section;
    EXPECT_THAT(explain(section), HasSubstr(std::string(section) + " (a section)\n"));
  }
  expectAllKeys(blockDeclarations(), partOf("Blocks"), "Blocks");
  expectAllKeys(nodeSetDeclarations(), partOf("Node Set"), "Node Set");
  expectAllKeys(solverDeclarations(), partOf("Solver"), "Solver");
  expectAllKeys(outputDeclarations(), partOf("Output"), "Output");
  expectAllKeys(exactSolutionDeclarations(), partOf("Exact Solution"), "Exact Solution");
  expectAllKeys(studyDeclarations(), partOf("Study"), "Study");
  expectAllKeys(studySeriesDeclarations(), partOf("Series"), "Series");
  expectAllKeys(fitDeclarations(), partOf("Fit"), "Fit");
  expectAllKeys(fitValueDeclarations(), partOf("Values"), "Values");
  expectAllKeys(fitSeriesDeclarations(), partOf("Fit Series"), "Fit Series");
}

/// Numbers with the declared unit are read as they are, so that "3 GPa" can be checked against it.
void expectUnits(const ParameterDeclarations& declarations, const std::string& owner) {
  for (const Parameter& parameter : declarations.parameters()) {
    const std::string& unit = parameter.unit;
    // Units that the rest of the deck decides, and lists of pairs.
    const bool isOpen = unit.find("unit of") == 0 || unit.find("that of") == 0 || unit.find(", ") != std::string::npos;
    if (unit.empty() || unit == "1" || isOpen) continue;
    std::string complaint;
    EXPECT_EQ(readQuantity("2.5 " + unit, unit, MinusSign::AfterPower, complaint), 2.5)
        << owner << ", " << parameter.name << ": " << complaint;
  }
  for (const auto& sublist : declarations.sublists())
    expectUnits(sublist.declarations.front(), owner + "/" + sublist.name);
}

TEST(Reference, UnitsAreThoseThatNumbersMayHave) {
  for (const ReferenceChapter& chapter : reference()) {
    expectUnits(chapter.declarations, chapter.title);
    for (const ReferenceTopic& topic : chapter.topics) expectUnits(topic.declarations, topic.name);
  }
}

TEST(Reference, SectionsTellHowNumbersAreWritten) {
  EXPECT_THAT(explain("PDHE"),
              testing::EndsWith("\nA number may be a product, as in 2*3600, and where its key has a unit "
                                "may have another one of that\nkind, as in 3 GPa, 0.1 mm, 50 kJ/m^2 or "
                                "1 h.\n"));
  EXPECT_THAT(explain("No Failure"), testing::Not(HasSubstr("A number may be")));
}

TEST(Reference, SectionsTellWhatMayStandInThem) {
  EXPECT_THAT(explain("Materials"), HasSubstr("  PDHE"));
  EXPECT_THAT(explain("Discretization"), HasSubstr("Influence Function: text; default: One"));
  EXPECT_THAT(explain("Discretization"), HasSubstr("  PdQuickGrid\n"));
  // Of the section alone what all types share; of a type all its keys.
  EXPECT_THAT(explain("Discretization"), testing::Not(HasSubstr("Input Mesh File")));
  EXPECT_THAT(explain("Exodus"), HasSubstr("Input Mesh File"));
}

TEST(Reference, WhatALineGoesOnWithStandsFurtherIn) {
  for (const char* topic : {"Corrosion Dissolution", "PDHE", "Reaction_Force"}) {
    std::istringstream lines(explain(topic));
    bool isAmongKeys = false;
    int nKeys = 0;
    for (std::string line; std::getline(lines, line);) {
      if (line.empty()) isAmongKeys = !isAmongKeys;
      if (line.find("Fields; it") != std::string::npos) isAmongKeys = false;
      if (!isAmongKeys || line.compare(0, 2, "  ") != 0 || line[2] == ' ') continue;
      ++nKeys;
      EXPECT_LE(line.size(), 100u) << line;
      const bool isOfSeveral = line.find("Give ") == 2 || line.find("\" needs \"") != std::string::npos;
      EXPECT_TRUE(line.find(": ") != std::string::npos || isOfSeveral) << line;
    }
    EXPECT_GT(nKeys, 0) << topic;
  }
}

TEST(Reference, OfANameThatSeveralHaveTellsAll) {
  const std::string text = explain("Diffusion");
  EXPECT_THAT(text, HasSubstr("Diffusion (Materials: "));
  EXPECT_THAT(text, HasSubstr("Diffusion (Solvers: "));
}

TEST(Reference, RowsGiveUnitRangeAndDefault) {
  ParameterDeclarations declarations;
  declarations.real("Density", "kg/m3", "Mass | volume.").positive().required();
  declarations.integer("Steps", "Number of steps.").atLeast(1).atMost(9).defaultTo(3);
  declarations.text("Law", "Form.").oneOf({"Linear", "Quadratic"});
  declarations.sublist("Inner", "More.").real("Radius", "m", "Size.").from("Euclid");
  declarations.exactlyOneOf({"Law", "Inner"});
  EXPECT_EQ(markdownPage({"Metal", "A body.", declarations, "", "", {}}),
            "# Metal\n\nA body.\n\n"
            "| Key | Value | Unit | Range | Default | Meaning |\n|---|---|---|---|---|---|\n"
            "| `Density` | number | kg/m3 | > 0 | required | Mass \\| volume. |\n"
            "| `Steps` | integer | – | in [1, 9] | `3` | Number of steps. |\n"
            "| `Law` | text | – | `Linear`, `Quadratic` | none | Form. |\n\n"
            "* Give exactly one of \"Law\", \"Inner\".\n\n"
            "**Section `Inner`** – More.\n\n"
            "| Key | Value | Unit | Range | Default | Meaning |\n|---|---|---|---|---|---|\n"
            "| `Radius` | number | m | any | none | Size. [Euclid] |\n\n");
}

}  // namespace
}  // namespace pd
