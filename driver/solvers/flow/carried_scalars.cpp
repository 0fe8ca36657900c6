#include "carried_scalars.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "../../model/collective.hpp"
#include "../../model/rates.hpp"
#include "asymmetric_rate.hpp"

namespace pd {

namespace {

/// Of one scalar on this rank.
class WayOut {
 public:
  WayOut(Simulation& simulation, const FlowGeometry& geometry, double reach, const std::string& label)
      : geometry_(geometry),
        label_(label),
        reach_(reach * (1.0 + 1e-9)),
        isPrescribed_(simulation.conditions.valueIsPrescribed(label)) {
    for (PeridigmNS::Block& block : *simulation.model.blocks()) {
      nameOf_[block.getID()] = block.getName();
      const auto* rate = dynamic_cast<const AsymmetricRate*>(block.getMaterialModel().get());
      if (rate != nullptr && rate->isAsymmetric(label)) carriers_.insert(block.getID());
    }
  }

  /// The first mistake at each outflow and block is added to `outflows` and `blocks`.
  void check(Mistakes& outflows, std::string& blocks) {
    const Discretization& mesh = geometry_.mesh();
    for (const int point : geometry_.fluid()) {
      if (!carries(point)) continue;
      const std::vector<int> neighbors = geometry_.neighborsOf(point);
      for (const int neighbor : neighbors) {
        const bool isBeyond = geometry_.isBeyondOutflow(neighbor);
        if (!isBeyond && (!geometry_.isFluid(neighbor) || carries(neighbor))) continue;
        if (isPrescribed_[static_cast<std::size_t>(mesh.sourceOf(neighbor))] != 0) continue;
        const FlowGeometry::End end = geometry_.endOf(point, neighbor, neighbors);
        if (end.length > reach_ || (isBeyond ? end.openFraction > 1.0 : end.kind != FlowGeometry::Kind::Fluid))
          continue;
        if (isBeyond)
          addOutflow(neighbor, outflows);
        else
          addBlock(point, neighbor, blocks);
      }
    }
  }

 private:
  int blockOf(int point) const { return geometry_.mesh().blockId[static_cast<std::size_t>(point)]; }
  bool carries(int point) const { return carriers_.count(blockOf(geometry_.mesh().sourceOf(point))) != 0; }

  void addOutflow(int beyond, Mistakes& mistakes) {
    const int boundary = geometry_.boundaryOf(beyond);
    if (!outflows_.insert(boundary).second) return;
    mistakes.add("",
                 fmt::format("{}: the flow carries \"{}\" to points beyond it at which that is not prescribed, where "
                             "it would pile up and come back; add \"Prescribed {}\" at its points beyond the fluid",
                             geometry_.titleOf(boundary), label_, label_));
  }
  void addBlock(int point, int there, std::string& messages) {
    const int from = blockOf(point), to = blockOf(geometry_.mesh().sourceOf(there));
    if (!blocks_.insert({from, to}).second) return;
    messages += fmt::format(
        "{}Steady Flow: the flow goes from block \"{}\" into block \"{}\", whose materials do not "
        "carry \"{}\" along; give it the same Advection Diffusion",
        messages.empty() ? "" : "\n", nameOf_.at(from), nameOf_.at(to), label_);
  }

  const FlowGeometry& geometry_;
  const std::string label_;
  const double reach_;
  const std::vector<char>& isPrescribed_;
  std::map<int, std::string> nameOf_;     ///< of blocks
  std::set<int> carriers_;                ///< blocks whose material carries the scalar
  std::set<int> outflows_;                ///< of which a mistake has been told
  std::set<std::pair<int, int>> blocks_;  ///< the same
};

}  // namespace

void requireWayOut(Simulation& simulation, const FlowGeometry& geometry, double reach) {
  Mistakes outflows;
  std::string blocks;
  for (const std::string& label : fieldsWithRates(*simulation.model.blocks()))
    if (simulation.model.hasField(label)) WayOut(simulation, geometry, reach, label).check(outflows, blocks);
  collectively(simulation.model.comm(), [&] { outflows.report(); });
  collectively(simulation.model.comm(), [&] {
    if (!blocks.empty()) throw RunError(blocks);
  });
}

}  // namespace pd
