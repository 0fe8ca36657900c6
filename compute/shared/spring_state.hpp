// Energy and bond forces of small displacements, by the springs of the materials.
#ifndef PD_SPRING_STATE_HPP
#define PD_SPRING_STATE_HPP

#include <vector>

#include "compute_support.hpp"
#include "linear_bonds.hpp"

namespace pd {

/// Of one block. What a bond carries is the force of its one end less that of its other.
struct SpringState {
  struct Fields : FieldTable {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle coordinates = reads(pd::fields::coordinates());
    FieldHandle bondDamage = readsIfThere(pd::fields::bondDamage());
  };
  /// Throws std::invalid_argument, naming `compute`, where a material has no springs.
  static void require(PeridigmNS::Block& block, const std::string& compute);
  /// Those of the whole block, which change with nothing: to be asked for once.
  static LinearSprings springsOf(PeridigmNS::Block& block);
  /// Of the points for which `wanted` [owned points] is not 0.
  SpringState(PeridigmNS::Block& block, const LinearSprings& springs, const Fields& fields,
              const std::vector<char>& wanted);

  std::vector<double> energy;  ///< [owned points] J; 0 of others
  std::vector<Vector3> force;  ///< [bonds of such points] N, of the energy of the owned point, towards the other end
};

}  // namespace pd

#endif
