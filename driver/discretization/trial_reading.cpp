#include "trial_reading.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>

namespace pd {

namespace {

constexpr std::size_t megabyte = 1 << 20;

/// Address space of this process in bytes, 0 where the system does not tell.
std::size_t addressSpace() {
  std::size_t nPages = 0;
  std::ifstream("/proc/self/statm") >> nPages;
  return nPages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// In the copy: no handler of MPI's, no words, no end of memory or time.
void prepareCopy(std::size_t fileSize) {
  for (const int number : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM}) std::signal(number, SIG_DFL);
  const rlimit noCore{0, 0};
  setrlimit(RLIMIT_CORE, &noCore);
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere >= 0) {
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
#ifndef __SANITIZE_ADDRESS__  // whose shadow is all of the address space
  rlimit memory{};
  const std::size_t enough = addressSpace() + 512 * megabyte + 4 * fileSize;
  if (getrlimit(RLIMIT_AS, &memory) == 0 && memory.rlim_cur > enough) {
    memory.rlim_cur = enough;
    setrlimit(RLIMIT_AS, &memory);
  }
#endif
  alarm(static_cast<unsigned>(10 + fileSize / (10 * megabyte)));
}

}  // namespace

std::string misfortuneOf(const std::function<void()>& read, std::size_t fileSize) {
  const pid_t copy = fork();
  if (copy < 0) return "";  // no process is to be had: as without a trial
  if (copy == 0) {
    prepareCopy(fileSize);
    try {
      read();
    } catch (...) {  // this process will meet it again, and can say it
    }
    _exit(0);
  }
  int status = 0;
  while (waitpid(copy, &status, 0) < 0)
    if (errno != EINTR) return "";
  if (!WIFSIGNALED(status)) return "";
  return WTERMSIG(status) == SIGALRM ? "does not come to an end with it" : "dies of it";
}

}  // namespace pd
