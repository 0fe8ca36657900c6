#include "fitted_deck.hpp"

#include <filesystem>
#include <functional>

#include "../deck/deck.hpp"
#include "../deck/deck_data.hpp"
#include "../deck/sections.hpp"
#include "deck_of_run.hpp"

namespace pd {

namespace {

/// Calls visit(value, path of the file) for each text of a deck that names a file.
void forEachFile(const Deck& deck, const std::function<void(const DeckNode&, const std::string&)>& visit) {
  const std::function<void(const DeckNode&)> walk = [&](const DeckNode& node) {
    for (const auto& entry : node.entries()) walk(entry.second);
    for (const DeckNode& item : node.items()) walk(item);
    if (!node.isScalar() || node.text().empty() || parseReal(node.text())) return;
    std::error_code error;
    const std::string path = deck.resolvePath(node.text());
    if (std::filesystem::is_regular_file(path, error)) visit(node, path);
  };
  walk(deck.root());
}

}  // namespace

std::vector<std::string> filesOf(const std::string& deckFile, const std::vector<StudyOverride>& overrides) {
  std::vector<std::string> files{deckFile};
  forEachFile(Deck::read(deckFile, textsOf(overrides)),
              [&](const DeckNode&, const std::string& path) { files.push_back(path); });
  return files;
}

std::string fittedDeck(const Fit& fit, const FittedDeck& fitted, const std::vector<double>& values,
                       const std::string& path, const std::string& outputName) {
  namespace fs = std::filesystem;
  std::vector<std::string> overrides = textsOf(overridesWith(fitted.overrides, fit.values, values));
  overrides.push_back("Output/Output Filename=\"" + outputName + "\"");
  const Deck deck = Deck::read(fitted.deckFile, overrides);
  checkDeck(deck);
  deck.mistakes().report();
  const fs::path folder = fs::absolute(path).parent_path();
  forEachFile(deck, [&](const DeckNode& node, const std::string& file) {
    node.becomes(fs::absolute(file).lexically_proximate(folder).lexically_normal().string());
  });
  std::string text = "# Fitted by pdrun --fit " + fit.fileName + ":\n";
  for (std::size_t i = 0; i < values.size(); ++i)
    text += "#   " + fit.values[i].name + ": " + realText(values[i]) +
            (fit.values[i].unit.empty() ? "" : " " + fit.values[i].unit) + "\n";
  return text + resolvedDeck(deck);
}

}  // namespace pd
