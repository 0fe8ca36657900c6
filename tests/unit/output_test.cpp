// What Output sections ask for, and the files of whole runs.
#include "driver/output/output.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "../expect_error.hpp"
#include "../model_plugins.hpp"
#include "../mpi/lattice.hpp"
#include "../test_folder.hpp"
#include "Peridigm_Discretization.hpp"
#include "driver/output/checkpoint.hpp"
#include "driver/output/hdf5_file.hpp"
#include "driver/output/output_section.hpp"

namespace pd::test {
namespace {

// ---- Output sections ----

OutputSection sectionOf(const std::string& text) { return readOutputSections(deckOf(text)).front(); }

TEST(OutputSections, FieldsAreDueByFrequencyByListAndAtTheEnd) {
  const OutputSection section = sectionOf("Output: {Output Frequency: 10, Output Steps: [13, 27.0]}\n");
  for (const int step : {0, 10, 13, 20, 27}) EXPECT_TRUE(section.areFieldsDue(step, false)) << step;
  for (const int step : {1, 12, 14, 29}) EXPECT_FALSE(section.areFieldsDue(step, false)) << step;
  EXPECT_TRUE(section.areFieldsDue(29, true));
}

TEST(OutputSections, NothingIsDueOutsideTheRange) {
  const OutputSection section =
      sectionOf("Output: {Output Frequency: 10, Initial Output Step: 20, Final Output Step: 40}\n");
  for (const int step : {20, 30, 40}) EXPECT_TRUE(section.areFieldsDue(step, false)) << step;
  for (const int step : {0, 10, 50}) EXPECT_FALSE(section.areFieldsDue(step, false)) << step;
  EXPECT_FALSE(section.areFieldsDue(55, true));
  EXPECT_FALSE(section.isHistoryDue(10, false));
}

TEST(OutputSections, WithoutFrequencyAndListNoFieldsAreWritten) {
  const OutputSection section = sectionOf("Output: {Output Variables: [Damage]}\n");
  EXPECT_FALSE(section.areFieldsDue(0, false));
  EXPECT_FALSE(section.areFieldsDue(7, true));
  EXPECT_TRUE(section.isHistoryDue(7, false));
  EXPECT_FALSE(section.isCheckpointDue(7, true));
}

TEST(OutputSections, PeridigmCountsTheInitialStateAsOutputOne) {
  EXPECT_FALSE(sectionOf("Output: {Output Frequency: 1, Initial Output Step: 1}\n").areFieldsDue(0, false));
  const OutputSection section = sectionOf("Peridigm: {Output: {Output Frequency: 1, Initial Output Step: 2}}\n");
  EXPECT_FALSE(section.areFieldsDue(0, false));
  EXPECT_TRUE(section.areFieldsDue(1, false));
  EXPECT_TRUE(sectionOf("Peridigm: {Output: {Output Frequency: 1}}\n").areFieldsDue(0, false));
}

TEST(OutputSections, PeridigmWritesHistoriesAsOftenAsFields) {
  const std::string section = "Output2: {Output Frequency: 35, Output Variables: {Global_Kinetic_Energy: true}}\n";
  EXPECT_TRUE(sectionOf(section).isHistoryDue(34, false));
  EXPECT_FALSE(sectionOf("Peridigm: {" + section.substr(0, section.size() - 1) + "}\n").isHistoryDue(34, false));
}

TEST(OutputSections, VariablesAreAListAMapOrOneName) {
  const auto labelsOf = [](const std::string& variables) {
    std::string labels;
    for (const OutputVariable& variable : sectionOf("Output: {Output Variables: " + variables + "}\n").variables)
      labels += variable.label + " ";
    return labels;
  };
  EXPECT_EQ(labelsOf("[Damage, Force]"), "Damage Force ");
  EXPECT_EQ(labelsOf("{Damage: true, Volume: false, Force: true}"), "Damage Force ");
  EXPECT_EQ(labelsOf("Damage"), "Damage ");
}

// ---- a whole run ----

/// Bonds of the run and the number of its evaluations, as values for the whole body.
class CountingCompute : public Compute {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declare.text("Output Label", "Of the result.").defaultTo("Test_Count");
    declare.text("Node Set", "Counted too.");
  }
  CountingCompute(Teuchos::RCP<const Teuchos::ParameterList> params, Teuchos::RCP<const Epetra_Comm> comm_,
                  Teuchos::RCP<const Teuchos::ParameterList> globalData)
      : Compute(params, comm_, globalData) {
    if (!params.is_null() && params->isParameter("Node Set")) nodeSet_ = params->get<std::string>("Node Set");
    id_ = FieldManager::self().getFieldId(GLOBAL, VECTOR, CONSTANT,
                                          params.is_null() ? "Test_Count" : params->get<std::string>("Output Label"));
  }
  std::vector<int> FieldIds() const override { return {id_}; }
  void initialize(Teuchos::RCP<std::vector<Block>>) override {
    if (nodeSet_.empty()) return;
    const auto sets =
        (*computeClassGlobalData->get<Teuchos::RCP<PeridigmNS::Discretization>*>("discretization"))->getNodeSets();
    if (sets->count(nodeSet_) == 0) throw std::invalid_argument("no node set " + nodeSet_);
    nSetPoints_ = static_cast<int>(sets->at(nodeSet_).size());
  }
  int compute(Teuchos::RCP<std::vector<Block>> blocks) const override {
    auto& result = *blocks->front().getData(id_, STEP_NONE);
    result[0] = blocks->front().getNeighborhoodData()->NumBonds();
    result[1] = ++nEvaluations_;
    result[2] = nSetPoints_;
    return 0;
  }

