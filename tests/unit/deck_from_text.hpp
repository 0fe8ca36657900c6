// Decks for tests, written as text.
#ifndef PD_DECK_FROM_TEXT_HPP
#define PD_DECK_FROM_TEXT_HPP

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "driver/deck/deck.hpp"

namespace pd {

/// "Suite.Test.yaml" in the working folder: tests that run side by side do not meet.
inline std::string deckFileName() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  return std::string(test->test_suite_name()) + "." + test->name() + ".yaml";
}

inline Deck deckFromText(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const std::string fileName = deckFileName();
  std::ofstream(fileName, std::ios::binary) << text;
  return Deck::read(fileName, overrides);
}

/// What the DeckError says that `work` throws; empty where it throws none. The name of the test's deck is cut down to
/// "deck".
template <class Work>
std::string complaintOf(const Work& work) {
  std::string message;
  try {
    work();
  } catch (const DeckError& error) {
    message = error.what();
  }
  const std::string name = deckFileName();
  for (std::size_t at = message.find(name); at != std::string::npos; at = message.find(name, at))
    message.replace(at, name.size(), "deck");
  return message;
}

}  // namespace pd

#endif
