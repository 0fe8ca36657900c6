// What conditions have in common that add to the external force.
#ifndef PD_LOAD_HPP
#define PD_LOAD_HPP

#include "condition.hpp"

namespace pd {

/// A force per volume at the points of a condition.
class Load : public Condition {
 public:
  explicit Load(const ConditionSection& section) : Condition(section, "Force_Density", 3) {}

  bool isLoad() const override { return true; }
  std::string obstacle(const RunContents& run) const override;

 protected:
  /// `500 points of 2.5e-06 m3 in all`; `volume` as of volumeOf(). Collective.
  std::string spread(double volume, const Discretization& mesh, const Communicator& comm) const;
};

/// Along one axis, the same multiple of the function everywhere.
class AxialLoad : public Load {
 public:
  using Load::Load;
  void measure(const Discretization& mesh, const Communicator& comm) override;
  std::string note() const override { return note_; }
  void addForceDensity(const Discretization& mesh, double t, double* forceDensity) const override;

 protected:
  /// Factor from the function to the force density, given the volume of all points, m3.
  virtual double scale(double volume) const = 0;
  /// What the log says before the points: `force shared by`.
  virtual std::string effect() const = 0;
  static void declareLoad(ParameterDeclarations& declare, const std::string& unit, const std::string& meaning);

 private:
  double scale_ = 1.0;
  std::string note_;
};

}  // namespace pd

#endif
