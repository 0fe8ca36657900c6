#include "restart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "../deck/deck_differences.hpp"
#include "../deck/sections.hpp"
#include "for_each_plugin.hpp"

namespace pd {

namespace {

// Ends of increments that are the same but for rounding: shares of a stage and of an increment.
constexpr double sameInStage = 1e-9, sameInIncrement = 1e-6;

std::string quotedNames(const std::set<std::string>& names) { return quotedList({names.begin(), names.end()}); }

std::set<std::string> namesOf(const RestartState& state) {
  std::set<std::string> names;
  for (const auto& entry : state.entries()) names.insert(entry.first);
  return names;
}

std::set<std::string> fieldsOf(const Solver& solver) {
  std::set<std::string> labels;
  for (const FieldUse& use : solver.fields().uses()) labels.insert(use.field.label);
  return labels;
}

/// One-step fields of points that plug-ins fill and that are no state: what they make of the deck.
std::map<std::string, std::vector<double>> fieldsOfTheDeck(Model& model) {
  namespace Field = PeridigmNS::PeridigmField;
  std::map<std::string, std::vector<double>> result;
  const auto keep = [&](const FieldUse& use) {
    const FieldDescription& field = use.field;
    const bool isFilled = use.access == FieldAccess::Writes && field.temporal == Field::CONSTANT;
    if (!isOfPoints(field.relation) || !isFilled || field.isState || !model.hasField(field.label)) return;
    const double* values = model.field(field.label);
    const auto count = static_cast<std::ptrdiff_t>(model.fieldWidth(field.label)) * model.nPoints();
    result[field.label].assign(values, values + count);
  };
  for (PeridigmNS::Block& block : *model.blocks()) forEachFieldUse(block, keep);
  return result;
}

std::set<std::string> without(const std::set<std::string>& names, const std::set<std::string>& others) {
  std::set<std::string> result;
  std::set_difference(names.begin(), names.end(), others.begin(), others.end(), std::inserter(result, result.end()));
  return result;
}

}  // namespace

std::set<std::string> fieldLabels(Model& model) {
  std::set<std::string> labels;
  for (PeridigmNS::Block& block : *model.blocks())
    for (const int id : block.getDataManager()->getFieldIds())
      labels.insert(PeridigmNS::FieldManager::self().getFieldSpec(id).label);
  return labels;
}

Restart::Restart(Model& model, const std::string& fileName, const std::string& deck, std::string timeUnit)
    : fileName_(fileName), timeUnit_(std::move(timeUnit)) {
  const auto ofDeck = fieldsOfTheDeck(model);
  checkpoint_ = readCheckpoint(model, fileName);
  for (const DeckDifference& difference : deckDifferences(deck, checkpoint_.deck)) {
    differences_.push_back(fmt::format("{} is {}, was {}", difference.path, difference.now, difference.before));
    isSameDeck_ = false;
    isSameModel_ = isSameModel_ && !difference.isOfModel;
  }
  if (isSameModel_) return;
  for (const auto& [label, values] : ofDeck) std::copy(values.begin(), values.end(), model.field(label));
}

std::string Restart::name() const { return fmt::format("\"{}\" (t = {} {})", fileName_, time(), timeUnit_); }

std::vector<std::string> Restart::notes() const {
  std::vector<std::string> lines = {
      fmt::format("going on from step {} (t = {:g} {}) of {}", step(), time(), timeUnit_, fileName_)};
  if (!isSameDeck_) lines.emplace_back("note: the deck is not the one that wrote this checkpoint:");
  for (const std::string& difference : differences_) lines.push_back("note:   " + difference);
  for (const std::string& label : startsAfresh_)
    lines.push_back(fmt::format("note: \"{}\" is not in the checkpoint; it starts from the initial state", label));
  return lines;
}

std::string Restart::whatCounts() const {
  return fmt::format(
      "after {}: times, iterations, evaluations, solves and their residuals are those since then; steps, events and "
      "amounts those since the start",
      name());
}

bool Restart::isReached(double end, double margin) const {
  return end <= time() + std::max(margin, 4.0 * std::numeric_limits<double>::epsilon() * std::abs(time()));
}

void Restart::refuseAsOver(const Stage& last) const {
  throw RunError(
      fmt::format("{} lies at or beyond the end of the last increment ({}, Final Time {} {}): nothing is left "
                  "to run; set a later Final Time",
                  name(), last.section, last.endTime, timeUnit_));
}

std::size_t Restart::findStage(const std::vector<Stage>& stages, const std::set<std::string>& ofPlugins,
                               const std::set<std::string>& ofConditions) {
  const Stage& first = stages.front();
  if (!isReached(first.startTime, sameInStage * (first.endTime - first.startTime)))
    throw RunError(
        fmt::format("{} lies before the Initial Time of {}, {} {}; set it to that of the run that wrote the "
                    "checkpoint",
                    name(), first.section, first.startTime, timeUnit_));
  std::size_t s = 0;
  const auto isOver = [&](const Stage& stage) {
    return isReached(stage.endTime, sameInStage * (stage.endTime - stage.startTime));
  };
  while (s < stages.size() && isOver(stages[s])) ++s;
  if (s == stages.size()) refuseAsOver(stages.back());
  const Stage& stage = stages[s];
  const double length = stage.endTime - stage.startTime;
  beginsStage_ = !(stage.startTime < time()) || time() - stage.startTime <= sameInStage * length;
  if (!beginsStage_) requireState(stage);
  std::set<std::string> needed = ofPlugins;
  if (isSameModel_) needed.insert(ofConditions.begin(), ofConditions.end());
  requireFields(stage, needed);
  std::set<std::string> state = ofConditions;
  for (const Stage& each : stages)
    for (const std::string& label : fieldsOf(*each.solver)) state.insert(label);
  for (const std::string& label : checkpoint_.missingFields)
    if (state.count(label) != 0) startsAfresh_.insert(label);
  return s;
}

void Restart::requireFields(const Stage& stage, std::set<std::string> needed) const {
  if (!beginsStage_)
    for (const std::string& label : fieldsOf(*stage.solver)) needed.insert(label);
  std::set<std::string> missing;
  for (const std::string& label : checkpoint_.missingFields)
    if (needed.count(label) != 0) missing.insert(label);
  if (missing.empty()) return;
  throw RunError(fmt::format("{} lacks {}, which this deck needs. {}", name(), quotedNames(missing),
                             isSameModel_ ? "The file is not complete; take another checkpoint, or start afresh"
                                          : "Go on with the materials, damage models and solvers of the run that wrote "
                                            "it, or start afresh"));
}

void Restart::requireState(const Stage& stage) const {
  if (stage.name != checkpoint_.solver)
    throw RunError(
        fmt::format("{} was written by the solver \"{}\", but {} ({} to {} {}) has \"{}\". Go on with \"{}\", "
                    "or let {} end at {} {} and give \"{}\" a section of its own that begins there "
                    "(Initial Time: {})",
                    name(), checkpoint_.solver, stage.section, stage.startTime, stage.endTime, timeUnit_, stage.name,
                    checkpoint_.solver, stage.section, time(), timeUnit_, stage.name, time()));
  const std::set<std::string> wanted = namesOf(stage.solver->restartState()), found = namesOf(checkpoint_.state);
  if (wanted == found) return;
  const std::set<std::string> lacking = without(wanted, found), surplus = without(found, wanted);
  throw RunError(fmt::format(
      "{} holds another kind of state than {}/{} of this deck needs:{}{}. Use the methods and parts of the run that "
      "wrote it, or give the new ones a section of their own that begins at its time (Initial Time: {})",
      name(), stage.section, stage.name, lacking.empty() ? "" : " it lacks " + quotedNames(lacking),
      surplus.empty() ? "" : (lacking.empty() ? " it has " : " and has ") + quotedNames(surplus), time()));
}

void Restart::setState(Solver& solver) const {
  if (beginsStage_) return;
  solver.setRestartState(checkpoint_.state);
  if (!isSameModel_) solver.modelHasChanged();
}

int Restart::incrementsDone(const Stage& stage, int nIncrements, bool isLast) const {
  if (beginsStage_) return 0;
  const auto endOf = [&](int increment) {
    return stage.solver->incrementEnd(increment, nIncrements, stage.startTime, stage.endTime);
  };
  // The first one that is not over, by bisection.
  int done = 0, next = nIncrements + 1;
  while (next - done > 1) {
    const int middle = done + (next - done) / 2;
    const bool isOver = isReached(endOf(middle), sameInIncrement * (endOf(middle) - endOf(middle - 1)));
    (isOver ? done : next) = middle;
  }
  if (isLast && done == nIncrements) refuseAsOver(stage);
  return done;
}

}  // namespace pd
