// NetCDF files, read by one process.
#ifndef PD_NETCDF_FILE_HPP
#define PD_NETCDF_FILE_HPP

#include <string>
#include <vector>

namespace pd {

/// An open file. Everything throws std::runtime_error, with the library's own words, where it cannot be read.
class NetcdfFile {
 public:
  explicit NetcdfFile(const std::string& fileName);
  ~NetcdfFile();
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;

  /// Length of a dimension; 0 where there is none of this name.
  std::size_t dimension(const std::string& name) const;
  /// The same of one that counts parts with entries of their own ("num_el_blk"); throws where the file is too small.
  std::size_t numberOf(const std::string& dimension) const;
  bool hasVariable(const std::string& name) const;
  /// Throws where the file is too small to hold so many numbers, however well they are packed: a damaged heading may
  /// claim more than there is memory for. `what` they are: "nodes".
  void requireRoomFor(std::size_t count, const std::string& what) const;
  /// A whole variable, the last dimension fastest. Throws where it holds something else than numbers.
  std::vector<double> reals(const std::string& variable) const;
  std::vector<long long> integers(const std::string& variable) const;
  /// The same; throws where it has not `count` numbers.
  std::vector<double> reals(const std::string& variable, std::size_t count) const;
  std::vector<long long> integers(const std::string& variable, std::size_t count) const;
  /// A variable of characters, [n][length]: without blanks and zeros at the ends.
  std::vector<std::string> texts(const std::string& variable) const;
  /// Empty where there is no such attribute, or one of another type.
  std::string textAttribute(const std::string& variable, const std::string& attribute) const;

 private:
  int idOf(const std::string& variable) const;
  std::vector<std::size_t> shapeOf(int variable) const;
  std::size_t sizeOf(int variable, const std::string& name) const;
  template <class Value, class Read>
  std::vector<Value> numbers(const std::string& variable, const Read& read) const;

  int file_ = -1;
  std::size_t size_ = 0;  ///< bytes
};

}  // namespace pd

#endif
