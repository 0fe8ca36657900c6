// Text files of numbers (meshes, node sets): reading, stepping through data lines, collecting mistakes.
#ifndef PD_TEXT_FILE_HPP
#define PD_TEXT_FILE_HPP

#include <optional>
#include <string>
#include <string_view>

#include "../deck/deck.hpp"
#include "../parallel/communicator.hpp"

namespace pd {

/// The whole file, read by the root rank and handed to all. Nothing where it cannot be read (a mistake at `place`
/// is added). Collective.
std::optional<std::string> readTextFile(const std::string& fileName, const std::string& place, const Communicator& comm,
                                        Mistakes& mistakes);

/// Steps through the lines that hold data: blank lines and lines that start with #, / or * are skipped, and so is
/// the rest of a line after a #.
class DataLines {
 public:
  explicit DataLines(std::string_view text) : rest_(text) {}
  /// Goes to the next data line; false at the end.
  bool next();
  /// Number of the line in the file, from 1.
  int number() const { return number_; }
  /// The next blank-separated word of the line; empty at its end.
  std::string_view word();

 private:
  std::string_view rest_, line_;
  int number_ = 0;
};

/// Adds the mistakes of one file as "file:line: message"; of very many only the first are listed.
class FileMistakes {
 public:
  FileMistakes(std::string fileName, Mistakes& mistakes) : fileName_(std::move(fileName)), mistakes_(mistakes) {}
  /// Says how many mistakes were left out.
  ~FileMistakes();
  FileMistakes(const FileMistakes&) = delete;
  FileMistakes& operator=(const FileMistakes&) = delete;

  void add(int line, const std::string& message);
  int count() const { return count_; }

 private:
  std::string fileName_;
  Mistakes& mistakes_;
  int count_ = 0;
};

/// `word` in quotes, shortened and freed of control characters so that it can stand in a message.
std::string quoted(std::string_view word);

}  // namespace pd

#endif
