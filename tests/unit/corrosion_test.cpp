// Current density of a dissolving metal, and the constant of bonds between solid and liquid points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "../../materials/corrosion/acidity.hpp"
#include "../../materials/corrosion/current_density.hpp"
#include "bond_constants.hpp"

namespace pd {
namespace {

constexpr double pi = 3.14159265358979323846;
// Alloy 625 in its crevice solution: log10 of i in A/cm2, i here in A/m2.
const std::string alloyCurrent = "1.0e4*pow(10, 1.151*exp(-0.723*pH) - 7.647)";
const std::string alloyPh = "7.405*exp(-0.08036*C) - 6.498";
constexpr double alloySaturation = 5600.0;  // mol/m3

double exactPh(double molar) { return 7.405 * std::exp(-0.08036 * molar) - 6.498; }
double exactCurrent(double molar) { return 1.0e4 * std::pow(10.0, 1.151 * std::exp(-0.723 * exactPh(molar)) - 7.647); }

CurrentDensity fromList(const Teuchos::ParameterList& given, double saturation) {
  ParameterDeclarations declarations;
  CurrentDensity::declareParameters(declarations);
  return CurrentDensity(declarations.complete(given, "a test"), saturation, "a test");
}

CurrentDensity fromText(const std::string& current, const std::string& ph, double saturation) {
  Teuchos::ParameterList list;
  list.set("Current Density", current);
  if (!ph.empty()) list.set("pH", ph);
  return fromList(list, saturation);
}

TEST(CurrentDensityTest, IsTheTableOfAlloy625) {
  const CurrentDensity current = fromText(alloyCurrent, alloyPh, alloySaturation);
  const CurrentDensity shiftedPh = fromText("pH + 10.0", alloyPh, alloySaturation);
  const struct {
    double molar, ph, current;
  } rows[] = {{0.0, 0.907, 8.92e-4},  {1.0, 0.335, 1.80e-3}, {2.0, -0.192, 4.74e-3}, {3.0, -0.679, 1.714e-2},
              {4.0, -1.129, 9.03e-2}, {5.0, -1.543, 0.734},  {5.5, -1.738, 2.50},    {5.6, -1.776, 3.242}};
  for (const auto& row : rows) {
    EXPECT_NEAR(shiftedPh.at(1000.0 * row.molar).current - 10.0, row.ph, 0.6e-3) << row.molar;
    // The table has three digits.
    EXPECT_NEAR(current.at(1000.0 * row.molar).current / row.current, 1.0, 3e-3) << row.molar;
  }
}

TEST(CurrentDensityTest, IsTheFormulaBetweenSamples) {
  const CurrentDensity current = fromText(alloyCurrent, alloyPh, alloySaturation);
  for (int k = 0; k <= 7001; ++k) {
    const double molar = 5.6 * k / 7001.0;
    ASSERT_NEAR(current.at(1000.0 * molar).current / exactCurrent(molar), 1.0, 1e-7) << molar;
  }
}

TEST(AcidityTest, IsTheFormulaUpToSaturation) {
  Teuchos::ParameterList list;
  EXPECT_FALSE(Acidity(list, alloySaturation, "a test").isGiven());
  list.set("pH", alloyPh);
  const Acidity acidity(list, alloySaturation, "a test");
  ASSERT_TRUE(acidity.isGiven());
  for (int k = 0; k <= 701; ++k) {
    const double molar = 5.6 * k / 701.0;
    ASSERT_NEAR(acidity.at(1000.0 * molar), exactPh(molar), 1e-10) << molar;
  }
  EXPECT_NEAR(acidity.at(-100.0), exactPh(0.0), 1e-12);
  EXPECT_NEAR(acidity.at(9000.0), exactPh(5.6), 1e-12);
  list.set<std::string>("pH", "log(C)");
  EXPECT_THROW(Acidity(list, alloySaturation, "a test"), std::invalid_argument);
}

TEST(CurrentDensityTest, SlopeIsThatOfTheCurrent) {
  const CurrentDensity smooth = fromText(alloyCurrent, alloyPh, alloySaturation);
  const CurrentDensity signless = fromText("2.0 - C + 0.25*C*C", "", 2000.0);  // zero at 2 mol/L
  Teuchos::ParameterList list;
  list.set("Current Density Table", Teuchos::Array<double>(Teuchos::tuple(0.0, 3.0, 1000.0, 5.0, 2000.0, 1.0)));
  const CurrentDensity table = fromList(list, 2000.0);
  for (const double c : {1.0, 333.3, 777.7, 1234.5, 1999.0})
    for (const CurrentDensity* current : {&smooth, &signless, &table}) {
      const double h = 1e-2;
      const double difference = (current->at(c + h).current - current->at(c - h).current) / (2.0 * h);
      EXPECT_NEAR(current->at(c).slope, difference, 1e-5 * std::abs(difference) + 1e-12) << c;
    }
}

TEST(CurrentDensityTest, TableIsLinearBetweenItsPairs) {
  Teuchos::ParameterList list;
  list.set("Current Density Table", Teuchos::Array<double>(Teuchos::tuple(500.0, 3.0, 1000.0, 5.0, 2000.0, 1.0)));
  const CurrentDensity table = fromList(list, 3000.0);
  EXPECT_DOUBLE_EQ(table.at(750.0).current, 4.0);
  EXPECT_DOUBLE_EQ(table.at(1500.0).current, 3.0);
  for (const double outside : {0.0, 499.0}) EXPECT_DOUBLE_EQ(table.at(outside).current, 3.0);
  EXPECT_DOUBLE_EQ(table.at(2500.0).current, 1.0);
  EXPECT_DOUBLE_EQ(table.at(2500.0).slope, 0.0);
}

TEST(CurrentDensityTest, EndsAtTheEndsOfItsRange) {
  const CurrentDensity current = fromText(alloyCurrent, alloyPh, alloySaturation);
  EXPECT_DOUBLE_EQ(current.at(-100.0).current, current.at(0.0).current);
  EXPECT_DOUBLE_EQ(current.at(1e6).current, current.at(alloySaturation).current);
  EXPECT_DOUBLE_EQ(current.at(-100.0).slope, 0.0);
  EXPECT_DOUBLE_EQ(current.at(1e6).slope, 0.0);
}

TEST(CurrentDensityTest, SpansManyDecades) {
  // 1e-6 to 1e3 A/m2.
  const CurrentDensity current = fromText("pow(10.0, -6.0 + 9.0*C/5.6)", "", alloySaturation);
  for (int k = 0; k <= 5600; ++k)
    ASSERT_NEAR(current.at(k).current / std::pow(10.0, -6.0 + 9.0 * k / 5600.0), 1.0, 1e-9) << k;
}

std::string refusalOf(const std::string& current, double saturation) {
  try {
    fromText(current, "", saturation);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(CurrentDensityTest, MayEndAtSaturation) {
  // To the last bit, with saturations that are no binary fractions of mol/L.
  for (const char* end : {"4.0", "3.6", "5.6", "4.7", "0.1"}) {
    const CurrentDensity current = fromText(std::string("5.1e3*sqrt(1 - C/") + end + ")", "", 1000.0 * std::stod(end));
    const double saturation = std::stod(end);
    EXPECT_EQ(current.at(1000.0 * saturation).current, 0.0) << end;
    for (int k = 0; k < 99; ++k)  // the root is steep at the very end
      EXPECT_NEAR(current.at(10.0 * k * saturation).current, 5.1e3 * std::sqrt(1.0 - k / 100.0), 1e-3) << end;
  }
  EXPECT_EQ(
      refusalOf("5.1e3*sqrt(1 - C/4.0)", 4600.0),
      "a test: \"5.1e3*sqrt(1 - C/4.0)\" is not a number at C = 4.00085 mol/L; it must have a value from C = 0 to "
      "saturation");
}

TEST(CurrentDensityTest, TakesTheProgramsOfPeridigmWithoutLoopsAndFiles) {
  const CurrentDensity current =
      fromText("double limit = 2.0; if (C < limit) { value = 1.0 + C; } else { value = 3.0; }", "", 4000.0);
  EXPECT_NEAR(current.at(1000.0).current, 2.0, 1e-12);
  EXPECT_NEAR(current.at(3000.0).current, 3.0, 1e-12);
  EXPECT_NE(refusalOf("while (value < 2) { value = C; }", 4000.0).find("loops are not allowed"), std::string::npos);
  EXPECT_NE(refusalOf("readline(\"/etc/hostname\", C)", 4000.0).find("quotes"), std::string::npos);
  EXPECT_NE(refusalOf("printf(C)", 4000.0).find("unknown name \"printf\""), std::string::npos);
  EXPECT_NE(refusalOf("1..2", 4000.0), "");
  // In one convention 1, in the other -1.
  EXPECT_NE(refusalOf("2 + -C^2", 1000.0).find("write the parentheses. They differ at C = "), std::string::npos);
  EXPECT_NEAR(fromText("2 + -(C^2)", "", 1000.0).at(1000.0).current, 1.0, 1e-12);
}

TEST(CurrentDensityTest, RefusesWhatIsNoCurrentDensity) {
  EXPECT_THROW(fromText("C +", "", 1000.0), std::invalid_argument);
  EXPECT_THROW(fromText("pH", "", 1000.0), std::invalid_argument);
  EXPECT_THROW(fromText("C - 0.5", "", 1000.0), std::invalid_argument);
  EXPECT_THROW(fromText("1.0/C", "", 1000.0), std::invalid_argument);
  EXPECT_THROW(fromText("exp(1000.0*C)", "", 1000.0), std::invalid_argument);
  for (const auto& numbers :
       {Teuchos::Array<double>(Teuchos::tuple(0.0, 1.0)), Teuchos::Array<double>(Teuchos::tuple(0.0, 1.0, 2.0)),
        Teuchos::Array<double>(Teuchos::tuple(1.0, 1.0, 1.0, 2.0)),
        Teuchos::Array<double>(Teuchos::tuple(0.0, 1.0, 1.0, -2.0))}) {
    Teuchos::ParameterList list;
    list.set("Current Density Table", numbers);
    EXPECT_THROW(fromList(list, 1000.0), std::invalid_argument) << numbers;
  }
  EXPECT_THROW(fromList(Teuchos::ParameterList(), 1000.0), std::invalid_argument);
}

namespace k = kernels;

TEST(InterfaceFluxTest, ContinuumConstantPassesTheFlux) {
  // Integral of c/r x over the half neighbourhood x > 0.
  const double horizon = 3.0, area = 0.7, thickness = 0.4;
  EXPECT_NEAR(k::interfaceFluxConstant({k::Geometry::Bar, area}, horizon) * area * horizon, 1.0, 1e-14);
  EXPECT_NEAR(k::interfaceFluxConstant({k::Geometry::PlaneStrain, thickness}, horizon) * thickness * horizon * horizon,
              1.0, 1e-14);
  EXPECT_NEAR(k::interfaceFluxConstant({k::Geometry::Solid, 1.0}, horizon) * pi * std::pow(horizon, 3) / 3.0, 1.0,
              1e-14);
}

}  // namespace
}  // namespace pd
