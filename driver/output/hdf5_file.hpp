// HDF5 files of tables that all ranks write and read together.
#ifndef PD_HDF5_FILE_HPP
#define PD_HDF5_FILE_HPP

#include <hdf5.h>

#include <string>
#include <vector>

#include "../parallel/communicator.hpp"
#include "global_order.hpp"

namespace pd {

/// An HDF5 identifier that closes itself.
class Hdf5Id {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Id(hid_t id, Close close) : id_(id), close_(close) {}
  ~Hdf5Id() { reset(); }
  Hdf5Id(Hdf5Id&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = H5I_INVALID_HID; }
  Hdf5Id(const Hdf5Id&) = delete;
  Hdf5Id& operator=(const Hdf5Id&) = delete;
  operator hid_t() const { return id_; }
  bool isValid() const { return id_ >= 0; }
  /// Whether closing succeeded.
  bool reset() {
    const bool isClosed = id_ < 0 || close_(id_) >= 0;
    id_ = H5I_INVALID_HID;
    return isClosed;
  }

 private:
  hid_t id_;
  Close close_;
};

/// Marks an open file as written by pdrun (attribute `writer` of its root group). False where that fails.
bool markHdf5(hid_t file);
/// Whether the file is one of HDF5 that has this mark. Of one process.
bool isMarkedHdf5(const std::string& path);

/// An open file. Every call is collective and throws RunError, naming the path and HDF5's reason, on all ranks where
/// it fails on one. What is created carries the mark. Time stamps are left out, so that equal content gives equal
/// files.
class Hdf5File {
 public:
  /// CreateChecked: all that is written has checksums, which reading verifies.
  enum class Mode { Create, CreateChecked, Read };
  Hdf5File(const std::string& path, Mode mode, const Communicator& comm);

  /// Writes what HDF5 still holds back and closes the file. The destructor only closes.
  void close();

  void makeGroup(const std::string& name);
  /// Whether the object is there; its group must be.
  bool has(const std::string& path) const;
  bool hasAttribute(const std::string& object, const std::string& name) const;

  // Attributes of a group or dataset ("/" for the file itself). Every rank gives the same value.
  void writeAttribute(const std::string& object, const std::string& name, double value);
  void writeAttribute(const std::string& object, const std::string& name, long long value);
  void writeAttribute(const std::string& object, const std::string& name, const std::string& value);
  double realAttribute(const std::string& object, const std::string& name) const;
  long long integerAttribute(const std::string& object, const std::string& name) const;
  std::string textAttribute(const std::string& object, const std::string& name) const;

  /// A table [rows.total x width] (one-dimensional where the width is 1) of which this rank gives the rows of `rows`.
  /// T is double, int, long long or char (a byte).
  template <class T>
  void write(const std::string& name, const std::vector<T>& values, const RowRange& rows, int width);
  template <class T>
  std::vector<T> read(const std::string& name, const RowRange& rows) const;

  long long nRows(const std::string& name) const;
  int width(const std::string& name) const;

 private:
  /// Sets room on the disk aside, since HDF5 leaves other ranks waiting for one that met the end of the disk.
  void makeRoomFor(std::size_t bytes);
  void require(bool isDone, const std::string& what) const;
  Hdf5Id tableProperties(const std::vector<hsize_t>& extent) const;
  std::vector<hsize_t> extent(const std::string& name) const;

  std::string path_;
  const Communicator& comm_;
  bool isChecked_;
  Hdf5Id file_;
  std::size_t spaceSetAside_ = 0;  ///< bytes
};

}  // namespace pd

#endif