 private:
  int id_ = -1, nSetPoints_ = 0;
  mutable int nEvaluations_ = 0;
  std::string nodeSet_;
};
PD_REGISTER_COMPUTE(CountingCompute, "Test_Count", "Counts.")

class OutputRun : public ::testing::Test {
 protected:
  /// Four points in a row; `text` of the Output sections and computes.
  std::unique_ptr<Output> start(const std::string& text, int firstStep = 0) {
    const bool isPeridigms = text.find("Peridigm:") == 0;
    deck = std::make_unique<Deck>(deckOf(isPeridigms ? text : plate + text));
    Discretization points = Lattice{4, 1, 1, 1.0}.discretization(comm);
    points.nodeSets["Ends"] = {0, 3};
    model = std::make_unique<Model>(isPeridigms ? deckOf(plate) : *deck, comm, points, std::vector<int>());
    auto output = std::make_unique<Output>(*deck, comm, true, folder / "");
    output->claim();
    model->allocateFields(output->fieldIds());
    output->initialize(*model);
    model->initialize();
    output->begin(firstStep, "# test.yaml with all defaults written out by pdrun.\n");
    return output;
  }
  void writeSteps(Output& output, int first, int last) {
    for (int step = first; step <= last; ++step) {
      for (int i = 0; i < 4; ++i) model->field("Displacement")[3 * i] = step + 0.1 * i;
      output.write(*model, step, last, 0.5 * step, step == last);
    }
  }
  std::string csv() const { return contentOf(folder / "plate.csv"); }

