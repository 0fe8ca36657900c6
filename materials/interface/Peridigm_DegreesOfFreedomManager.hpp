// Which fields an implicit solver treats as unknowns; the names of Peridigm's DegreesOfFreedomManager.
#ifndef PERIDIGM_DEGREESOFFREEDOMMANAGER_HPP
#define PERIDIGM_DEGREESOFFREEDOMMANAGER_HPP

namespace PeridigmNS {

class DegreesOfFreedomManager {
 public:
  static DegreesOfFreedomManager& self() {
    static DegreesOfFreedomManager manager;
    return manager;
  }
  /// Set by the host before it asks for a Jacobian.
  void setUnknowns(bool displacement, bool temperature) {
    displacement_ = displacement;
    temperature_ = temperature;
  }
  bool displacementTreatedAsUnknown() const { return displacement_; }
  bool temperatureTreatedAsUnknown() const { return temperature_; }
  int totalNumberOfDegreesOfFreedom() const { return (displacement_ ? 3 : 0) + (temperature_ ? 1 : 0); }
  int numberOfDisplacementDegreesOfFreedom() const { return displacement_ ? 3 : 0; }
  int numberOfTemperatureDegreesOfFreedom() const { return temperature_ ? 1 : 0; }
  int displacementDofOffset() const { return 0; }
  int temperatureDofOffset() const { return displacement_ ? 3 : 0; }

 private:
  bool displacement_ = true, temperature_ = false;
};

}  // namespace PeridigmNS

#endif
