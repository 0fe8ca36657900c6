// What a run writes besides its field files: histories, log, progress, report.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "../expect_error.hpp"
#include "../test_folder.hpp"
#include "driver/output/history.hpp"
#include "driver/output/progress.hpp"
#include "driver/output/report.hpp"
#include "driver/output/run_log.hpp"
#include "driver/output/xdmf_writer.hpp"

namespace pd::test {
namespace {

TEST(Xdmf, NamesAreEscaped) {
  XdmfWriter writer("a&b.steps/mesh.h5", 5);
  writer.addStep(0.25, "a&b.steps/000001.h5", {{"Stress<\"xx\">", 9}});
  const std::string text = writer.text();
  EXPECT_CONTAINS(text, "<Time Value=\"0.25\"/>");
  EXPECT_CONTAINS(text, "Name=\"Stress&lt;&quot;xx&quot;>\" AttributeType=\"Tensor\"");
  EXPECT_CONTAINS(text, ">a&amp;b.steps/000001.h5:/Stress&lt;");
  EXPECT_CONTAINS(text, "Dimensions=\"5 9\"");
}

TEST(HistoryFile, ComponentsHaveTheNamesOfPeridigm) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(columnNames("Energy", 1), Names{"Energy"});
  EXPECT_EQ(columnNames("Force", 3), (Names{"ForceX", "ForceY", "ForceZ"}));
  EXPECT_EQ(columnNames("Stress", 9), (Names{"StressXX", "StressXY", "StressXZ", "StressYX", "StressYY", "StressYZ",
                                             "StressZX", "StressZY", "StressZZ"}));
  EXPECT_EQ(columnNames("Pair", 2), (Names{"Pair_1", "Pair_2"}));
}

TEST(HistoryFile, EachRowIsOnDiskAtOnceAndReadsBackExactly) {
  const TestFolder folder("pd_history_test");
  const std::string file = folder / "new/plate.csv";
  History history(file, {"A", "B"}, 0);
  history.row(3, 0.1, {1.0 / 3.0, -2.0e-300});
  const std::string content = contentOf(file);
  EXPECT_EQ(content, "step,time,A,B\n3,0.1,0.3333333333333333,-2e-300\n");
  EXPECT_EQ(std::stod(content.substr(content.find("0.33"))), 1.0 / 3.0);
}

TEST(HistoryFile, ARestartDropsLaterAndCutRows) {
  const TestFolder folder("pd_history_test");
  const std::string file = folder / "plate.csv";
  std::ofstream(file) << "step,time,A\n0,0,1\n1,1,2\n2,2,3\n10,10,4\n3,3,5";
  History(file, {"A"}, 2).row(2, 2.0, {30.0});
  EXPECT_EQ(contentOf(file), "step,time,A\n0,0,1\n1,1,2\n2,2,30\n");
  // The last line has no end: a killed run may have left part of a number there.
  std::ofstream(file) << "step,time,A\n0,0,1\n1,1,2";
  History(file, {"A"}, 5);
  EXPECT_EQ(contentOf(file), "step,time,A\n0,0,1\n");
}

TEST(HistoryFile, OtherColumnsAreKeptApart) {
  const TestFolder folder("pd_history_test");
  const std::string file = folder / "plate.csv", old = "step,time,A\n0,0,1\n";
  std::ofstream(file) << old;
  History(file, {"B"}, 5);
  EXPECT_EQ(contentOf(file), "step,time,B\n");
  EXPECT_EQ(contentOf(file + ".old"), old);
}

TEST(HistoryFile, UnitsStandBesideIt) {
  const TestFolder folder("pd_history_test");
  writeColumnUnits(folder / "plate", {"TipX", "Mean"}, {"m", ""});
  const auto json = nlohmann::json::parse(contentOf(folder / "plate.csv-metadata.json"));
  EXPECT_EQ(json["url"], "plate.csv");
  const auto& columns = json["tableSchema"]["columns"];
  ASSERT_EQ(columns.size(), 4u);
  EXPECT_EQ(columns[1]["schema:unitText"], "s");
  EXPECT_EQ(columns[2]["name"], "TipX");
  EXPECT_EQ(columns[2]["schema:unitText"], "m");
  EXPECT_FALSE(columns[3].contains("schema:unitText"));
}

TEST(HistoryFile, NamesTheFileThatCannotBeWritten) {
  const TestFolder folder("pd_history_test");
  std::ofstream(folder / "file") << "no folder";
  EXPECT_CONTAINS(errorOf<RunError>([&] { History(folder / "file/plate.csv", {"A"}, 0); }), folder / "file");
}

TEST(RunLogFile, AFullDiskIsReported) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  RunLog log(true);
  log.line("kept");
  log.requireWritten();
  log.open("/dev/full", true);
  EXPECT_CONTAINS(errorOf<RunError>([&] { log.requireWritten(); }), "\"/dev/full\": No space left on device");
}

