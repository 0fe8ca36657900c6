// Breakage of bonds by stretch: the plain critical stretch, and the one that falls with the coverage by hydrogen.
#ifndef PD_CRITICAL_STRETCH_HPP
#define PD_CRITICAL_STRETCH_HPP

#include <string>
#include <vector>

#include "alive_bonds.hpp"
#include "bond_damage_model.hpp"
#include "parameters.hpp"
#include "point_arrays.hpp"
#include "step_listener.hpp"
#include "stretch_kernel.hpp"

namespace pd {

/// A bond breaks for good when its stretch exceeds the critical one; bonds of points in No_Failure never do.
/// Damage of a point = broken bonds / bonds (as Peridigm counts).
class CriticalStretch : public BondDamageModel, public StepListener {
 public:
  struct Fields : BondDamageModel::Fields {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle coordinates = reads(pd::fields::coordinates());
    FieldHandle concentration;  ///< of the hydrogen, in models that know it
    /// `concentrationField`: empty where the model has none.
    explicit Fields(const std::string& concentrationField = "") {
      if (!concentrationField.empty()) concentration = reads(pd::fields::diffusingScalar(concentrationField));
    }
  };

  static void declareParameters(ParameterDeclarations& declare);
  explicit CriticalStretch(const Teuchos::ParameterList& params);

  std::string Name() const override { return "Critical Stretch"; }
  const Fields& fields() const override { return fields_; }
  void initialize(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& dataManager) const override;
  void worsen(double dt, const Call& call, PeridigmNS::DataManager& dataManager) const override;
  void stepTakenBack() const override;

 protected:
  /// For derived models: `params` completed with their own declarations.
  CriticalStretch(const Teuchos::ParameterList& params, const Fields& fields);
  /// Parameters that give the critical stretch without hydrogen and the bounds.
  static void declareCommonParameters(ParameterDeclarations& declare);
  /// psi in [0, 1] of all local points, or false where the model has none.
  virtual bool coverage(PeridigmNS::DataManager&, kernels::PointArrays&) const { return false; }

  kernels::CriticalStretchLaw law_;

 private:
  struct Cache {
    kernels::ChunkedNeighborhood neighborhood;
    kernels::AliveBonds alive;
    kernels::PointArrays reference, current, coverage;
    kernels::BondConstants reference2;
    bool isPlane = false;
    double longestBond = 0.0;
    std::vector<std::size_t> chunkOf;    ///< [points] that has its bonds; of points of other lists none
    std::vector<std::size_t> listStart;  ///< [points] in the list of neighbours
    // What bonds looked like when all were last tested (see findChunksToTest).
    std::vector<double> slack;
    kernels::PointArrays testedPositions, testedCoverage;
    std::vector<double> approach;  ///< [points] findApproach()
  };
  struct Views;

  Cache& cacheOf(const Call& call, const double* x, int nPoints) const;
  /// By how much (m) a point may have brought its bonds nearer to their limits since all were tested: by how far it has
  /// moved, and by what the change of its coverage takes from them. Both ends of a bond add up.
  void findApproach(Cache& cache, const Views& views) const;
  double setApart(const Call& call, const Cache& cache, std::vector<char>& near) const;
  /// Chunks with a bond that may have reached its limit since all were tested. Returns false where testing all again
  /// pays.
  bool findChunksToTest(const Call& call, Cache& cache, const Views& views, std::vector<std::size_t>& chunks) const;

  Fields fields_;
  mutable NeighborhoodCache<Cache> caches_;
};

}  // namespace pd

#endif
