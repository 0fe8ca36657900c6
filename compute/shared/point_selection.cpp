#include "point_selection.hpp"

#include <Teuchos_Array.hpp>
#include <map>
#include <stdexcept>
#include <unordered_set>

namespace pd {

namespace {

std::string unknownName(const std::string& kind, const std::string& name, const std::vector<std::string>& known) {
  std::string message = "no " + kind + " \"" + name + "\" (there are: ";
  for (std::size_t i = 0; i < known.size(); ++i) message += (i == 0 ? "" : ", ") + known[i];
  const std::string nearest = nearestWord(name, known);
  return message + ")" + (nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?");
}

std::unordered_set<int> membersOf(const std::vector<std::string>& names,
                                  const std::map<std::string, std::vector<int>>& nodeSets) {
  std::unordered_set<int> members;
  for (const std::string& name : names) {
    const auto it = nodeSets.find(name);
    if (it == nodeSets.end()) {
      std::vector<std::string> known;
      for (const auto& entry : nodeSets) known.push_back(entry.first);
      throw std::invalid_argument(unknownName("node set", name, known));
    }
    members.insert(it->second.begin(), it->second.end());
  }
  return members;
}

}  // namespace

void PointSelection::declareParameters(ParameterDeclarations& declarations) {
  declarations.text("Block", "Run over the points of this block alone (default: all points).");
  declarations.text("Node Set", "Run over the points of this node set alone (default: all points).");
  declarations.atMostOneOf({"Block", "Node Set"});
}

PointSelection::PointSelection(const Teuchos::ParameterList& parameters, const ComputeParameters& globalData) {
  if (parameters.isParameter("Block")) blockName_ = parameters.get<std::string>("Block");
  if (parameters.isParameter("Node Set")) nodeSetNames_.push_back(parameters.get<std::string>("Node Set"));
  if (parameters.isParameter("Node Sets"))
    for (const std::string& name : parameters.get<Teuchos::Array<std::string>>("Node Sets"))
      nodeSetNames_.push_back(name);
  if (globalData.is_null() || !globalData->isParameter("discretization")) return;
  discretization_ = *globalData->get<Teuchos::RCP<PeridigmNS::Discretization>*>("discretization");
}

std::string PointSelection::name() const {
  if (!blockName_.empty()) return "block \"" + blockName_ + "\"";
  return nodeSetNames_.empty() ? "the body" : "node set " + quotedList(nodeSetNames_);
}

void PointSelection::initialize(const Blocks& blocks) {
  if (isAll()) return;
  std::unordered_set<int> members;
  if (!nodeSetNames_.empty() && discretization_.is_null())
    throw std::invalid_argument("this host hands no node sets to computes");
  if (!nodeSetNames_.empty()) members = membersOf(nodeSetNames_, *discretization_->getNodeSets());

  isSelected_.assign(blocks->size(), {});
  std::vector<std::string> blockNames;
  bool isFound = blockName_.empty();
  for (std::size_t b = 0; b < blocks->size(); ++b) {
    PeridigmNS::Block& block = (*blocks)[b];
    const auto neighborhood = block.getNeighborhoodData();
    const auto map = block.getOverlapScalarPointMap();
    const bool isTheBlock = block.getName() == blockName_;
    isFound = isFound || isTheBlock;
    blockNames.push_back(block.getName());
    isSelected_[b].resize(static_cast<std::size_t>(neighborhood->NumOwnedPoints()));
    for (std::size_t i = 0; i < isSelected_[b].size(); ++i)
      isSelected_[b][i] = isTheBlock || members.count(map->GID(neighborhood->OwnedIDs()[i])) != 0 ? 1 : 0;
  }
  if (!isFound) throw std::invalid_argument(unknownName("block", blockName_, blockNames));
}

}  // namespace pd
