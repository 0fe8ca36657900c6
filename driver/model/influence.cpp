#include "influence.hpp"

#include "../deck/function.hpp"
#include "Peridigm_InfluenceFunction.hpp"

namespace pd {

void setInfluenceFunction(const Deck& deck) {
  auto& influence = PeridigmNS::InfluenceFunction::self();
  const DeckNode node = deck["Discretization"]["Influence Function"];
  const std::string text = node ? node.text() : "One";
  if (text == "One" || text == "Parabolic Decay" || text == "Gaussian")
    influence.setInfluenceFunction(text);
  else
    influence.setInfluenceFunction(influenceFunction(text, node.place(), node.isPeridigms()));
}

}  // namespace pd
