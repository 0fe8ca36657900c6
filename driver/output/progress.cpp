#include "progress.hpp"

#include <fmt/format.h>

#include <cmath>

namespace pd {

namespace {

constexpr double secondsBetweenTerminalLines = 0.2;
constexpr double secondsBetweenLogLines = 60.0;
constexpr int partsInLog = 20;            // a log line every 5 %
constexpr double averagingSeconds = 5.0;  // of the rate
constexpr double shortestSample = 0.1;    // s; shorter ones measure the clock

}  // namespace

std::string durationText(double seconds) {
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

void ProgressRate::update(int step, double seconds) {
  if (!hasSample_) {
    hasSample_ = true;
  } else {
    const double elapsed = seconds - seconds_;
    if (elapsed < shortestSample || step == step_) return;
    const double rate = (step - step_) / elapsed;
    rate_ += rate_ == 0.0 ? rate : (1.0 - std::exp(-elapsed / averagingSeconds)) * (rate - rate_);
  }
  step_ = step;
  seconds_ = seconds;
}

std::string progressText(int step, int nSteps, double time, const std::string& what, double stepsPerSecond,
                         const std::string& timeUnit) {
  std::string text = fmt::format("step {}/{}", step, nSteps);
  if (nSteps > 0) text += fmt::format(" ({} %)", static_cast<int>(100.0 * step / nSteps));
  text += fmt::format(", t = {:.6g} {}", time, timeUnit);
  if (!what.empty()) text += ", " + what;
  if (stepsPerSecond > 0.0)
    text += fmt::format(", {:.3g} steps/s, {} left", stepsPerSecond, durationText((nSteps - step) / stepsPerSecond));
  return text;
}

void Progress::report(int step, int nSteps, double time, const std::string& what) {
  const double now = std::chrono::duration<double>(Clock::now() - start_).count();
  rate_.update(step, now);
  if (log_.hasTerminal() && (lastShown_ < 0.0 || now - lastShown_ >= secondsBetweenTerminalLines)) {
    log_.replaceTerminalLine(progressText(step, nSteps, time, what, rate_.stepsPerSecond(), timeUnit_));
    lastShown_ = now;
  }
  const int part = nSteps > 0 ? static_cast<int>(static_cast<long long>(partsInLog) * step / nSteps) : 0;
  if (part == lastLoggedPart_ && now - lastLogged_ < secondsBetweenLogLines) return;
  log_.progressLine(progressText(step, nSteps, time, what, rate_.stepsPerSecond(), timeUnit_));
  lastLogged_ = now;
  lastLoggedPart_ = part;
}

}  // namespace pd
