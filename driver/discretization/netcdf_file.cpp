#include "netcdf_file.hpp"

#include <netcdf.h>

#include <filesystem>
#include <limits>
#include <stdexcept>
#include <system_error>

#include "classic_header.hpp"
#include "trial_reading.hpp"

namespace pd {

namespace {

void require(int status, const std::string& what) {
  if (status != NC_NOERR) throw std::runtime_error(what + ": " + nc_strerror(status));
}

/// Up to the first zero, without blanks at the end.
std::string textWithin(const std::string& text) {
  const std::string result = text.substr(0, text.find('\0'));
  const std::size_t last = result.find_last_not_of(' ');
  return last == std::string::npos ? "" : result.substr(0, last + 1);
}

template <class Value>
std::vector<Value> ofLength(std::vector<Value> values, std::size_t count, const std::string& variable) {
  if (values.size() == count) return values;
  throw std::runtime_error("\"" + variable + "\" has " + std::to_string(values.size()) + " numbers where " +
                           std::to_string(count) + " are needed");
}

/// Has the library read all that it knows of a file but its values.
void openAll(const std::string& fileName) {
  int file = 0, nVariables = 0;
  if (nc_open(fileName.c_str(), NC_NOWRITE, &file) != NC_NOERR) return;
  nc_inq_nvars(file, &nVariables);
  for (int variable = 0; variable < nVariables; ++variable) {
    char name[NC_MAX_NAME + 1] = {};
    int nDimensions = 0, nAttributes = 0;
    if (nc_inq_var(file, variable, name, nullptr, &nDimensions, nullptr, &nAttributes) != NC_NOERR) continue;
    std::vector<int> dimensions(static_cast<std::size_t>(nDimensions));
    nc_inq_vardimid(file, variable, dimensions.data());
    for (const int dimension : dimensions) nc_inq_dim(file, dimension, name, nullptr);
    for (int attribute = 0; attribute < nAttributes; ++attribute) {
      std::size_t length = 0;
      nc_type type = NC_NAT;
      if (nc_inq_attname(file, variable, attribute, name) != NC_NOERR) continue;
      if (nc_inq_att(file, variable, name, &type, &length) != NC_NOERR || type != NC_CHAR) continue;
      std::string text(length, '\0');
      nc_get_att_text(file, variable, name, text.data());
    }
  }
  nc_close(file);
}

}  // namespace

NetcdfFile::NetcdfFile(const std::string& fileName) {
  std::error_code error;
  size_ = static_cast<std::size_t>(std::filesystem::file_size(fileName, error));
  if (error) throw std::runtime_error("it cannot be read as NetCDF: " + error.message());
  checkClassicHeader(fileName);
  if (const std::string misfortune = misfortuneOf([&] { openAll(fileName); }, size_); !misfortune.empty())
    throw std::runtime_error("it cannot be read as NetCDF: it is damaged, and the library " + misfortune);
  require(nc_open(fileName.c_str(), NC_NOWRITE, &file_), "it cannot be read as NetCDF");
}

NetcdfFile::~NetcdfFile() { nc_close(file_); }

std::size_t NetcdfFile::dimension(const std::string& name) const {
  int id = 0;
  if (nc_inq_dimid(file_, name.c_str(), &id) != NC_NOERR) return 0;
  std::size_t length = 0;
  require(nc_inq_dimlen(file_, id, &length), name);
  return length;
}

std::size_t NetcdfFile::numberOf(const std::string& name) const {
  const std::size_t count = dimension(name);
  if (count > size_)  // each takes some bytes
    throw std::runtime_error("\"" + name + "\" is " + std::to_string(count) + ", in a file of " +
                             std::to_string(size_) + " bytes");
  return count;
}

bool NetcdfFile::hasVariable(const std::string& name) const {
  int id = 0;
  return nc_inq_varid(file_, name.c_str(), &id) == NC_NOERR;
}

int NetcdfFile::idOf(const std::string& variable) const {
  int id = 0;
  require(nc_inq_varid(file_, variable.c_str(), &id), "it has no \"" + variable + "\"");
  return id;
}

std::vector<std::size_t> NetcdfFile::shapeOf(int variable) const {
  int nDimensions = 0;
  require(nc_inq_varndims(file_, variable, &nDimensions), "dimensions");
  std::vector<int> ids(static_cast<std::size_t>(nDimensions));
  require(nc_inq_vardimid(file_, variable, ids.data()), "dimensions");
  std::vector<std::size_t> shape;
  for (const int id : ids) require(nc_inq_dimlen(file_, id, &shape.emplace_back()), "dimensions");
  return shape;
}

void NetcdfFile::requireRoomFor(std::size_t count, const std::string& what) const {
  constexpr std::size_t bestPacking = 1100;  // zlib packs 1032 bytes into one at most (its FAQ)
  if (count / bestPacking > size_)
    throw std::runtime_error("it claims " + std::to_string(count) + " " + what + ", more than a file of " +
                             std::to_string(size_) + " bytes can hold");
}

std::size_t NetcdfFile::sizeOf(int variable, const std::string& name) const {
  std::size_t size = 1;
  for (const std::size_t length : shapeOf(variable))
    if (__builtin_mul_overflow(size, length, &size)) size = std::numeric_limits<std::size_t>::max();
  requireRoomFor(size, "values of \"" + name + "\"");
  return size;
}

template <class Value, class Read>
std::vector<Value> NetcdfFile::numbers(const std::string& variable, const Read& read) const {
  const int id = idOf(variable);
  nc_type type = NC_NAT;
  require(nc_inq_vartype(file_, id, &type), variable);
  if (type == NC_CHAR || type < NC_BYTE || type > NC_UINT64)
    throw std::runtime_error("\"" + variable + "\" holds no numbers");
  std::vector<Value> values(sizeOf(id, variable));
  if (!values.empty()) require(read(file_, id, values.data()), variable);
  return values;
}

std::vector<double> NetcdfFile::reals(const std::string& variable) const {
  return numbers<double>(variable, nc_get_var_double);
}

std::vector<long long> NetcdfFile::integers(const std::string& variable) const {
  return numbers<long long>(variable, nc_get_var_longlong);
}

std::vector<double> NetcdfFile::reals(const std::string& variable, std::size_t count) const {
  return ofLength(reals(variable), count, variable);
}

std::vector<long long> NetcdfFile::integers(const std::string& variable, std::size_t count) const {
  return ofLength(integers(variable), count, variable);
}

std::vector<std::string> NetcdfFile::texts(const std::string& variable) const {
  const int id = idOf(variable);
  const auto shape = shapeOf(id);
  nc_type type = NC_NAT;
  require(nc_inq_vartype(file_, id, &type), variable);
  if (shape.size() != 2 || type != NC_CHAR) throw std::runtime_error("\"" + variable + "\" is no list of names");
  std::string characters(sizeOf(id, variable), '\0');
  if (!characters.empty()) require(nc_get_var_text(file_, id, characters.data()), variable);
  std::vector<std::string> names;
  for (std::size_t row = 0; row < shape[0]; ++row)
    names.push_back(textWithin(characters.substr(row * shape[1], shape[1])));
  return names;
}

std::string NetcdfFile::textAttribute(const std::string& variable, const std::string& attribute) const {
  const int id = idOf(variable);
  std::size_t length = 0;
  nc_type type = NC_NAT;
  if (nc_inq_att(file_, id, attribute.c_str(), &type, &length) != NC_NOERR || type != NC_CHAR) return "";
  std::string text(length, '\0');
  require(nc_get_att_text(file_, id, attribute.c_str(), text.data()), attribute);
  return textWithin(text);
}

}  // namespace pd
