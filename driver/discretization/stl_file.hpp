// Surfaces of triangles in STL files, as programs for drawing and for tomography write them.
#ifndef PD_STL_FILE_HPP
#define PD_STL_FILE_HPP

#include <string>
#include <vector>

#include "triangle_surface.hpp"

namespace pd {

/// An STL file, in text or binary: closed surfaces, each in one part, places times `scale` plus `shift` (m). Directions
/// that the file gives beside its triangles are not looked at. Throws DeckError with all mistakes as "file:line:
/// message", of a binary file "file: triangle 7: message": text that is not of an STL file; triangles without an area;
/// edges that do not belong to two triangles that have them in opposite directions; surfaces turned inside out, or that
/// pass through themselves. Places are one place only where all their digits are the same.
std::vector<decomposition::TriangleSurface> readStl(const std::string& text, const std::string& fileName, double scale,
                                                    const decomposition::Place& shift);

}  // namespace pd

#endif
