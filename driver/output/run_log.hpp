// Lines of a run for its log file and the terminal.
#ifndef PD_RUN_LOG_HPP
#define PD_RUN_LOG_HPP

#include <cstdio>
#include <memory>
#include <string>

namespace pd {

/// Used by the root rank alone.
class RunLog {
 public:
  /// Lines are kept until open().
  explicit RunLog(bool isQuiet);
  ~RunLog();

  /// `isContinued`: lines are added to those of the run that is restarted. The first one says which program, host and
  /// process write, and when. Throws RunError.
  void open(const std::string& path, bool isContinued);

  /// A line for the file, and for standard output unless quiet.
  void line(const std::string& text);
  /// A line of progress: as line(), but not for a terminal, which has its own line for that.
  void progressLine(const std::string& text);

  /// Whether standard error is a terminal that shows a line which replaces itself.
  bool hasTerminal() const { return hasTerminal_; }
  /// Replaces the terminal's last line.
  void replaceTerminalLine(const std::string& text);

  /// Throws RunError where a line could not be written, such as on a full disk.
  void requireWritten() const;

 private:
  void writeToFile(const std::string& text);
  void print(const std::string& text);
  void clearTerminalLine();

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string path_, kept_;
  std::unique_ptr<std::FILE, Close> file_;
  bool isQuiet_, hasTerminal_;
  bool isTerminalLineShown_ = false;
  int writeError_ = 0;
};

}  // namespace pd

#endif
