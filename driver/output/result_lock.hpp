// Who writes the results of a name.
#ifndef PD_RESULT_LOCK_HPP
#define PD_RESULT_LOCK_HPP

#include <string>

namespace pd {

/// The file <base>.lock, held by one process as long as this object lives: the system lets go of it when the process
/// ends, however it ends, so that the next run takes it over. The file names its owner. Used by the root rank alone.
class ResultLock {
 public:
  /// Throws RunError, naming the owner, where another process has the lock, on this host or another.
  explicit ResultLock(const std::string& base);
  ~ResultLock();
  ResultLock(const ResultLock&) = delete;
  ResultLock& operator=(const ResultLock&) = delete;

 private:
  std::string path_;
  int descriptor_ = -1;
};

/// "pdrun on HOST, process 123, since 2026-11-29 17:30:12".
std::string thisRun();

}  // namespace pd

#endif