  Communicator comm{MPI_COMM_SELF};
  TestFolder folder{"pd_output_run_test"};
  const std::string plate =
      "Materials: {Soft: {Material Model: Test Springs, Stiffness: 1.0}}\n"
      "Blocks: {All: {Block Names: default, Material: Soft, Horizon: 1.0}}\n";
  std::unique_ptr<Deck> deck;
  std::unique_ptr<Model> model;
};

TEST_F(OutputRun, WritesWhatIsAskedForWhenItIsDue) {
  const auto output = start(
      "Compute Class Parameters: {Mine: {Compute Class: Test_Count, Output Label: Bonds, Node Set: Ends}}\n"
      "Output: {Output Filename: plate, Output Frequency: 2, Output Variables: [Displacement, Block_Id, Proc_Num]}\n");
  writeSteps(*output, 0, 5);
  EXPECT_EQ(csv(),
            "step,time,BondsX,BondsY,BondsZ\n0,0,6,1,2\n1,0.5,6,2,2\n2,1,6,3,2\n3,1.5,6,4,2\n4,2,6,5,2\n5,2.5,6,6,2\n");
  for (const char* step : {"000000", "000002", "000004", "000005"})
    EXPECT_TRUE(std::filesystem::exists(folder / ("plate.steps/" + std::string(step) + ".h5"))) << step;
  EXPECT_FALSE(std::filesystem::exists(folder / "plate.steps/000001.h5"));
  const std::string xdmf = contentOf(folder / "plate.xdmf");
  for (const char* label : {"\"Displacement\" AttributeType=\"Vector\"", "\"Block_Id\"", "\"Proc_Num\""})
    EXPECT_CONTAINS(xdmf, label);
}

TEST_F(OutputRun, FieldsSayTheirUnits) {
  const auto output = start(
      "Compute Class Parameters: {Mean: {Compute Class: Field_Mean, Variable: Displacement, Output Label: Mean}}\n"
      "Output: {Output Filename: plate, Output Frequency: 1, Output Variables: [Displacement, Block_Id, Proc_Num]}\n");
  writeSteps(*output, 0, 0);
  const Hdf5File file(folder / "plate.steps/000000.h5", Hdf5File::Mode::Read, comm);
  EXPECT_EQ(file.textAttribute("Displacement", "units"), "m");
  EXPECT_EQ(file.textAttribute("Block_Id", "units"), "1");
  EXPECT_EQ(file.textAttribute("Proc_Num", "units"), "1");
  const auto json = nlohmann::json::parse(contentOf(folder / "plate.csv-metadata.json"));
  EXPECT_EQ(json["tableSchema"]["columns"][2]["name"], "Mean");
  EXPECT_EQ(json["tableSchema"]["columns"][2]["schema:unitText"], "m");
}

TEST_F(OutputRun, AComputeIsMadeForTheNameOfItsClass) {
  const auto output = start("Output: {Output Filename: plate, History Frequency: 3, Output Variables: [Test_Count]}\n");
  writeSteps(*output, 0, 4);
  EXPECT_EQ(csv(), "step,time,Test_CountX,Test_CountY,Test_CountZ\n0,0,6,1,0\n3,1.5,6,2,0\n4,2,6,3,0\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "plate.h5")) << "no fields were asked for";
}

TEST_F(OutputRun, SectionsMayShareAFileName) {
  const auto output = start(
      "Output1: {Output Filename: plate, Output Frequency: 2, Output Variables: [Displacement]}\n"
      "Output2: {Output Filename: plate, Output Frequency: 3, Output Variables: [Volume, Displacement]}\n");
  writeSteps(*output, 0, 4);
  const std::string xdmf = contentOf(folder / "plate.xdmf");
  std::string found;
  for (auto at = xdmf.find("<Time Value=\""); at != std::string::npos; at = xdmf.find("<Time Value=\"", at + 1)) {
    const std::string grid = xdmf.substr(at, xdmf.find("</Grid>", at) - at);
    found += grid.substr(13, grid.find('"', 13) - 13);
    found += grid.find("\"Displacement\"") != std::string::npos ? "D" : "";
    found += grid.find("\"Volume\"") != std::string::npos ? "V " : " ";
  }
  EXPECT_EQ(found, "0DV 1D 1.5DV 2DV ");
}

TEST_F(OutputRun, ARestartGoesOnWithTheFiles) {
  const std::string text =
      "Output: {Output Filename: plate, Output Frequency: 1, Output Variables: [Displacement, Test_Count]}\n";
  writeSteps(*start(text), 0, 4);
  const auto output = start(text, 3);
  writeSteps(*output, 3, 5);
  const std::string content = csv();
  EXPECT_CONTAINS(content, "\n2,1,6,3,0\n3,1.5,6,1,0\n4,2,6,2,0\n5,2.5,6,3,0\n");
  const std::string xdmf = contentOf(folder / "plate.xdmf");
  std::string steps;
  for (auto at = xdmf.find(".h5:/Displacement"); at != std::string::npos; at = xdmf.find(".h5:/Displacement", at + 1))
    steps += xdmf[at - 1];
  EXPECT_EQ(steps, "012345");
}

TEST_F(OutputRun, ANewRunRemovesTheStepsOfAnOldOne) {
  const std::string text = "Output: {Output Filename: plate, Output Frequency: 1, Output Variables: [Displacement]}\n";
  writeSteps(*start(text), 0, 4);
  std::ofstream(folder / "plate.steps/000009.h5.pdrun-unfinished") << "part";
  writeSteps(*start(text), 0, 1);
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "plate.steps"))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"000000.h5", "000001.h5", "mesh.h5"}));
}

