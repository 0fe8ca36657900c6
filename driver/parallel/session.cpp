#include "session.hpp"

#include <Tpetra_Core.hpp>

namespace pd {

ParallelSession::ParallelSession(int& argc, char**& argv) { Tpetra::initialize(&argc, &argv); }

ParallelSession::~ParallelSession() { Tpetra::finalize(); }

}  // namespace pd
