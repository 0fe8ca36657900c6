// Arrays that BondMechanics works on (its sources only).
#ifndef PD_BOND_MECHANICS_VIEWS_HPP
#define PD_BOND_MECHANICS_VIEWS_HPP

#include "bond_mechanics.hpp"
#include "damage_views.hpp"

namespace pd {

/// Overlap arrays of the block; null where the field is not in the run.
struct BondMechanics::Views {
  Views(const BondMechanics& owner, PeridigmNS::DataManager& dataManager);
  int nPoints = 0;
  bool ownsFirstPoint = false;  ///< this rank speaks for the block
  const double* x = nullptr;
  const double* y = nullptr;
  const double* volume = nullptr;
  const double* cellVolume = nullptr;        ///< volume where the deck has no voids
  const double* interactionShare = nullptr;  ///< null: all of every bond
  double* force = nullptr;
  double* familyVolume = nullptr;
  double* surfaceFactor = nullptr;
  const double* blockId = nullptr;
  DamageViews damaged;

  double shareOf(std::size_t bond) const { return interactionShare == nullptr ? 1.0 : interactionShare[bond]; }
};

}  // namespace pd

#endif
