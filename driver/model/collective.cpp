#include "collective.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <set>
#include <sstream>

#include "model.hpp"

namespace pd {

namespace {

std::string linesOnce(const std::string& text) {
  std::istringstream lines(text);
  std::set<std::string> seen;
  std::string result;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && seen.insert(line).second) result += (result.empty() ? "" : "\n") + line;
  return result;
}

}  // namespace

void collectively(const Communicator& comm, const std::function<void()>& work) {
  std::string message;
  bool hasFailed = false, isUsersMistake = false;
  try {
    work();
  } catch (const DeckError& error) {
    message = error.what();
    hasFailed = isUsersMistake = true;
  } catch (const std::invalid_argument& error) {
    message = error.what();
    hasFailed = isUsersMistake = true;
  } catch (const std::exception& error) {
    message = whatOf(error);
    hasFailed = true;
  }
  if (!comm.any(hasFailed)) return;
  const bool onlyUsersMistakes = !comm.any(hasFailed && !isUsersMistake);
  const std::string all = linesOnce(comm.gather(message.empty() ? "" : message + "\n"));
  if (onlyUsersMistakes) throw DeckError(all);
  throw RunError(all);
}

void onRoot(const Communicator& comm, const std::function<void()>& work) {
  collectively(comm, [&] {
    if (comm.isRoot()) work();
  });
}

std::string outOfMemory(const std::string& what) {
  rlimit limit{};
  double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    bytes = std::min(bytes, static_cast<double>(limit.rlim_cur));
  return fmt::format(
      "memory does not suffice for {} (a process may use {:.1f} GB here); take fewer points or a smaller Horizon, or "
      "more memory",
      what, bytes / 1e9);
}

std::string whatOf(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) == nullptr ? error.what() : outOfMemory("this run");
}

void abortRun(const Communicator& comm, const std::string& message) {
  if (comm.size() > 1) {
    std::fprintf(stderr, "pdrun: error on rank %d: %s\n", comm.rank(), message.c_str());
    std::fflush(stderr);
    MPI_Abort(comm.mpi(), 3);
  }
  throw RunError(message);
}

}  // namespace pd
