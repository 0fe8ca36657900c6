// Numbers with units, and products, in decks.
#include "driver/deck/quantity.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "driver/deck/units.hpp"

namespace pd {
namespace {

std::optional<double> read(const std::string& text, const std::string& unit) {
  std::string complaint;
  return readQuantity(text, unit, MinusSign::AfterPower, complaint);
}

std::string complaintAbout(const std::string& text, const std::string& unit) {
  std::string complaint;
  EXPECT_FALSE(readQuantity(text, unit, MinusSign::AfterPower, complaint)) << text;
  return complaint;
}

TEST(Quantity, IsTheNumberThatIsMeantToTheLastBit) {
  const struct {
    const char *text, *unit;
    double value;
  } rows[] = {{"3 GPa", "Pa", 3.0e9},
              {"3GPa", "Pa", 3.0e9},
              {"0.3 mm", "m", 0.0003},
              {"0.7e-3 mm", "m", 0.7e-6},
              {"-2.5 um", "m", -2.5e-6},
              {"2 \u00b5m", "m", 2.0e-6},
              {"2 \u03bcm", "m", 2.0e-6},
              {"1 h", "s", 3600.0},
              {"1.5 d", "s", 129600.0},
              {"30 min", "s", 1800.0},
              {"2*3600", "s", 7200.0},
              {"2*3600", "1", 7200.0},
              {"2*24 h", "s", 172800.0},
              {"(1 + 2)*4", "1", 12.0},
              {"1/3 m", "m", 1.0 / 3.0},
              {"50 kJ/m^2", "J/m2", 5.0e4},
              {"50 kJ/m\u00b2", "J/m2", 5.0e4},
              {"0.3 N/mm", "J/m2", 300.0},
              {"7.85 g/cm^3", "kg/m3", 7850.0},
              {"7.85e-9 Mg/mm3", "kg/m3", 7850.0},
              {"8.6e-6 cm2/s", "m2/s", 8.6e-10},
              {"4.6 mol/L", "mol/m3", 4600.0},
              {"5 mA/cm2", "A/m2", 50.0},
              {"26.98 g/mol", "kg/mol", 0.02698},
              {"5 1/s", "1/s", 5.0},
              {"5 /s", "1/s", 5.0},
              {"5 kHz", "1/s", 5000.0},
              {"90 deg", "degrees", 90.0},
              {"1 bar", "Pa", 1.0e5},
              {"1 in", "m", 0.0254}};
  for (const auto& row : rows) EXPECT_EQ(read(row.text, row.unit), row.value) << row.text;
  EXPECT_DOUBLE_EQ(read("36 km/h", "m/s").value(), 10.0);
  EXPECT_DOUBLE_EQ(read("1 ksi", "Pa").value(), 6894757.293168361);
  EXPECT_DOUBLE_EQ(read("pi rad", "degrees").value(), 180.0);
  EXPECT_DOUBLE_EQ(read("2 W/(m2 K)", "kg/(s3 K)").value(), 2.0);
  EXPECT_DOUBLE_EQ(read("sqrt(2)*1 mm", "m").value(), 1.4142135623730951e-3);
}

TEST(Quantity, NamesBothUnitsThatDoNotFit) {
  EXPECT_EQ(complaintAbout("3 GPa", "kg/m3"), "GPa does not convert to kg/m3");
  EXPECT_EQ(complaintAbout("3 Gpa", "Pa"), "there is no unit \"Gpa\" (did you mean \"GPa\"?); it is in Pa");
  EXPECT_EQ(complaintAbout("3 furlong", "m"), "there is no unit \"furlong\"; it is in m");
  EXPECT_EQ(complaintAbout("3 m", "1"), "it takes a number without a unit");
  EXPECT_EQ(complaintAbout("25 \u00b0C", "K"), "degrees Celsius start elsewhere than K; write K");
  EXPECT_EQ(complaintAbout("3 m/", "m"), "\"m/\" is no unit; it is in m");
  EXPECT_EQ(complaintAbout("3 m", "unit of the field"),
            "it takes no unit, since its own (unit of the field) depends on the rest of the deck");
  EXPECT_EQ(complaintAbout("1e300*1e300", "1"), "its value is not finite");
  EXPECT_EQ(complaintAbout("1/0 s", "s"), "its value is not finite");
  EXPECT_EQ(complaintAbout("1e300 Tm", "m"), "its value is not finite");
}

TEST(Quantity, LeavesAloneWhatIsNoNumber) {
  for (const char* text : {"", " ", "x", "2*x", "3 + t", "Verlet", "block_1", "nan", "inf", "-", "{", "\"3\"", "3 %",
                           "x < 2", "2*(x + 1)"}) {
    EXPECT_FALSE(read(text, "m")) << text;
    EXPECT_EQ(complaintAbout(text, "m"), "") << text;
    EXPECT_FALSE(hasUnit(text)) << text;
  }
  EXPECT_TRUE(hasUnit("3 x"));
  for (const char* text : {"m^", "m10", "(m", "m)", "m//s", "*m", "((((((((((m))))))))))", "m^-", "1.5"})
    EXPECT_FALSE(parseUnit(text)) << text;
}

}  // namespace
}  // namespace pd
