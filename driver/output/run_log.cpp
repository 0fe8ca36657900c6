#include "run_log.hpp"

#include <unistd.h>

#include <cerrno>

#include "atomic_file.hpp"
#include "result_lock.hpp"

namespace pd {

RunLog::RunLog(bool isQuiet) : isQuiet_(isQuiet), hasTerminal_(!isQuiet && isatty(STDERR_FILENO) != 0) {}

void RunLog::open(const std::string& path, bool isContinued) {
  path_ = path;
  makeFolderOf(path_);
  file_.reset(openForWriting(path_, isContinued));
  writeToFile(thisRun());
  if (std::fputs(kept_.c_str(), file_.get()) < 0 || std::fflush(file_.get()) != 0) writeError_ = errno;
  kept_.clear();
}

RunLog::~RunLog() { clearTerminalLine(); }

void RunLog::line(const std::string& text) {
  writeToFile(text);
  if (!isQuiet_) print(text);
}

void RunLog::progressLine(const std::string& text) {
  writeToFile(text);
  if (!isQuiet_ && !hasTerminal_) print(text);
}

void RunLog::writeToFile(const std::string& text) {
  if (!file_)
    kept_ += text + "\n";
  else if (std::fprintf(file_.get(), "%s\n", text.c_str()) < 0 || std::fflush(file_.get()) != 0)
    writeError_ = errno;
}

void RunLog::print(const std::string& text) {
  clearTerminalLine();
  std::printf("%s\n", text.c_str());
  std::fflush(stdout);
}

void RunLog::replaceTerminalLine(const std::string& text) {
  // Carriage return, text, and the control sequence (ECMA-48 EL) that erases the rest of the line.
  std::fprintf(stderr, "\r%s\x1b[K", text.c_str());
  std::fflush(stderr);
  isTerminalLineShown_ = true;
}

void RunLog::clearTerminalLine() {
  if (!isTerminalLineShown_) return;
  std::fprintf(stderr, "\r\x1b[K");
  std::fflush(stderr);
  isTerminalLineShown_ = false;
}

void RunLog::requireWritten() const {
  if (writeError_ != 0) throwFileError("write", path_, writeError_);
}

}  // namespace pd
