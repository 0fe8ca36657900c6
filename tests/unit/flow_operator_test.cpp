// Rows of operators of a flow that share their weights.
#include "driver/solvers/flow/flow_operator.hpp"

#include <gtest/gtest.h>

#include <map>

namespace pd {
namespace {

using Row = std::map<int, std::array<double, 3>>;

Row rowOf(const FlowOperator<3>& rows, std::size_t r) {
  Row found;
  rows.forEach(r, [&](const auto& term) { found[term.point] = term.weights; });
  return found;
}

/// Weights of both neighbours of a point on a line, of which the right one has `right`.
void addRow(FlowOperator<3>& rows, int point, double right) {
  rows.add(point + 1, {right, 0.0, 0.25});
  rows.add(point - 1, {-0.5, 0.0, 0.25});
  rows.add(point + 1, {0.0, 1.0, 0.0});  // terms of one point add up
  rows.close(point, {static_cast<double>(point), 0.0, 0.0});
}

TEST(FlowOperatorTest, EqualRowsShareAStencil) {
  FlowOperator<3> rows;
  const double rounded = 0.5 * (1.0 + 1e-15), other = 0.5 * (1.0 + 1e-9);
  const std::vector<double> right{0.5, rounded, other, 0.5, -0.5};
  for (std::size_t r = 0; r < right.size(); ++r) addRow(rows, 10 * static_cast<int>(r) + 5, right[r]);
  rows.repeat(2, 95);
  rows.finish();
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows.nStencils(), 3U);
  for (std::size_t r = 0; r < right.size(); ++r) {
    const int point = 10 * static_cast<int>(r) + 5;
    const double expected = r == 1 ? 0.5 : right[r];  // that of the first of equal rows
    EXPECT_EQ(rowOf(rows, r), (Row{{point - 1, {-0.5, 0.0, 0.25}}, {point + 1, {expected, 1.0, 0.25}}}));
    EXPECT_EQ(rows.constants[r][0], point);
  }
  EXPECT_EQ(rowOf(rows, 5), (Row{{94, {-0.5, 0.0, 0.25}}, {96, {other, 1.0, 0.25}}}));
  EXPECT_EQ(rows.constants[5][0], 0.0);
}

TEST(FlowOperatorTest, TheSameWeightsAtOtherOffsetsAreAnotherStencil) {
  FlowOperator<1> rows;
  for (const int offset : {1, 2}) {
    rows.add(10 + offset, {1.0});
    rows.add(10, {-1.0});
    rows.close(10, {0.0});
  }
  EXPECT_EQ(rows.nStencils(), 2U);
  EXPECT_EQ(rows.row(1).pointOf(1), 12);
}

TEST(FlowOperatorTest, NineWeightsAreStoredAsOneOrThreeWhereTheyMayBe) {
  FlowOperator<9> rows;
  rows.add(1, {2.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 2.0});
  rows.close(0, {});
  rows.add(2, {1.0, 2.0, 3.0, 1.0, 2.0, 3.0, 1.0, 2.0, 3.0});
  rows.close(1, {});
  rows.add(3, {1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0});
  rows.close(2, {});
  using Form = FlowOperator<9>::Form;
  const std::array<Form, 3> forms{Form::Identity, Form::SameRows, Form::Whole};
  for (std::size_t r = 0; r < 3; ++r) EXPECT_EQ(rows.row(r).form, forms[r]);
  rows.forEach(1, [](const auto& term) { EXPECT_EQ(term.weights[7], 2.0); });
  rows.forEach(2, [](const auto& term) { EXPECT_EQ(term.weights[4], -1.0); });
}

TEST(FlowOperatorTest, RowsAreTakenOverFromAnEarlierOperator) {
  FlowOperator<3> earlier, rows;
  for (const int point : {5, 15, 25}) addRow(earlier, point, point == 15 ? 0.75 : 0.5);
  earlier.finish();
  rows.takeStencils(earlier);
  rows.keep(earlier, 0, 5);
  addRow(rows, 10, 2.0);
  rows.keep(earlier, 1, 15);
  rows.finish();
  ASSERT_EQ(rows.size(), 3U);
  const std::vector<std::pair<int, double>> expected{{5, 0.5}, {10, 2.0}, {15, 0.75}};
  for (std::size_t r = 0; r < expected.size(); ++r) {
    const auto [point, right] = expected[r];
    EXPECT_EQ(rowOf(rows, r), (Row{{point - 1, {-0.5, 0.0, 0.25}}, {point + 1, {right, 1.0, 0.25}}}));
    EXPECT_EQ(rows.constants[r][0], point);
  }
}

}  // namespace
}  // namespace pd
