// What a step has found, so that it can be taken back as a whole.
#ifndef PD_STEP_RECORD_HPP
#define PD_STEP_RECORD_HPP

#include <Teuchos_RCP.hpp>
#include <string>
#include <vector>

#include "Peridigm_Block.hpp"

namespace pd {

/// Copies of the fields that a step may change, at the points that it may touch. Two-step bond fields whose steps are
/// apart are not copied: N is their copy. Where bonds may break in place, all points are taken to be touched.
class StepRecord {
 public:
  /// A point field: its values at NP1, or of a one-step field its values.
  struct PointField {
    std::string label;
    double* values;
    int width;
  };

  /// Forgets earlier copies; touch() follows. `damage`: by local id, 0 where Bond_Damage of all bonds of a point is 0;
  /// null where the run has no such field.
  void begin(const std::vector<PointField>& fields, Teuchos::RCP<std::vector<PeridigmNS::Block>> blocks, int nOwned,
             const double* damage);
  /// Copies what these owned points, none of them twice in a step, are at present.
  void touch(const std::vector<int>& points);
  void touchAll();
  /// Owned values and bonds as they were at begin() or touch(). Ghosts are left to the caller. May be called again.
  void takeBack();
  /// The state has been written from outside (a checkpoint): what is known of bonds is out of date.
  void forget() { blocks_ = Teuchos::null; }

  const std::vector<PointField>& fields() const { return fields_; }

 private:
  /// A bond field of a block whose steps share their memory: a value never falls, so that most points need no copy.
  struct GrowingField {
    double* values;
    bool isBondDamage;
    std::vector<int> points;             ///< owned points of the block
    std::vector<std::size_t> firstBond;  ///< [points + 1]
    std::vector<char> isFull;            ///< [points] all bonds are at 1 for good
    // Of the step.
    std::vector<std::size_t> whole;    ///< positions in `points` whose bonds are all 0
    std::vector<std::size_t> damaged;  ///< positions of those whose bonds are copied
    std::vector<double> copies;
  };

  static std::vector<GrowingField> growingFields(PeridigmNS::Block& block);
  static void copyBonds(GrowingField& field, const double* damage);

  std::vector<PointField> fields_;
  std::vector<std::vector<double>> copies_;  ///< of each field, in the order of points_
  std::vector<int> points_;
  Teuchos::RCP<std::vector<PeridigmNS::Block>> blocks_;
  std::vector<GrowingField> growing_;
  int nOwned_ = 0;
};

}  // namespace pd

#endif
