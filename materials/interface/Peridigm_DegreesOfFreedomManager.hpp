// Which fields an implicit solver treats as unknowns; the names of Peridigm's DegreesOfFreedomManager.
#ifndef PERIDIGM_DEGREESOFFREEDOMMANAGER_HPP
#define PERIDIGM_DEGREESOFFREEDOMMANAGER_HPP

#include <string>
#include <utility>
#include <vector>

namespace PeridigmNS {

class DegreesOfFreedomManager {
 public:
  /// A point field with `width` values a point, such as {"Displacement", 3}.
  struct Unknown {
    std::string field;
    int width;
  };

  static DegreesOfFreedomManager& self() {
    static DegreesOfFreedomManager manager;
    return manager;
  }
  /// Set by the host before it asks for a Jacobian; in this order at each point. Plug-ins ask unknownPlace()
  /// (registry/unknowns.hpp).
  void setUnknowns(std::vector<Unknown> unknowns) { unknowns_ = std::move(unknowns); }
  const std::vector<Unknown>& unknowns() const { return unknowns_; }
  /// Of the field's first value among the unknowns of a point; -1 where it is none of them.
  int offsetOf(const std::string& field) const {
    int offset = 0;
    for (const Unknown& unknown : unknowns_) {
      if (unknown.field == field) return offset;
      offset += unknown.width;
    }
    return -1;
  }
  int totalNumberOfDegreesOfFreedom() const {
    int total = 0;
    for (const Unknown& unknown : unknowns_) total += unknown.width;
    return total;
  }

  // What Peridigm's own materials ask.
  bool displacementTreatedAsUnknown() const { return offsetOf("Displacement") >= 0; }
  bool temperatureTreatedAsUnknown() const { return offsetOf("Temperature") >= 0; }
  int numberOfDisplacementDegreesOfFreedom() const { return displacementTreatedAsUnknown() ? 3 : 0; }
  int numberOfTemperatureDegreesOfFreedom() const { return temperatureTreatedAsUnknown() ? 1 : 0; }
  int displacementDofOffset() const { return offsetOf("Displacement"); }
  int temperatureDofOffset() const { return offsetOf("Temperature"); }

 private:
  std::vector<Unknown> unknowns_ = {{"Displacement", 3}};
};

}  // namespace PeridigmNS

#endif
