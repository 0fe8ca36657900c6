// Declaration of a plug-in's fields. One declaration feeds FieldIds(), views of the values, the exchange between ranks,
// ownership checks, checkpoints, units of pictures and `pdrun --explain`.
//
//   struct Fields : FieldTable {
//     FieldHandle volume = reads(fields::volume());
//     FieldHandle life = writes(fields::bondScalar("Remaining_Life", "1", "Share of the life that is left."));
//   } fields_;
//   ...  const double* before = fields_.life.before(dataManager);   // STEP_N
//        double* now = fields_.life.of(dataManager);                // STEP_NP1
#ifndef PD_FIELDS_HPP
#define PD_FIELDS_HPP

#include <string>
#include <vector>

#include "Peridigm_DataManager.hpp"
#include "Peridigm_Field.hpp"

namespace pd {

/// What the value at a point becomes at the point's mirror image.
enum class Reflection {
  Even,         ///< the same (every scalar that is no odd one)
  Odd,          ///< the negative
  Vector,       ///< mirrored, as a displacement or a force
  AxialVector,  ///< mirrored with the opposite sign, as a rotation
  Position      ///< mirrored at the plane itself, as coordinates
};

/// What a field is, whoever uses it.
struct FieldDescription {
  std::string label;
  PeridigmNS::PeridigmField::Relation relation = PeridigmNS::PeridigmField::UNDEFINED_RELATION;
  PeridigmNS::PeridigmField::Length length = PeridigmNS::PeridigmField::UNDEFINED_LENGTH;
  PeridigmNS::PeridigmField::Temporal temporal = PeridigmNS::PeridigmField::UNDEFINED_TEMPORAL;
  std::string unit;     ///< "Pa", "m", ...; "1" for a pure number; fields::unitOfDeck
  std::string meaning;  ///< one sentence
  Reflection reflection = Reflection::Even;
  /// Of a two-step field: a value never falls, within a step either, and its user may find that of NP1 at N. Where all
  /// users of a bond field say so, both steps share one memory.
  bool onlyGrows = false;
  /// Of a one-step field: what it holds at the end of a step is where the next one starts from.
  bool isState = false;
  std::string rateOf;  ///< label of the field whose time derivative this one is; empty: of none

  FieldDescription& growing();
  FieldDescription& state();
  FieldDescription& reflected(Reflection rule);
  FieldDescription& in(const std::string& itsUnit);
  /// Has it a label? Without one it is a field that only a deck names, in the description of a class of plug-ins.
  bool isNamed() const { return relation != PeridigmNS::PeridigmField::UNDEFINED_RELATION; }
  /// Registers the field with the FieldManager, or finds it. Throws std::invalid_argument where the label is known as
  /// something else.
  int id() const;
};

/// What a plug-in does with a field.
enum class FieldAccess {
  Reads,
  Writes,  ///< it alone
  /// Zeroes it, then adds; contributions of blocks and ranks are summed by the host. An optional one is set at the
  /// plug-in's own points.
  Adds,
  Worsens  ///< raises it towards 1, as other plug-ins of the block may: damage
};

/// When the host carries owners' values to ghosts for a plug-in.
enum class Ghosts { None, AfterInitialize, AfterPrecompute };

struct FieldUse {
  FieldDescription field;
  FieldAccess access = FieldAccess::Reads;
  Ghosts ghosts = Ghosts::None;
  bool isOptional = false;  ///< used where somebody else brings it
  int id = -1;
};

/// A field of a plug-in, seen through the data of a block.
class FieldHandle {
 public:
  FieldHandle() = default;
  FieldHandle(int id, PeridigmNS::PeridigmField::Temporal temporal)
      : id_(id), isTwoStep_(temporal == PeridigmNS::PeridigmField::TWO_STEP) {}

  int id() const { return id_; }
  /// Not used with these parameters: a handle that nothing was assigned to.
  bool isUsed() const { return id_ >= 0; }
  bool isIn(PeridigmNS::DataManager& data) const { return isUsed() && data.hasData(id_, now()); }
  /// Values at STEP_NP1, of a one-step field its values. Throws std::logic_error where they were not allocated.
  double* of(PeridigmNS::DataManager& data) const { return view(data, now()); }
  /// Null where it is not there.
  double* ifIn(PeridigmNS::DataManager& data) const { return isIn(data) ? of(data) : nullptr; }
  /// Values at STEP_N.
  double* before(PeridigmNS::DataManager& data) const { return view(data, PeridigmNS::PeridigmField::STEP_N); }
  /// How many values, of all points or bonds of the block.
  int length(PeridigmNS::DataManager& data) const { return data.getData(id_, now())->MyLength(); }

 private:
  PeridigmNS::PeridigmField::Step now() const {
    return isTwoStep_ ? PeridigmNS::PeridigmField::STEP_NP1 : PeridigmNS::PeridigmField::STEP_NONE;
  }
  double* view(PeridigmNS::DataManager& data, PeridigmNS::PeridigmField::Step step) const {
    double* values = nullptr;
    data.getData(id_, step)->ExtractView(&values);
    return values;
  }

  int id_ = -1;
  bool isTwoStep_ = false;
};

/// The fields of a plug-in. Derive from it with a FieldHandle a field, as above.
class FieldTable {
 public:
  const std::vector<FieldUse>& uses() const { return uses_; }
  const FieldUse* find(int id) const;
  /// For FieldIds(): all but the optional ones.
  std::vector<int> ids() const;
  /// For FieldIdsForSynchronizationAfter...().
  std::vector<int> ids(Ghosts when) const;
  /// What it adds to, but for optional ones: fields that a host sums over blocks and ranks.
  std::vector<int> sums() const;
  /// The field that is the rate of the field `label` and that it adds to; -1 where it gives none.
  int rateOf(const std::string& label) const;
  /// Takes over what a part of the plug-in uses.
  void include(const FieldTable& part);

