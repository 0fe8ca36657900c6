// The base class of what a deck has in section Boundary Conditions: initial and boundary conditions, sources and loads.
#ifndef PD_CONDITION_HPP
#define PD_CONDITION_HPP

#include <Teuchos_ParameterList.hpp>
#include <set>
#include <string>
#include <vector>

#include "../../materials/registry/registry.hpp"
#include "../deck/deck.hpp"
#include "../deck/function.hpp"
#include "../model/model.hpp"
#include "far_field.hpp"

namespace pd {

/// What a condition is made of.
struct ConditionSection {
  std::string name;  ///< its key in the deck
  DeckNode node;
  Teuchos::ParameterList
      list;  ///< what its type declares, with defaults; a function given as a table is in `node` alone
};

/// What a run has that conditions may need.
struct RunContents {
  bool hasDamageModel = false;               ///< any block
  std::set<std::string> solverFields;        ///< point fields that solvers asked for
  std::set<std::string> fieldsWithFarField;  ///< Solver::fieldsWithFarField() of all solvers
};

/// A condition acts on one point field, at the points of a node set, by a function of place and time. It is registered
/// by the `Type` that decks name, and declares its keys, but for Type itself. Its constructor looks at values alone;
/// findPoints() and measure() follow once there is a mesh, then the hooks of a run, each of which does nothing unless a
/// condition says otherwise. Fields are set at ghosts too.
class Condition {
 public:
  /// Reads what most conditions have, where they declare it: Node Set, Coordinate (for a `width` of 3), Value. `width`:
  /// values a point of `field`. Derived constructors throw DeckError, or std::invalid_argument without the place.
  Condition(const ConditionSection& section, std::string field, int width);
  virtual ~Condition() = default;
  Condition(const Condition&) = delete;
  Condition& operator=(const Condition&) = delete;

  const std::string& name() const { return name_; }
  const DeckNode& node() const { return node_; }
  const std::string& field() const { return field_; }
  int width() const { return width_; }
  int component() const { return component_; }                ///< of the field; 0 of a scalar
  const std::vector<int>& points() const { return points_; }  ///< local ids, owned and ghosts
  /// `condition "Pull"`.
  std::string title() const { return "condition \"" + name_ + "\""; }
  /// value(x, t) at each of points(); kept, and evaluated anew only where t matters. Throws DeckError, on this rank
  /// alone, where one is not finite.
  const std::vector<double>& evaluate(const Discretization& mesh, double t) const;

  // What it is, before anything runs.
  /// Fields that it needs beside field(), or brings along; registers them with the FieldManager.
  virtual std::vector<int> fieldIds() const { return {}; }
  /// Why it would do nothing in such a run, as the end of a sentence; empty where it does something.
  virtual std::string obstacle(const RunContents&) const { return ""; }
  /// A verb ("prescribe") where its values are those of the field: two conditions with one verb must then agree at the
  /// points that they share. Empty where it adds to what others do.
  virtual std::string claim() const { return ""; }
  /// Whether what it gives may differ from one time of the run to the next.
  virtual bool dependsOnTime() const { return value_.dependsOnTime(); }
  virtual bool isPrescription() const { return false; }  ///< it marks and sets values at all times
  virtual bool isLoad() const { return false; }          ///< it adds to the external force
  virtual bool reachesBeyond() const { return false; }   ///< it adds an exchange with what is beyond the mesh
  virtual bool followsDamage() const { return false; }   ///< it acts on a change of damage

  // Where it is.
  /// Throws DeckError where there is no such node set.
  void findPoints(const Discretization& mesh);
  /// Volumes, shares of an area ... of points(). Throws DeckError, on all ranks alike, where they do not do.
  /// Collective.
  virtual void measure(const Discretization&, const Communicator&) {}
  /// What the log should say of it, after measure().
  virtual std::string note() const { return ""; }

  /// Seconds of the solver at work in one of the run, in whose time the hooks below are called.
  void setTimeScale(double scale) { timeScale_ = scale; }

  /// Throws DeckError where nothing moves along `axis`, in a plane scene or one along a line.
  void requireMotionAlong(int axis, const Discretization& mesh) const;

  // What it does in a run. `isPrescribed`: [width() nPoints], of its field, shared with all conditions on that field.
  virtual void applyInitial(Model&, double) {}
  virtual void markPrescribed(std::vector<char>&) const {}
  /// Sets the values of time t.
  virtual void applyPrescribed(Model&, double) {}
  /// Adds to `forceDensity` [3 nOwned], N/m3.
  virtual void addForceDensity(const Discretization&, double, double*) const {}
  /// Adds its exchange to `far`, whose arrays are there.
  virtual void addFarField(const Discretization&, double, FarField&) const {}
  /// Damage has changed, ghosts included; `t`: time of the last applyPrescribed(). Returns how many owned points are
  /// newly prescribed.
  virtual long long damageHasChanged(Model&, double, std::vector<char>&) { return 0; }
  /// A step begins: remembers what it keeps from one time to the next beside the field.
  virtual void beginStep() {}
  /// The step is taken back: all is as at the last beginStep(). The field is brought back by the model.
  virtual void takeBackStep(Model&, std::vector<char>&) {}
  /// Takes up what it keeps from one time to the next from the fields, which are those of time t.
  virtual void resume(Model&, double, std::vector<char>&) {}

 protected:
  /// Sets the component of the field to `values`, one for each of points().
  void write(Model& model, const std::vector<double>& values) const;
  double timeScale() const { return timeScale_; }

 private:
  std::string name_, field_;
  DeckNode node_;
  int width_ = 1, component_ = 0;
  double timeScale_ = 1.0;
  std::vector<int> points_;
  Function value_ = Function::constant(0.0);
  mutable std::vector<double> values_;
  mutable double evaluatedAt_ = 0.0;
};

using ConditionRegistry = PluginRegistry<Condition, const ConditionSection&>;

// Keys that many conditions have, each with the same words.
void declareNodeSet(ParameterDeclarations& declare);
void declareCoordinate(ParameterDeclarations& declare);
void declareField(ParameterDeclarations& declare);

/// Sum of the volumes of the owned points among `points`, all ranks, m3. Collective.
double volumeOf(const std::vector<int>& points, const Discretization& mesh, const Communicator& comm);

}  // namespace pd

#define PD_REGISTER_CONDITION(Class, Name, Brief) PD_REGISTER(pd::ConditionRegistry, Class, Name, Brief)

#endif
