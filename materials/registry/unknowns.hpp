// Where the unknowns of a point stand in a Jacobian, in either host.
#ifndef PD_UNKNOWNS_HPP
#define PD_UNKNOWNS_HPP

#include <string>

#include "Peridigm_DegreesOfFreedomManager.hpp"
#include "fields.hpp"

namespace pd {

/// A field among the unknowns that the host solves for at present.
struct UnknownPlace {
  bool isUnknown;
  int perPoint;  ///< unknowns of a point
  int offset;    ///< of the field's first component among them
  /// Of the first component at the point with this global id.
  int row(int globalId) const { return perPoint * globalId + offset; }
};

namespace detail {

/// Our host has any list of fields.
template <class Manager>
auto placeAmong(Manager& manager, const std::string& field, int)
    -> decltype(static_cast<void>(manager.offsetOf(field)), UnknownPlace()) {
  const int offset = manager.offsetOf(field);
  return {offset >= 0, manager.totalNumberOfDegreesOfFreedom(), offset};
}

/// Peridigm knows these two by name.
template <class Manager>
UnknownPlace placeAmong(Manager& manager, const std::string& field, long) {
  const int perPoint = manager.totalNumberOfDegreesOfFreedom();
  if (field == "Displacement" && manager.displacementTreatedAsUnknown())
    return {true, perPoint, manager.displacementDofOffset()};
  if (field == "Temperature" && manager.temperatureTreatedAsUnknown())
    return {true, perPoint, manager.temperatureDofOffset()};
  return {false, perPoint, -1};
}

}  // namespace detail

/// `field`: Displacement, or the label of a field that the material gives a rate of.
inline UnknownPlace unknownPlace(const std::string& field) {
  return detail::placeAmong(PeridigmNS::DegreesOfFreedomManager::self(), field, 0);
}

/// Does a material with these fields give the rate of an unknown?
inline bool givesUnknownRate(const FieldTable& table) {
  for (const FieldUse& use : table.uses()) {
    const bool isForce = use.field.label == fields::forceDensity().label;
    const std::string unknown = isForce ? fields::displacement().label : use.field.rateOf;
    if (use.access == FieldAccess::Adds && !unknown.empty() && unknownPlace(unknown).isUnknown) return true;
  }
  return false;
}

}  // namespace pd

#endif
