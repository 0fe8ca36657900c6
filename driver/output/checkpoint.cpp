#include "checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "../model/collective.hpp"
#include "atomic_file.hpp"
#include "bond_order.hpp"
#include "hdf5_file.hpp"

namespace pd {

using namespace PeridigmNS;

namespace {

/// Fields of these relations that some block has, sorted by label. Every rank knows every block, so all find the same.
std::vector<FieldSpec> storedFields(Model& model, PeridigmField::Relation first, PeridigmField::Relation second) {
  std::set<int> ids;
  for (Block& block : *model.blocks())
    for (const int id : block.getDataManager()->getFieldIds()) ids.insert(id);
  std::vector<FieldSpec> specs;
  for (const int id : ids) {
    const FieldSpec spec = FieldManager::self().getFieldSpec(id);
    if (spec.relation == first || spec.relation == second) specs.push_back(spec);
  }
  std::sort(specs.begin(), specs.end(), [](const FieldSpec& a, const FieldSpec& b) { return a.label < b.label; });
  return specs;
}

std::vector<FieldSpec> pointFields(Model& model) {
  return storedFields(model, PeridigmField::NODE, PeridigmField::ELEMENT);
}
std::vector<FieldSpec> globalFields(Model& model) {
  return storedFields(model, PeridigmField::GLOBAL, PeridigmField::GLOBAL);
}
std::vector<FieldSpec> bondFields(Model& model) {
  return storedFields(model, PeridigmField::BOND, PeridigmField::BOND);
}
int widthOf(const FieldSpec& spec) { return PeridigmField::variableDimension(spec.length); }

/// Which form of checkpoints this is.
constexpr long long form = 2;

/// Rows of a table that the root rank writes alone.
RowRange rootRows(const Communicator& comm, std::size_t count) {
  const auto rows = static_cast<long long>(count);
  return {0, comm.isRoot() ? rows : 0, rows};
}

RowRange allRows(long long count) { return {0, count, count}; }

void writeText(Hdf5File& file, const Communicator& comm, const std::string& name, const std::string& text) {
  file.write(name, comm.isRoot() ? std::vector<char>(text.begin(), text.end()) : std::vector<char>(),
             rootRows(comm, text.size()), 1);
}

std::string readText(const Hdf5File& file, const std::string& name) {
  const std::vector<char> text = file.read<char>(name, allRows(file.nRows(name)));
  return {text.begin(), text.end()};
}

void writeSolverState(Hdf5File& file, const Communicator& comm, const RestartState& state) {
  std::string names;
  std::vector<double> values;
  for (const auto& [name, value] : state.entries()) {
    names += name + "\n";
    if (comm.isRoot()) values.push_back(value);
  }
  file.makeGroup("solver");
  writeText(file, comm, "solver/names", names);
  file.write("solver/state", values, rootRows(comm, state.entries().size()), 1);
}

RestartState readSolverState(const Hdf5File& file, const std::string& fileName) {
  std::istringstream names(readText(file, "solver/names"));
  const std::vector<double> values = file.read<double>("solver/state", allRows(file.nRows("solver/state")));
  RestartState state;
  std::size_t k = 0;
  for (std::string name; std::getline(names, name); ++k)
    if (k < values.size()) state.add(name, values[k]);
  if (k != values.size())
    throw RunError(fmt::format("\"{}\": the solver's state has {} numbers and {} names", fileName, values.size(), k));
  return state;
}

void writeFields(Hdf5File& file, Model& model, const GlobalOrder& order) {
  file.makeGroup("points");
  for (const FieldSpec& spec : pointFields(model)) {
    const int width = widthOf(spec);
    file.write("points/" + spec.label, order.toRows(model.field(spec.label), width), order.rows(), width);
  }
  file.makeGroup("globals");
  for (const FieldSpec& spec : globalFields(model)) {
    const double* values = model.field(spec.label);
    const auto width = static_cast<std::size_t>(widthOf(spec));
    file.write("globals/" + spec.label, std::vector<double>(values, values + width), rootRows(order.comm(), width), 1);
  }
  file.makeGroup("bonds");
  const BondOrder bonds(model, order);
  file.write("bonds/count", bonds.rowCounts(), order.rows(), 1);
  file.write("bonds/neighbor", bonds.neighborRows(), bonds.bondRows(), 1);
  for (const FieldSpec& spec : bondFields(model))
    file.write("bonds/" + spec.label, bonds.toRows(spec.id, widthOf(spec)), bonds.bondRows(), widthOf(spec));
}

/// Whether the checkpoint has the table of a field. Throws RunError where it has another width.
bool isStored(const Hdf5File& file, const std::string& table, int width, const std::string& fileName) {
  if (!file.has(table)) return false;
  if (file.width(table) == width) return true;
  throw RunError(fmt::format("\"{}\" holds {} with {} values a row, this run needs {}", fileName, table,
                             file.width(table), width));
}

void requireSameMesh(const Hdf5File& file, Model& model, const GlobalOrder& order, const std::string& fileName) {
  for (const auto& [label, width] : {std::pair("Model_Coordinates", 3), std::pair("Volume", 1)}) {
    const std::string table = std::string("points/") + label;
    if (!model.hasField(label)) continue;
    if (!file.has(table)) throw RunError("\"" + fileName + "\" is damaged: it lacks " + table);
    bool isSame = file.nRows(table) == order.rows().total;
    if (isSame) isSame = file.read<double>(table, order.rows()) == order.toRows(model.field(label), width);
    if (order.comm().any(!isSame)) throw RunError("\"" + fileName + "\" is a checkpoint of another mesh");
  }
}

void requireSameBonds(const Hdf5File& file, const BondOrder& bonds, const GlobalOrder& order,
                      const std::string& fileName) {
  const bool isSame =
      file.nRows("bonds/neighbor") == bonds.bondRows().total &&
      bonds.isSame(file.read<int>("bonds/count", order.rows()), file.read<int>("bonds/neighbor", bonds.bondRows()));
  if (!isSame)
    throw RunError("\"" + fileName +
                   "\" was written with other neighbourhoods: horizon, influence function, bond filters, Cracks or "
                   "Voids differ");
}

/// What Cracks, Voids and Bond Decomposition of the deck have made of the mesh, which no run changes: what a checkpoint
/// has of it must be that of this run's deck.
void requireSameGeometry(const Hdf5File& file, Model& model, const GlobalOrder& order, const BondOrder& bonds,
                         const std::string& fileName) {
  const auto require = [&](const std::string& table, bool isOurs, const RowRange& range, const auto& ofRun) {
    bool isSame = isOurs == file.has(table);
    if (isSame && isOurs) isSame = file.nRows(table) == range.total && file.width(table) == 1;
    if (order.comm().any(!isSame)) return false;
    if (!isOurs) return true;
    const std::vector<double> stored = file.read<double>(table, range), made = ofRun();
    isSame =
        stored.size() == made.size() && std::equal(stored.begin(), stored.end(), made.begin(), [](double a, double b) {
          return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
        });
    return !order.comm().any(!isSame);
  };
  bool isSame = true;
  for (const std::string label : {"Cell_Volume", "Counted_Bonds"})
    isSame = isSame && require("points/" + label, model.hasField(label), order.rows(),
                               [&] { return order.toRows(model.field(label), 1); });
  const std::vector<FieldSpec> specs = bondFields(model);
  const auto share =
      std::find_if(specs.begin(), specs.end(), [](const FieldSpec& s) { return s.label == "Interaction_Share"; });
  isSame = isSame && require("bonds/Interaction_Share", share != specs.end(), bonds.bondRows(),
                             [&] { return bonds.toRows(share->id, 1); });
  if (!isSame)
    throw RunError("\"" + fileName +
                   "\" was written with other shares of bonds and cells: Cracks, Voids or Bond Decomposition of "
                   "Discretization differ; give those of the deck that wrote it, or begin anew");
}

/// Damage of points and of bonds is a share: what is none was not written by a run.
void requireShares(const std::vector<double>& values, const std::string& label, const GlobalOrder& order,
                   const std::string& fileName) {
  const bool isOfDamage = label == "Damage" || label == "Bond_Damage";
  const bool isGood =
      !isOfDamage || std::all_of(values.begin(), values.end(), [](double v) { return v >= 0.0 && v <= 1.0 + 1e-9; });
  if (order.comm().any(!isGood))
    throw RunError("\"" + fileName + "\" is damaged: it has values of " + label + " that are not from 0 to 1");
}

/// Returns the labels of fields that the file has not.
std::vector<std::string> readFields(const Hdf5File& file, Model& model, const GlobalOrder& order,
                                    const std::string& fileName) {
  const BondOrder bonds(model, order);
  requireSameBonds(file, bonds, order, fileName);
  requireSameGeometry(file, model, order, bonds, fileName);
  std::vector<std::string> missing;
  const auto isThere = [&](const std::string& group, const FieldSpec& spec, int width) {
    const bool isIt = isStored(file, group + spec.label, width, fileName);
    if (!isIt) missing.push_back(spec.label);
    return isIt;
  };
  for (const FieldSpec& spec : pointFields(model)) {
    const int width = widthOf(spec);
    if (!isThere("points/", spec, width)) continue;
    double* values = model.field(spec.label);
    const std::vector<double> rows = file.read<double>("points/" + spec.label, order.rows());
    requireShares(rows, spec.label, order, fileName);
    order.toPoints(rows, width, values);
    model.exchange().import(values, width, model.reflectionOf(spec.label));
  }
  for (const FieldSpec& spec : globalFields(model)) {
    if (!isThere("globals/", spec, 1)) continue;
    const std::vector<double> values = file.read<double>("globals/" + spec.label, allRows(widthOf(spec)));
    std::copy(values.begin(), values.end(), model.field(spec.label));
  }
  for (const FieldSpec& spec : bondFields(model)) {
    if (!isThere("bonds/", spec, widthOf(spec))) continue;
    const std::vector<double> rows = file.read<double>("bonds/" + spec.label, bonds.bondRows());
    requireShares(rows, spec.label, order, fileName);
    bonds.fromRows(rows, spec.id, widthOf(spec));
  }
  return missing;
}

}  // namespace

void writeCheckpoint(Model& model, const GlobalOrder& order, const std::string& fileName,
                     const Checkpoint& checkpoint) {
  const Communicator& comm = order.comm();
  collectively(comm, [&] {
    if (comm.isRoot()) makeFolderOf(fileName);
  });
  Hdf5File file(unfinishedName(fileName), Hdf5File::Mode::CreateChecked, comm);
  file.writeAttribute("/", "checkpoint", form);
  file.writeAttribute("/", "step", static_cast<long long>(checkpoint.step));
  file.writeAttribute("/", "time", checkpoint.time);
  file.writeAttribute("/", "solver", checkpoint.solver);
  writeText(file, comm, "deck", checkpoint.deck);
  writeFields(file, model, order);
  writeSolverState(file, comm, checkpoint.state);
  file.close();
  collectively(comm, [&] {
    if (comm.isRoot()) finishFile(fileName);
  });
}

Checkpoint readCheckpoint(Model& model, const std::string& fileName) {
  const Discretization& points = model.discretization();
  const Hdf5File file(fileName, Hdf5File::Mode::Read, model.comm());
  if (!file.hasAttribute("/", "checkpoint") || file.integerAttribute("/", "checkpoint") != form)
    throw RunError("\"" + fileName + "\" is no checkpoint, or one of another version of pdrun");
  const GlobalOrder order(model.comm(), points.globalIds, points.nOwned, points.nGlobal);
  Checkpoint checkpoint;
  checkpoint.step = static_cast<int>(file.integerAttribute("/", "step"));
  checkpoint.time = file.realAttribute("/", "time");
  checkpoint.solver = file.textAttribute("/", "solver");
  if (checkpoint.step < 0 || !std::isfinite(checkpoint.time))
    throw RunError(
        fmt::format("\"{}\" is damaged: it is of step {} and t = {}", fileName, checkpoint.step, checkpoint.time));
  checkpoint.deck = readText(file, "deck");
  checkpoint.state = readSolverState(file, fileName);
  requireSameMesh(file, model, order, fileName);
  checkpoint.missingFields = readFields(file, model, order, fileName);
  model.adoptState();
  return checkpoint;
}

}  // namespace pd
