// Parts of a flow that nothing connects, by whatever passes between points; of bodies, by unbroken bonds, see
// connected_parts.hpp.
#ifndef PD_FLOW_PARTS_HPP
#define PD_FLOW_PARTS_HPP

#include <algorithm>
#include <vector>

#include "../../model/model.hpp"

namespace pd {

struct FlowParts {
  std::size_t nParts = 0;           ///< of all ranks
  std::vector<std::size_t> partOf;  ///< [points] in the order of their smallest global ids
  std::vector<char> isFirst;        ///< [points] 1 where no point of the part has a smaller global id
};

/// `names` [nPoints of the mesh]: the smallest global id of the part of each of the owned `points`, which is its own
/// where isFirst. Collective.
FlowParts numberFlowParts(const Model& model, const std::vector<int>& points, const std::vector<double>& names);

/// Parts of owned `points`. `forEachConnection(k, connect)` calls connect(other) for the local ids, owned, ghosts or
/// images, that points[k] is connected with; both ends tell of a connection. Collective.
template <class ForEachConnection>
FlowParts findFlowParts(const Model& model, const std::vector<int>& points,
                        const ForEachConnection& forEachConnection) {
  const Discretization& mesh = model.discretization();
  std::vector<double> names(mesh.globalIds.begin(), mesh.globalIds.end());
  names.resize(static_cast<std::size_t>(mesh.nPoints));
  for (bool hasChanged = true; hasChanged;) {
    hasChanged = false;
    for (bool isMoving = true; isMoving;) {
      isMoving = false;
      for (std::size_t k = 0; k < points.size(); ++k)
        forEachConnection(k, [&](int connected) {
          const int source = mesh.sourceOf(connected);
          double &own = names[static_cast<std::size_t>(points[k])], &other = names[static_cast<std::size_t>(source)];
          isMoving = isMoving || other < own || (source < mesh.nOwned && own < other);
          own = std::min(own, other);
          if (source < mesh.nOwned) other = own;  // ghosts hear of it from their owners
        });
      hasChanged = hasChanged || isMoving;
    }
    model.exchange().import(names.data(), 1, std::nullopt);
    hasChanged = model.comm().any(hasChanged);
  }
  return numberFlowParts(model, points, names);
}

}  // namespace pd

#endif
