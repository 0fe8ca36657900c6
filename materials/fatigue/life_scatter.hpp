// Constants of strain-life relations that differ from specimen to specimen, or from bond to bond.
#ifndef PD_LIFE_SCATTER_HPP
#define PD_LIFE_SCATTER_HPP

#include <Teuchos_ParameterList.hpp>
#include <cstdint>
#include <string>

#include "bond_normals.hpp"
#include "parameters.hpp"
#include "strain_life.hpp"

namespace pd {

/// Limit, ductility and exponent are lognormal about the medians of the deck, independent of each other. Their numbers
/// follow from the seed alone, or from it and the global ids of a bond's ends (bond_normals.hpp): they are the same on
/// any ranks, in any order, and after a restart.
class LifeScatter {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  /// From a completed list. Throws std::invalid_argument, naming `owner`.
  LifeScatter(const Teuchos::ParameterList& params, const std::string& owner);
  LifeScatter() = default;  ///< none

  bool isBetweenBonds() const { return between_ == Between::Bonds; }
  bool isBetweenSpecimens() const { return between_ == Between::Specimens; }
  kernels::StrainLife ofSpecimen(const kernels::StrainLife& median) const;
  /// Of a bond, by the global ids of its ends; `shift` of an image beyond a plane of symmetry, else 0.
  kernels::StrainLife ofBond(const kernels::StrainLife& median, int firstId, int secondId, int shift) const;

 private:
  enum class Between { Nothing, Bonds, Specimens };
  kernels::StrainLife drawn(const kernels::StrainLife& median, const kernels::Normals& normals) const;

  Between between_ = Between::Nothing;
  std::uint32_t seed_ = 0;
  double limit_ = 0.0, ductility_ = 0.0, exponent_ = 0.0;  ///< standard deviations of natural logarithms
};

}  // namespace pd

#endif
