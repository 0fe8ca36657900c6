// The computes of a run: created from the deck, evaluated when something is written.
#ifndef PD_COMPUTE_SET_HPP
#define PD_COMPUTE_SET_HPP

#include <Teuchos_ParameterList.hpp>
#include <set>
#include <string>
#include <vector>

#include "../deck/deck.hpp"
#include "../model/model.hpp"
#include "Peridigm_Compute.hpp"
#include "Peridigm_Discretization.hpp"

namespace pd {

class ComputeSet {
 public:
  /// One compute with default parameters for each of computesWithoutSection(), as Peridigm does, and one for each entry
  /// of `Compute Class Parameters`. Throws DeckError.
  ComputeSet(const Deck& deck, const Communicator& comm);

  std::vector<int> fieldIds() const;
  /// Hands the node sets and the whole body to the computes and initialises them. Throws DeckError. Collective.
  void initialize(Model& model);

  /// Mesh, bonds and displacements stay as they are until the state changes: values for the whole body that follow from
  /// these alone are evaluated once.
  void stateIsSettled();
  void stateHasChanged();
  /// Evaluates all computes, or only those that yield values for the whole body. Collective.
  void evaluate(Model& model, bool onlyGlobal) const;
  /// Evaluates the one that makes this value, and those whose values for the whole body that one reads. Collective.
  void evaluate(Model& model, const std::string& label) const;
  /// Is there one that makes it?
  bool makes(const std::string& label) const { return !makersOf(label).empty(); }
  /// Does one of these keep what an evaluation finds, for the next one?
  bool keepsEvaluations(const std::string& label) const;
  /// What computes have found out (RunNotes) since this was last asked, with the place of each in the deck.
  std::vector<std::string> newNotes();
  /// Fields that must be made of the state before (state_fields.hpp).
  std::set<std::string> fieldsOfState(bool onlyGlobal) const;
  std::set<std::string> fieldsOfState(const std::string& label) const;

  /// Marks the points [nPoints] at whose displacements those that yield values for the whole body look, in this state.
  /// Returns the place in the deck of one that may look at any; empty where there is none.
  std::string markRead(Model& model, std::vector<char>& isRead) const;

  /// Labels of fields for the whole body, in the order of the computes.
  const std::vector<std::string>& globalLabels() const { return globalLabels_; }
  /// Has a compute been made of the class (spaces as underscores, as in Peridigm)?
  bool hasClass(const std::string& name) const;

 private:
  struct Entry {
    std::string className;
    std::string place;  ///< in the deck; empty where the compute is made by default
    Teuchos::RCP<PeridigmNS::Compute> compute;
    bool isGlobal = false;
    bool looksAtDisplacements = false;  ///< or at what follows from them
    std::set<std::string> fieldsOfState;
    std::set<std::string> reads, writes;  ///< values for the whole body
    bool keepsEvaluations = false;        ///< what one finds, for the next
    bool followsFromState = false;        ///< from mesh, bonds and displacements alone, as others that it reads do
    bool isDue(bool onlyGlobal) const { return isGlobal || !onlyGlobal; }
  };
  std::vector<Entry>::const_iterator placeFor(const Entry& entry) const;
  std::vector<const Entry*> makersOf(const std::string& label) const;
  bool followsFromState(const Entry& entry) const;
  void evaluate(Model& model, const Entry& entry) const;
  void add(const std::string& className, const DeckNode& node, const Deck& deck, const Communicator& comm);

  std::vector<Entry> entries_;
  bool isSettled_ = false;
  mutable std::set<const Entry*> isKnown_;  ///< whose values are those of the settled state
  std::set<std::string> notes_;
  std::vector<std::string> globalLabels_;
  class SymmetricBody;
  // Filled as the run starts.
  Teuchos::RCP<PeridigmNS::Discretization::NodeSets> nodeSets_;
  Teuchos::RCP<SymmetricBody> wholeBody_;

  Teuchos::RCP<PeridigmNS::Discretization> discretization_;
  Teuchos::RCP<Teuchos::ParameterList> globalData_;
};

}  // namespace pd

#endif
