// Start and end of MPI and of what Tpetra needs (Kokkos).
#ifndef PD_SESSION_HPP
#define PD_SESSION_HPP

namespace pd {

/// One object in main(), alive as long as anything parallel is. Ends only what it started itself.
class ParallelSession {
 public:
  ParallelSession(int& argc, char**& argv);
  ~ParallelSession();
  ParallelSession(const ParallelSession&) = delete;
  ParallelSession& operator=(const ParallelSession&) = delete;
};

}  // namespace pd

#endif
