#include "checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <set>

#include "../model/collective.hpp"
#include "atomic_file.hpp"
#include "bond_order.hpp"
#include "hdf5_file.hpp"
#include "output.hpp"

namespace pd {

using namespace PeridigmNS;

std::string textHash(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL;  // offset and prime of FNV-1a, Fowler, Noll and Vo
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return fmt::format("{:016x}", hash);
}

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

/// Rows of a table that the root rank writes alone.
RowRange rootRows(const Communicator& comm, std::size_t count) {
  const auto rows = static_cast<long long>(count);
  return {0, comm.isRoot() ? rows : 0, rows};
}

RowRange allRows(long long count) { return {0, count, count}; }

bool isSameOnAllRanks(const Communicator& comm, const std::vector<double>& state) {
  const double length = static_cast<double>(state.size());
  if (comm.max(length) != comm.min(length)) return false;
  std::vector<double> ofRoot = state;
  MPI_Bcast(ofRoot.data(), static_cast<int>(ofRoot.size()), MPI_DOUBLE, 0, comm.mpi());
  return !comm.any(!state.empty() && std::memcmp(ofRoot.data(), state.data(), state.size() * sizeof(double)) != 0);
}

void writeSolverState(Hdf5File& file, const Communicator& comm, const std::vector<double>& state) {
  file.makeGroup("solver");
  const int count = static_cast<int>(state.size());
  if (isSameOnAllRanks(comm, state)) {
    file.write("solver/count", std::vector<int>{count}, rootRows(comm, 1), 1);
    file.write("solver/state", state, rootRows(comm, state.size()), 1);
    return;
  }
  file.write("solver/count", std::vector<int>{count}, consecutiveRows(comm, 1), 1);
  file.write("solver/state", state, consecutiveRows(comm, count), 1);
}

std::vector<double> readSolverState(const Hdf5File& file, const Communicator& comm, const std::string& fileName) {
  const long long nStates = file.nRows("solver/count");
  const std::vector<int> counts = file.read<int>("solver/count", allRows(nStates));
  const long long total = file.nRows("solver/state");
  if (nStates == 1) return file.read<double>("solver/state", allRows(total));
  if (nStates != comm.size())
    throw RunError(
        fmt::format("\"{}\" holds the state of a solver on {} ranks, which cannot be handed to {}; restart "
                    "it on {} ranks",
                    fileName, nStates, comm.size(), nStates));
  return file.read<double>("solver/state", consecutiveRows(comm, counts[static_cast<std::size_t>(comm.rank())]));
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
  const std::string table = "points/Model_Coordinates";
  bool isSame = file.has(table) && file.nRows(table) == order.rows().total;
  if (isSame) isSame = file.read<double>(table, order.rows()) == order.toRows(model.field("Model_Coordinates"), 3);
  if (order.comm().any(!isSame)) throw RunError("\"" + fileName + "\" is a checkpoint of another mesh");
}

void readFields(const Hdf5File& file, Model& model, const GlobalOrder& order, const std::string& fileName) {
  const GhostExchange ghosts(model.comm(), model.discretization().globalIds, model.nOwned());
  for (const FieldSpec& spec : pointFields(model)) {
    const std::string table = "points/" + spec.label;
    const int width = widthOf(spec);
    if (!isStored(file, table, width, fileName)) continue;
    double* values = model.field(spec.label);
    order.toPoints(file.read<double>(table, order.rows()), width, values);
    ghosts.import(values, width);
  }
  for (const FieldSpec& spec : globalFields(model)) {
    const std::string table = "globals/" + spec.label;
    if (!file.has(table)) continue;
    const std::vector<double> values = file.read<double>(table, allRows(widthOf(spec)));
    std::copy(values.begin(), values.end(), model.field(spec.label));
  }
  const BondOrder bonds(model, order);
  const bool isSame =
      file.nRows("bonds/neighbor") == bonds.bondRows().total &&
      bonds.isSame(file.read<int>("bonds/count", order.rows()), file.read<int>("bonds/neighbor", bonds.bondRows()));
  if (!isSame)
    throw RunError("\"" + fileName +
                   "\" was written with other neighbourhoods: horizon, influence function or bond filters differ");
  for (const FieldSpec& spec : bondFields(model)) {
    const std::string table = "bonds/" + spec.label;
    if (isStored(file, table, widthOf(spec), fileName))
      bonds.fromRows(file.read<double>(table, bonds.bondRows()), spec.id, widthOf(spec));
  }
}

}  // namespace

void writeCheckpoint(Model& model, const GlobalOrder& order, const std::string& fileName, int step, double time,
                     const std::vector<double>& solverState, const std::string& deckHash) {
  const Communicator& comm = order.comm();
  collectively(comm, [&] {
    if (comm.isRoot()) makeFolderOf(fileName);
  });
  Hdf5File file(unfinishedName(fileName), Hdf5File::Mode::Create, comm);
  file.writeAttribute("/", "step", static_cast<long long>(step));
  file.writeAttribute("/", "time", time);
  file.writeAttribute("/", "deck", deckHash);
  writeFields(file, model, order);
  writeSolverState(file, comm, solverState);
  file.close();
  collectively(comm, [&] {
    if (comm.isRoot()) finishFile(fileName);
  });
}

Checkpoint readCheckpoint(Model& model, const std::string& fileName) {
  const Discretization& points = model.discretization();
  const Hdf5File file(fileName, Hdf5File::Mode::Read, model.comm());
  const GlobalOrder order(model.comm(), points.globalIds, points.nOwned, points.nGlobal);
  requireSameMesh(file, model, order, fileName);
  readFields(file, model, order, fileName);
  model.adoptState();
  Checkpoint checkpoint;
  checkpoint.step = static_cast<int>(file.integerAttribute("/", "step"));
  checkpoint.time = file.realAttribute("/", "time");
  checkpoint.deckHash = file.textAttribute("/", "deck");
  checkpoint.solverState = readSolverState(file, model.comm(), fileName);
  return checkpoint;
}

}  // namespace pd
