#include "report.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace pd {

namespace {

/// Largest resident memory of this process, bytes.
double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// Phases of any rank: one that owns no point of a block may lack some.
std::set<std::string> phaseNames(const Communicator& comm, const Timers& timers) {
  std::string own;
  for (const auto& phase : timers.phases()) own += phase.first + "\n";
  std::istringstream all(comm.gather(own));
  std::set<std::string> names;
  for (std::string name; std::getline(all, name);) names.insert(name);
  return names;
}

double ratio(double a, double b) { return b > 0.0 ? a / b : 0.0; }

}  // namespace

double RunReport::bondUpdatesPerSecond() const {
  double updates = 0.0, time = 0.0;
  for (const ReportPhase& phase : phases) {
    if (phase.bondUpdates == 0) continue;
    updates += static_cast<double>(phase.bondUpdates);
    time += phase.seconds;
  }
  return ratio(updates, time);
}

RunReport collectReport(Model& model, double seconds) {
  const Communicator& comm = model.comm();
  RunReport report;
  report.nRanks = comm.size();
  report.nPoints = model.discretization().nGlobal;
  report.nBonds = comm.sum(model.nBonds());
  report.seconds = comm.max(seconds);
  const auto& own = model.timers().phases();
  for (const std::string& name : phaseNames(comm, model.timers())) {
    const auto it = own.find(name);
    const Timers::Phase phase = it == own.end() ? Timers::Phase() : it->second;
    report.phases.push_back({name, comm.max(phase.seconds),
                             static_cast<long long>(comm.max(static_cast<double>(phase.calls))),
                             comm.sum(phase.bondUpdates)});
  }
  std::stable_sort(report.phases.begin(), report.phases.end(),
                   [](const ReportPhase& a, const ReportPhase& b) { return a.seconds > b.seconds; });
  report.bondBytes = comm.sum(static_cast<double>(model.bondBytes()));
  report.peakBytes = comm.sum(peakMemory());
  return report;
}

std::string reportTable(const RunReport& report) {
  std::string text =
      fmt::format("{:<24} {:>11} {:>8} {:>11} {:>15}\n", "phase", "seconds", "share", "calls", "bond-updates/s");
  double accounted = 0.0;
  const auto row = [&](const std::string& name, double time, const std::string& calls, const std::string& rate) {
    text += fmt::format("{:<24} {:>11.3f} {:>6.1f} % {:>11} {:>15}\n", name, time, 100.0 * ratio(time, report.seconds),
                        calls, rate);
  };
  for (const ReportPhase& phase : report.phases) {
    const double updates = static_cast<double>(phase.bondUpdates);
    row(phase.name, phase.seconds, std::to_string(phase.calls),
        phase.bondUpdates > 0 ? fmt::format("{:.3g}", ratio(updates, phase.seconds)) : "");
    accounted += phase.seconds;
  }
  // Phases of different ranks overlap where ranks wait for one another, so nothing may be left over.
  row("other", std::max(0.0, report.seconds - accounted), "", "");
  row("total", report.seconds, "",
      report.bondUpdatesPerSecond() > 0.0 ? fmt::format("{:.3g}", report.bondUpdatesPerSecond()) : "");
  text += fmt::format("points {}, directed bonds {}, ranks {}\n", report.nPoints, report.nBonds, report.nRanks);
  text += fmt::format("memory: {:.1f} bytes a bond, peak {:.0f} MiB\n",
                      ratio(report.bondBytes, static_cast<double>(report.nBonds)), report.peakBytes / (1 << 20));
  for (const auto& [name, value] : report.errorNorms) text += fmt::format("error {}: {:.6g}\n", name, value);
  for (const std::string& line : report.solverSummary) text += line + "\n";
  text.pop_back();
  return text;
}

std::string reportJson(const RunReport& report) {
  using nlohmann::ordered_json;
  ordered_json json;
  json["writer"] = "pdrun";
  json["deck"] = report.deck;
  json["ranks"] = report.nRanks;
  json["points"] = report.nPoints;
  json["bonds"] = report.nBonds;
  json["seconds"] = report.seconds;
  json["phases"] = ordered_json::array();
  for (const ReportPhase& phase : report.phases)
    json["phases"].push_back({{"name", phase.name},
                              {"seconds", phase.seconds},
                              {"share", ratio(phase.seconds, report.seconds)},
                              {"calls", phase.calls},
                              {"bond_updates", phase.bondUpdates},
                              {"bond_updates_per_s", ratio(static_cast<double>(phase.bondUpdates), phase.seconds)}});
  json["bond_updates_per_s"] = report.bondUpdatesPerSecond();
  json["bytes_per_bond"] = ratio(report.bondBytes, static_cast<double>(report.nBonds));
  json["peak_memory_bytes"] = report.peakBytes;
  json["error_norms"] = ordered_json::object();
  for (const auto& [name, value] : report.errorNorms) json["error_norms"][name] = value;
  json["solver"] = report.solverSummary;
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace pd
