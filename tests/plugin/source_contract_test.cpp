// Plug-ins are sources that a Peridigm tree can take as they are: they include nothing of the driver, and of the
// interface only headers that Peridigm has too.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

const fs::path sourceDir = PD_SOURCE_DIR;

std::vector<fs::path> sourcesIn(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(sourceDir / folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".cpp" || extension == ".hpp" || extension == ".h") files.push_back(entry.path());
  }
  return files;
}

struct Include {
  fs::path file;
  std::string name;
  bool isQuoted;
};

std::vector<Include> includesIn(const std::string& folder) {
  const std::regex pattern(R"re(^\s*#\s*include\s*(["<])([^">]+)[">])re");
  std::vector<Include> includes;
  for (const fs::path& file : sourcesIn(folder)) {
    std::ifstream in(file);
    std::smatch match;
    for (std::string line; std::getline(in, line);)
      if (std::regex_search(line, match, pattern)) includes.push_back({file, match[2], match[1] == "\""});
  }
  return includes;
}

bool isIn(const std::vector<std::string>& folders, const std::string& header) {
  for (const std::string& folder : folders)
    if (fs::exists(sourceDir / folder / header)) return true;
  return false;
}

/// materials/ and all folders in it.
std::vector<std::string> materialFolders() {
  std::vector<std::string> folders{"materials"};
  for (const auto& entry : fs::recursive_directory_iterator(sourceDir / "materials"))
    if (entry.is_directory()) folders.push_back(fs::relative(entry.path(), sourceDir).string());
  return folders;
}

TEST(PluginSources, MaterialsIncludeOnlyTheirOwnHeadersAndTheInterface) {
  const std::vector<std::string> folders = materialFolders();
  const std::vector<Include> includes = includesIn("materials");
  ASSERT_GT(includes.size(), 50u);
  for (const Include& include : includes) {
    if (!include.isQuoted) continue;
    EXPECT_TRUE(isIn(folders, include.name)) << include.file << " includes " << include.name;
    EXPECT_EQ(include.name.find(".."), std::string::npos) << include.file << " includes " << include.name;
  }
}

TEST(PluginSources, ComputesIncludeOnlyTheirOwnHeadersTheInterfaceTheRegistryAndKernels) {
  const std::vector<Include> includes = includesIn("compute");
  ASSERT_GT(includes.size(), 50u);
  for (const Include& include : includes)
    if (include.isQuoted) {
      EXPECT_TRUE(isIn({"compute", "compute/shared", "materials/interface", "materials/kernels", "materials/registry"},
                       include.name))
          << include.file << " includes " << include.name;
      EXPECT_EQ(include.name.find(".."), std::string::npos) << include.file << " includes " << include.name;
    }
}

TEST(PluginSources, UseNoSolverNoFilesAndNoMessagePassing) {
  const std::regex forbidden(
      "^(mpi|Tpetra|Belos|MueLu|Ifpack|Amesos|Zoltan|Kokkos|hdf5|yaml-cpp|fmt|CLI|fstream|driver).*");
  for (const char* folder : {"materials", "compute"})
    for (const Include& include : includesIn(folder))
      EXPECT_FALSE(std::regex_match(include.name, forbidden)) << include.file << " includes " << include.name;
}

// The build looks for headers in all folders, in any order.
TEST(PluginSources, HeadersAreToldApartByTheirNames) {
  std::set<std::string> names;
  for (const char* folder : {"materials", "compute"})
    for (const fs::path& file : sourcesIn(folder)) {
      if (file.extension() == ".cpp") continue;
      EXPECT_TRUE(names.insert(file.filename().string()).second) << file;
    }
}

// Kernels are arithmetic over plain arrays: they know no host at all.
TEST(PluginSources, KernelsIncludeNoInterface) {
  for (const Include& include : includesIn("materials/kernels"))
    if (include.isQuoted) {
      EXPECT_TRUE(isIn({"materials/kernels"}, include.name)) << include.file << " includes " << include.name;
    }
}

TEST(PluginSources, TheInterfaceHasNoHeaderThatPeridigmLacks) {
  const std::set<std::string> ofPeridigm{"Epetra_Comm.h",
                                         "Peridigm_Block.hpp",
                                         "Peridigm_Compute.hpp",
                                         "Peridigm_DamageModel.hpp",
                                         "Peridigm_DataManager.hpp",
                                         "Peridigm_DegreesOfFreedomManager.hpp",
                                         "Peridigm_Discretization.hpp",
                                         "Peridigm_Field.hpp",
                                         "Peridigm_InfluenceFunction.hpp",
                                         "Peridigm_Material.hpp",
                                         "Peridigm_NeighborhoodData.hpp",
                                         "Peridigm_SerialMatrix.hpp"};
  for (const fs::path& file : sourcesIn("materials/interface")) {
    if (file.extension() == ".cpp") continue;
    EXPECT_EQ(ofPeridigm.count(file.filename().string()), 1u) << file;
  }
}

// The one line that makes a plug-in known stands in its own source.
TEST(PluginSources, EverySourceOfAComputeOrModelRegistersAtMostOnePlugin) {
  const std::regex pattern(R"(^PD_REGISTER_(MATERIAL|DAMAGE_MODEL|COMPUTE)\()");
  int nPlugins = 0;
  for (const char* folder : {"materials", "compute"})
    for (const fs::path& file : sourcesIn(folder)) {
      std::ifstream in(file);
      int n = 0;
      for (std::string line; std::getline(in, line);) n += std::regex_search(line, pattern) ? 1 : 0;
      EXPECT_LE(n, 1) << file;
      nPlugins += n;
    }
  EXPECT_GT(nPlugins, 20);
}

}  // namespace
