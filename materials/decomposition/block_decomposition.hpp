// What cracks and voids of a plug-in's parameters leave of the bonds of a block, in hosts whose decks have no place for
// them.
#ifndef PD_BLOCK_DECOMPOSITION_HPP
#define PD_BLOCK_DECOMPOSITION_HPP

#include <string>
#include <vector>

#include "Peridigm_DataManager.hpp"
#include "call.hpp"
#include "discontinuity_forms.hpp"

namespace pd::decomposition {

class BlockDecomposition {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  /// `params`: completed. `owner` begins messages. Throws std::invalid_argument with all mistakes.
  BlockDecomposition(const Teuchos::ParameterList& params, const std::string& owner);

  /// Volume of a point's cell with its voids, m³, where the mesh has `volume`.
  double cellVolume(double volume) const { return cellVolume_ > 0.0 ? cellVolume_ : volume; }

  struct Shares {
    /// [bonds] eta V'_i V'_j/(V_i V_j) with the volumes V of the mesh: eq. 15's force is this times that of whole
    /// bonds, whether the mesh has the volumes of cells or those of the material in them.
    std::vector<double> left;
    std::vector<double> counted;  ///< [points of the call] the sum, over bonds, of what Damage is the lost part of
  };
  /// `x`: [3][points of the block] reference positions, m; `volume`: m³. Throws std::invalid_argument where a form is
  /// not of the body's dimension, or a point has next to no material or another volume than its cell.
  Shares of(const Call& call, const double* x, const double* volume, PeridigmNS::DataManager& data) const;

 private:
  struct Entry {
    std::string path;
    bool isCrack;
    DiscontinuityForm form;
  };
  void read(const Teuchos::ParameterList& params, const std::string& list, std::vector<std::string>& messages);
  void requireMeshOfThePlane(const double* x, int nPoints) const;
  void requireSizes(const double* volume, int nPoints) const;
  double edgeOf(double volume) const;
  Cell cellOf(const double* place, double volume) const;
  /// Material of the point's cell, in volumes of the mesh.
  std::vector<double> solidVolumes(const double* x, const double* volume, int nPoints) const;

  std::string owner_;
  DecompositionRule rule_;
  bool countsCracks_ = true;
  double cellVolume_ = 0.0, thickness_ = 1.0;
  int dimension_ = 0;
  std::vector<Entry> entries_;
  NearDiscontinuities all_, withoutCracks_;
};

}  // namespace pd::decomposition

#endif
