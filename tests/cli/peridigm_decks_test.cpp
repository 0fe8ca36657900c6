// Decks of Peridigm as pdrun takes them: XML and YAML alike, unknown keys strict and lenient, mistakes by line.
#include <gtest/gtest.h>
#include <mpi.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "run_pdrun.hpp"

namespace pd {
namespace {

using pd_test::Outcome;
using pd_test::SceneFiles;

/// Lines are counted on: change the numbers in the tests with them.
const char* const goodXml = R"xml(<ParameterList>
  <Parameter name="Verbose" type="bool" value="false"/>
  <ParameterList name="Discretization">
    <Parameter name="Type" type="string" value="Text File"/>
    <Parameter name="Input Mesh File" type="string" value="mesh.txt"/>
  </ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="Rock">
      <Parameter name="Material Model" type="string" value="Elastic"/>
      <Parameter name="Density" type="double" value="2200.0"/>
      <Parameter name="Bulk Modulus" type="double" value="14.9e9"/>
      <Parameter name="Shear Modulus" type="double" value="8.94e9"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Blocks">
    <ParameterList name="All">
      <Parameter name="Block Names" type="string" value="block_1"/>
      <Parameter name="Material" type="string" value="Rock"/>
      <Parameter name="Horizon" type="double" value="1.5"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Boundary Conditions">
    <Parameter name="First Node Set" type="string" value="1 2"/>
    <ParameterList name="Push">
      <Parameter name="Type" type="string" value="Initial Velocity"/>
      <Parameter name="Node Set" type="string" value="First Node Set"/>
      <Parameter name="Coordinate" type="string" value="x"/>
      <Parameter name="Value" type="string" value="if(x &lt; 0.5)\{ value = 1.0; \} else \{ value = 2.0; \}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Solver">
    <Parameter name="Final Time" type="double" value="1.0e-5"/>
    <ParameterList name="Verlet">
      <Parameter name="Fixed dt" type="double" value="1.0e-6"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Output">
    <Parameter name="Output Filename" type="string" value="result"/>
    <Parameter name="Output Frequency" type="int" value="1"/>
    <ParameterList name="Output Variables">
      <Parameter name="Displacement" type="bool" value="true"/>
      <Parameter name="Global_Kinetic_Energy" type="bool" value="true"/>
    </ParameterList>
  </ParameterList>
</ParameterList>
)xml";

const char* const goodYaml = R"yaml(Peridigm:
  Discretization: {Type: Text File, Input Mesh File: mesh.txt}
  Materials:
    Rock: {Material Model: Elastic, Density: 2200.0, Bulk Modulus: 14.9e9, Shear Modulus: 8.94e9}
  Blocks:
    All: {Block Names: block_1, Material: Rock, Horizon: 1.5}
  Boundary Conditions:
    First Node Set: 1 2
    Push:
      Type: Initial Velocity
      Node Set: First Node Set
      Coordinate: x
      Value: "if(x < 0.5)\{ value = 1.0; \} else \{ value = 2.0; \}"
  Solver: {Final Time: 1.0e-5, Verlet: {Fixed dt: 1.0e-6}}
  Output:
    Output Filename: result
    Output Frequency: 1
    Output Variables: {Displacement: true, Global_Kinetic_Energy: true}
)yaml";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// Writes deck and mesh and runs the deck.
Outcome run(const SceneFiles& scene, const std::string& name, const std::string& deck,
            std::vector<std::string> arguments = {}) {
  scene.write("mesh.txt", "0 0 0 1 1.0\n1 0 0 1 1.0\n0 1 0 1 1.0\n0 0 1 1 1.0\n1 1 1 1 1.0\n");
  const std::string path = scene.write(name, deck);
  return pd_test::runPdrun(scene, path, std::move(arguments));
}

std::string contentOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(PeridigmDecks, RunAlikeInXmlAndYaml) {
  const SceneFiles xml("peridigm_xml"), yaml("peridigm_yaml");
  const Outcome first = run(xml, "deck.xml", goodXml), second = run(yaml, "deck.yaml", goodYaml);
  ASSERT_EQ(first.exitCode, 0) << first.errors;
  ASSERT_EQ(second.exitCode, 0) << second.errors;
  const std::string history = contentOf(xml.path("result.csv"));
  // Both points move: 1/2 rho V (1 + 4) at the start.
  EXPECT_NE(history.find("\n0,0,5500"), std::string::npos) << history;
  EXPECT_EQ(history, contentOf(yaml.path("result.csv")));
}

TEST(PeridigmDecks, AStepBeyondTheFinalTimeIsNotMade) {
  const SceneFiles theirs("peridigm_long_step"), ours("own_long_step");
  const Outcome outcome = run(theirs, "deck.xml", replaced(goodXml, "value=\"1.0e-6\"", "value=\"1.9e-4\""));
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_NE(contentOf(theirs.path("result.log")).find("as in Peridigm no step is made"), std::string::npos);
  const std::string history = contentOf(theirs.path("result.csv"));
  EXPECT_EQ(std::count(history.begin(), history.end(), '\n'), 2) << "the header and the initial state:\n" << history;
  // In decks of our own a step meets the Final Time.
  const std::string deck =
      "Discretization: {Type: Text File, Input Mesh File: mesh.txt}\n"
      "Materials: {Rock: {Material Model: Elastic, Density: 2200.0, Bulk Modulus: 14.9e9, Shear Modulus: 8.94e9}}\n"
      "Blocks: {All: {Block Names: block_1, Material: Rock, Horizon: 1.5}}\n"
      "Solver: {Final Time: 1.0e-5, Verlet: {Fixed dt: 1.9e-4}}\n"
      "Output: {Output Filename: result, Output Variables: [Global_Kinetic_Energy]}\n";
  EXPECT_EQ(run(ours, "deck.yaml", deck).exitCode, 0);
  EXPECT_NE(contentOf(ours.path("result.csv")).find("\n1,1e-05,"), std::string::npos);
}

