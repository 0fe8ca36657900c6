#include "hdf5_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <limits>
#include <system_error>

#include "../model/collective.hpp"
#include "../model/model.hpp"
#include "atomic_file.hpp"
#include "disk_space.hpp"

namespace pd {

namespace {

/// Bytes of a file's and of a table's entries in the tables of contents, more than HDF5 takes.
constexpr std::size_t spaceOfContents = 1 << 14;
/// Of a table with checksums, one a chunk, which HDF5 reads and writes as a whole.
constexpr hsize_t valuesPerChunk = 1 << 17;

hid_t memoryType(double) { return H5T_NATIVE_DOUBLE; }
hid_t memoryType(int) { return H5T_NATIVE_INT; }
hid_t memoryType(long long) { return H5T_NATIVE_LLONG; }
hid_t memoryType(char) { return H5T_NATIVE_CHAR; }
hid_t fileType(double) { return H5T_IEEE_F64LE; }
hid_t fileType(int) { return H5T_STD_I32LE; }
hid_t fileType(long long) { return H5T_STD_I64LE; }
hid_t fileType(char) { return H5T_STD_I8LE; }

/// Why HDF5 failed last. Kept when it happens, since the next call of HDF5 forgets it.
std::string& hdf5Reason() {
  static std::string reason = "no reason given";
  return reason;
}

/// Keeps the innermost entry of the error stack, the reason closest to the system, and the call that failed.
herr_t rememberReason(hid_t stack, void*) {
  hdf5Reason().clear();
  H5Ewalk2(
      stack, H5E_WALK_UPWARD,
      [](unsigned, const H5E_error2_t* error, void*) -> herr_t {
        std::string& reason = hdf5Reason();
        if (reason.empty() && error->desc != nullptr) reason = error->desc;
        return 0;
      },
      nullptr);
  return 0;
}

Hdf5Id withoutTimes(hid_t propertyClass) {
  Hdf5Id properties(H5Pcreate(propertyClass), H5Pclose);
  H5Pset_obj_track_times(properties, false);
  return properties;
}

Hdf5Id openFile(const std::string& path, Hdf5File::Mode mode, const Communicator& comm) {
  // Open MPI looks for the working folder of a relative path itself, and crashes where that was removed.
  std::error_code error;
  const std::string wholePath = std::filesystem::absolute(path, error).string();
  collectively(comm, [&] {
    if (error) throwFileError("open", path, error.value());
    if (!comm.isRoot()) return;
    if (mode == Hdf5File::Mode::Read) {
      // The system's reason, plainer than what MPI makes of it.
      if (access(path.c_str(), R_OK) != 0) throwFileError("open", path, errno);
      if (std::filesystem::is_directory(path, error)) throwFileError("open", path, EISDIR);
      return;
    }
    unlink(path.c_str());  // MPI would write through a link
    setSpaceAside(path, spaceOfContents);
  });
  H5Eset_auto2(H5E_DEFAULT, rememberReason, nullptr);
  Hdf5Id properties(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_mpio(properties, comm.mpi(), MPI_INFO_NULL);
  // The latest form of a file has checksums over its tables of contents.
  if (mode == Hdf5File::Mode::CreateChecked) H5Pset_libver_bounds(properties, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
  const hid_t file = mode == Hdf5File::Mode::Read
                         ? H5Fopen(wholePath.c_str(), H5F_ACC_RDONLY, properties)
                         : H5Fcreate(wholePath.c_str(), H5F_ACC_TRUNC, withoutTimes(H5P_FILE_CREATE), properties);
  return Hdf5Id(file, H5Fclose);
}

Hdf5Id collectiveTransfer() {
  Hdf5Id transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE);
  return transfer;
}

/// Selects this rank's rows in the file, and gives the shape of its memory.
Hdf5Id selectRows(hid_t fileSpace, const RowRange& rows, const std::vector<hsize_t>& extent) {
  std::vector<hsize_t> start(extent.size(), 0), count(extent);
  start[0] = static_cast<hsize_t>(rows.first);
  count[0] = static_cast<hsize_t>(rows.count);
  Hdf5Id memorySpace(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose);
  if (rows.count == 0) {
    H5Sselect_none(fileSpace);
    H5Sselect_none(memorySpace);
  } else {
    H5Sselect_hyperslab(fileSpace, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  }
  return memorySpace;
}

}  // namespace

Hdf5File::Hdf5File(const std::string& path, Mode mode, const Communicator& comm)
    : path_(path), comm_(comm), isChecked_(mode == Mode::CreateChecked), file_(openFile(path, mode, comm)) {
  require(file_.isValid(), mode == Mode::Read ? "open" : "create");
  if (mode == Mode::Read) return;
  makeRoomFor(spaceOfContents);
  require(markHdf5(file_), "write to");
}

void Hdf5File::makeRoomFor(std::size_t bytes) {
  spaceSetAside_ += bytes;
  onRoot(comm_, [&] { setSpaceAside(path_, spaceSetAside_); });
}

void Hdf5File::require(bool isDone, const std::string& what) const {
  collectively(comm_, [&] {
    if (!isDone)
      throw RunError("cannot " + what + " \"" + path_ + "\": " + hdf5Reason() + littleSpaceLeft(path_) +
                     missingFolder(path_));
  });
}

void Hdf5File::close() {
  require(file_.reset(), "write");
  onRoot(comm_, [&] { giveSpaceBack(path_, spaceSetAside_); });
}

void Hdf5File::makeGroup(const std::string& name) {
  makeRoomFor(spaceOfContents);
  const Hdf5Id properties = withoutTimes(H5P_GROUP_CREATE);
  const Hdf5Id group(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose);
  require(group.isValid(), "make group " + name + " in");
}

bool Hdf5File::has(const std::string& path) const {
  const htri_t found = H5Lexists(file_, path.c_str(), H5P_DEFAULT);
  require(found >= 0, "look for " + path + " in");
  return found > 0;
}

bool Hdf5File::hasAttribute(const std::string& object, const std::string& name) const {
  const htri_t found = H5Aexists_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT);
  require(found >= 0, "look for " + name + " in");
  return found > 0;
}

namespace {

bool writeScalar(hid_t file, const std::string& object, const std::string& name, hid_t stored, hid_t given,
                 const void* value) {
  const Hdf5Id space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Id attribute(
      H5Acreate_by_name(file, object.c_str(), name.c_str(), stored, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  return attribute.isValid() && H5Awrite(attribute, given, value) >= 0;
}

bool writeScalarText(hid_t file, const std::string& object, const std::string& name, const std::string& value) {
  const Hdf5Id type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, value.size() + 1);
  return writeScalar(file, object, name, type, type, value.c_str());
}

bool readScalar(hid_t file, const std::string& object, const std::string& name, hid_t type, void* value) {
  const Hdf5Id attribute(H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.isValid() && H5Aread(attribute, type, value) >= 0;
}

}  // namespace

void Hdf5File::writeAttribute(const std::string& object, const std::string& name, double value) {
  require(writeScalar(file_, object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value), "write " + name + " to");
}

void Hdf5File::writeAttribute(const std::string& object, const std::string& name, long long value) {
  require(writeScalar(file_, object, name, H5T_STD_I64LE, H5T_NATIVE_LLONG, &value), "write " + name + " to");
}

void Hdf5File::writeAttribute(const std::string& object, const std::string& name, const std::string& value) {
  require(writeScalarText(file_, object, name, value), "write " + name + " to");
}

namespace {

const char* const markName = "writer";

}  // namespace

bool markHdf5(hid_t file) { return writeScalarText(file, "/", markName, "pdrun"); }

bool isMarkedHdf5(const std::string& path) {
  htri_t isMarked = 0;
  H5E_BEGIN_TRY {
    const Hdf5Id file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (file.isValid()) isMarked = H5Aexists(file, markName);
  }
  H5E_END_TRY
  return isMarked > 0;
}

double Hdf5File::realAttribute(const std::string& object, const std::string& name) const {
  double value = 0.0;
  require(readScalar(file_, object, name, H5T_NATIVE_DOUBLE, &value), "read " + name + " from");
  return value;
}

long long Hdf5File::integerAttribute(const std::string& object, const std::string& name) const {
  long long value = 0;
  require(readScalar(file_, object, name, H5T_NATIVE_LLONG, &value), "read " + name + " from");
  return value;
}

std::string Hdf5File::textAttribute(const std::string& object, const std::string& name) const {
  const Hdf5Id attribute(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(attribute.isValid(), "read " + name + " from");
  const Hdf5Id type(H5Aget_type(attribute), H5Tclose);
  std::string value(H5Tget_size(type), '\0');
  require(H5Aread(attribute, type, value.data()) >= 0, "read " + name + " from");
  return value.c_str();
}

Hdf5Id Hdf5File::tableProperties(const std::vector<hsize_t>& extent) const {
  Hdf5Id properties = withoutTimes(H5P_DATASET_CREATE);
  if (!isChecked_ || extent[0] == 0) return properties;
  std::vector<hsize_t> chunk = extent;
  const hsize_t width = extent.size() > 1 ? extent[1] : 1;
  chunk[0] = std::min(extent[0], std::max<hsize_t>(1, valuesPerChunk / width));
  H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data());
  H5Pset_fletcher32(properties);
  return properties;
}

template <class T>
void Hdf5File::write(const std::string& name, const std::vector<T>& values, const RowRange& rows, int width) {
  std::vector<hsize_t> extent = {static_cast<hsize_t>(rows.total)};
  if (width > 1) extent.push_back(static_cast<hsize_t>(width));
  const std::size_t nValues = static_cast<std::size_t>(rows.total) * static_cast<std::size_t>(width);
  // The last chunk is stored whole; entries of chunks in the tables of contents take less than a thousandth.
  const std::size_t nStored = nValues > valuesPerChunk ? nValues + nValues / 1000 + valuesPerChunk : nValues;
  makeRoomFor(spaceOfContents + nStored * sizeof(T));
  const Hdf5Id fileSpace(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose);
  const Hdf5Id properties = tableProperties(extent);
  const Hdf5Id dataset(H5Dcreate2(file_, name.c_str(), fileType(T()), fileSpace, H5P_DEFAULT, properties, H5P_DEFAULT),
                       H5Dclose);
  require(dataset.isValid(), "make table " + name + " in");
  if (rows.total == 0) return;  // parallel HDF5 refuses to write to a table without rows
  const Hdf5Id memorySpace = selectRows(fileSpace, rows, extent);
  const herr_t status = H5Dwrite(dataset, memoryType(T()), memorySpace, fileSpace, collectiveTransfer(), values.data());
  require(status >= 0, "write table " + name + " to");
}

std::vector<hsize_t> Hdf5File::extent(const std::string& name) const {
  const Hdf5Id dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  require(dataset.isValid(), "open table " + name + " in");
  const Hdf5Id space(H5Dget_space(dataset), H5Sclose);
  const int nDimensions = H5Sget_simple_extent_ndims(space);
  std::vector<hsize_t> result(static_cast<std::size_t>(std::max(1, nDimensions)), 0);
  H5Sget_simple_extent_dims(space, result.data(), nullptr);
  // The best that zlib can do (its FAQ), should somebody have packed the file: a table of fill values needs no room.
  constexpr hsize_t bestPacking = 1032;
  hsize_t size = H5Tget_size(Hdf5Id(H5Dget_type(dataset), H5Tclose));
  for (const hsize_t length : result)
    if (__builtin_mul_overflow(size, length, &size)) size = std::numeric_limits<hsize_t>::max();
  const hsize_t stored = H5Dget_storage_size(dataset);
  collectively(comm_, [&] {
    if (nDimensions < 1 || nDimensions > 2)
      throw RunError("table " + name + " of \"" + path_ + "\" has " + std::to_string(nDimensions) + " dimensions");
    if (size / bestPacking > stored)
      throw RunError("table " + name + " of \"" + path_ + "\" claims " + std::to_string(result[0]) +
                     " rows, which the file does not hold");
  });
  return result;
}

long long Hdf5File::nRows(const std::string& name) const { return static_cast<long long>(extent(name)[0]); }

int Hdf5File::width(const std::string& name) const {
  const std::vector<hsize_t> size = extent(name);
  return size.size() > 1 ? static_cast<int>(size[1]) : 1;
}

template <class T>
std::vector<T> Hdf5File::read(const std::string& name, const RowRange& rows) const {
  const std::vector<hsize_t> size = extent(name);
  collectively(comm_, [&] {
    if (static_cast<long long>(size[0]) != rows.total)
      throw RunError("table " + name + " of \"" + path_ + "\" has " + std::to_string(size[0]) + " rows, not " +
                     std::to_string(rows.total));
  });
  if (rows.total == 0) return {};
  const Hdf5Id dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Id fileSpace(H5Dget_space(dataset), H5Sclose);
  const Hdf5Id memorySpace = selectRows(fileSpace, rows, size);
  std::vector<T> values(static_cast<std::size_t>(rows.count) * (size.size() > 1 ? size[1] : 1));
  const herr_t status = H5Dread(dataset, memoryType(T()), memorySpace, fileSpace, collectiveTransfer(), values.data());
  require(status >= 0, "read table " + name + " of");
  return values;
}

#define PD_INSTANTIATE(T)                                                                         \
  template void Hdf5File::write(const std::string&, const std::vector<T>&, const RowRange&, int); \
  template std::vector<T> Hdf5File::read(const std::string&, const RowRange&) const;
PD_INSTANTIATE(double)
PD_INSTANTIATE(int)
PD_INSTANTIATE(long long)
PD_INSTANTIATE(char)
#undef PD_INSTANTIATE

}  // namespace pd
