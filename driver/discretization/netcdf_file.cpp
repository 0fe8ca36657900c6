#include "netcdf_file.hpp"

#include <netcdf.h>

#include <functional>
#include <numeric>
#include <stdexcept>

namespace pd {

namespace {

void require(int status, const std::string& what) {
  if (status != NC_NOERR) throw std::runtime_error(what + ": " + nc_strerror(status));
}

/// Up to the first zero, without blanks at the end.
std::string trimmed(const std::string& text) {
  const std::string result = text.substr(0, text.find('\0'));
  const std::size_t last = result.find_last_not_of(' ');
  return last == std::string::npos ? "" : result.substr(0, last + 1);
}

}  // namespace

NetcdfFile::NetcdfFile(const std::string& fileName) {
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

std::size_t NetcdfFile::sizeOf(int variable) const {
  const auto shape = shapeOf(variable);
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

std::vector<double> NetcdfFile::reals(const std::string& variable) const {
  const int id = idOf(variable);
  std::vector<double> values(sizeOf(id));
  if (!values.empty()) require(nc_get_var_double(file_, id, values.data()), variable);
  return values;
}

std::vector<long long> NetcdfFile::integers(const std::string& variable) const {
  const int id = idOf(variable);
  std::vector<long long> values(sizeOf(id));
  if (!values.empty()) require(nc_get_var_longlong(file_, id, values.data()), variable);
  return values;
}

std::vector<std::string> NetcdfFile::texts(const std::string& variable) const {
  const int id = idOf(variable);
  const auto shape = shapeOf(id);
  if (shape.size() != 2) throw std::runtime_error("\"" + variable + "\" is no list of names");
  std::string characters(shape[0] * shape[1], '\0');
  if (!characters.empty()) require(nc_get_var_text(file_, id, characters.data()), variable);
  std::vector<std::string> names;
  for (std::size_t row = 0; row < shape[0]; ++row)
    names.push_back(trimmed(characters.substr(row * shape[1], shape[1])));
  return names;
}

std::string NetcdfFile::textAttribute(const std::string& variable, const std::string& attribute) const {
  const int id = idOf(variable);
  std::size_t length = 0;
  if (nc_inq_attlen(file_, id, attribute.c_str(), &length) != NC_NOERR) return "";
  std::string text(length, '\0');
  require(nc_get_att_text(file_, id, attribute.c_str(), text.data()), attribute);
  return trimmed(text);
}

}  // namespace pd
