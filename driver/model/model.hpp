// The discrete model of this rank: blocks with their plug-ins, fields, and the evaluations that solvers ask for.
#ifndef PD_MODEL_HPP
#define PD_MODEL_HPP

#include <Teuchos_RCP.hpp>
#include <memory>
#include <string>
#include <vector>

#include "../deck/deck.hpp"
#include "../discretization/point_exchange.hpp"
#include "../parallel/communicator.hpp"
#include "Peridigm_Block.hpp"
#include "field_reflections.hpp"
#include "fields.hpp"
#include "step_record.hpp"
#include "timers.hpp"

namespace pd {

/// Point fields are arrays over the overlap (owned points, ghosts, images), shared by all blocks.
class Model {
 public:
  /// Creates the plug-ins that the deck names and allocates the fields that they and `extraFields` ask for, and only
  /// those. Fills Model_Coordinates, Coordinates, Volume, Block_Id, Element_Id (where asked for), Bond_Damage of
  /// cut bonds, and what Cracks and Voids leave of bonds. Collective.
  Model(const Deck& deck, const Communicator& comm, Discretization discretization, const std::vector<int>& extraFields);

  /// Allocates further fields (zero, or filled where the constructor's comment says so). A bond field is given to
  /// every block.
  void allocateFields(const std::vector<int>& fieldIds);

  /// Calls initialize() of all plug-ins, synchronises what they declare, and evaluates damage, forces and flux
  /// divergences once, so that every field that is used at STEP_N exists. Call after initial conditions are set. A
  /// restart overwrites the fields afterwards: plug-ins keep their state in fields alone. Collective.
  void initialize();

  /// What materials have to say about the run (RunNotes), each line once. Call after initialize(). Collective.
  std::vector<std::string> notes() const;

  const Communicator& comm() const { return comm_; }
  const Discretization& discretization() const { return discretization_; }
  Discretization& discretization() { return discretization_; }
  Teuchos::RCP<std::vector<PeridigmNS::Block>> blocks() const { return blocks_; }
  Timers& timers() { return timers_; }
  int nOwned() const { return discretization_.nOwned; }
  int nPoints() const { return discretization_.nPoints; }

  /// Has a plug-in (or the driver) asked for this point field?
  bool hasField(const std::string& label) const;
  /// Overlap array of a point field, at STEP_NP1 (or STEP_NONE for constant fields). Throws std::invalid_argument.
  double* field(const std::string& label);
  /// The same of a field of the caller's table.
  double* field(const FieldHandle& handle) const { return handle.of(*shared_); }
  /// The same at STEP_N.
  double* fieldAtN(const std::string& label);
  int fieldWidth(const std::string& label) const;  ///< values a point
  /// Owners' STEP_NP1 values to ghosts, and from there to images. Collective.
  void importGhosts(const std::string& label);
  /// Images alone, where ghosts are up to date already.
  void fillImages(const std::string& label);
  const PointExchange& exchange() const { return exchange_; }
  /// What planes of symmetry make of a point field; none where there are no planes.
  std::optional<Reflection> reflectionOf(const std::string& label) const;

  bool hasMechanics() const { return hasField("Force_Density"); }
  bool hasDamage() const;

  // Evaluations at STEP_NP1, over all blocks, ghosts exchanged as needed.
  void evaluateDamage(double dt);
  /// Force_Density = sum of the blocks' internal force densities (N/m3), complete at owned points.
  /// Coordinates of ghosts must be up to date (updateCoordinates does it). Calls precompute() first.
  void evaluateForce(double dt);
  /// `fluxField` = flux divergence, complete at owned points. Ghosts of the advanced field must be up to date.
  /// precompute() is called for materials without mechanics alone: it is the (dear) preparation of forces elsewhere.
  /// `isPrepared`: nothing has changed but the advanced field since the last evaluation: precompute() is left out.
  void evaluateFluxDivergence(double dt, const std::string& fluxField, bool isPrepared = false);
  void evaluateStoredEnergy(double dt);
  /// Adds the tangents of all blocks.
  void assembleJacobian(double dt, PeridigmNS::SerialMatrix& matrix);

  /// Copies owned displacements to Coordinates = Model_Coordinates + Displacement, ghosts included.
  void updateCoordinates();

  // Steps. NP1 follows from N, however often something is evaluated; acceptStep() alone makes NP1 to N. A solver
  // accepts each of its steps.
  /// Remembers the state, so that takeBackStep() can bring it back: stepped fields, one-step fields that are state
  /// (FieldDescription::isState), bonds. Without `points`, of all points; else of these owned points and those that
  /// touch() adds before they change.
  void beginStep();
  void beginStep(const std::vector<int>& points);
  void touch(const std::vector<int>& points) { record_.touch(points); }
  /// Everything as at beginStep(), ghosts included. Collective.
  void takeBackStep();
  /// NP1 becomes N; plug-ins that want to know (StepListener) and were called in the step are told. `time`: the end.
  void acceptStep(double time, double dt);
  /// What a host has written into the fields is the state to start from: NP1 becomes N.
  void adoptState();

  /// Sum over owned points of all ranks.
  double dot(const double* a, const double* b, int width) const;

  /// Directed bonds of this rank.
  long long nBonds() const { return discretization_.nBonds(); }
  /// Throws RunError naming field, point, place and step where an owned value is not finite.
  void requireFinite(const std::string& label, int step) const;
  /// Bytes of bond data (lists, fields) on this rank.
  std::size_t bondBytes() const;

 private:
  void createBlocks(const Deck& deck);
  void allocatePluginFields();
  void fillConstantFields();
  void cutBonds(const Deck& deck);
  /// Fields of what Cracks and Voids leave of bonds and cells; refuses materials that do not know them.
  void decomposeBonds(const Deck& deck);
  void shareBondSteps(PeridigmNS::Block& block);
  void restoreHistories();
  std::vector<StepRecord::PointField> recordedFields();
  void prepareImages(const Deck& deck);
  /// `rateField`: the field whose rate alone follows; -1: forces, and all else.
  void callPrecompute(double dt, int rateField);
  void synchronise(const std::vector<int>& fieldIds);
  void sumBlocks(const std::string& label);
  Teuchos::RCP<PeridigmNS::FieldVector> vector(const std::string& label, bool atN) const;

  const Communicator& comm_;
  Discretization discretization_;
  PointExchange exchange_;
  FieldReflections reflections_;
  Teuchos::RCP<PeridigmNS::DataManager> shared_;  ///< the point fields of all blocks
  Teuchos::RCP<std::vector<PeridigmNS::Block>> blocks_;
  StepRecord record_;
  bool hasCalledDamage_ = false, hasCalledMaterials_ = false;  ///< since the last accepted step
  mutable Timers timers_;
};

/// A run that cannot go on (NaN, no convergence, unstable step). pdrun exits with code 3.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace pd

#endif
