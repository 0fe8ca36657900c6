#include "explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "../deck/deck_parameters.hpp"
#include "explain_fields.hpp"

namespace pd {

namespace {

constexpr std::size_t lineWidth = 100;

const std::string furtherIn(4, ' ');

/// `text` in lines of at most lineWidth characters, the first after `indent`, the others after `rest` too.
std::string wrapped(const std::string& text, const std::string& indent, const std::string& rest = "") {
  std::istringstream words(text);
  std::string result, line = indent;
  bool isFresh = true;
  for (std::string word; words >> word;) {
    if (!isFresh && line.size() + 1 + word.size() > lineWidth) {
      result += line + "\n";
      line = indent + rest;
      isFresh = true;
    }
    line += (isFresh ? "" : " ") + word;
    isFresh = false;
  }
  return isFresh ? result : result + line + "\n";
}

std::string declarationsText(const ParameterDeclarations& declarations, const std::string& indent) {
  std::string result;
  for (const Parameter& parameter : declarations.parameters()) {
    std::string use = parameter.isRequired ? "required" : "optional";
    if (const std::string value = parameter.defaultText(); !value.empty()) use = "default: " + value;
    // The meaning stands between a key and what its line goes on with.
    result += wrapped(parameter.name + ": " + parameter.expectation() + "; " + use, indent, furtherIn + furtherIn);
    result += wrapped(parameter.meaning + (parameter.source.empty() ? "" : " [" + parameter.source + "]"),
                      indent + furtherIn);
  }
  for (const auto& rule : declarations.rules()) result += wrapped(ruleText(rule), indent, furtherIn);
  for (const auto& sublist : declarations.sublists()) {
    result += wrapped((sublist.name == "*" ? "(any name)" : sublist.name) + ": a section; optional", indent);
    result += wrapped(sublist.meaning, indent + furtherIn);
    result += declarationsText(sublist.declarations.front(), indent + furtherIn);
  }
  return result;
}

std::string topicsText(const std::vector<ReferenceTopic>& topics) {
  std::string result;
  std::size_t width = 0;
  for (const ReferenceTopic& topic : topics) width = std::max(width, topic.name.size());
  for (const ReferenceTopic& topic : topics)
    result +=
        topic.brief.empty() ? "  " + topic.name + "\n" : fmt::format("  {:<{}}  {}\n", topic.name, width, topic.brief);
  return result;
}

std::string sectionText(const ReferenceChapter& chapter, const std::vector<ReferenceTopic>& topics) {
  std::string result = chapter.section + " (a section)\n" + wrapped(chapter.brief, "  ");
  const std::string keys = declarationsText(chapter.declarations, "  ");
  if (!keys.empty()) result += "\n" + keys;
  if (topics.empty()) return result;
  return result + "\n" +
         wrapped(chapter.title + ", each " + fmt::format(fmt::runtime(chapter.use), "NAME") +
                     "; pdrun --explain NAME tells the keys of one:",
                 "") +
         topicsText(topics);
}

std::string fieldsText(const ReferenceTopic& topic) {
  std::string result;
  for (const std::string& line : fieldLines(topic.fields())) result += wrapped(line, furtherIn, furtherIn);
  return result.empty() ? "" : "\n  Fields; it\n" + result;
}

std::string topicText(const ReferenceChapter& chapter, const ReferenceTopic& topic) {
  const std::string keys = declarationsText(topic.declarations, "  ");
  return topic.name + " (" + chapter.title + ": " + chapter.useOf(topic) + ")\n" + wrapped(topic.brief, "  ") + "\n" +
         (keys.empty() ? "  It takes no parameters.\n" : keys) + fieldsText(topic);
}

/// Whether a key takes a number.
bool hasNumbers(const ParameterDeclarations& declarations) {
  return std::any_of(declarations.parameters().begin(), declarations.parameters().end(),
                     [](const Parameter& parameter) { return !parameter.unit.empty(); }) ||
         std::any_of(declarations.sublists().begin(), declarations.sublists().end(),
                     [](const auto& sublist) { return hasNumbers(sublist.declarations.front()); });
}

void append(std::string& all, const std::string& text) { all += (all.empty() ? "" : "\n") + text; }

/// Sections of that name below `declarations`, which are those of `path`, each with the places where it stands. One
/// that others take over with all its keys is one section.
void findBelow(const ParameterDeclarations& declarations, const std::string& path, const std::string& name,
               std::vector<ReferenceChapter>& found) {
  for (const auto& sublist : declarations.sublists()) {
    const std::string below = path + "/" + sublist.name;
    if (sublist.name == name) {
      const ParameterDeclarations& keys = sublist.declarations.front();
      const std::string text = sublist.meaning + declarationsText(keys, "");
      const auto same = std::find_if(found.begin(), found.end(), [&](const ReferenceChapter& other) {
        return other.use + declarationsText(other.declarations, "") == text;
      });
      if (same == found.end())
        found.push_back({name, sublist.meaning + " In " + path, keys, "", sublist.meaning, {}});
      else if (same->brief.find(path) == std::string::npos)
        same->brief += ", " + path;
    }
    findBelow(sublist.declarations.front(), below, name, found);
  }
}

std::vector<ReferenceChapter> sectionsBelow(const std::string& name) {
  std::vector<ReferenceChapter> found;
  for (const ReferenceChapter& chapter : reference()) {
    findBelow(chapter.declarations, chapter.name(), name, found);
    for (const ReferenceTopic& topic : chapter.topics) findBelow(topic.declarations, topic.name, name, found);
  }
  for (ReferenceChapter& chapter : found) {
    chapter.use.clear();
    chapter.brief += "; * stands for any name.";
  }
  return found;
}

}  // namespace

const char* const numbersOfDecks =
    "A number may be a product, as in 2*3600, and where its key has a unit may have another one of that kind, as in 3 "
    "GPa, 0.1 mm, 50 kJ/m^2 or 1 h.";

std::string listEverything() {
  std::string result;
  std::vector<ReferenceTopic> sections;
  for (const ReferenceChapter& chapter : reference()) {
    if (!chapter.section.empty()) sections.push_back({chapter.section, chapter.brief, {}});
    if (!chapter.topics.empty()) append(result, chapter.title + "\n" + topicsText(chapter.topics));
  }
  append(result, "Sections of a deck\n" + topicsText(sections));
  return result + "\npdrun --explain NAME tells the keys of one.\n";
}

std::vector<ReferenceChapter> chaptersAbout(const std::string& name) {
  std::vector<ReferenceChapter> result;
  std::vector<std::string> known;
  for (ReferenceChapter chapter : reference()) {
    if (!chapter.section.empty()) known.push_back(chapter.section);
    for (const ReferenceTopic& topic : chapter.topics) known.push_back(topic.name);
    if (chapter.section != name) {
      chapter.section.clear();
      chapter.brief.clear();
      chapter.declarations = {};
      auto& topics = chapter.topics;
      topics.erase(std::remove_if(topics.begin(), topics.end(), [&](const auto& topic) { return topic.name != name; }),
                   topics.end());
      if (topics.empty()) continue;
    }
    result.push_back(chapter);
  }
  if (result.empty()) result = sectionsBelow(name);
  if (!result.empty()) return result;
  throw DeckError("--explain: nothing is called \"" + name + "\"" + didYouMean(name, known) +
                  "; pdrun --list names everything");
}

std::string explain(const std::string& name) {
  std::string result;
  bool asksForNumbers = false;
  for (const ReferenceChapter& chapter : chaptersAbout(name)) {
    if (chapter.section == name) append(result, sectionText(chapter, chapter.topics));
    asksForNumbers = asksForNumbers || hasNumbers(chapter.declarations);
    for (const ReferenceTopic& topic : chapter.topics) {
      if (topic.name != name) continue;
      append(result, topicText(chapter, topic));
      asksForNumbers = asksForNumbers || hasNumbers(topic.declarations);
    }
  }
  if (asksForNumbers) append(result, wrapped(numbersOfDecks, ""));
  return result;
}

std::string explainEverything() {
  std::string result;
  for (const ReferenceChapter& chapter : reference()) {
    if (!chapter.section.empty()) append(result, sectionText(chapter, {}));
    for (const ReferenceTopic& topic : chapter.topics) append(result, topicText(chapter, topic));
  }
  append(result, wrapped(numbersOfDecks, ""));
  return result;
}

}  // namespace pd
