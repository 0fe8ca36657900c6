// Voids that files list, one a line or a few lines each.
#ifndef PD_VOID_LISTS_HPP
#define PD_VOID_LISTS_HPP

#include <string>
#include <vector>

#include "discontinuity_reader.hpp"

namespace pd {

/// Lines "x y z radius", m. Throws DeckError with all mistakes as "file:line: message".
std::vector<DiscontinuityForm> readSphereList(const GeometryFile& file);
/// Lines "polygon x y", m: the corners of polygon 1 in turn, those of polygon 2 ... (`pdmesh outline`). Throws as
/// above.
std::vector<DiscontinuityForm> readPolygonList(const GeometryFile& file);

}  // namespace pd

#endif
