// Wall time per phase of a run.
#ifndef PD_TIMERS_HPP
#define PD_TIMERS_HPP

#include <chrono>
#include <map>
#include <string>

namespace pd {

/// Seconds, calls and directed bonds passed over per named phase, on this rank.
class Timers {
 public:
  struct Phase {
    double seconds = 0.0;
    long long calls = 0;
    long long bondUpdates = 0;
  };

  class Scope {
   public:
    Scope(Timers& timers, const std::string& phase, long long bondUpdates = 0)
        : phase_(timers.phases_[phase]), bondUpdates_(bondUpdates), start_(Clock::now()) {}
    ~Scope() {
      phase_.seconds += std::chrono::duration<double>(Clock::now() - start_).count();
      phase_.calls += 1;
      phase_.bondUpdates += bondUpdates_;
    }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    using Clock = std::chrono::steady_clock;
    Phase& phase_;
    long long bondUpdates_;
    Clock::time_point start_;
  };

  /// Adds time measured elsewhere.
  void add(const std::string& phase, double seconds) {
    phases_[phase].seconds += seconds;
    phases_[phase].calls += 1;
  }

  const std::map<std::string, Phase>& phases() const { return phases_; }

 private:
  std::map<std::string, Phase> phases_;
};

}  // namespace pd

#endif
