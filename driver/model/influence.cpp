#include "influence.hpp"

#include <muParser.h>

#include <cmath>
#include <memory>

#include "Peridigm_InfluenceFunction.hpp"

namespace pd {

namespace {

struct Expression {
  mu::Parser parser;
  double zeta = 0.0, horizon = 1.0;

  explicit Expression(const std::string& text) {
    parser.DefineVar("zeta", &zeta);
    parser.DefineVar("horizon", &horizon);
    parser.SetExpr(text);
  }
  double operator()(double bondLength, double reach) {
    zeta = bondLength;
    horizon = reach;
    return parser.Eval();
  }
};

}  // namespace

void setInfluenceFunction(const Deck& deck) {
  auto& influence = PeridigmNS::InfluenceFunction::self();
  const DeckNode node = deck["Discretization"]["Influence Function"];
  const std::string text = node ? node.text() : "One";
  if (text == "One" || text == "Parabolic Decay" || text == "Gaussian") {
    influence.setInfluenceFunction(text);
    return;
  }
  const auto complain = [&](const std::string& why) {
    throw DeckError(node.place() + ": \"" + text + "\" is no influence function: " + why +
                    " (allowed: One, Parabolic Decay, Gaussian, or an expression in zeta and horizon such as "
                    "\"1 - zeta/horizon\")");
  };
  try {
    const auto expression = std::make_shared<Expression>(text);
    if (!std::isfinite((*expression)(0.5, 1.0))) complain("its value at zeta = horizon/2 is not finite");
    influence.setInfluenceFunction([expression](double zeta, double horizon) { return (*expression)(zeta, horizon); });
  } catch (const mu::ParserError& error) {
    complain(error.GetMsg());
  }
}

}  // namespace pd
