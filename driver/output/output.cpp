#include "output.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "../deck/deck_parameters.hpp"
#include "../deck/sections.hpp"
#include "../model/collective.hpp"
#include "../model/state_fields.hpp"
#include "../parallel/broadcast.hpp"
#include "Peridigm_Field.hpp"
#include "atomic_file.hpp"
#include "compute_set.hpp"
#include "output_files.hpp"
#include "output_section.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "result_files.hpp"
#include "result_lock.hpp"
#include "run_log.hpp"

namespace pd {

using PeridigmNS::FieldManager;
namespace PeridigmField = PeridigmNS::PeridigmField;

namespace {

using Clock = std::chrono::steady_clock;
const Clock::time_point programStart = Clock::now();

/// The rank that owns each point, Peridigm's name for it.
const char* const rankLabel = "Proc_Num";

/// Fields of points that the driver fills by itself, whatever plug-ins there are.
std::vector<FieldDescription> driverFields() {
  return {fields::volume(),
          fields::blockId(),
          fields::elementId(),
          fields::horizon(),
          fields::coordinates(),
          fields::externalForceDensity(),
          fields::storedEnergyDensity()};
}

/// Paths of the results without their endings, and their places in the deck.
std::map<std::string, std::string> resultPaths(const Deck& deck, const std::string& folder) {
  const std::vector<OutputSection> sections = readOutputSections(deck, folder);
  std::map<std::string, std::string> paths;
  for (const OutputSection& section : sections) paths.emplace(section.fileName, section.place);
  if (paths.empty()) paths.emplace(mainOutputName(deck, sections, folder), deck.fileName());
  return paths;
}

void addObstaclesOfPlaces(const Deck& deck, const std::string& folder, Mistakes& mistakes) {
  for (const auto& [path, place] : resultPaths(deck, folder))
    if (const std::string obstacle = obstacleOfPlace(path, folder); !obstacle.empty()) mistakes.add(place, obstacle);
}

void addObstaclesOfFiles(const Deck& deck, const std::string& folder, Mistakes& mistakes) {
  for (const auto& [path, place] : resultPaths(deck, folder))
    for (const std::string& obstacle : obstaclesOfFiles(path)) mistakes.add(place, obstacle);
}

}  // namespace

struct Output::Implementation {
  const Deck deck;
  const Communicator& comm;
  const std::string folder;  ///< of results
  const std::vector<OutputSection> sections;
  const std::string mainName;
  // Of the root rank alone.
  std::vector<std::unique_ptr<ResultLock>> locks;
  std::unique_ptr<RunLog> log;
  std::unique_ptr<Progress> progress;

  std::unique_ptr<ComputeSet> computes;
  std::vector<OutputFiles> files;
  std::unique_ptr<GlobalOrder> order;
  std::set<std::string> fieldsOfState;  ///< that are written
  int firstStep = 0;
  bool isOpen = false;
  std::string timeUnit = "s";
  std::vector<std::string> warnings;

  Implementation(const Deck& deck_, const Communicator& comm_, const std::string& folder_)
      : deck(deck_),
        comm(comm_),
        folder(folder_),
        sections(readOutputSections(deck_, folder_)),
        mainName(mainOutputName(deck_, sections, folder_)) {}

