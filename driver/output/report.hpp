// The closing report of a run: where the time went, how fast bonds were passed over, what they cost in memory.
#ifndef PD_REPORT_HPP
#define PD_REPORT_HPP

#include <string>
#include <utility>
#include <vector>

#include "../model/model.hpp"

namespace pd {

struct ReportPhase {
  std::string name;
  double seconds = 0.0;       ///< of the slowest rank
  long long calls = 0;        ///< most of any rank
  long long bondUpdates = 0;  ///< of all ranks
};

struct RunReport {
  std::string deck;
  int nRanks = 1;
  long long nPoints = 0, nBonds = 0;  ///< directed bonds
  double seconds = 0.0;               ///< from the reading of the deck to now
  std::vector<ReportPhase> phases;    ///< longest first
  double bondBytes = 0.0;             ///< of all ranks
  double peakBytes = 0.0;             ///< largest resident memory of each rank, added up
  std::vector<std::string> solverSummary;
  std::vector<std::pair<std::string, double>> errorNorms;

  /// Bond-updates of all phases over the seconds of those phases.
  double bondUpdatesPerSecond() const;
};

/// Collects the report over all ranks. Collective.
RunReport collectReport(Model& model, double seconds);

std::string reportTable(const RunReport& report);
std::string reportJson(const RunReport& report);

}  // namespace pd

#endif
