#include "command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <thread>

#include "../../materials/registry/long_work.hpp"
#include "../deck/sections.hpp"
#include "../model/collective.hpp"
#include "../model/run_setup.hpp"
#include "../parallel/launch.hpp"
#include "../study/check_fit.hpp"
#include "../study/check_study.hpp"
#include "../study/run_fit.hpp"
#include "../study/run_study.hpp"
#include "explain.hpp"
#include "markdown.hpp"

namespace pd {

namespace {

constexpr int userMistake = 2, failedRun = 3, unexpected = 4;

const char* const sampleRuns =
    "Sample runs:\n"
    "  pdrun plate.yaml                                   run a deck\n"
    "  pdrun --ranks 4 plate.yaml                         the same on 4 processes\n"
    "  mpirun -np 4 pdrun plate.yaml                      so, too, with what mpirun offers\n"
    "  pdrun plate.yaml --set \"Solver/Final Time=1.0\"     with another value\n"
    "  pdrun plate.yaml --restart plate.checkpoint.h5     go on from a checkpoint\n"
    "  pdrun plate.yaml --output-folder /scratch/plate    results go there\n"
    "  pdrun --check plate.yaml                           look for mistakes only\n"
    "  pdrun --study study.yaml                           a deck for many values: errors, histories\n"
    "  pdrun --fit fit.yaml                               values of a deck, adjusted to measured series\n"
    "  pdrun --list                                       materials, solvers, conditions ...\n"
    "  pdrun --explain \"Critical Stretch\"                 keys of one of them, or of a section of the deck\n"
    "  pdrun --explain --all --markdown reference         the whole reference, pages in a folder\n"
    "\n"
    "Exit codes: 0 done; 2 a mistake in deck, mesh or arguments; 3 the run could not go on; 4 a fault of pdrun.";

void print(std::FILE* stream, const std::string& text) {
  std::fprintf(stream, "%s%s", text.c_str(), text.empty() || text.back() == '\n' ? "" : "\n");
  std::fflush(stream);
}

void print(const Communicator& comm, std::FILE* stream, const std::string& text) {
  if (comm.isRoot()) print(stream, text);
}

std::string withPrefix(const std::string& prefix, const Mistakes& lines) {
  std::string result;
  for (const std::string& line : lines.lines()) result += prefix + line + "\n";
  return result;
}

/// Everything that a run may refuse before its first step.
void check(const RunOptions& options, const Communicator& comm) {
  const Deck deck = Deck::read(options.deckFile, options.overrides, options.unknownKeys);
  checkDeck(deck);
  const auto warn = [&] { print(comm, stderr, withPrefix("warning: ", deck.warnings())); };
  try {
    if (deck.mistakes().empty()) checkResults(deck, options.outputFolder, comm);
    deck.mistakes().report();
    for (const std::string& note : rehearse(deck, comm, options.restartFile)) print(comm, stdout, note);
  } catch (...) {
    warn();
    throw;
  }
  warn();
  print(comm, stdout, options.deckFile + ": no mistakes found");
}

/// Throws DeckError on more than one rank: the runs of a study are processes of their own.
void performStudy(const CommandLine& commandLine, const Communicator& comm) {
  if (comm.size() > 1) throw DeckError("pdrun: a study times runs of one process each; start it without mpirun");
  Mistakes mistakes;
  Study study = readStudy(commandLine.studyFile, commandLine.options.overrides, mistakes);
  const bool isRun = commandLine.action == CommandLine::Action::Study;
  checkStudy(study, comm, !isRun, mistakes);
  mistakes.sort(commandLine.studyFile);
  mistakes.report();
  checkStudyResults(study, commandLine.options.outputFolder);
  if (isRun) return runStudy(study, commandLine.options.outputFolder, commandLine.options.isQuiet);
  print(comm, stdout, commandLine.studyFile + ": no mistakes found, " + std::to_string(study.runs.size()) + " runs");
}

/// Throws DeckError on more than one rank: the runs of a fit are processes of their own.
void performFit(const CommandLine& commandLine, const Communicator& comm) {
  if (comm.size() > 1)
    throw DeckError("pdrun: a fit runs its decks side by side, each on one rank (Processes); start it without mpirun");
  Mistakes mistakes;
  Fit fit = readFit(commandLine.fitFile, commandLine.options.overrides, mistakes);
  const bool isRun = commandLine.action == CommandLine::Action::Fit;
  checkFit(fit, comm, !isRun, mistakes);
  mistakes.sort(commandLine.fitFile);
  mistakes.report();
  checkFitResults(fit, commandLine.options.outputFolder);
  if (isRun) return runFit(fit, commandLine.options.outputFolder, commandLine.options.isQuiet);
  print(comm, stdout,
        fmt::format("{}: no mistakes found, {} values, {} runs a step", commandLine.fitFile, fit.values.size(),
                    fit.runs.size()));
}

/// Does what any process can do alone; false where that is not what is asked for.
bool explains(const CommandLine& commandLine) {
  if (commandLine.action == CommandLine::Action::Print)
    print(stdout, commandLine.text);
  else if (commandLine.action == CommandLine::Action::WriteReference)
    for (const std::string& page : writeReference(commandLine.referenceFolder)) print(stdout, page);
  else
    return false;
  return true;
}

/// Lines about work of plug-ins that takes more than seconds, on the terminal of the root.
void showLongWork(const Communicator& comm) {
  if (!comm.isRoot()) return;
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds patience(2);
  LongWork::listen([patience, shown = Clock::now()](const std::string& what) mutable {
    if (Clock::now() - shown < patience) return;
    shown = Clock::now();
    print(stderr, what + " ...");
  });
}

void perform(const CommandLine& commandLine, const Communicator& comm) {
  if (!commandLine.options.isQuiet) showLongWork(comm);
  switch (commandLine.action) {
    case CommandLine::Action::Print:
    case CommandLine::Action::WriteReference:
      if (comm.isRoot()) explains(commandLine);
      break;
    case CommandLine::Action::Check:
      check(commandLine.options, comm);
      break;
    case CommandLine::Action::Run:
      runDeck(commandLine.options, comm);
      break;
    case CommandLine::Action::Study:
    case CommandLine::Action::CheckStudy:
      performStudy(commandLine, comm);
      break;
    case CommandLine::Action::Fit:
    case CommandLine::Action::CheckFit:
      performFit(commandLine, comm);
      break;
  }
}

/// The exit code of `work`, whose errors are printed; those of all ranks by rank 0.
template <class Work>
int exitCodeOf(int rank, const Work& work) {
  const auto printOnce = [&](const std::string& text) {
    if (rank == 0) print(stderr, text);
  };
  try {
    work();
    return 0;
  } catch (const DeckError& error) {
    printOnce(error.what());
    return userMistake;
  } catch (const RunError& error) {
    printOnce(std::string("the run cannot go on: ") + error.what());
    return failedRun;
  } catch (const std::bad_alloc& error) {
    // Perhaps on one rank alone: each says so itself.
    std::fprintf(stderr, "pdrun, rank %d: the run cannot go on: %s\n", rank, whatOf(error).c_str());
    return failedRun;
  } catch (const std::exception& error) {
    // Perhaps on one rank alone: each says so itself.
    std::fprintf(stderr, "pdrun, rank %d: unexpected error, a fault of pdrun rather than of your deck: %s\n", rank,
                 error.what());
    return unexpected;
  }
}

/// The arguments after the name of the program, without --ranks.
std::vector<std::string> argumentsOfRanks(int argc, const char* const* argv) {
  const std::string option = "--ranks";
  std::vector<std::string> result;
  for (int k = 1; k < argc; ++k) {
    const std::string argument = argv[k];
    if (argument == option)
      ++k;  // its value
    else if (argument.rfind(option + "=", 0) != 0)
      result.push_back(argument);
  }
  return result;
}

/// Waits for the other ranks and returns the highest code. A rank that has failed does not wait for ever: the others
/// may be waiting for it elsewhere.
int leaveTogether(int code, MPI_Comm ranks) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds patience(20);
  int highest = code, hasArrived = 0;
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Iallreduce(&code, &highest, 1, MPI_INT, MPI_MAX, ranks, &request);
  const auto start = Clock::now();
  for (;;) {
    MPI_Test(&request, &hasArrived, MPI_STATUS_IGNORE);
    if (hasArrived != 0) return highest;
    if (code != 0 && Clock::now() - start > patience) MPI_Abort(ranks, code);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// What --explain and the options beside it ask for.
struct Explanation {
  std::string topic, folder;
  bool isAll = false, isMarkdown = false;
};

/// Throws DeckError where they do not fit each other.
CommandLine explanation(const Explanation& asked) {
  if (asked.topic.empty() != asked.isAll)
    throw DeckError("pdrun: --explain takes a NAME, or --all in its place; pdrun --list has the names");
  if (!asked.folder.empty() && !asked.isAll) throw DeckError("pdrun: pages go to a folder with --all alone");
  CommandLine result;
  result.action = asked.folder.empty() ? CommandLine::Action::Print : CommandLine::Action::WriteReference;
  result.referenceFolder = asked.folder;
  if (asked.isMarkdown)
    result.text = markdown(asked.isAll ? reference() : chaptersAbout(asked.topic));
  else
    result.text = asked.isAll ? explainEverything() : explain(asked.topic);
  return result;
}

}  // namespace

CommandLine parseCommandLine(int argc, const char* const* argv) {
  CommandLine result;
  RunOptions& options = result.options;
  bool isCheck = false, isList = false;
  std::string peridigmKeys = "strict";
  Explanation explained;
  CLI::App app{"Peridynamic degradation of materials: runs a deck in YAML, or one of Peridigm.", "pdrun"};
  app.footer(sampleRuns);
  app.add_option("deck", options.deckFile, "The deck to run (YAML, or Peridigm's XML).");
  app.add_option("--set", options.overrides, "Override a value of the deck: path=value. May be given several times.")
      ->type_name("PATH=VALUE")
      ->expected(1)
      ->take_all();
  app.add_option("--restart", options.restartFile, "Go on from a checkpoint of the same deck.")->type_name("FILE");
  app.add_option("--output-folder", options.outputFolder,
                 "Results go below FOLDER, which is made where it is not there, in place of the folder that pdrun is "
                 "started in.")
      ->type_name("FOLDER");
  app.add_option("--peridigm-keys", peridigmKeys,
                 "Unknown keys in decks of Peridigm: mistakes (strict, the default), or ignored with a warning "
                 "(lenient).")
      ->type_name("strict|lenient")
      ->check(CLI::IsMember({"strict", "lenient"}));
  app.add_option("--study", result.studyFile,
                 "Run a deck over lists of overrides: its errors against work, its histories.")
      ->type_name("FILE");
  app.add_option("--fit", result.fitFile,
                 "Adjust values of a deck until histories of its runs agree with measured series.")
      ->type_name("FILE");
  app.add_flag("--check", isCheck,
               "Look for mistakes in deck, mesh and node sets, and with --restart in what the run goes on from; run "
               "nothing.");
  app.add_flag("--list", isList, "Name all materials, damage models, computes, solvers, conditions and sections.");
  const CLI::Option* const explainOption =
      app.add_option("--explain", explained.topic, "Tell the keys of one of these, or with --all of everything.")
          ->type_name("[NAME]")
          ->expected(0, 1);
  app.add_flag("--all", explained.isAll, "With --explain: everything.")->needs("--explain");
  const CLI::Option* const markdownOption =
      app.add_option("--markdown", explained.folder, "With --explain: as Markdown; with --all as pages of a folder.")
          ->type_name("[FOLDER]")
          ->expected(0, 1)
          ->needs("--explain");
  app.add_option("--ranks", result.nRanks,
                 "Run or check the deck on so many processes: starts itself under mpirun, also for root and on fewer "
                 "cores.")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000));
  app.add_flag("--quiet", options.isQuiet, "Print nothing on the terminal but warnings and errors.");
  app.set_version_flag("--version", std::string("pdrun ") + PD_VERSION);

