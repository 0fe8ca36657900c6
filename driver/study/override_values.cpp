#include "override_values.hpp"

namespace pd {

std::string quotedYaml(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

std::string flowYaml(const DeckNode& value) {
  std::string text;
  if (value.isSequence()) {
    for (const DeckNode& item : value.items()) text += (text.empty() ? "" : ", ") + flowYaml(item);
    return "[" + text + "]";
  }
  if (value.isMap()) {
    for (const auto& [key, entry] : value.entries())
      text += (text.empty() ? "" : ", ") + quotedYaml(key) + ": " + flowYaml(entry);
    return "{" + text + "}";
  }
  return value.isQuoted() ? quotedYaml(value.text()) : value.text();
}

bool isMissing(const DeckNode& value) { return value.isMap() && value.entries().empty(); }

StudyOverride overrideOfCommandLine(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw DeckError("--set \"" + text + "\": write it as path=value, as in --set \"Solver/Final Time=1.0\"");
  return {text.substr(0, equals), text.substr(equals + 1), ""};
}

void addOfRoot(const Mistakes& own, const Deck& file, const std::string& what, Mistakes& mistakes) {
  const std::string place = file.root().keyPlace() + ": ";
  for (const std::string& line : own.lines()) {
    const bool lacksPath =
        line.compare(0, place.size(), place) == 0 && (line[place.size()] == ' ' || line[place.size()] == ':');
    mistakes.add("", lacksPath ? place + "the " + what + line.substr(place.size()) : line);
  }
}

}  // namespace pd
