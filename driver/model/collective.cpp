#include "collective.hpp"

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
    message = error.what();
    hasFailed = true;
  }
  if (!comm.any(hasFailed)) return;
  const bool onlyUsersMistakes = !comm.any(hasFailed && !isUsersMistake);
  const std::string all = linesOnce(comm.gather(message.empty() ? "" : message + "\n"));
  if (onlyUsersMistakes) throw DeckError(all);
  throw RunError(all);
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
