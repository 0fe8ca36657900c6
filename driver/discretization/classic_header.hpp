// The heading of a NetCDF file in one of its classic formats.
#ifndef PD_CLASSIC_HEADER_HPP
#define PD_CLASSIC_HEADER_HPP

#include <string>

namespace pd {

/// Throws std::runtime_error where the heading of a classic file (CDF-1, CDF-2 or CDF-5) counts more dimensions,
/// attributes or variables than the file holds, or says that values of a variable lie beyond its end: nc_open takes
/// memory by these counts before it looks for what they count. Other files are left to the library. The layout is
/// that of "NetCDF Classic Format Specification" in the NetCDF User's Guide.
void checkClassicHeader(const std::string& fileName);

}  // namespace pd

#endif
