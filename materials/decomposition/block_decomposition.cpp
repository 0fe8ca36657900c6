#include "block_decomposition.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "parts.hpp"

namespace pd::decomposition {

namespace {

/// Keys of all forms of a kind, none of them required: which of them go together depends on the type.
void declareForms(ParameterDeclarations& declare, const std::map<std::string, FormType>& forms) {
  std::vector<std::string> types;
  for (const auto& [type, form] : forms) types.push_back(type);
  declare.text("Type", "Form of the discontinuity.").oneOf(types).required();
  for (const auto& [type, form] : forms)
    for (Parameter parameter : form.declarations.parameters()) {
      if (declare.find(parameter.name) != nullptr) continue;
      parameter.isRequired = false;
      parameter.defaultValue = std::monostate();
      declare.real(parameter.name, "", "") = parameter;
    }
}

std::string textOf(const double* place) {
  std::ostringstream text;
  text << "(" << place[0] << ", " << place[1] << ", " << place[2] << ") m";
  return text.str();
}

}  // namespace

void BlockDecomposition::declareParameters(ParameterDeclarations& declare) {
  declare.real("Horizon", "m", "Radius of the neighbourhood; given by the block.").positive();
  declareForms(
      declare.sublist("Cracks", "Cracks that take a part of the bonds that meet them, by names of your choice.")
          .sublist("*", "A crack."),
      crackForms());
  declareForms(declare.sublist("Voids", "Holes and pores that take a part of cells and bonds, by names of your choice.")
                   .sublist("*", "A void."),
               voidForms());
  declare.atLeastOneOf({"Cracks", "Voids"});
  declareRule(declare);
  declare.real("Thickness", "m", "Thickness of a plane problem (volumes of the mesh are area x thickness).")
      .positive()
      .defaultTo(1.0);
  declare
      .real("Cell Volume", "m3",
            "Volume of every point's cell, where the mesh has that of the material in it, as Volume in results of "
            "pdrun is; by default the mesh has the cell's.")
      .positive();
}

BlockDecomposition::BlockDecomposition(const Teuchos::ParameterList& params, const std::string& owner)
    : owner_(owner),
      rule_(ruleFrom(params)),
      countsCracks_(params.get<bool>("Cracks Count In Damage")),
      cellVolume_(params.isParameter("Cell Volume") ? params.get<double>("Cell Volume") : 0.0),
      thickness_(params.get<double>("Thickness")) {
  std::vector<std::string> messages;
  read(params, "Cracks", messages);
  read(params, "Voids", messages);
  if (messages.empty() && entries_.empty()) messages.emplace_back("neither \"Cracks\" nor \"Voids\" has an entry");
  throwAll(owner_, messages);
  for (const Entry& entry : entries_) {
    for (const auto& screen : entry.form.screens) {
      all_.screens.push_back(screen.get());
      if (!entry.isCrack) withoutCracks_.screens.push_back(screen.get());
    }
    for (const auto& v : entry.form.voids) all_.voids.push_back(v.get());
  }
  withoutCracks_.voids = all_.voids;
}

void BlockDecomposition::read(const Teuchos::ParameterList& params, const std::string& list,
                              std::vector<std::string>& messages) {
  if (!params.isSublist(list)) return;
  const bool areCracks = list == "Cracks";
  const Teuchos::ParameterList& entries = params.sublist(list);
  for (auto it = entries.begin(); it != entries.end(); ++it) {
    const std::string &name = entries.name(it), path = list + "/" + name;
    const Teuchos::ParameterList& entry = entries.sublist(name);
    const FormType& type = (areCracks ? crackForms() : voidForms()).at(entry.get<std::string>("Type"));
    if (dimension_ == 0) dimension_ = type.dimension;
    if (dimension_ != type.dimension)
      messages.push_back(path + " is a form in " + (type.dimension == 2 ? "the plane" : "space") +
                         ", but others are not; a body has one dimension");
    try {
      const Teuchos::ParameterList whole = type.declarations.complete(entry, path);
      entries_.push_back({path, areCracks, areCracks ? crackFrom(whole) : voidFrom(whole)});
    } catch (const FormError& error) {
      messages.push_back(path + (error.key.empty() ? "" : "/" + error.key) + " " + error.what());
    } catch (const std::invalid_argument& error) {
      messages.emplace_back(error.what());
    }
  }
}

double BlockDecomposition::edgeOf(double volume) const {
  const double whole = cellVolume(volume);
  return dimension_ == 2 ? std::sqrt(whole / thickness_) : std::cbrt(whole);
}

Cell BlockDecomposition::cellOf(const double* place, double volume) const {
  const double edge = edgeOf(volume);
  Cell cell{{place[0], place[1], dimension_ == 2 ? 0.0 : place[2]}, {}, dimension_};
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimension_); ++d) cell.edges[d][d] = edge;
  return cell;
}

