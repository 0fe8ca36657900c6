// A run that is killed while it writes: the steps that it has listed stay readable, and a restart goes on from them.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <mpi.h>
#include <semaphore.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <random>
#include <thread>
#include <vector>

#include "../model_plugins.hpp"
#include "../mpi/lattice.hpp"
#include "../test_folder.hpp"
#include "driver/output/atomic_file.hpp"
#include "driver/output/checkpoint.hpp"
#include "driver/output/field_writer.hpp"
#include "driver/output/global_order.hpp"
#include "driver/output/output.hpp"
#include "driver/parallel/session.hpp"

namespace pd::test {
namespace {

constexpr int nPoints = 20000;  // a few milliseconds a step, so that kills meet every part of it

/// Writes steps firstStep, firstStep + 1, ... until it is killed. read_series.py knows their values.
void writeSteps(const std::string& name, int firstStep) {
  const Communicator comm(MPI_COMM_WORLD);
  std::vector<int> ids(nPoints), blocks(nPoints, 1);
  std::vector<double> x(3 * nPoints), volumes(nPoints, 2.0), damage(nPoints), displacement(3 * nPoints);
  for (int i = 0; i < nPoints; ++i) {
    ids[i] = nPoints - 1 - i;
    x[3 * i] = ids[i];
  }
  const GlobalOrder order(comm, ids, nPoints, nPoints);
  FieldWriter writer(name, order, x.data(), blocks.data(), volumes.data(), firstStep);
  for (int step = firstStep;; ++step) {
    for (int i = 0; i < nPoints; ++i) {
      damage[i] = step + ids[i] / 65536.0;
      for (int k = 0; k < 3; ++k) displacement[3 * i + k] = step * ids[i] + k;
    }
    writer.write(step, 0.5 * step, {{"Damage", 1, damage.data(), "1"}, {"Displacement", 3, displacement.data(), "m"}});
  }
}

int numberOf(const std::string& text, const std::string& word) {
  int count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

/// Steps that the XDMF file lists.
int nListed(const std::string& name) { return numberOf(contentOf(name + ".xdmf"), "<Time "); }

/// Runs `work` in a child process, which MPI has not been started in.
pid_t inChild(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child != 0) return child;
  int result = 1;
  try {
    int noArguments = 0;
    char** arguments = nullptr;
    const ParallelSession session(noArguments, arguments);
    work();
    result = 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  _exit(result);
}

/// Lets a child do `work`, which must not end, and kills it `delay` after `isReady`.
void runAndKill(const std::function<void()>& work, const std::function<bool()>& isReady,
                std::chrono::microseconds delay) {
  const pid_t child = inChild(work);
  ASSERT_GE(child, 0);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  int status = 0;
  bool isReadyInTime = isReady();
  while (!isReadyInTime && std::chrono::steady_clock::now() < deadline) {
    ASSERT_EQ(waitpid(child, &status, WNOHANG), 0) << "the writer ended by itself";
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    isReadyInTime = isReady();
  }
  if (isReadyInTime) std::this_thread::sleep_for(delay);
  kill(child, SIGKILL);
  waitpid(child, &status, 0);
  ASSERT_TRUE(isReadyInTime) << "nothing was written";
  ASSERT_TRUE(WIFSIGNALED(status));
}

/// Reads all that the files list with h5py and meshio; 0 where it is right.
int readByPython(const std::string& name, int nSteps) {
  const std::string command = "/usr/bin/python3 " PD_SOURCE_DIR "/tests/unit/read_series.py \"" + name + "\" " +
                              std::to_string(nPoints) + " " + std::to_string(nSteps);
  return std::system(command.c_str());
}

TEST(KilledOutput, LeavesTheListedStepsReadableAndRestartable) {
  const TestFolder folder("pd_killed_output_test");
  const std::string name = folder / "plate";
  std::mt19937 random(1);
  std::uniform_int_distribution<int> delay(0, 12000);
  int firstStep = 0, nUnfinished = 0;
  for (int attempt = 0; attempt < 8; ++attempt) {
    runAndKill([&] { writeSteps(name, firstStep); }, [&] { return nListed(name) > firstStep; },
               std::chrono::microseconds(delay(random)));
    ASSERT_FALSE(HasFatalFailure());
    const int listed = nListed(name);
    ASSERT_GT(listed, firstStep);
    ASSERT_EQ(readByPython(name, listed), 0) << "after " << listed << " steps";
    for (const auto& entry : std::filesystem::directory_iterator(folder / "plate.steps"))
      if (isUnfinished(entry.path().string())) ++nUnfinished;
    firstStep = listed;
  }
  EXPECT_GT(nUnfinished, 0) << "no kill met a file that was being written, so nothing was tested";
}

// ---- checkpoints ----

struct Body {
  Body()
      : deck(deckOf(plateText())),
        comm(MPI_COMM_WORLD),
        model(deck, comm, Lattice{40, 40, 1, 1.5}.discretization(comm), {}) {
    model.initialize();
  }
  Deck deck;
  Communicator comm;
  Model model;
};

/// Writes checkpoints of steps 1, 2, ..., all displacements equal to the step, until it is killed.
void writeCheckpoints(const std::string& fileName) {
  Body body;
  const Discretization& points = body.model.discretization();
  const GlobalOrder order(body.comm, points.globalIds, points.nOwned, points.nGlobal);
  for (int step = 1;; ++step) {
    std::fill_n(body.model.field("Displacement"), 3 * points.nPoints, step);
    writeCheckpoint(body.model, order, fileName, {step, 0.5 * step, "", {}, "", {}});
  }
}

/// Throws where the file is not one of those.
void readWrittenCheckpoint(const std::string& fileName) {
  Body body;
  const Checkpoint checkpoint = readCheckpoint(body.model, fileName);
  const double* displacement = body.model.field("Displacement");
  if (checkpoint.step < 1 || checkpoint.time != 0.5 * checkpoint.step) throw std::runtime_error("wrong step or time");
  if (std::count(displacement, displacement + 3 * body.model.nPoints(), checkpoint.step) != 3 * body.model.nPoints())
    throw std::runtime_error("displacements of another step");
}

TEST(KilledOutput, LeavesACheckpointThatIsWhole) {
  const TestFolder folder("pd_killed_checkpoint_test");
  const std::string fileName = folder / "plate.checkpoint.h5";
  std::mt19937 random(2);
  std::uniform_int_distribution<int> delay(0, 8000);
  int nUnfinished = 0;
  for (int attempt = 0; attempt < 4; ++attempt) {
    std::filesystem::remove(fileName);
    runAndKill([&] { writeCheckpoints(fileName); }, [&] { return std::filesystem::exists(fileName); },
               std::chrono::microseconds(delay(random)));
    ASSERT_FALSE(HasFatalFailure());
    if (std::filesystem::exists(unfinishedName(fileName))) ++nUnfinished;
    int status = 1;
    waitpid(inChild([&] { readWrittenCheckpoint(fileName); }), &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_GT(nUnfinished, 0) << "no kill met a file that was being written, so nothing was tested";
}

/// Kills leave Open MPI's semaphore for a file's shared pointer behind, taken. Here one is made by hand.
TEST(KilledOutput, IsNotWaitedForByTheNextRun) {
  const TestFolder folder("pd_killed_semaphore_test");
  const std::string fileName = folder / "semaphore.checkpoint.h5";
  const char* semaphore = "/OMPIO_semaphore.checkpoint.h5.pdrun-unfinished";
  ASSERT_NE(sem_open(semaphore, O_CREAT, 0600, 0), SEM_FAILED);
  runAndKill([&] { writeCheckpoints(fileName); }, [&] { return std::filesystem::exists(fileName); },
             std::chrono::microseconds(0));
  sem_unlink(semaphore);
}

}  // namespace
}  // namespace pd::test
