#include "disk_space.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <system_error>

#include "atomic_file.hpp"

namespace pd {

namespace {

/// Bytes of the file's disk that anybody may have, the greatest number where that cannot be said.
std::uintmax_t freeBytes(const std::string& path) {
  std::error_code error;
  const auto folder = std::filesystem::absolute(path, error).parent_path();
  const std::filesystem::space_info space = std::filesystem::space(folder, error);
  return error ? UINTMAX_MAX : space.available;
}

}  // namespace

void setSpaceAside(const std::string& path, std::size_t bytes) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0) throwFileError("open", path, errno);
  int error = 0;
  do {
    error = fallocate(descriptor, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(bytes)) == 0 ? 0 : errno;
  } while (error == EINTR);
  struct stat file {};
  if (error != 0 && error != ENOSPC && error != EDQUOT && error != EFBIG && fstat(descriptor, &file) == 0)
    error = freeBytes(path) + static_cast<std::uintmax_t>(file.st_size) < bytes ? ENOSPC : 0;
  ::close(descriptor);
  if (error != 0) throwFileError("write", path, error);
}

void giveSpaceBack(const std::string& path, std::size_t bytes) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return;
  struct stat file {};
  if (fstat(descriptor, &file) == 0 && static_cast<std::size_t>(file.st_size) < bytes)
    fallocate(descriptor, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, file.st_size,
              static_cast<off_t>(bytes) - file.st_size);
  ::close(descriptor);
}

std::string littleSpaceLeft(const std::string& path) {
  constexpr std::uintmax_t little = 64 << 20;
  const std::uintmax_t bytes = freeBytes(path);
  return bytes > little ? "" : "; the disk has " + std::to_string(bytes >> 10) + " KiB left";
}

}  // namespace pd