void BlockDecomposition::requireMeshOfThePlane(const double* x, int nPoints) const {
  if (dimension_ != 2) return;
  for (int i = 1; i < nPoints; ++i)
    if (x[3 * i + 2] != x[2])
      throw std::invalid_argument(owner_ +
                                  ": its forms are forms in the plane, but points of the mesh differ in z, as " +
                                  textOf(x) + " and " + textOf(x + 3 * i) + " do");
}

/// Beside the smallest cell.
void BlockDecomposition::requireSizes(const double* volume, int nPoints) const {
  if (nPoints == 0) return;
  const double spacing = edgeOf(*std::min_element(volume, volume + nPoints));
  std::vector<std::string> messages;
  const auto look = [&](const Entry& entry, const std::string& complaint) {
    if (!complaint.empty()) messages.push_back(entry.path + " " + complaint);
  };
  for (const Entry& entry : entries_) {
    if (entry.isCrack)
      for (const auto& screen : entry.form.screens) look(entry, complaintOfCrack(screen->box(), dimension_, spacing));
    for (const auto& v : entry.form.voids) look(entry, complaintOfVoid(*v, spacing));
  }
  throwAll(owner_, messages);
}

std::vector<double> BlockDecomposition::solidVolumes(const double* x, const double* volume, int nPoints) const {
  std::vector<double> solid(static_cast<std::size_t>(nPoints));
  constexpr double nearlySame = 1e-2;
  for (int i = 0; i < nPoints; ++i) {
    const double* place = x + 3 * i;
    const Cell cell = cellOf(place, volume[i]);
    const double share = solidShare(cell, nearBox(all_, boxAround(cell, cell)).voids, rule_);
    if (share <= leastSolid)
      throw std::invalid_argument(owner_ + ": the cell of the point at " + textOf(place) +
                                  " has next to no material beside the voids; take such points out of the mesh, as "
                                  "pdrun does: its results have the others, with their Volume");
    const double ofMaterial = share * cellVolume(volume[i]), ratio = ofMaterial / volume[i];
    if (cellVolume_ > 0.0 && std::abs(ratio - 1.0) > nearlySame && std::abs(ratio - share) > nearlySame)
      throw std::invalid_argument(owner_ + ": the point at " + textOf(place) + " has the volume " +
                                  std::to_string(volume[i] / cellVolume_) + " times the \"Cell Volume\", but " +
                                  std::to_string(share) + " of its cell is material; see the unit");
    solid[static_cast<std::size_t>(i)] = ratio;
  }
  return solid;
}

BlockDecomposition::Shares BlockDecomposition::of(const Call& call, const double* x, const double* volume,
                                                  PeridigmNS::DataManager& data) const {
  const auto points = data.getOverlapScalarPointMap();
  const int nPoints = points->NumMyElements();
  requireMeshOfThePlane(x, nPoints);
  requireSizes(volume, nPoints);
  const std::vector<double> solid = solidVolumes(x, volume, nPoints);
  const auto cellAt = [&](int i) { return cellOf(x + 3 * i, volume[i]); };
  InteractionShares shares(rule_), sharesWithoutCracks(rule_);
  Shares found;
  const int* entry = call.neighborhoodList;
  for (int p = 0; p < call.nOwned; ++p, entry += *entry + 1) {
    const int i = call.ownedIds[p];
    Box reach = boxAround(cellAt(i), cellAt(i));
    for (int k = 1; k <= *entry; ++k) {
      const Box other = boxAround(cellAt(entry[k]), cellAt(entry[k]));
      for (std::size_t d = 0; d < 3; ++d) {
        reach.low[d] = std::min(reach.low[d], other.low[d]);
        reach.high[d] = std::max(reach.high[d], other.high[d]);
      }
    }
    const NearDiscontinuities near = nearBox(all_, reach), rest = nearBox(withoutCracks_, reach);
    double counted = 0.0;
    for (int k = 1; k <= *entry; ++k) {
      const bool isTurned = points->GID(entry[k]) < points->GID(i);  // the same from both ends
      const int first = isTurned ? entry[k] : i, second = isTurned ? i : entry[k];
      const Cell a = cellAt(first), b = cellAt(second);
      const double weight = solid[static_cast<std::size_t>(i)] * solid[static_cast<std::size_t>(entry[k])];
      const double left = near.empty() ? 1.0 : shares.of({first, a}, {second, b}, near);
      const bool asWithoutCracks = countsCracks_ && rest.screens.size() < near.screens.size() && left < 1.0;
      const double whole = asWithoutCracks ? sharesWithoutCracks.of({first, a}, {second, b}, rest) : left;
      found.left.push_back(weight * left);
      counted += weight * whole;
    }
    found.counted.push_back(counted);
  }
  return found;
}

}  // namespace pd::decomposition
