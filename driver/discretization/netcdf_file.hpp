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
  bool hasVariable(const std::string& name) const;
  /// A whole variable, the last dimension fastest.
  std::vector<double> reals(const std::string& variable) const;
  std::vector<long long> integers(const std::string& variable) const;
  /// A variable of characters, [n][length]: without blanks and zeros at the ends.
  std::vector<std::string> texts(const std::string& variable) const;
  /// Empty where there is no such attribute.
  std::string textAttribute(const std::string& variable, const std::string& attribute) const;

 private:
  int idOf(const std::string& variable) const;
  std::vector<std::size_t> shapeOf(int variable) const;
  std::size_t sizeOf(int variable) const;

  int file_ = -1;
};

}  // namespace pd

#endif
