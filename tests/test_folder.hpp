// A folder for the files of one test.
#ifndef PD_TEST_FOLDER_HPP
#define PD_TEST_FOLDER_HPP

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace pd::test {

/// What the processes of one run under mpirun have in common, and no other run.
inline std::string nameOfRun() {
  const char* const job = std::getenv("PMIX_NAMESPACE");
  return job != nullptr ? job : std::to_string(getpid());
}

/// Empty at first, removed with its content at the end. The name must differ from those of tests that this run has at
/// the same time; of processes that share the folder, `isOwner` must be true on exactly one.
class TestFolder {
 public:
  explicit TestFolder(const std::string& name, bool isOwner = true)
      : path_(std::filesystem::temp_directory_path() / (name + "_" + nameOfRun())), isOwner_(isOwner) {
    if (!isOwner_) return;
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TestFolder() {
    std::error_code ignored;
    if (isOwner_) std::filesystem::remove_all(path_, ignored);
  }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
  bool isOwner_;
};

inline std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

}  // namespace pd::test

#endif
