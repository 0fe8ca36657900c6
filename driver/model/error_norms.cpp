#include "error_norms.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "collective.hpp"
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

}  // namespace

ErrorNorms::ErrorNorms(const Deck& deck, Model& model) : model_(model) {
  if (!deck["Exact Solution"]) return;
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
      if (const DeckNode set = node["Node Set"]) {
        const auto found = model.discretization().nodeSets.find(set.text());
        if (found == model.discretization().nodeSets.end())
          throw DeckError(set.place() + ": no node set \"" + set.text() + "\"");
        std::copy_if(found->second.begin(), found->second.end(), std::back_inserter(entry.points),
                     [&](int point) { return point < model.nOwned(); });
      } else {
        entry.points.resize(static_cast<std::size_t>(model.nOwned()));
        std::iota(entry.points.begin(), entry.points.end(), 0);
      }
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
    double squaredError = 0.0, squaredExact = 0.0, largestError = 0.0, largestExact = 0.0;
    for (const int point : entry.points) {
      const double* x = mesh.x.data() + 3 * static_cast<std::size_t>(point);
      const double volume = mesh.volume[static_cast<std::size_t>(point)];
      const double exact = entry.value(x[0], x[1], x[2], t);
      const double error = std::abs(values[entry.width * point + entry.component] - exact);
      squaredError += volume * error * error;
      squaredExact += volume * exact * exact;
      largestError = std::max(largestError, error);
      largestExact = std::max(largestExact, std::abs(exact));
    }
    squaredError = model_.comm().sum(squaredError);
    squaredExact = model_.comm().sum(squaredExact);
    largestError = model_.comm().max(largestError);
    largestExact = model_.comm().max(largestExact);
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
