#include "text_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "../parallel/broadcast.hpp"

namespace pd {

namespace {

constexpr int maximumListedMistakes = 20;  ///< mistakes of one file

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// What is wrong with the file; empty where it was read.
std::string readOnThisRank(const std::string& fileName, std::string& text) {
  std::error_code error;
  if (std::filesystem::is_directory(fileName, error)) return "is a folder";
  errno = 0;
  std::ifstream file(fileName, std::ios::binary | std::ios::ate);
  if (!file) return errno == 0 ? "cannot be opened" : std::strerror(errno);
  text.resize(static_cast<std::size_t>(std::max<std::streamoff>(file.tellg(), 0)));
  file.seekg(0);
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0) text.erase(0, 3);  // byte order mark of UTF-8
  return file ? "" : "cannot be read to its end";
}

}  // namespace

std::optional<std::string> readTextFile(const std::string& fileName, const std::string& place, const Communicator& comm,
                                        Mistakes& mistakes) {
  std::string text, problem;
  if (comm.isRoot()) problem = readOnThisRank(fileName, text);
  broadcast(problem, comm);
  if (!problem.empty()) {
    mistakes.add(place, "file \"" + fileName + "\": " + problem + " (relative names start at the deck's folder)");
    return std::nullopt;
  }
  broadcast(text, comm);
  return text;
}

bool DataLines::next() {
  while (!rest_.empty()) {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    while (!line_.empty() && isBlank(line_.front())) line_.remove_prefix(1);
    if (line_.empty() || line_.front() == '#' || line_.front() == '/' || line_.front() == '*') continue;
    line_ = line_.substr(0, line_.find('#'));
    return true;
  }
  return false;
}

std::string_view DataLines::word() {
  std::size_t begin = 0;
  while (begin < line_.size() && isBlank(line_[begin])) ++begin;
  std::size_t end = begin;
  while (end < line_.size() && !isBlank(line_[end])) ++end;
  const std::string_view result = line_.substr(begin, end - begin);
  line_.remove_prefix(end);
  return result;
}

FileMistakes::~FileMistakes() {
  if (count_ > maximumListedMistakes)
    mistakes_.add(fileName_,
                  std::to_string(count_ - maximumListedMistakes) + " more mistakes of this file are not listed");
}

void FileMistakes::add(int line, const std::string& message) {
  if (++count_ <= maximumListedMistakes) mistakes_.add(fileName_ + ":" + std::to_string(line), message);
}

std::string quoted(std::string_view word) {
  constexpr std::size_t maximumLength = 40;
  std::string result(word.substr(0, maximumLength));
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) c = '?';
  return "\"" + result + (word.size() > maximumLength ? "...\"" : "\"");
}

}  // namespace pd
