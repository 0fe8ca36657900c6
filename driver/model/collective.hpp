// Errors that one rank meets and all ranks must share, so that none waits for another for ever.
#ifndef PD_COLLECTIVE_HPP
#define PD_COLLECTIVE_HPP

#include <functional>
#include <string>

#include "../parallel/communicator.hpp"

namespace pd {

/// Runs `work`, which must not communicate, on every rank. Where it throws on any rank, every rank throws: DeckError
/// for what a user did wrong (DeckError, std::invalid_argument), RunError otherwise, with the messages of all ranks,
/// each once. Collective.
void collectively(const Communicator& comm, const std::function<void()>& work);

/// Runs `work` inside a hot loop, where agreement of all ranks would cost too much. An exception becomes RunError on
/// one rank; on several it is printed and the whole job is aborted with exit code 3.
template <class Work>
void orAbort(const Communicator& comm, const Work& work);

/// Prints and aborts, or throws RunError on one rank.
[[noreturn]] void abortRun(const Communicator& comm, const std::string& message);

template <class Work>
void orAbort(const Communicator& comm, const Work& work) {
  try {
    work();
  } catch (const std::exception& error) {
    abortRun(comm, error.what());
  }
}

}  // namespace pd

#endif
