#include "markdown.hpp"

#include <cctype>
#include <filesystem>
#include <fstream>

#include "../deck/deck.hpp"
#include "../output/atomic_file.hpp"
#include "explain.hpp"
#include "explain_fields.hpp"

namespace pd {

namespace {

/// A cell of a table, whose columns "|" would end.
std::string cell(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return " " + (result.empty() ? "–" : result) + " |";
}

std::string valueText(const Parameter& parameter) {
  const bool isOfPlaceAndTime = parameter.isOfPlaceAndTime();
  switch (parameter.type) {
    case ParameterType::Real:
      return "number";
    case ParameterType::Integer:
      return "integer";
    case ParameterType::Flag:
      return "true or false";
    case ParameterType::Text:
      return "text";
    case ParameterType::Function:
      return "number" + std::string(isOfPlaceAndTime ? ", function of " : " or function of ") +
             commaList(parameter.variables) + (isOfPlaceAndTime ? ", or table" : "");
    case ParameterType::Reals:
      return "list of numbers";
    case ParameterType::Texts:
      return "list of names";
    case ParameterType::Functions:
      return "list of numbers or functions of " + commaList(parameter.variables);
  }
  return "";
}

std::string rangeText(const Parameter& parameter) {
  std::string names;
  for (const std::string& choice : parameter.choices) names += (names.empty() ? "`" : ", `") + choice + "`";
  if (!names.empty()) return names;
  Parameter bare = parameter;
  bare.unit.clear();
  const std::string range = bare.allowedText();
  return range.empty() ? "any" : range;
}

std::string defaultCell(const Parameter& parameter) {
  if (parameter.isRequired) return "required";
  const std::string text = parameter.defaultText();
  return text.empty() ? "none" : "`" + text + "`";
}

std::string row(const Parameter& parameter) {
  const std::string source = parameter.source.empty() ? "" : " [" + parameter.source + "]";
  return "|" + cell("`" + parameter.name + "`") + cell(valueText(parameter)) + cell(parameter.unit) +
         cell(rangeText(parameter)) + cell(defaultCell(parameter)) + cell(parameter.meaning + source) + "\n";
}

/// `path` names the section that the keys stand in, where that is one below the topic.
std::string keys(const ParameterDeclarations& declarations, const std::string& path) {
  std::string result;
  if (!declarations.parameters().empty())
    result += "| Key | Value | Unit | Range | Default | Meaning |\n|---|---|---|---|---|---|\n";
  for (const Parameter& parameter : declarations.parameters()) result += row(parameter);
  if (!result.empty()) result += "\n";
  for (const auto& rule : declarations.rules()) result += "* " + ruleText(rule) + "\n";
  if (!declarations.rules().empty()) result += "\n";
  for (const auto& sublist : declarations.sublists()) {
    const std::string below = path + sublist.name;
    result +=
        "**Section `" + below + "`** – " + sublist.meaning + "\n\n" + keys(sublist.declarations.front(), below + "/");
  }
  return result;
}

std::string fieldsTable(const FieldTable& fields) {
  std::string result;
  for (const ExplainedField& field : explainedFields(fields))
    result += "|" + cell("`" + field.label + "`") + cell(field.use) + cell(field.unit) + cell(field.meaning) + "\n";
  return result.empty() ? "" : "| Field | Use | Unit | Meaning |\n|---|---|---|---|\n" + result + "\n";
}

std::string fileName(const ReferenceChapter& chapter) {
  std::string result;
  for (const char c : chapter.name())
    result += c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result + ".md";
}

const char* const indexTitle = "# Reference of decks and studies";

std::string indexPage(const std::vector<ReferenceChapter>& chapters) {
  std::string result = std::string(indexTitle) +
                       "\n\n"
                       "Made by `pdrun --explain --all --markdown` from what the program itself checks decks with. " +
                       numbersOfDecks +
                       "\n\n"
                       "| Page | What it is | Names |\n|---|---|---|\n";
  for (const ReferenceChapter& chapter : chapters) {
    std::string names;
    for (const ReferenceTopic& topic : chapter.topics) names += (names.empty() ? "`" : ", `") + topic.name + "`";
    result +=
        "|" + cell("[" + chapter.name() + "](" + fileName(chapter) + ")") + cell(chapter.brief) + cell(names) + "\n";
  }
  return result;
}

/// Pages of others, where no earlier reference is in the folder.
void refuseOtherPages(const std::filesystem::path& folder,
                      const std::vector<std::pair<std::string, std::string>>& pages) {
  std::ifstream index(folder / pages.front().first);
  std::string title;
  if (std::getline(index, title) && title == indexTitle) return;
  Mistakes mistakes;
  for (const auto& page : pages)
    if (std::filesystem::exists(std::filesystem::symlink_status(folder / page.first)))
      mistakes.add("pdrun", "\"" + (folder / page.first).string() +
                                "\" is there already and is no page of a reference; name a folder of its own");
  mistakes.report();
}

}  // namespace

std::string markdownPage(const ReferenceChapter& chapter) {
  std::string result = "# " + chapter.name() + "\n\n";
  if (!chapter.brief.empty()) result += chapter.brief + "\n\n";
  result += keys(chapter.declarations, "");
  for (const ReferenceTopic& topic : chapter.topics) {
    const std::string topicKeys = keys(topic.declarations, "");
    result += "## " + topic.name + "\n\n" + (topic.brief.empty() ? "" : topic.brief + " ") +
              "In a deck: " + chapter.useOf(topic) + ".\n\n" +
              (topicKeys.empty() ? "It takes no keys.\n\n" : topicKeys) + fieldsTable(topic.fields());
  }
  return result;
}

std::string markdown(const std::vector<ReferenceChapter>& chapters) {
  std::string result;
  for (const ReferenceChapter& chapter : chapters) result += markdownPage(chapter);
  return result;
}

std::vector<std::string> writeReference(const std::string& folder) {
  const std::vector<ReferenceChapter> chapters = reference();
  std::vector<std::pair<std::string, std::string>> pages = {{"README.md", indexPage(chapters)}};
  for (const ReferenceChapter& chapter : chapters) pages.emplace_back(fileName(chapter), markdownPage(chapter));
  const std::filesystem::path place(folder);
  refuseOtherPages(place, pages);
  std::vector<std::string> names;
  for (const auto& [name, text] : pages) {
    names.push_back((place / name).string());
    makeFolderOf(names.back());
    writeFileAtomically(names.back(), text);
  }
  return names;
}

}  // namespace pd
