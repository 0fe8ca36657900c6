#include "discontinuity_reader.hpp"

#include "../deck/sections.hpp"
#include "stl_file.hpp"
#include "void_lists.hpp"

namespace pd {

namespace {

using decomposition::Place;

/// From the values of the entry, whose mistakes throw with their places.
template <class From>
DiscontinuityForm formOf(const DeckNode& node, const ParameterDeclarations& declarations, From from) {
  try {
    return from(node.parameters(declarations));
  } catch (const decomposition::FormError& error) {
    const DeckNode wrong = error.key.empty() ? node : node[error.key];
    throw DeckError(wrong.place() + ": " + wrong.path() + " " + error.what());
  }
}

Place shiftOf(const DeckNode& entry) {
  Place shift{};
  if (!entry["Shift"]) return shift;
  const auto numbers = entry["Shift"].items();
  if (numbers.size() != shift.size())
    throw DeckError(entry["Shift"].place() + ": " + entry["Shift"].path() + " must be three numbers, [x, y, z]");
  for (std::size_t d = 0; d < shift.size(); ++d) shift[d] = numbers[d].real();
  return shift;
}

std::vector<DiscontinuityForm> fromFile(const DeckNode& entry, const std::string& type,
                                        const ReadGeometryFile& readFile) {
  const GeometryFile file = readFile(required(entry, "File Name"));
  if (type == "Sphere List") return readSphereList(file);
  if (type == "Polygon List") return readPolygonList(file);
  std::vector<DiscontinuityForm> forms;
  for (const decomposition::TriangleSurface& surface :
       readStl(file.text, file.name, entry.real("Scale", 1.0), shiftOf(entry))) {
    forms.emplace_back(decomposition::DiscontinuityForm{decomposition::surfaceScreens(surface), {}});
    forms.back().voids.push_back(decomposition::surfaceVoid(surface));
  }
  return forms;
}

void requireFormOf(const DeckNode& entry, int wanted, int dimension) {
  if (wanted == dimension) return;
  throw DeckError(entry["Type"].place() + ": " + entry["Type"].path() +
                  (wanted == 2 ? " is a form in the plane, but the mesh fills space"
                               : " is a form in space, but the mesh fills a plane"));
}

}  // namespace

DiscontinuityForm readCrack(const DeckNode& node, int dimension) {
  const decomposition::FormType& form = decomposition::crackForms().at(required(node, "Type").text());
  requireFormOf(node, form.dimension, dimension);
  return formOf(node, form.declarations, decomposition::crackFrom);
}

std::vector<DiscontinuityForm> readVoid(const DeckNode& node, int dimension, const ReadGeometryFile& readFile) {
  const std::string type = required(node, "Type").text();
  const auto plain = decomposition::voidForms().find(type);
  if (plain == decomposition::voidForms().end()) {
    requireFormOf(node, type == "Polygon List" ? 2 : 3, dimension);
    return fromFile(node, type, readFile);
  }
  requireFormOf(node, plain->second.dimension, dimension);
  std::vector<DiscontinuityForm> forms;
  forms.push_back(formOf(node, plain->second.declarations, decomposition::voidFrom));
  return forms;
}

}  // namespace pd