  OutputFiles& filesNamed(const std::string& fileName);
  OutputLabels sortLabels(Model& model, const OutputSection& section, Mistakes& mistakes);
  void refuse(Model& model, const OutputVariable& variable, Mistakes& mistakes);
  const GlobalOrder& orderOf(Model& model);
  /// All computes, or those for the whole body alone; what they find out is logged.
  void evaluate(Model& model, bool onlyGlobal);
  void takeNotes();
  /// Evaluates the computes that are due; whether fields are, and whether anything is.
  std::pair<bool, bool> evaluateDue(Model& model, int step, bool isLast);
  void line(const std::string& text) {
    if (log) log->line(text);
  }
};

OutputFiles& Output::Implementation::filesNamed(const std::string& fileName) {
  for (OutputFiles& known : files)
    if (known.fileName() == fileName) return known;
  files.emplace_back(fileName);
  return files.back();
}

void Output::Implementation::refuse(Model& model, const OutputVariable& variable, Mistakes& mistakes) {
  const bool isBondField = FieldManager::self().hasField(variable.label) &&
                           FieldManager::self().getFieldSpec(variable.label).relation == PeridigmField::BOND;
  std::vector<std::string> known = {rankLabel};
  for (const std::string& label : FieldManager::self().getFieldLabels())
    if (model.hasField(label)) known.push_back(label);
  const std::string label = "\"" + variable.label + "\"";
  const std::string message =
      isBondField ? label +
                        " is a field of bonds, which are written to checkpoints only; the compute Bond_Field_Mean "
                        "makes a field of points of it"
                  : "no plug-in of this run provides " + label;
  // Peridigm leaves out in silence what no plug-in provides.
  if (deck.isPeridigmDeck())
    line("note: " + variable.place + ": " + message + "; it is left out");
  else
    mistakes.add(variable.place, message + didYouMean(variable.label, known) + "; there are: " + commaList(known));
}

OutputLabels Output::Implementation::sortLabels(Model& model, const OutputSection& section, Mistakes& mistakes) {
  OutputLabels labels;
  for (const OutputVariable& variable : section.variables) {
    if (model.hasField(variable.label)) {
      const bool isGlobal = FieldManager::self().getFieldSpec(variable.label).relation == PeridigmField::GLOBAL;
      (isGlobal ? labels.global : labels.point).push_back(variable.label);
      if (isMadeOfState(variable.label)) fieldsOfState.insert(variable.label);
    } else if (variable.label == rankLabel) {
      labels.point.push_back(variable.label);
    } else if (!computes->hasClass(variable.label)) {
      // A compute may be asked for by its class, and yield fields with other labels.
      refuse(model, variable, mistakes);
    }
  }
  return labels;
}

const GlobalOrder& Output::Implementation::orderOf(Model& model) {
  const Discretization& points = model.discretization();
  if (!order) order = std::make_unique<GlobalOrder>(comm, points.globalIds, points.nOwned, points.nGlobal);
  return *order;
}

void Output::Implementation::evaluate(Model& model, bool onlyGlobal) {
  computes->evaluate(model, onlyGlobal);
  takeNotes();
}

void Output::Implementation::takeNotes() {
  for (const std::string& note : computes->newNotes()) {
    line("warning: " + note);
    warnings.push_back(note);
  }
}

std::pair<bool, bool> Output::Implementation::evaluateDue(Model& model, int step, bool isLast) {
  const auto isAnyDue = [&](auto isDue) {
    return std::any_of(files.begin(), files.end(), [&](OutputFiles& each) { return (each.*isDue)(step, isLast); });
  };
  const bool areFieldsDue = isAnyDue(&OutputFiles::areFieldsDue), isHistoryDue = isAnyDue(&OutputFiles::isHistoryDue);
  if (!areFieldsDue && !isHistoryDue) return {false, false};
  std::set<std::string> ofState = computes->fieldsOfState(!areFieldsDue);
  if (areFieldsDue) ofState.insert(fieldsOfState.begin(), fieldsOfState.end());
  makeOfState(model, ofState);
  evaluate(model, !areFieldsDue);
  return {areFieldsDue, true};
}

Output::Output(const Deck& deck, const Communicator& comm, bool isQuiet, const std::string& folder)
    : implementation_(new Implementation(deck, comm, folder)) {
  Implementation& self = *implementation_;
  if (!comm.isRoot()) return;
  self.log = std::make_unique<RunLog>(isQuiet);
  self.progress = std::make_unique<Progress>(*self.log);
}

Output::~Output() = default;

void Output::claim() {
  Implementation& self = *implementation_;
  onRoot(self.comm, [&] {
    Mistakes mistakes;
    addObstaclesOfPlaces(self.deck, self.folder, mistakes);
    mistakes.report();
    // A lock is a file, and what is in the way can be said once nobody else writes.
    for (const auto& [path, place] : resultPaths(self.deck, self.folder))
      self.locks.push_back(std::make_unique<ResultLock>(path));
    addObstaclesOfFiles(self.deck, self.folder, mistakes);
    mistakes.report();
  });
}

void Output::begin(int firstStep, const std::string& resolvedDeck) {
  Implementation& self = *implementation_;
  self.firstStep = firstStep;
  onRoot(self.comm, [&] {
    for (const auto& [path, place] : resultPaths(self.deck, self.folder))
      firstStep == 0 ? removeResults(path) : removeReport(path);  // the report is that of a run that has ended
    self.log->open(self.mainName + endings::log, firstStep > 0);
    writeFileAtomically(self.mainName + endings::resolved, resolvedDeck);
  });
}

std::vector<int> Output::fieldIds() {
  Implementation& self = *implementation_;
  self.computes = std::make_unique<ComputeSet>(self.deck, self.comm);
  std::vector<int> ids = self.computes->fieldIds();
  for (const OutputSection& section : self.sections)
    for (const OutputVariable& variable : section.variables)
      for (const FieldDescription& field : driverFields())
        if (field.label == variable.label) ids.push_back(field.id());
  return ids;
}

void Output::initialize(Model& model) {
  Implementation& self = *implementation_;
  Mistakes mistakes;
  for (const OutputSection& section : self.sections)
    self.filesNamed(section.fileName).add(section, self.sortLabels(model, section, mistakes));
  mistakes.report();
  // What computes yield for the whole body is cheap to write, so it is, asked for by name or not.
  for (const std::string& label : self.computes->globalLabels()) {
    const bool isListed = std::any_of(self.files.begin(), self.files.end(),
                                      [&](const OutputFiles& files) { return files.hasColumn(label); });
    if (!isListed && !self.files.empty()) self.files.front().addColumn(label);
  }
  self.computes->initialize(model);
}

void Output::write(Model& model, int step, int, double time, bool isLast) {
  Implementation& self = *implementation_;
  if (!self.isOpen) {
    const Timers::Scope timer(model.timers(), "output");
    for (OutputFiles& files : self.files) files.open(model, self.orderOf(model), self.firstStep, self.timeUnit);
    self.isOpen = true;
  }
  const auto [areFieldsDue, isAnyDue] = self.evaluateDue(model, step, isLast);
  stateHasChanged();
  if (!isAnyDue) return;
  const Timers::Scope timer(model.timers(), "output");
  for (OutputFiles& files : self.files) files.write(model, step, time, isLast);
  if (areFieldsDue)
    collectively(self.comm, [&] {
      if (self.log) self.log->requireWritten();
    });
}

void Output::stateIsSettled() { implementation_->computes->stateIsSettled(); }
void Output::stateHasChanged() { implementation_->computes->stateHasChanged(); }

void Output::evaluate(Model& model, int step) { implementation_->evaluateDue(model, step, false); }

void Output::evaluateGlobals(Model& model) {
  Implementation& self = *implementation_;
  makeOfState(model, self.computes->fieldsOfState(true));
  self.evaluate(model, true);
}

void Output::evaluateGlobal(Model& model, const std::string& label) {
  Implementation& self = *implementation_;
  makeOfState(model, self.computes->fieldsOfState(label));
  self.computes->evaluate(model, label);
  self.takeNotes();
}

bool Output::makesGlobal(const std::string& label) const { return implementation_->computes->makes(label); }

bool Output::keepsEvaluations(const std::string& label) const {
  return implementation_->computes->keepsEvaluations(label);
}

std::string Output::markRead(Model& model, std::vector<char>& isRead) const {
  return implementation_->computes->markRead(model, isRead);
}

bool Output::needsDisplacements(Model& model, int step, bool isLast) const {
  std::vector<char> isRead(static_cast<std::size_t>(model.nPoints()), 0);
  const bool computesNeedThem = !markRead(model, isRead).empty();
  const auto& files = implementation_->files;
  return isCheckpointDue(step, isLast) || std::any_of(files.begin(), files.end(), [&](const OutputFiles& each) {
           return each.areFieldsDue(step, isLast) || (computesNeedThem && each.isHistoryDue(step, isLast));
         });
}

const std::vector<std::string>& Output::warnings() const { return implementation_->warnings; }

bool Output::isCheckpointDue(int step, bool isLast) const {
  const auto& files = implementation_->files;
  return std::any_of(files.begin(), files.end(),
                     [&](const OutputFiles& each) { return each.isCheckpointDue(step, isLast); });
}

void Output::checkpoint(Model& model, const Checkpoint& checkpoint, bool isLast) {
  Implementation& self = *implementation_;
  for (const OutputFiles& files : self.files) {
    if (!files.isCheckpointDue(checkpoint.step, isLast)) continue;
    const Timers::Scope timer(model.timers(), "checkpoint");
    writeCheckpoint(model, self.orderOf(model), files.fileName() + endings::checkpoint, checkpoint);
  }
}

void Output::setTimeUnit(const std::string& unit) {
  implementation_->timeUnit = unit;
  if (implementation_->progress) implementation_->progress->setTimeUnit(unit);
}

void Output::startSolver() {
  for (OutputFiles& files : implementation_->files) files.startSolver();
}

void Output::log(const std::string& line) { implementation_->line(line); }

void Output::progress(int step, int nSteps, double time, const std::string& what) {
  if (implementation_->progress) implementation_->progress->report(step, nSteps, time, what);
}

void Output::report(Model& model, const std::vector<std::string>& solverSummary,
                    const std::vector<std::pair<std::string, double>>& errorNorms) {
  Implementation& self = *implementation_;
  RunReport report = collectReport(model, std::chrono::duration<double>(Clock::now() - programStart).count());
  report.deck = self.deck.fileName();
  report.solverSummary = solverSummary;
  report.errorNorms = errorNorms;
  onRoot(self.comm, [&] {
    std::istringstream table(reportTable(report));
    for (std::string line; std::getline(table, line);) self.log->line(line);
    self.log->requireWritten();
    writeFileAtomically(self.mainName + endings::report, reportJson(report));
  });
}

void checkResults(const Deck& deck, const std::string& folder, const Communicator& comm) {
  Mistakes mistakes;
  std::string lines;
  if (comm.isRoot()) {
    try {
      addObstaclesOfPlaces(deck, folder, mistakes);
      if (mistakes.empty()) addObstaclesOfFiles(deck, folder, mistakes);
    } catch (const RunError& error) {
      mistakes.add("", error.what());  // a folder that cannot be read
    }
    for (const std::string& line : mistakes.lines()) lines += line + "\n";
  }
  broadcast(lines, comm);
  std::istringstream all(lines);
  for (std::string line; std::getline(all, line);) deck.mistakes().add("", line);
}

}  // namespace pd