 protected:
  FieldHandle reads(const FieldDescription& field, Ghosts ghosts = Ghosts::None);
  FieldHandle readsIfThere(const FieldDescription& field);
  FieldHandle writes(const FieldDescription& field, Ghosts ghosts = Ghosts::None);
  FieldHandle writesIfThere(const FieldDescription& field);
  FieldHandle adds(const FieldDescription& field);
  FieldHandle addsIfThere(const FieldDescription& field);
  FieldHandle worsens(const FieldDescription& field);
  FieldHandle worsensIfThere(const FieldDescription& field);

 private:
  FieldHandle use(const FieldDescription& field, FieldAccess access, Ghosts ghosts, bool isOptional);
  std::vector<FieldUse> uses_;
};

/// A plug-in that has such a table. Of one that has none a host knows the ids alone and takes the safe way.
class FieldUser {
 public:
  virtual ~FieldUser() = default;
  virtual const FieldTable& fields() const = 0;
};

/// The table of a plug-in; null where it has none.
template <class Plugin>
const FieldTable* fieldTableOf(const Plugin& plugin) {
  const auto* user = dynamic_cast<const FieldUser*>(&plugin);
  return user == nullptr ? nullptr : &user->fields();
}

/// The table of a plug-in. One that has none is taken to read and to step all that it asks for, and to add to the two
/// fields that Peridigm's own materials add to.
FieldTable assumedFields(const std::vector<int>& ids);
template <class Plugin>
FieldTable fieldsIn(const Plugin& plugin) {
  const FieldTable* table = fieldTableOf(plugin);
  return table != nullptr ? *table : assumedFields(plugin.FieldIds());
}

/// A plug-in of a block, as messages name it.
struct NamedTable {
  std::string name;
  FieldTable table;
};
/// A message for each field that one of these plug-ins of a block writes alone and another one changes too.
std::vector<std::string> contestedFields(const std::vector<NamedTable>& plugins);

/// Descriptions: of any field, and of those that several plug-ins share.
namespace fields {

/// The unit of what a deck gives in any unit it likes, and of a rate of it: not one to write beside numbers.
inline const char* const unitOfDeck = "unit of the deck";

/// What the tables of this process say of the field called `label`; null where none has it. A description with a unit
/// goes before one that leaves it to the deck.
const FieldDescription* find(const std::string& label);
/// The same; of a field that stands in no table what the FieldManager knows. Throws std::invalid_argument, with the
/// known fields, where nobody has registered it.
FieldDescription describe(const std::string& label);
/// Do all tables that have the field use it only where somebody else brings it?
bool isOptionalEverywhere(const std::string& label);
/// The unit to write beside the field's numbers ("Pa"; "1" for a pure number); empty where it is not known.
std::string unitOf(const std::string& label);

/// A field that the deck names by `key`, before it has done so.
FieldDescription namedBy(const std::string& key, const std::string& unit, const std::string& meaning);
/// Values for the whole body.
FieldDescription globalScalar(const std::string& label, const std::string& unit, const std::string& meaning);
FieldDescription globalVector(const std::string& label, const std::string& unit, const std::string& meaning);
/// As Peridigm has scalars and tensors of its computes: of cells, without steps.
FieldDescription elementScalar(const std::string& label, const std::string& unit, const std::string& meaning);
FieldDescription elementTensor(const std::string& label, const std::string& unit, const std::string& meaning);
FieldDescription pointScalar(const std::string& label, const std::string& unit, const std::string& meaning);
FieldDescription pointVector(const std::string& label, const std::string& unit, const std::string& meaning);
/// With the steps N and NP1.
FieldDescription steppedScalar(const std::string& label, const std::string& unit, const std::string& meaning);
FieldDescription steppedVector(const std::string& label, const std::string& unit, const std::string& meaning);
/// A history of bonds, with the steps N and NP1.
FieldDescription bondScalar(const std::string& label, const std::string& unit, const std::string& meaning);

FieldDescription modelCoordinates();
FieldDescription coordinates();
FieldDescription displacement();
FieldDescription velocity();
/// Of a fluid: its rate, at points that stay where they are, and the pressure.
FieldDescription velocityRate();
FieldDescription pressure();
FieldDescription volume();
FieldDescription blockId();
FieldDescription elementId();
FieldDescription horizon();
FieldDescription forceDensity();
FieldDescription externalForceDensity();
FieldDescription damage();
FieldDescription bondDamage();
FieldDescription noFailure();
/// Of cracks and voids that points do not resolve (decomposition/); a host that has such brings them.
FieldDescription interactionShare();
FieldDescription cellVolume();
FieldDescription countedBonds();
FieldDescription storedEnergyDensity();
FieldDescription weightedVolume();
FieldDescription dilatation();
FieldDescription solidConcentration();
FieldDescription saturationConcentration();
FieldDescription interfaceAreaDensity();
FieldDescription saltCoverage();
FieldDescription filmCoverage();
FieldDescription dissolutionDemand();
FieldDescription dissolutionRate();
FieldDescription dissolutionRateSlope();
FieldDescription currentDensity();
/// A scalar that diffuses, and its rate (field_names.hpp).
FieldDescription diffusingScalar(const std::string& label);
FieldDescription fluxDivergence(const std::string& label);
/// Those of dissolved metal, "Concentration" in mol/m3.
/// Of metal ions, by the label that the deck gives them.
FieldDescription ionConcentration(const std::string& label);
FieldDescription ionFluxDivergence(const std::string& label);

}  // namespace fields

}  // namespace pd

#endif
