// Decks in XML: parameter lists of Teuchos, as Peridigm reads them.
#include <fstream>

#include "deck_from_text.hpp"
#include "driver/deck/deck_parameters.hpp"

namespace pd {
namespace {

std::string xmlFileName() { return deckFileName() + ".xml"; }

Deck deckFromXml(const std::string& text, const std::vector<std::string>& overrides = {}) {
  std::ofstream(xmlFileName(), std::ios::binary) << text;
  return Deck::read(xmlFileName(), overrides);
}

/// Complaints with the deck's name cut down to "deck.xml".
std::string complaintOfXml(const std::string& text) {
  return complaintOf([&] { deckFromXml(text); });
}

const char* const bar = R"xml(<?xml version="1.0"?>
<ParameterList>
  <!-- a comment -->
  <ParameterList name="Solver">
    <Parameter name="Final Time" type="double" value=" 1.5 "/>
    <ParameterList name="Verlet">
      <Parameter name="Verbose"
                 type="bool"
                 value="false"/>
    </ParameterList>
    <Parameter name="Steps" type="int" value="-20"/>
  </ParameterList>
  <Parameter name="Value" type="string" value="if(x &lt; 1.0)\{ value = 2.0; \}"/>
  <Parameter name="Times" type="Array(double)" value="{0.0, 1e-3,2}"/>
</ParameterList>
)xml";

TEST(XmlDeck, HasTheTreeAndThePlacesOfTheFile) {
  const Deck deck = deckFromXml(bar);
  EXPECT_TRUE(deck.isPeridigmDeck());
  const DeckNode time = deck["Solver"]["Final Time"];
  EXPECT_DOUBLE_EQ(time.real(), 1.5);
  EXPECT_EQ(time.place(), xmlFileName() + ":5");
  EXPECT_EQ(time.path(), "Solver/Final Time");
  const DeckNode verbose = deck["Solver"]["Verlet"]["Verbose"];
  EXPECT_FALSE(verbose.flag());
  EXPECT_EQ(verbose.keyPlace(), xmlFileName() + ":7");
  EXPECT_EQ(verbose.place(), xmlFileName() + ":9");
  EXPECT_EQ(deck["Solver"]["Steps"].integer(), -20);
  EXPECT_EQ(deck["Value"].text(), "if(x < 1.0)\\{ value = 2.0; \\}");
  ASSERT_EQ(deck["Times"].items().size(), 3u);
  EXPECT_DOUBLE_EQ(deck["Times"].items()[1].real(), 1.0e-3);
  std::vector<std::string> keys;
  for (const auto& entry : deck["Solver"].entries()) keys.push_back(entry.first);
  EXPECT_EQ(keys, (std::vector<std::string>{"Final Time", "Verlet", "Steps"}));
}

TEST(XmlDeck, TakesOverrides) {
  const Deck deck = deckFromXml(bar, {"Solver/Final Time=2.0"});
  EXPECT_DOUBLE_EQ(deck["Solver"]["Final Time"].real(), 2.0);
}

TEST(XmlDeck, ReportsAllMistakesWithTheirLines) {
  const std::string complaint = complaintOfXml(R"(<ParameterList>
  <Parameter name="A" type="int" value="3.5"/>
  <Parameter name="B" type="double" value="heavy"/>
  <Parameter name="C" type="dubble" value="1.0"/>
  <Parameter name="D" value="1.0"/>
  <Parameter type="double" value="1.0"/>
  <Parameter name="E" type="bool" value="maybe"/>
  <Paramter name="F" type="int" value="1"/>
  <Parameter name="G" type="int" value="1"/>
  <Parameter name="G" type="int" value="1"/>
  <Parameter name="H" type="int" value="1" vlaue="2"/>
  left over
</ParameterList>
)");
  for (const char* part : {"deck.xml:2: parameter \"A\": \"3.5\" is no value of type \"int\" (write it without a "
                           "point, or type=\"double\")",
                           "deck.xml:3: parameter \"B\": \"heavy\" is no value of type \"double\"",
                           "deck.xml:4: parameter \"C\": unknown type \"dubble\" (did you mean \"double\"?)",
                           "deck.xml:5: parameter \"D\" has no type", "deck.xml:6: this <Parameter> has no name",
                           "deck.xml:7: parameter \"E\": \"maybe\" is no value of type \"bool\" (true or false)",
                           "deck.xml:8: unknown element <Paramter> (did you mean \"Parameter\"?)",
                           "deck.xml:10: \"G\" is given twice in the same section (first in line 9)",
                           "deck.xml:11: unknown attribute \"vlaue\" of <Parameter> (did you mean \"value\"?)",
                           "\"left over\" stands outside of elements"})
    EXPECT_NE(complaint.find(part), std::string::npos) << part << "\nis not in\n" << complaint;
}

TEST(XmlDeck, NamesTheLineOfASyntaxError) {
  EXPECT_EQ(complaintOfXml("<ParameterList>\n  <Parameter name=\"A\" type=\"int\" value=\"1\">\n</ParameterList>\n"),
            "deck.xml:2: XML syntax: a closing tag does not belong to the element that is open; look for a missing "
            "\"/>\" or </...>");
  EXPECT_NE(complaintOfXml("<ParameterList>\n<Parameter name=A/>\n</ParameterList>").find("deck.xml:2: XML syntax: "),
            std::string::npos);
  EXPECT_NE(complaintOfXml("").find("XML syntax"), std::string::npos);
  EXPECT_NE(complaintOfXml("<Deck/>").find("deck.xml:1: a deck in XML is one <ParameterList>, not <Deck>"),
            std::string::npos);
}

TEST(XmlDeck, ChecksTypesAgainstTheDeclarations) {
  ParameterDeclarations declare;
  declare.real("Density", "kg/m3", "Mass density.");
  declare.real("Length", "m", "A length.");
  declare.integer("Steps", "A count.");
  declare.flag("Loud", "A flag.");
  declare.text("Name", "A name.");
  declare.function("Value", "1", "A function.");
  const Deck deck = deckFromXml(R"(<ParameterList>
  <Parameter name="Density" type="string" value="2200.0"/>
  <Parameter name="Length" type="int" value="2"/>
  <Parameter name="Steps" type="double" value="20"/>
  <Parameter name="Loud" type="string" value="true"/>
  <Parameter name="Name" type="int" value="7"/>
  <Parameter name="Value" type="string" value="0.5*t"/>
</ParameterList>
)");
  Mistakes mistakes;
  const Teuchos::ParameterList list = readParameters(deck.root(), declare, mistakes);
  const std::vector<std::string> expected{
      ":2: Density must be a number in kg/m3, not the string \"2200.0\"; write type=\"double\"",
      ":4: Steps must be an integer, not the double \"20\"; write type=\"int\"",
      ":5: Loud must be true or false, not the string \"true\"; write type=\"bool\"",
      ":6: Name must be text, not the int \"7\"; write type=\"string\""};
  ASSERT_EQ(mistakes.lines().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(mistakes.lines()[i], xmlFileName() + expected[i]);
  EXPECT_DOUBLE_EQ(list.get<double>("Length"), 2.0);
  EXPECT_EQ(list.get<std::string>("Value"), "0.5*t");
}

}  // namespace
}  // namespace pd
