#include "error_norms.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "../discretization/node_sets.hpp"
#include "collective.hpp"
#include "solver_sections.hpp"
#include "state_fields.hpp"

namespace pd {

namespace {

std::vector<std::pair<std::string, DeckNode>> namedEntries(const DeckNode& section) {
  if (!section.isSequence()) return section.entries();
  std::vector<std::pair<std::string, DeckNode>> result;
  for (const DeckNode& item : section.items()) result.emplace_back("", item);
  return result;
}

DeckNode needed(const DeckNode& node, const std::string& key) {
  if (!node[key]) throw DeckError(node.place() + ": an exact solution needs the key \"" + key + "\"");
  return node[key];
}

/// Owned points that an entry compares.
std::vector<int> comparedPoints(const DeckNode& entry, const Discretization& mesh) {
  std::vector<int> points;
  if (const DeckNode set = entry["Node Set"]) {
    const std::vector<int>* found = findNodeSet(mesh.nodeSets, set.text());
    if (found == nullptr) throw DeckError(set.place() + ": no node set \"" + set.text() + "\"");
    std::copy_if(found->begin(), found->end(), std::back_inserter(points),
                 [&](int point) { return point < mesh.nOwned; });
  } else {
    points.resize(static_cast<std::size_t>(mesh.nOwned));
    std::iota(points.begin(), points.end(), 0);
  }
  return points;
}

double exactValue(const Function& value, const Discretization& mesh, int point, double t) {
  const auto i = static_cast<std::size_t>(point);
  return value.at(mesh.x.data() + 3 * i, t, mesh.globalIds[i]);
}

/// Throws DeckError with all exact values that are not finite at the end of the run. Collective.
void checkExactSolution(const Deck& deck, const Discretization& mesh, const Communicator& comm) {
  if (!deck["Exact Solution"]) return;
  collectively(comm, [&] {
    Mistakes mistakes;
    for (const auto& [name, node] : namedEntries(deck["Exact Solution"])) try {
        const Function value = Function::fromDeck(needed(node, "Value"));
        for (const int point : comparedPoints(node, mesh)) exactValue(value, mesh, point, finalTime(deck));
      } catch (const DeckError& error) {
        mistakes.add("", error.what());
      }
    mistakes.report();
  });
}

}  // namespace

ErrorNorms::ErrorNorms(const Deck& deck, Model& model) : model_(model) {
  if (!deck["Exact Solution"]) return;
  checkExactSolution(deck, model.discretization(), model.comm());
  collectively(model.comm(), [&] {
    for (const auto& [name, node] : namedEntries(deck["Exact Solution"])) {
      Entry entry;
      entry.field = needed(node, "Field").text();
      if (!model.hasField(entry.field))
        throw DeckError(node["Field"].place() + ": no plug-in, solver or output of this deck uses the field \"" +
                        entry.field + "\"");
      entry.width = model.fieldWidth(entry.field);
      entry.name = name.empty() ? entry.field : name;
      if (entry.width > 1) {
        const std::string letter = needed(node, "Coordinate").text();
        const auto component = std::string("xyz").find(letter);
        if (letter.size() != 1 || component == std::string::npos || static_cast<int>(component) >= entry.width)
          throw DeckError(node["Coordinate"].place() + ": Coordinate is \"" + letter + "\", must be x, y or z");
        entry.component = static_cast<int>(component);
        if (name.empty()) entry.name += " " + letter;
      }
      entry.value = Function::fromDeck(needed(node, "Value"));
      entry.points = comparedPoints(node, model.discretization());
      entries_.push_back(std::move(entry));
    }
  });
}

std::vector<std::pair<std::string, double>> ErrorNorms::evaluate(double t) const {
  std::vector<std::pair<std::string, double>> norms;
  const Discretization& mesh = model_.discretization();
  for (const Entry& entry : entries_) {
    if (isMadeOfState(entry.field)) makeOfState(model_, {entry.field});
    const double* values = model_.field(entry.field);
    std::vector<double> exact;
    double squaredError = 0.0, squaredExact = 0.0, largestError = 0.0, largestExact = 0.0;
    for (const int point : entry.points) {
      exact.push_back(exactValue(entry.value, mesh, point, t));
      largestExact = std::max(largestExact, std::abs(exact.back()));
    }
    largestExact = model_.comm().max(largestExact);
    const double scale = largestExact > 0.0 ? largestExact : 1.0;  // squares stay within the range of a double
    for (std::size_t k = 0; k < exact.size(); ++k) {
      const int point = entry.points[k];
      const double volume = mesh.volume[static_cast<std::size_t>(point)];
      const double error = std::abs(values[entry.width * point + entry.component] - exact[k]);
      squaredError += volume * (error / scale) * (error / scale);
      squaredExact += volume * (exact[k] / scale) * (exact[k] / scale);
      largestError = std::max(largestError, error);
    }
    squaredError = model_.comm().sum(squaredError);
    squaredExact = model_.comm().sum(squaredExact);
    largestError = model_.comm().max(largestError);
    if (largestExact > 0.0) {
      norms.emplace_back(entry.name + " relative L2 error", std::sqrt(squaredError / squaredExact));
      norms.emplace_back(entry.name + " relative maximum error", largestError / largestExact);
    } else {
      norms.emplace_back(entry.name + " absolute L2 error", std::sqrt(squaredError));
      norms.emplace_back(entry.name + " absolute maximum error", largestError);
    }
  }
  return norms;
}

}  // namespace pd
