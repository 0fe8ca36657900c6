#include "run_log.hpp"

#include <unistd.h>

#include <cerrno>

#include "atomic_file.hpp"

namespace pd {

RunLog::RunLog(const std::string& path, bool isQuiet, bool isContinued)
    : path_(path), isQuiet_(isQuiet), hasTerminal_(!isQuiet && isatty(STDERR_FILENO) != 0) {
  makeFolderOf(path_);
  file_.reset(std::fopen(path_.c_str(), isContinued ? "ab" : "wb"));
  if (!file_) throwFileError("open", path_, errno);
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
  if (std::fprintf(file_.get(), "%s\n", text.c_str()) < 0 || std::fflush(file_.get()) != 0) writeError_ = errno;
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
