#include "step_index.hpp"

#include <hdf5.h>

#include "../model/model.hpp"
#include "atomic_file.hpp"
#include "hdf5_file.hpp"

namespace pd {

struct StepIndex::Implementation {
  std::string path;
  Hdf5Id file;

  void require(bool isDone) const {
    if (!isDone) throw RunError("cannot build the index \"" + path + "\"");
  }
  void link(const std::string& name, const std::string& target) {
    require(H5Lcreate_external(target.c_str(), "/", file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT) >= 0);
  }
};

namespace {

/// A file that lives in memory only.
hid_t createInMemory(const std::string& path) {
  const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  constexpr std::size_t growth = 1 << 16;
  H5Pset_fapl_core(access, growth, false);
  return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
}

}  // namespace

StepIndex::StepIndex(const std::string& path, const std::string& meshFile)
    : implementation_(new Implementation{path, Hdf5Id(createInMemory(path), H5Fclose)}) {
  Implementation& index = *implementation_;
  index.require(index.file.isValid() && markHdf5(index.file));
  index.link("mesh", meshFile);
  const Hdf5Id steps(H5Gcreate2(index.file, "steps", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  index.require(steps.isValid());
}

StepIndex::~StepIndex() = default;

void StepIndex::addStep(const std::string& name, const std::string& stepFile) {
  implementation_->link("steps/" + name, stepFile);
}

void StepIndex::write() {
  const Implementation& index = *implementation_;
  index.require(H5Fflush(index.file, H5F_SCOPE_GLOBAL) >= 0);
  const ssize_t size = H5Fget_file_image(index.file, nullptr, 0);
  index.require(size > 0);
  std::string image(static_cast<std::size_t>(size), '\0');
  index.require(H5Fget_file_image(index.file, image.data(), image.size()) == size);
  writeFileAtomically(index.path, image);
}

FoundStep readStepFile(const std::string& path) {
  const auto require = [&](bool isDone) {
    if (!isDone) throw RunError("cannot read \"" + path + "\" of an earlier run");
  };
  const Hdf5Id file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  require(file.isValid());
  FoundStep found;
  const Hdf5Id time(H5Aopen(file, "time", H5P_DEFAULT), H5Aclose);
  require(time.isValid() && H5Aread(time, H5T_NATIVE_DOUBLE, &found.time) >= 0);
  hsize_t position = 0;
  require(H5Literate(
              file, H5_INDEX_NAME, H5_ITER_INC, &position,
              [](hid_t, const char* name, const H5L_info_t*, void* names) -> herr_t {
                static_cast<std::vector<std::string>*>(names)->push_back(name);
                return 0;
              },
              &found.names) >= 0);
  for (const std::string& name : found.names) {
    const Hdf5Id table(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
    require(table.isValid());
    const Hdf5Id space(H5Dget_space(table), H5Sclose);
    hsize_t extent[2] = {0, 1};
    require(H5Sget_simple_extent_ndims(space) <= 2 && H5Sget_simple_extent_dims(space, extent, nullptr) >= 0);
    found.nPoints = static_cast<long long>(extent[0]);
    found.widths.push_back(static_cast<int>(extent[1]));
  }
  return found;
}

}  // namespace pd
