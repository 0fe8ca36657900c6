#include "launch.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iterator>

#include "../deck/deck.hpp"

namespace pd {

namespace {

constexpr int cannotBeStarted = 127;  ///< exit code, as of a shell
constexpr int endingSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

sigset_t awaitedSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGCHLD);
  for (const int signal : endingSignals) sigaddset(&signals, signal);
  return signals;
}

std::vector<std::string> mpirunCommand(int nRanks, const std::vector<std::string>& arguments) {
  std::vector<std::string> command{"mpirun", "--quiet", "--oversubscribe", "--bind-to", "none"};
  if (geteuid() == 0) command.emplace_back("--allow-run-as-root");
  command.insert(command.end(), {"-np", std::to_string(nRanks), ownProgram()});
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

/// In the child: becomes the command. In a group of its own, so that what a terminal sends to this program's group
/// comes once, passed on by the parent; it reads nothing, which the terminal would stop it for.
[[noreturn]] void become(const std::vector<std::string>& command, const sigset_t& mask) {
  std::vector<char*> pointers;
  for (const std::string& word : command) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  const int nothing = open("/dev/null", O_RDONLY);
  if (nothing >= 0) dup2(nothing, STDIN_FILENO);
  sigprocmask(SIG_SETMASK, &mask, nullptr);
  execvp(pointers[0], pointers.data());
  _exit(cannotBeStarted);
}

/// Ends this process as the signal does where nobody catches it.
[[noreturn]] void endBy(int signal, const sigset_t& mask) {
  std::signal(signal, SIG_DFL);
  std::raise(signal);
  sigprocmask(SIG_SETMASK, &mask, nullptr);
  _exit(128 + signal);
}

}  // namespace

std::string ownProgram() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).string();
}

bool isWithinJob() {
  const char* const variables[] = {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"};
  return std::any_of(std::begin(variables), std::end(variables),
                     [](const char* variable) { return std::getenv(variable) != nullptr; });
}

int runOnRanks(int nRanks, const std::vector<std::string>& arguments) {
  const std::vector<std::string> command = mpirunCommand(nRanks, arguments);
  const sigset_t signals = awaitedSignals();
  sigset_t before;
  sigprocmask(SIG_BLOCK, &signals, &before);
  const pid_t child = fork();
  if (child == 0) become(command, before);
  if (child < 0) throw DeckError(fmt::format("pdrun: mpirun cannot be started: {}", std::strerror(errno)));

  int status = 0, passedOn = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    const int signal = sigwaitinfo(&signals, nullptr);
    if (signal < 0 || signal == SIGCHLD) continue;
    passedOn = signal;
    kill(child, signal == SIGQUIT ? SIGTERM : signal);
  }
  if (passedOn != 0) endBy(passedOn, before);
  sigprocmask(SIG_SETMASK, &before, nullptr);
  if (WIFSIGNALED(status)) throw DeckError(fmt::format("pdrun: mpirun was ended by signal {}", WTERMSIG(status)));
  const int code = WEXITSTATUS(status);
  if (code == cannotBeStarted)
    throw DeckError("pdrun: --ranks needs mpirun, which cannot be started; install Open MPI, or put it into PATH");
  if (code > 128)
    std::fprintf(stderr, "pdrun: a rank was ended by signal %d (%s)\n", code - 128, strsignal(code - 128));
  return code;
}

}  // namespace pd
