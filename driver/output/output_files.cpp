#include "output_files.hpp"

#include <algorithm>

#include "../model/collective.hpp"
#include "result_files.hpp"

namespace pd {

namespace {

void addOnce(std::vector<std::string>& labels, const std::string& label) {
  if (std::find(labels.begin(), labels.end(), label) == labels.end()) labels.push_back(label);
}

}  // namespace

void OutputFiles::add(const OutputSection& section, const OutputLabels& labels) {
  parts_.push_back({section, labels});
  for (const std::string& label : labels.global) addColumn(label);
}

void OutputFiles::addColumn(const std::string& label) { addOnce(columns_, label); }

bool OutputFiles::hasColumn(const std::string& label) const {
  return std::find(columns_.begin(), columns_.end(), label) != columns_.end();
}

void OutputFiles::startSolver() {
  for (Part& part : parts_) part.section.startSolver();
}

bool OutputFiles::areFieldsDue(int step, bool isLast) const {
  return std::any_of(parts_.begin(), parts_.end(), [&](const Part& part) {
    return !part.labels.point.empty() && part.section.areFieldsDue(step, isLast);
  });
}

bool OutputFiles::isHistoryDue(int step, bool isLast) const {
  return !columns_.empty() && std::any_of(parts_.begin(), parts_.end(),
                                          [&](const Part& part) { return part.section.isHistoryDue(step, isLast); });
}

bool OutputFiles::isCheckpointDue(int step, bool isLast) const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [&](const Part& part) { return part.section.isCheckpointDue(step, isLast); });
}

bool OutputFiles::writesFields() const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [](const Part& part) { return !part.labels.point.empty() && part.section.writesFields(); });
}

void OutputFiles::open(Model& model, const GlobalOrder& order, int firstStep, const std::string& timeUnit) {
  const Discretization& points = model.discretization();
  if (writesFields())
    fields_ = std::make_unique<FieldWriter>(fileName_, order, points.x.data(), points.blockId.data(),
                                            points.volume.data(), firstStep);
  if (columns_.empty()) return;
  collectively(model.comm(), [&] {
    if (!model.comm().isRoot()) return;
    std::vector<std::string> names, units;
    for (const std::string& label : columns_)
      for (const std::string& name : columnNames(label, model.fieldWidth(label))) {
        names.push_back(name);
        units.push_back(fields::unitOf(label));
      }
    writeColumnUnits(fileName_, names, units, timeUnit);  // first: by it the history is known to be ours
    history_ = std::make_unique<History>(fileName_ + endings::history, names, firstStep);
  });
}

void OutputFiles::write(Model& model, int step, double time, bool isLast) {
  if (isHistoryDue(step, isLast)) writeHistory(model, step, time);
  if (areFieldsDue(step, isLast)) writeFields(model, step, time, isLast);
}

void OutputFiles::writeFields(Model& model, int step, double time, bool isLast) {
  std::vector<std::string> labels;
  for (const Part& part : parts_)
    if (part.section.areFieldsDue(step, isLast))
      for (const std::string& label : part.labels.point) addOnce(labels, label);
  const std::vector<double> rank(static_cast<std::size_t>(model.nOwned()), model.comm().rank());
  std::vector<PointField> fields;
  for (const std::string& label : labels) {
    if (model.hasField(label))
      fields.push_back({label, model.fieldWidth(label), model.field(label), fields::unitOf(label)});
    else
      fields.push_back({label, 1, rank.data(), "1"});  // Proc_Num, which no plug-in holds
  }
  fields_->write(step, time, fields);
}

void OutputFiles::writeHistory(Model& model, int step, double time) {
  collectively(model.comm(), [&] {
    if (!model.comm().isRoot()) return;
    std::vector<double> values;
    for (const std::string& label : columns_) {
      const double* value = model.field(label);
      values.insert(values.end(), value, value + model.fieldWidth(label));
    }
    history_->row(step, time, values);
  });
}

}  // namespace pd
