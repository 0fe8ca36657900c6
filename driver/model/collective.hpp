// Errors that one rank meets and all ranks must share, so that none waits for another for ever.
#ifndef PD_COLLECTIVE_HPP
#define PD_COLLECTIVE_HPP

#include <exception>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>

#include "../parallel/communicator.hpp"

namespace pd {

/// Runs `work`, which must not communicate, on every rank. Where it throws on any rank, every rank throws: DeckError
/// for what a user did wrong (DeckError, std::invalid_argument), RunError otherwise, with the messages of all ranks,
/// each once. Collective.
void collectively(const Communicator& comm, const std::function<void()>& work);

/// The same where rank 0 alone works.
void onRoot(const Communicator& comm, const std::function<void()>& work);

/// Runs `work` inside a hot loop, where agreement of all ranks would cost too much. An exception becomes RunError on
/// one rank; on several it is printed and the whole job is aborted with exit code 3.
template <class Work>
void orAbort(const Communicator& comm, const Work& work);

/// Prints and aborts, or throws RunError on one rank.
[[noreturn]] void abortRun(const Communicator& comm, const std::string& message);

/// error.what(), or where memory has run out, a sentence that says so.
std::string whatOf(const std::exception& error);

/// That memory does not suffice for `what` ("the fields of 1000 points"), how much there is, and what to do.
std::string outOfMemory(const std::string& what);

template <class Work>
void orAbort(const Communicator& comm, const Work& work) {
  try {
    work();
  } catch (const std::exception& error) {
    abortRun(comm, whatOf(error));
  }
}

/// Runs `work`, which may communicate. Where memory does not suffice for `what`, as abortRun().
template <class Work>
void withMemoryFor(const Communicator& comm, const std::string& what, const Work& work) {
  try {
    work();
  } catch (const std::bad_alloc&) {
    abortRun(comm, outOfMemory(what));
  } catch (const std::length_error&) {
    abortRun(comm, outOfMemory(what));
  }
}

}  // namespace pd

#endif
