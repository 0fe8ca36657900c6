#include "atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "../model/model.hpp"

namespace pd {

std::string unfinishedName(const std::string& path) { return path + ".unfinished"; }

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
  std::FILE* file = std::fopen(unfinished.c_str(), "wb");
  if (file == nullptr) throwFileError("create", unfinished, errno);
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