TEST(PeridigmDecks, XmlMistakesNameTheirLine) {
  const SceneFiles scene("peridigm_broken");
  struct Case {
    const char *from, *to, *expected;
  };
  for (const Case& broken :
       {Case{"type=\"double\" value=\"2200.0\"", "type=\"double\" value=\"heavy\"",
             "deck.xml:10: parameter \"Density\": \"heavy\" is no value of type \"double\"\n"},
        Case{"type=\"double\" value=\"2200.0\"", "type=\"string\" value=\"2200.0\"",
             "deck.xml:10: Materials/Rock/Density must be a number > 0 kg/m3, not the string \"2200.0\"; write "
             "type=\"double\"\n"},
        Case{"type=\"double\" value=\"2200.0\"", "type=\"double\" value=\"-2200.0\"",
             "deck.xml:10: Materials/Rock/Density is -2200, must be > 0 kg/m3\n"},
        Case{"type=\"int\" value=\"1\"", "type=\"double\" value=\"1.0\"",
             "deck.xml:39: Output/Output Frequency must be an integer >= -1, not the double \"1.0\"; write "
             "type=\"int\"\n"},
        Case{"\"Rock\"/>", "\"Rok\"/>",
             "deck.xml:18: Blocks/All/Material: there is no \"Rok\" in Materials (did you mean \"Rock\"?)"},
        Case{"\"Horizon\"", "\"Horizn\"",
             "deck.xml:19: unknown key \"Horizn\" in Blocks/All (did you mean \"Horizon\"?)"},
        Case{"value=\"mesh.txt\"/>", "value=\"mesh.txt\">",
             "deck.xml:5: XML syntax: a closing tag does not belong to the element that is open; look for a missing "
             "\"/>\" or </...>\n"},
        Case{"Displacement", "Displacment",
             "deck.xml:41: Output/Output Variables: nothing in this deck provides \"Displacment\" (did you mean "
             "\"Displacement\"?)"}}) {
    const Outcome outcome = run(scene, "deck.xml", replaced(goodXml, broken.from, broken.to));
    EXPECT_EQ(outcome.exitCode, 2) << broken.expected;
    EXPECT_NE(outcome.errors.find(broken.expected), std::string::npos) << broken.expected << "\n--- is not in ---\n"
                                                                       << outcome.errors;
  }
}

/// The good deck with keys that nobody knows in several places.
std::string withUnknownKeys() {
  std::string deck = replaced(goodYaml, "Peridigm:\n", "Peridigm:\n  Author: me\n");
  deck = replaced(deck, "Density: 2200.0,", "Density: 2200.0, Colour: {Red: 1},");
  deck = replaced(deck, "Coordinate: x\n", "Coordinate: x\n      Comment: pushed\n");
  return replaced(deck, "Displacement: true,", "Displacement: true, Beauty: true,");
}

TEST(PeridigmDecks, UnknownKeysAreMistakesOrWarnings) {
  const std::vector<std::string> expected{"deck.yaml:2:3: unknown key \"Author\" at the top level",
                                          "deck.yaml:5:54: unknown key \"Colour\" in Materials/Rock",
                                          "deck.yaml:14:7: unknown key \"Comment\" in Boundary Conditions/Push"};
  const SceneFiles scene("peridigm_unknown");
  const Outcome strict = run(scene, "deck.yaml", withUnknownKeys());
  EXPECT_EQ(strict.exitCode, 2);
  for (const std::string& line : expected)
    EXPECT_NE(strict.errors.find(line), std::string::npos) << line << "\n--- is not in ---\n" << strict.errors;

  const Outcome lenient = run(scene, "deck.yaml", withUnknownKeys(), {"--peridigm-keys", "lenient"});
  EXPECT_EQ(lenient.exitCode, 0) << lenient.errors;
  const std::string log = contentOf(scene.path("result.log"));
  for (const std::string& line : expected) {
    const std::string message = line.substr(line.find("unknown"));
    EXPECT_NE(log.find(message), std::string::npos) << message << "\n--- is not in ---\n" << log;
  }
  EXPECT_NE(log.find("nothing in this deck provides \"Beauty\"; it is left out"), std::string::npos) << log;
  // The resolved deck is free of them.
  const std::string resolved = contentOf(scene.path("result.resolved.yaml"));
  for (const char* key : {"Author", "Colour", "Comment", "Beauty"})
    EXPECT_EQ(resolved.find(key), std::string::npos) << resolved;
}

TEST(PeridigmDecks, LenienceIsForThemAlone) {
  const SceneFiles scene("peridigm_native");
  std::istringstream lines(withUnknownKeys());
  std::string deck, line;
  std::getline(lines, line);  // the root key
  while (std::getline(lines, line)) deck += line.substr(2) + "\n";
  EXPECT_EQ(run(scene, "deck.yaml", deck, {"--peridigm-keys", "lenient"}).exitCode, 2);
  EXPECT_EQ(run(scene, "deck.yaml", goodYaml, {"--peridigm-keys", "loose"}).exitCode, 2);
}

TEST(PeridigmDecks, PointsWithoutNeighboursAreWarnedOf) {
  const SceneFiles scene("peridigm_lonely");
  const Outcome outcome = run(scene, "deck.xml", replaced(goodXml, "value=\"1.5\"", "value=\"1.2\""));
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_NE(contentOf(scene.path("result.log")).find("mesh.txt:5: the point (1, 1, 1) has no neighbours"),
            std::string::npos);
}

}  // namespace
}  // namespace pd
