#include "atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "../model/model.hpp"

namespace pd {

namespace {

const std::string unfinishedEnding = ".pdrun-unfinished";  // a mark: whoever finds it knows whose it is

}  // namespace

std::string unfinishedName(const std::string& path) { return path + unfinishedEnding; }

bool isUnfinished(const std::string& path) {
  const std::string name = path.substr(path.find_last_of('/') + 1);
  const std::size_t at = name.rfind(unfinishedEnding);
  if (at == std::string::npos || at == 0) return false;
  const std::size_t end = at + unfinishedEnding.size();
  return end == name.size() || name[end] == '.';
}

std::FILE* openForWriting(const std::string& path, bool isContinued) {
  // Not blocking: nothing waits for the reader of a pipe.
  const int flags = O_WRONLY | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | (isContinued ? O_APPEND : O_TRUNC);
  const int descriptor = open(path.c_str(), flags, 0666);
  std::FILE* file = descriptor < 0 ? nullptr : fdopen(descriptor, isContinued ? "ab" : "wb");
  if (file != nullptr) return file;
  const int error = errno;
  if (descriptor >= 0) close(descriptor);
  throwFileError("open", path, error);
}

std::string missingFolder(const std::string& path) {
  std::error_code error;
  // A working folder that was removed has no name any more.
  const std::filesystem::path folder = std::filesystem::absolute(path, error).parent_path();
  if (!error && (std::filesystem::exists(folder, error) || error)) return "";
  return "; its folder is not there (was it removed or renamed?)";
}

void throwFileError(const std::string& what, const std::string& path, int errorNumber) {
  throw RunError("cannot " + what + " \"" + path + "\": " + std::generic_category().message(errorNumber) +
                 missingFolder(path));
}

namespace {

void giveItsName(const std::string& path) {
  if (std::rename(unfinishedName(path).c_str(), path.c_str()) != 0)
    throwFileError("rename a finished file to", path, errno);
}

}  // namespace

void finishFile(const std::string& path) {
  const std::string unfinished = unfinishedName(path);
  // Without this, a power failure could leave the new name on an empty file.
  const int descriptor = open(unfinished.c_str(), O_RDONLY);
  if (descriptor < 0) throwFileError("open", unfinished, errno);
  const bool isSynced = fsync(descriptor) == 0;
  const int syncError = errno;
  close(descriptor);
  if (!isSynced) throwFileError("write", unfinished, syncError);
  giveItsName(path);
}

void writeFileAtomically(const std::string& path, const std::string& content) {
  const std::string unfinished = unfinishedName(path);
  unlink(unfinished.c_str());  // a link too
  std::FILE* file = openForWriting(unfinished, false);
  const bool isWritten = std::fwrite(content.data(), 1, content.size(), file) == content.size();
  const int writeError = errno;
  const bool isClosed = std::fclose(file) == 0;
  if (!isWritten || !isClosed) {
    const int error = isWritten ? errno : writeError;
    std::remove(unfinished.c_str());
    throwFileError("write", path, error);
  }
  giveItsName(path);
}

void makeFolderOf(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (folder.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw RunError("cannot create the folder \"" + folder.string() + "\": " + error.message());
}

}  // namespace pd