TEST_F(OutputRun, AllUnknownVariablesAreReportedWithTheirPlaces) {
  const std::string message = errorOf<DeckError>(
      [&] { start("Output:\n  Output Filename: plate\n  Output Variables: [Displacment, Bond_Damage, Volume]\n"); });
  EXPECT_CONTAINS(message,
                  "test.yaml:5:22: no plug-in of this run provides \"Displacment\" (did you mean "
                  "\"Displacement\"?)");
  EXPECT_CONTAINS(message, "test.yaml:5:35: \"Bond_Damage\" is a field of bonds");
  EXPECT_EQ(message.find("\"Volume\""), std::string::npos) << message;
}

TEST_F(OutputRun, PeridigmDecksMayNameWhatNoPlugInProvides) {
  const auto output = start(
      "Peridigm:\n  Output:\n    Output File Type: ExodusII\n    Output Filename: plate\n    Output Frequency: 1\n"
      "    Output Variables: {Displacement: true, Dilatation: true}\n");
  writeSteps(*output, 0, 0);
  EXPECT_CONTAINS(contentOf(folder / "plate.log"), "\"Dilatation\"; it is left out");
  EXPECT_CONTAINS(contentOf(folder / "plate.xdmf"), "\"Displacement\"");
}

TEST_F(OutputRun, MistakesThatComputesFindNameTheirPlace) {
  const std::string message = errorOf<DeckError>([&] {
    start(
        "Compute Class Parameters:\n  Mine: {Compute Class: Test_Count, Node Set: Nowhere}\n"
        "Output: {Output Filename: plate, Output Variables: [Displacement]}\n");
  });
  EXPECT_CONTAINS(message, "test.yaml:4:3: no node set Nowhere");
}

TEST_F(OutputRun, ReportsAndCheckpoints) {
  const auto output = start(
      "Output: {Output Filename: plate, Output Frequency: 1, Output Variables: [Displacement], Checkpoint Frequency: "
      "2}\n");
  writeSteps(*output, 0, 1);
  EXPECT_FALSE(output->isCheckpointDue(1, false));
  output->checkpoint(*model, {1, 0.5, "Test", {}, "", {}}, false);
  EXPECT_FALSE(std::filesystem::exists(folder / "plate.checkpoint.h5"));
  writeSteps(*output, 2, 2);
  EXPECT_TRUE(output->isCheckpointDue(2, false));
  const RestartState state = {{"steps", 4.0}, {"proposed step", 5.0}};
  output->checkpoint(*model, {2, 1.0, "Test", state, "", {}}, false);
  output->report(*model, {"Test: summary"}, {{"Displacement error", 0.5}});
  const auto json = nlohmann::json::parse(contentOf(folder / "plate.report.json"));
  EXPECT_EQ(json["points"], 4);
  EXPECT_EQ(json["bonds"], 6);
  EXPECT_EQ(json["error_norms"]["Displacement error"], 0.5);
  EXPECT_CONTAINS(contentOf(folder / "plate.log"), "directed bonds 6");
  model->field("Displacement")[3] = 77.0;
  const Checkpoint checkpoint = readCheckpoint(*model, folder / "plate.checkpoint.h5");
  EXPECT_EQ(checkpoint.step, 2);
  EXPECT_EQ(checkpoint.state.entries(), state.entries());
  EXPECT_EQ(model->field("Displacement")[3], 2.1);
}

}  // namespace
}  // namespace pd::test