  const auto printing = [&](const std::string& text) {
    result.action = CommandLine::Action::Print;
    result.text = text;
    return result;
  };
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return printing(app.help());
  } catch (const CLI::CallForVersion& version) {
    return printing(version.what());
  } catch (const CLI::ParseError& error) {
    throw DeckError(std::string("pdrun: ") + error.what() + "\nTry pdrun --help.");
  }
  if (peridigmKeys == "lenient") options.unknownKeys = UnknownKeys::AreWarnings;
  if (result.nRanks > 0 && isWithinJob())
    throw DeckError("pdrun: --ranks starts mpirun itself; leave it out, or mpirun");
  if (result.nRanks > 0 && options.deckFile.empty())
    throw DeckError("pdrun: --ranks is for the run or the check of a deck, of which none is given");
  if (isList) return printing(listEverything());
  explained.isMarkdown = markdownOption->count() > 0;
  if (explainOption->count() > 0) return explanation(explained);
  if (!result.studyFile.empty() && !result.fitFile.empty())
    throw DeckError("pdrun: --study and --fit are two things; give one of them");
  const bool isStudy = !result.studyFile.empty();
  if (isStudy || !result.fitFile.empty()) {
    const std::string what = isStudy ? "study" : "fit";
    if (!options.deckFile.empty() || !options.restartFile.empty())
      throw DeckError("pdrun: a " + what +
                      " names its deck itself and starts it anew; leave out the deck and --restart");
    if (options.unknownKeys != UnknownKeys::AreMistakes)
      throw DeckError("pdrun: the deck of a " + what + " is read strictly; leave out --peridigm-keys");
    using Action = CommandLine::Action;
    result.action =
        isStudy ? (isCheck ? Action::CheckStudy : Action::Study) : (isCheck ? Action::CheckFit : Action::Fit);
    return result;
  }
  if (options.deckFile.empty()) throw DeckError("pdrun: no deck is given.\nTry pdrun --help.");
  result.action = isCheck ? CommandLine::Action::Check : CommandLine::Action::Run;
  return result;
}

std::optional<int> runWithoutMpi(int argc, const char* const* argv) {
  if (isWithinJob()) return std::nullopt;
  std::optional<int> codeOfRanks;
  bool isDone = true;
  const int code = exitCodeOf(0, [&] {
    const CommandLine commandLine = parseCommandLine(argc, argv);
    if (commandLine.nRanks > 1)
      codeOfRanks = runOnRanks(commandLine.nRanks, argumentsOfRanks(argc, argv));
    else
      isDone = explains(commandLine);
  });
  if (codeOfRanks) return codeOfRanks;
  return isDone ? std::optional(code) : std::nullopt;
}

int runCommandLine(int argc, const char* const* argv, const Communicator& comm) {
  // Of its own, so that these messages cannot meet those of an unfinished run.
  MPI_Comm ranks = MPI_COMM_NULL;
  MPI_Comm_dup(comm.mpi(), &ranks);
  const int own = exitCodeOf(comm.rank(), [&] { perform(parseCommandLine(argc, argv), comm); });
  const int code = leaveTogether(own, ranks);
  MPI_Comm_free(&ranks);
  return code;
}

}  // namespace pd
