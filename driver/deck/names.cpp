#include "names.hpp"

#include <algorithm>
#include <filesystem>

namespace pd {

namespace {

constexpr std::size_t longestName = 200;  // bytes; file systems allow 255, of which endings take up to 40

/// What of `refused` the text has, in words; control characters among them. Empty where it has none.
std::string refusedIn(const std::string& text, const std::string& refused) {
  if (hasControlCharacter(text)) return "a line break, a tab or another control character";
  const std::size_t at = text.find_first_of(refused);
  return at == std::string::npos ? "" : std::string(1, text[at]);
}

bool hasBlankEnd(const std::string& text) { return text.front() == ' ' || text.back() == ' '; }

}  // namespace

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool hasControlCharacter(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
}

std::string complaintOfFileName(const std::string& name) {
  const std::filesystem::path path(name);
  const std::string remedy = "; the folder that results go to is named by pdrun --output-folder FOLDER";
  if (name.empty()) return "must not be empty";
  if (path.is_absolute()) return "must be a path below the folder of the run, not an absolute one" + remedy;
  if (const std::string found = refusedIn(name, ":\"\\"); !found.empty())
    return "must not contain " + found + ", which XDMF and CSV files cannot tell from their own";
  if (hasBlankEnd(name)) return "must not begin or end with a blank";
  for (const auto& part : path) {
    if (part == "..") return "must not lead out of the folder of the run (\"..\")" + remedy;
    if (part.string().size() > longestName)
      return "has a part of " + std::to_string(part.string().size()) + " characters; names of files end at " +
             std::to_string(longestName);
  }
  if (!path.has_filename() || path.filename() == ".") return "must end with a name, not with a folder";
  return "";
}

std::string complaintOfLabel(const std::string& label) {
  if (label.empty()) return "must not be empty";
  if (const std::string found = refusedIn(label, ",\"'#/"); !found.empty())
    return "must not contain " + found +
           ": it is the heading of a column and the name of a table; use letters, digits and _";
  if (hasBlankEnd(label)) return "must not begin or end with a blank";
  if (label == ".") return "must be a name";
  for (const char* taken : {"step", "time"})
    if (label == taken)
      return std::string("must not be \"") + taken + "\": the history has a column of this name already";
  return "";
}

}  // namespace pd