/// Without the first line of each run, which says who writes.
std::string linesOf(const std::string& file) {
  std::istringstream content(contentOf(file));
  std::string lines;
  for (std::string line; std::getline(content, line);)
    if (line.compare(0, 6, "pdrun ") != 0) lines += line + "\n";
  return lines;
}

TEST(RunLogFile, ARestartGoesOn) {
  const TestFolder folder("pd_log_test");
  const std::string file = folder / "plate.log";
  const auto write = [&](const std::string& early, const std::string& late, bool isContinued) {
    RunLog log(true);
    log.line(early);
    log.open(file, isContinued);
    log.line(late);
  };
  write("kept", "first", false);
  write("second", "third", true);
  EXPECT_EQ(linesOf(file), "kept\nfirst\nsecond\nthird\n");
  EXPECT_CONTAINS(contentOf(file), ", process " + std::to_string(getpid()) + ", since 20");
  write("fourth", "fifth", false);
  EXPECT_EQ(linesOf(file), "fourth\nfifth\n");
}

TEST(ProgressLine, Durations) {
  EXPECT_EQ(durationText(0.4), "0 s");
  EXPECT_EQ(durationText(59.6), "1 min 0 s");
  EXPECT_EQ(durationText(754.0), "12 min 34 s");
  EXPECT_EQ(durationText(11100.0), "3 h 5 min");
}

TEST(ProgressLine, RateFollowsTheRun) {
  ProgressRate rate;
  rate.update(0, 10.0);
  EXPECT_EQ(rate.stepsPerSecond(), 0.0);
  rate.update(20, 11.0);
  EXPECT_DOUBLE_EQ(rate.stepsPerSecond(), 20.0);
  for (int i = 1; i <= 60; ++i) rate.update(20 + 5 * i, 11.0 + i);
  EXPECT_NEAR(rate.stepsPerSecond(), 5.0, 1.0e-3);  // 60 s is 12 times its averaging time; 15 exp(-12) = 9e-5
}

TEST(ProgressLine, SaysStepTimeWorkRateAndTimeLeft) {
  EXPECT_EQ(progressText(120, 3000, 739200.0, "diffusion", 50.0),
            "step 120/3000 (4 %), t = 739200 s, diffusion, 50 steps/s, 58 s left");
  EXPECT_EQ(progressText(0, 10, 0.0, "", 0.0), "step 0/10 (0 %), t = 0 s");
}

TEST(ProgressLine, TheLogGetsALineEveryFivePercent) {
  const TestFolder folder("pd_progress_test");
  const std::string file = folder / "plate.log";
  RunLog log(true);
  log.open(file, false);
  Progress progress(log);
  for (int step = 1; step <= 1000; ++step) progress.report(step, 1000, step, "");
  const std::string content = contentOf(file);
  EXPECT_EQ(std::count(content.begin(), content.end(), '\n'), 1 + 20);  // after the line that marks the file
}

TEST(Report, TableAndJsonSayTheSame) {
  RunReport report;
  report.deck = "plate \"one\".yaml";
  report.nRanks = 2;
  report.nPoints = 100;
  report.nBonds = 4000;
  report.seconds = 10.0;
  report.phases = {{"diffusion", 4.0, 50, 8000000000LL}, {"force", 1.0, 5, 1000000000LL}, {"output", 0.5, 2, 0}};
  report.bondBytes = 96000.0;
  report.errorNorms = {{"Displacement relative L2 error", 1.5e-3}};
  report.solverSummary = {"Verlet: critical time step 1e-8 s"};
  const std::string table = reportTable(report);
  EXPECT_CONTAINS(table, "40.0 %");
  EXPECT_CONTAINS(table, "2e+09");
  EXPECT_CONTAINS(table, "24.0 bytes a bond");
  EXPECT_CONTAINS(table, "error Displacement relative L2 error: 0.0015");
  EXPECT_CONTAINS(table, "critical time step");
  const auto json = nlohmann::json::parse(reportJson(report));
  EXPECT_EQ(json["deck"], report.deck);
  EXPECT_EQ(json["phases"][0]["bond_updates_per_s"], 2.0e9);
  EXPECT_EQ(json["phases"][2]["share"], 0.05);
  EXPECT_DOUBLE_EQ(json["bond_updates_per_s"], 9.0e9 / 5.0);
  EXPECT_EQ(json["bytes_per_bond"], 24.0);
  EXPECT_EQ(json["error_norms"]["Displacement relative L2 error"], 1.5e-3);
  EXPECT_EQ(json["solver"][0], report.solverSummary[0]);
}

}  // namespace
}  // namespace pd::test
