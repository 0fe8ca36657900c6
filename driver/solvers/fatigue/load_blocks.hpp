// Cycles of load that come in blocks.
#ifndef PD_LOAD_BLOCKS_HPP
#define PD_LOAD_BLOCKS_HPP

#include <Teuchos_ParameterList.hpp>
#include <vector>

#include "../../../materials/registry/parameters.hpp"

namespace pd {

/// Blocks of so many cycles with one peak (in parts of the load of the conditions) and one load ratio each, which are
/// repeated in their order from the cycle 0 of the run on; or one that never ends.
class LoadBlocks {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  /// From a completed list. Throws std::invalid_argument.
  explicit LoadBlocks(const Teuchos::ParameterList& parameters);

  struct Load {
    double peak, ratio;
    double end;  ///< cycle of the run at which the block ends
  };
  /// Of the cycles that follow cycle t of the run.
  Load at(double t) const;
  bool areSeveral() const { return blocks_.size() > 1; }
  /// How many blocks there are from t0 to t1.
  double count(double t0, double t1) const;

 private:
  struct Block {
    double cycles, peak, ratio;
  };
  std::vector<Block> blocks_;
  double period_;
};

}  // namespace pd

#endif
