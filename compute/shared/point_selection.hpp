// Which of a rank's points a compute runs over: a block, node sets, or all.
#ifndef PD_POINT_SELECTION_HPP
#define PD_POINT_SELECTION_HPP

#include <string>
#include <vector>

#include "Peridigm_Discretization.hpp"
#include "compute_support.hpp"

namespace pd {

class PointSelection {
 public:
  /// All points.
  PointSelection() = default;
  /// Reads "Block", "Node Set" or "Node Sets" from a compute's parameters; takes the discretization from the host's
  /// global data. Call it in the compute's constructor: what Peridigm's global data points to is gone later.
  PointSelection(const Teuchos::ParameterList& parameters, const ComputeParameters& globalData);

  /// Declares "Block" and "Node Set", of which one may be given.
  static void declareParameters(ParameterDeclarations& declarations);

  /// `block "A"`, `node set "B"`, `the body`.
  std::string name() const;
  bool isAll() const { return blockName_.empty() && nodeSetNames_.empty(); }

  /// Throws std::invalid_argument, with the known names, where the block or a node set does not exist.
  void initialize(const Blocks& blocks);

  /// Is the owned point number `ownedIndex` (its place in OwnedIDs) of this block selected?
  bool includes(std::size_t block, int ownedIndex) const {
    return isAll() || isSelected_[block][static_cast<std::size_t>(ownedIndex)] != 0;
  }

  /// Calls visit(block number, local id) for every selected point.
  template <class Visit>
  void forEach(const Blocks& blocks, Visit&& visit) const {
    for (std::size_t b = 0; b < blocks->size(); ++b) {
      const auto neighborhood = (*blocks)[b].getNeighborhoodData();
      const int* ownedIDs = neighborhood->OwnedIDs();
      for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i)
        if (includes(b, i)) visit(b, ownedIDs[i]);
    }
  }

 private:
  std::string blockName_;
  std::vector<std::string> nodeSetNames_;
  Teuchos::RCP<PeridigmNS::Discretization> discretization_;
  std::vector<std::vector<char>> isSelected_;
};

}  // namespace pd

#endif
