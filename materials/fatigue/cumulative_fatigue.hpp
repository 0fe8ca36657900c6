// Fatigue of bonds by a strain-life relation: initiation and growth of cracks from one set of constants.
#ifndef PD_CUMULATIVE_FATIGUE_HPP
#define PD_CUMULATIVE_FATIGUE_HPP

#include <memory>
#include <string>
#include <vector>

#include "cyclic_damage.hpp"
#include "fatigue_element.hpp"
#include "field_names.hpp"
#include "life_scatter.hpp"
#include "strain_life.hpp"

namespace pd {

/// After Liu, Bao & Sui, "A fatigue damage-cumulative model in peridynamics", Chin. J. Aeronaut. 34(2) (2021), of which
/// the ideas were known here and not the equations: a relation of the form of Coffin and Manson, damage that
/// accumulates, a fatigue element block, no law of Paris. Derived, so that its parameters mean what they say:
///   away from cracks    d(lost life)/dN = 1/N of the strain range, by the relation with a limit (strain_life.hpp)
///   near a crack tip    what makes the crack grow by r/N of the element at its tip (fatigue_element.hpp)
/// Lost lives add up (Miner), blocks of load included. Constants may scatter (life_scatter.hpp). Means of stress do not
/// count: R = -1 is what constants are taken at.
class CumulativeFatigue : public CyclicDamage {
 public:
  struct Fields : CyclicDamage::Fields {
    FieldHandle imageShift;
    explicit Fields(bool scattersBetweenBonds = false) {
      if (scattersBetweenBonds)
        imageShift = readsIfThere(pd::fields::pointScalar(
            imageShiftField, "1", "Of images beyond planes of symmetry: how far ids are from what they mirror."));
    }
  };

  static void declareParameters(ParameterDeclarations& declare);
  explicit CumulativeFatigue(const Teuchos::ParameterList& given);

  void initialize(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& data) const override;
  void worsen(double dt, const Call& call, PeridigmNS::DataManager& data) const override;
  std::vector<std::string> runNotes() const override;

 private:
  LifeScatter scatter_;
  Fields ownFields_;
  kernels::StrainLife life_;  ///< the median, or that of the specimen
  std::unique_ptr<FatigueElement> element_;
};

}  // namespace pd

#endif
