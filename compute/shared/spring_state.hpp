// Energy and bond forces of small displacements, by the springs of the materials.
#ifndef PD_SPRING_STATE_HPP
#define PD_SPRING_STATE_HPP

#include <vector>

#include "compute_support.hpp"
#include "linear_bonds.hpp"

namespace pd {

/// Of points of one block. What a bond carries is the force of its one end less that of its other.
struct SpringState {
  struct Fields : FieldTable {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle coordinates = reads(pd::fields::coordinates());
    FieldHandle bondDamage = readsIfThere(pd::fields::bondDamage());
  };
  /// Throws std::invalid_argument, naming `compute`, where a material has no springs.
  static void require(PeridigmNS::Block& block, const std::string& compute);
  /// Those of the block's material, of all its bonds. They do not change while the block is what it is.
  static LinearSprings springsOf(PeridigmNS::Block& block);
  /// Of the points at `places` of the block's OwnedIDs, rising; `starts`: its listStarts().
  SpringState(PeridigmNS::Block& block, const Fields& fields, const LinearSprings& springs,
              const std::vector<std::size_t>& places, const std::vector<std::size_t>& starts);

  std::vector<double> energy;  ///< [places] J
  std::vector<Vector3> force;  ///< [bonds of them] N, of the energy of the owned point, towards the other end
};

}  // namespace pd

#endif
