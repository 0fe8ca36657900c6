// How far a run has come, how fast it goes and how long it still takes.
#ifndef PD_PROGRESS_HPP
#define PD_PROGRESS_HPP

#include <chrono>
#include <string>

#include "run_log.hpp"

namespace pd {

/// "45 s", "12 min 30 s", "3 h 5 min".
std::string durationText(double seconds);

/// Increments per second, averaged over the last seconds.
class ProgressRate {
 public:
  /// `seconds` since any fixed moment.
  void update(int step, double seconds);
  /// 0 while nothing is known.
  double stepsPerSecond() const { return rate_; }

 private:
  bool hasSample_ = false;
  int step_ = 0;
  double seconds_ = 0.0;
  double rate_ = 0.0;
};

/// "step 120/3000 (4 %), t = 739200 s, diffusion, 51.2 steps/s, 56 s left"
std::string progressText(int step, int nSteps, double time, const std::string& what, double stepsPerSecond,
                         const std::string& timeUnit = "s");

/// Shows progress on the terminal a few times a second, and in the log at every 5 % and once a minute.
class Progress {
 public:
  explicit Progress(RunLog& log) : log_(log), start_(Clock::now()) {}
  void setTimeUnit(const std::string& unit) { timeUnit_ = unit; }
  void report(int step, int nSteps, double time, const std::string& what);

 private:
  using Clock = std::chrono::steady_clock;
  RunLog& log_;
  Clock::time_point start_;
  ProgressRate rate_;
  double lastShown_ = -1.0, lastLogged_ = 0.0;
  int lastLoggedPart_ = 0;
  std::string timeUnit_ = "s";
};

}  // namespace pd

#endif
