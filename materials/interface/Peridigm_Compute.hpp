// The base class of computes (derived quantities), with the names and signatures of Peridigm's.
// Inside a Peridigm tree Peridigm's own header of this name is found instead.
#ifndef PERIDIGM_COMPUTE_HPP
#define PERIDIGM_COMPUTE_HPP

#include <Epetra_Comm.h>

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>
#include <vector>

#include "Peridigm_Block.hpp"

namespace PeridigmNS {

class Compute {
 public:
  /// `params`: the deck's entry. `computeClassGlobalData`: what the host offers to all computes.
  Compute(Teuchos::RCP<const Teuchos::ParameterList>, Teuchos::RCP<const Epetra_Comm> epetraComm_,
          Teuchos::RCP<const Teuchos::ParameterList> computeClassGlobalData_)
      : epetraComm(epetraComm_), computeClassGlobalData(computeClassGlobalData_) {}
  virtual ~Compute() = default;

  virtual std::vector<int> FieldIds() const = 0;
  virtual void initialize(Teuchos::RCP<std::vector<Block>>) {}
  /// Collective over all ranks. Returns 0.
  virtual int compute(Teuchos::RCP<std::vector<Block>> blocks) const = 0;

 protected:
  Teuchos::RCP<const Epetra_Comm> epetraComm;
  Teuchos::RCP<const Teuchos::ParameterList> computeClassGlobalData;
};

}  // namespace PeridigmNS

#endif
