#include "load_blocks.hpp"

#include <Teuchos_Array.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pd {

void LoadBlocks::declareParameters(ParameterDeclarations& declare) {
  declare
      .real("Load Ratio", "1",
            "R: smallest over largest load of a cycle; conditions give the largest. Where R is not 0, a linear body is "
            "assumed: strains go as loads. 0 where nothing is given.")
      .atLeast(-1.0)
      .atMost(0.99);
  ParameterDeclarations& blocks = declare.sublist(
      "Load Blocks", "In place of Load Ratio: blocks of cycles, repeated from the cycle 0 of the run on.");
  blocks.reals("Cycles", "1", "Of each block.").required();
  blocks.reals("Peaks", "1", "Largest load of each block, in parts of the load of the conditions.").required();
  blocks.reals("Load Ratios", "1", "R of each block; 0 where the list is not given.");
  declare.atMostOneOf({"Load Ratio", "Load Blocks"});
}

LoadBlocks::LoadBlocks(const Teuchos::ParameterList& parameters) {
  if (!parameters.isSublist("Load Blocks")) {
    period_ = std::numeric_limits<double>::infinity();
    blocks_.push_back(
        {period_, 1.0, parameters.isParameter("Load Ratio") ? parameters.get<double>("Load Ratio") : 0.0});
    return;
  }
  const Teuchos::ParameterList& list = parameters.sublist("Load Blocks");
  const auto cycles = list.get<Teuchos::Array<double>>("Cycles"), peaks = list.get<Teuchos::Array<double>>("Peaks");
  auto ratios = Teuchos::Array<double>(cycles.size(), 0.0);
  if (list.isParameter("Load Ratios")) ratios = list.get<Teuchos::Array<double>>("Load Ratios");
  if (cycles.size() < 1 || peaks.size() != cycles.size() || ratios.size() != cycles.size())
    throw std::invalid_argument(
        "Load Blocks: \"Cycles\", \"Peaks\" and \"Load Ratios\" must have one number a block each");
  period_ = 0.0;
  for (Teuchos::Array<double>::size_type k = 0; k < cycles.size(); ++k) {
    if (!(cycles[k] > 0.0) || !(peaks[k] > 0.0) || !(ratios[k] >= -1.0) || !(ratios[k] <= 0.99))
      throw std::invalid_argument(
          "Load Blocks: cycles and peaks must be above 0, and load ratios in [-1, 0.99]; leave unloaded blocks out");
    blocks_.push_back({cycles[k], peaks[k], ratios[k]});
    period_ += cycles[k];
  }
}

LoadBlocks::Load LoadBlocks::at(double t) const {
  if (!std::isfinite(period_)) return {blocks_.front().peak, blocks_.front().ratio, period_};
  // A step that was to end a block has ended it, whatever rounding has left.
  const double margin = 1e-9 * period_;
  const double start = period_ * std::floor((t + margin) / period_);
  double end = start;
  for (const Block& block : blocks_) {
    end += block.cycles;
    if (t + margin < end) return {block.peak, block.ratio, end};
  }
  return {blocks_.front().peak, blocks_.front().ratio, end + blocks_.front().cycles};
}

double LoadBlocks::count(double t0, double t1) const {
  return std::isfinite(period_) ? (t1 - t0) / period_ * static_cast<double>(blocks_.size()) : 1.0;
}

}  // namespace pd
