// Voids that files list, one a line or a few lines each.
#ifndef PD_VOID_LISTS_HPP
#define PD_VOID_LISTS_HPP

#include <string>
#include <vector>

#include "discontinuity_reader.hpp"

namespace pd {

DiscontinuityForm ellipsoidForm(const decomposition::Ellipsoid& shape);
/// A sphere, or a circle in a plane.
DiscontinuityForm ballForm(const decomposition::Place& center, double radius, int dimension);
/// A hole with these corners, which complaintOfOutline() has nothing against.
DiscontinuityForm polygonForm(const std::vector<decomposition::Place>& corners);

/// Why these corners, in turn, are not the outline of a hole; empty where they are: it has an inside, and its sides
/// meet at the corners between them alone.
std::string complaintOfOutline(const std::vector<decomposition::Place>& corners);

/// Lines "x y z radius", m. Throws DeckError with all mistakes as "file:line: message".
std::vector<DiscontinuityForm> readSphereList(const GeometryFile& file);
/// Lines "polygon x y", m: the corners of polygon 1 in turn, those of polygon 2 ... (`pdmesh outline`). Throws as
/// above.
std::vector<DiscontinuityForm> readPolygonList(const GeometryFile& file);

}  // namespace pd

#endif
