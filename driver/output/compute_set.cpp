#include "compute_set.hpp"

#include <algorithm>

#include "../deck/block_plugins.hpp"
#include "../deck/sections.hpp"
#include "../model/collective.hpp"
#include "../model/state_fields.hpp"
#include "partial_reader.hpp"
#include "plugins.hpp"
#include "run_notes.hpp"
#include "whole_body.hpp"

namespace pd {

using PeridigmNS::FieldManager;
using PeridigmNS::FieldSpec;

namespace {

/// Calls `work`; a mistake that a plug-in finds is given the place in the deck.
template <class Work>
void atPlace(const std::string& place, const Work& work) {
  try {
    work();
  } catch (const DeckError&) {
    throw;
  } catch (const std::exception& error) {
    throw DeckError((place.empty() ? "" : place + ": ") + error.what());
  }
}

/// Whether displacements have no part in a field: it is of the mesh, of bonds that have broken, or of the whole body.
bool isOfMeshOrBreakage(const FieldSpec& spec) {
  static const std::set<std::string> labels = {
      fields::modelCoordinates().label, fields::volume().label,     fields::horizon().label, fields::blockId().label,
      fields::elementId().label,        fields::bondDamage().label, fields::damage().label};
  return spec.relation == PeridigmNS::PeridigmField::GLOBAL || labels.count(spec.label) > 0;
}

}  // namespace

class ComputeSet::SymmetricBody : public WholeBody {
 public:
  int nCopies() const override { return symmetry.nCopies(); }
  std::array<double, 9> reflection(int copy) const override { return symmetry.matrix(copy); }
  std::array<double, 3> place(int copy, const double* x) const override { return symmetry.place(copy, x); }
  Symmetry symmetry;
};

ComputeSet::ComputeSet(const Deck& deck, const Communicator& comm)
    : nodeSets_(Teuchos::rcp(new PeridigmNS::Discretization::NodeSets)),
      wholeBody_(Teuchos::rcp(new SymmetricBody)),
      discretization_(Teuchos::rcp(new PeridigmNS::Discretization(nodeSets_))),
      globalData_(Teuchos::rcp(new Teuchos::ParameterList)) {
  globalData_->set("discretization", &discretization_);
  globalData_->set<Teuchos::RCP<const WholeBody>>("whole body", wholeBody_);
  // First those that others may take fields from.
  for (const std::string& name : computesWithoutSection(deck)) add(name, DeckNode(), deck, comm);
  Mistakes mistakes;
  for (const auto& [name, node] : deck["Compute Class Parameters"].entries()) {
    try {
      add(withUnderscores(node["Compute Class"].text()), node, deck, comm);
    } catch (const DeckError& error) {
      mistakes.add("", error.what());
    }
  }
  mistakes.report();
}

void ComputeSet::add(const std::string& className, const DeckNode& node, const Deck& deck, const Communicator& comm) {
  const auto* plugin = ComputeRegistry::self().find(className);
  if (plugin == nullptr)
    throw DeckError(node["Compute Class"].place() + ": unknown compute class \"" + className + "\"");
  Teuchos::RCP<Teuchos::ParameterList> parameters;
  if (node) {
    parameters = Teuchos::rcp(new Teuchos::ParameterList(node.parameters(plugin->declare())));
    giveAxisOfRevolution(deck, plugin->declare(), *parameters);
  }
  Entry entry;
  entry.className = className;
  entry.place = node ? node.keyPlace() : "";
  atPlace(entry.place, [&] {
    entry.compute =
        plugin->create(parameters, Teuchos::rcp(static_cast<const Epetra_Comm*>(&comm), false), globalData_);
    const FieldTable fields = fieldsIn(*entry.compute);
    for (const FieldUse& use : fields.uses()) {
      if (isMadeOfState(use.field.label)) entry.fieldsOfState.insert(use.field.label);
      const bool isWritten = use.access != FieldAccess::Reads;
      entry.keepsEvaluations = entry.keepsEvaluations || (use.field.isState && isWritten);
      if (use.field.relation != PeridigmNS::PeridigmField::GLOBAL) continue;
      // What has steps is state that the compute keeps or that this host gives it, no result.
      const bool hasSteps = use.field.temporal != PeridigmNS::PeridigmField::CONSTANT;
      const bool mayBeWritten = fieldTableOf(*entry.compute) == nullptr && !hasSteps;
      (isWritten || mayBeWritten ? entry.writes : entry.reads).insert(use.field.label);
      entry.keepsEvaluations = entry.keepsEvaluations || (hasSteps && isWritten);
    }
    for (const int id : entry.compute->FieldIds()) {
      const FieldSpec spec = FieldManager::self().getFieldSpec(id);
      entry.looksAtDisplacements = entry.looksAtDisplacements || !isOfMeshOrBreakage(spec);
      if (spec.relation != PeridigmNS::PeridigmField::GLOBAL) continue;
      entry.isGlobal = true;
      if (spec.temporal != PeridigmNS::PeridigmField::CONSTANT) continue;
      if (std::find(globalLabels_.begin(), globalLabels_.end(), spec.label) == globalLabels_.end())
        globalLabels_.push_back(spec.label);
    }
  });
  entry.followsFromState = followsFromState(entry);
  entries_.insert(placeFor(entry), entry);
}

/// Before those that read its values, wherever the deck names it, so that none looks at values of an earlier state.
std::vector<ComputeSet::Entry>::const_iterator ComputeSet::placeFor(const Entry& entry) const {
  const auto readsOf = [](const Entry& reader, const Entry& maker) {
    return std::any_of(maker.writes.begin(), maker.writes.end(),
                       [&](const std::string& label) { return reader.reads.count(label) != 0; });
  };
  if (fieldTableOf(*entry.compute) == nullptr) return entries_.end();
  const auto place =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& other) { return readsOf(other, entry); });
  const bool isInTurn = std::any_of(place, entries_.end(), [&](const Entry& other) { return readsOf(entry, other); });
  return isInTurn ? entries_.end() : place;
}

