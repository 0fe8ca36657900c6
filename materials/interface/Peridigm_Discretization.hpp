// What computes use of Peridigm's Discretization: the node sets.
// Inside a Peridigm tree Peridigm's own header of this name is found instead.
#ifndef PERIDIGM_DISCRETIZATION_HPP
#define PERIDIGM_DISCRETIZATION_HPP

#include <Teuchos_RCP.hpp>
#include <map>
#include <string>
#include <vector>

namespace PeridigmNS {

/// A host hands it to computes as the entry "discretization" of their global data, of type
/// `Teuchos::RCP<PeridigmNS::Discretization>*`.
class Discretization {
 public:
  using NodeSets = std::map<std::string, std::vector<int>>;

  explicit Discretization(Teuchos::RCP<NodeSets> nodeSets_) : nodeSets(nodeSets_) {}
  virtual ~Discretization() = default;

  /// 0-based global ids by name of the node set; at least those that this rank owns.
  virtual Teuchos::RCP<NodeSets> getNodeSets() { return nodeSets; }

 protected:
  Teuchos::RCP<NodeSets> nodeSets;
};

}  // namespace PeridigmNS

#endif
