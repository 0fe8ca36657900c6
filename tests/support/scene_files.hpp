// Small meshes and decks written to a folder of their own for a test.
#ifndef PD_TESTS_SCENE_FILES_HPP
#define PD_TESTS_SCENE_FILES_HPP

#include <fmt/format.h>
#include <mpi.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace pd_test {

/// A folder below the working directory, emptied at the start. In a parallel test the root rank writes.
class SceneFiles {
 public:
  explicit SceneFiles(const std::string& name, MPI_Comm comm = MPI_COMM_SELF) : folder_("scene_" + name), comm_(comm) {
    int rank = 0;
    MPI_Comm_rank(comm_, &rank);
    isWriter_ = rank == 0;
    if (isWriter_) {
      std::filesystem::remove_all(folder_);
      std::filesystem::create_directories(folder_);
    }
    MPI_Barrier(comm_);
  }
  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& text) const {
    if (isWriter_) std::ofstream(path(name)) << text;
    MPI_Barrier(comm_);
    return path(name);
  }
  std::string path(const std::string& name) const { return folder_ + "/" + name; }

 private:
  std::string folder_;
  MPI_Comm comm_;
  bool isWriter_ = false;
};

/// A text mesh of nx x ny x nz points with unit spacing and volume, from the origin, x fastest. `jitter`: each
/// coordinate of an axis with more than one point is moved by up to this much, the same way in every call.
inline std::string latticeMesh(int nx, int ny, int nz, double jitter = 0.0) {
  std::uint64_t state = 1;
  const auto noise = [&] {  // linear congruential generator with Knuth's MMIX constants
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return jitter * (2.0 * static_cast<double>(state >> 11) / 9007199254740992.0 - 1.0);
  };
  std::string text = "# x y z block_id volume\n";
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        text += fmt::format("{:.17g} {:.17g} {:.17g} 1 1.0\n", i + (nx > 1 ? noise() : 0.0),
                            j + (ny > 1 ? noise() : 0.0), k + (nz > 1 ? noise() : 0.0));
  return text;
}

/// A deck of one block with this horizon; `discretization` and `conditions` are YAML of two and four blanks' indent.
inline std::string deckText(const std::string& horizon, const std::string& discretization = "",
                            const std::string& conditions = "") {
  return "Discretization:\n  Type: Text File\n  Input Mesh File: mesh.txt\n" + discretization +
         "Blocks:\n  Body:\n    Block Names: block_1\n    Material: None\n    Horizon: " + horizon + "\n" +
         (conditions.empty() ? "" : "Boundary Conditions:\n" + conditions);
}

}  // namespace pd_test

#endif