/// A table says all that it reads, of the whole body values of earlier ones that do so, too; of displacements those of
/// a few points.
bool ComputeSet::followsFromState(const Entry& entry) const {
  const bool readsPoints = dynamic_cast<const PartialReader*>(entry.compute.get()) != nullptr;
  if (fieldTableOf(*entry.compute) == nullptr || !entry.isGlobal || entry.keepsEvaluations ||
      (entry.looksAtDisplacements && !readsPoints))
    return false;
  return std::all_of(entry.reads.begin(), entry.reads.end(), [&](const std::string& label) {
    const std::vector<const Entry*> makers = makersOf(label);
    return !makers.empty() && makers.back()->followsFromState;
  });
}

void ComputeSet::stateIsSettled() {
  isSettled_ = true;
  isKnown_.clear();
}

void ComputeSet::stateHasChanged() {
  isSettled_ = false;
  isKnown_.clear();
}

bool ComputeSet::hasClass(const std::string& name) const {
  return std::any_of(entries_.begin(), entries_.end(),
                     [&](const Entry& entry) { return entry.className == withUnderscores(name); });
}

std::set<std::string> ComputeSet::fieldsOfState(bool onlyGlobal) const {
  std::set<std::string> labels;
  for (const Entry& entry : entries_)
    if (entry.isDue(onlyGlobal)) labels.insert(entry.fieldsOfState.begin(), entry.fieldsOfState.end());
  return labels;
}

/// In the order in which they run, in which none reads values of a later one.
std::vector<const ComputeSet::Entry*> ComputeSet::makersOf(const std::string& label) const {
  std::set<std::string> wanted = {label};
  std::vector<const Entry*> makers;
  for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
    const auto isWanted = [&](const std::string& written) { return wanted.count(written) != 0; };
    if (std::none_of(entry->writes.begin(), entry->writes.end(), isWanted)) continue;
    wanted.insert(entry->reads.begin(), entry->reads.end());
    makers.insert(makers.begin(), &*entry);
  }
  return makers;
}

std::set<std::string> ComputeSet::fieldsOfState(const std::string& label) const {
  std::set<std::string> labels;
  for (const Entry* entry : makersOf(label)) labels.insert(entry->fieldsOfState.begin(), entry->fieldsOfState.end());
  return labels;
}

bool ComputeSet::keepsEvaluations(const std::string& label) const {
  const std::vector<const Entry*> makers = makersOf(label);
  return std::any_of(makers.begin(), makers.end(), [](const Entry* entry) { return entry->keepsEvaluations; });
}

std::vector<int> ComputeSet::fieldIds() const {
  std::vector<int> ids;
  for (const Entry& entry : entries_) {
    const std::vector<int> more = entry.compute->FieldIds();
    ids.insert(ids.end(), more.begin(), more.end());
  }
  return ids;
}

std::string ComputeSet::markRead(Model& model, std::vector<char>& isRead) const {
  for (const Entry& entry : entries_) {
    if (!entry.isGlobal || !entry.looksAtDisplacements) continue;
    const auto* reader = dynamic_cast<const PartialReader*>(entry.compute.get());
    if (reader == nullptr) return entry.place.empty() ? entry.className : entry.place;
    reader->markRead(model.blocks(), isRead);
  }
  return "";
}

void ComputeSet::initialize(Model& model) {
  const Discretization& points = model.discretization();
  wholeBody_->symmetry = points.symmetry;
  for (const auto& [name, localIds] : points.nodeSets) {
    std::vector<int>& globalIds = (*nodeSets_)[name];
    for (const int id : localIds)
      if (id < points.nOwned) globalIds.push_back(points.globalIds[static_cast<std::size_t>(id)]);
  }
  // A compute may add over ranks here, so its mistakes are those of all ranks: the same names are known to each.
  for (const Entry& entry : entries_) atPlace(entry.place, [&] { entry.compute->initialize(model.blocks()); });
}

std::vector<std::string> ComputeSet::newNotes() {
  std::vector<std::string> lines;
  for (const Entry& entry : entries_)
    if (const auto* notes = dynamic_cast<const RunNotes*>(entry.compute.get()))
      for (const std::string& note : notes->runNotes())
        if (const std::string line = (entry.place.empty() ? "" : entry.place + ": ") + note; notes_.insert(line).second)
          lines.push_back(line);
  return lines;
}

void ComputeSet::evaluate(Model& model, bool onlyGlobal) const {
  const Timers::Scope timer(model.timers(), "computes");
  for (const Entry& entry : entries_)
    if (entry.isDue(onlyGlobal)) evaluate(model, entry);
}

void ComputeSet::evaluate(Model& model, const std::string& label) const {
  const Timers::Scope timer(model.timers(), "computes");
  for (const Entry* entry : makersOf(label)) evaluate(model, *entry);
}

void ComputeSet::evaluate(Model& model, const Entry& entry) const {
  const bool isKept = isSettled_ && entry.followsFromState;
  if (isKept && !isKnown_.insert(&entry).second) return;
  orAbort(model.comm(), [&] { entry.compute->compute(model.blocks()); });
}

}  // namespace pd
