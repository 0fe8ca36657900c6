// A folder for the files of one test.
#ifndef PD_TEST_FOLDER_HPP
#define PD_TEST_FOLDER_HPP

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace pd::test {

/// Empty at first, removed with its content at the end. The name must differ from those of tests that run at the
/// same time; processes that share the folder must see the same `isOwner` on exactly one of them.
class TestFolder {
 public:
  explicit TestFolder(const std::string& name, bool isOwner = true)
      : path_(std::filesystem::temp_directory_path() / name), isOwner_(isOwner) {
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
