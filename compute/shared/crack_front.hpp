// The foremost damaged point along a direction: what Crack_Tip and Crack_Length have in common.
#ifndef PD_CRACK_FRONT_HPP
#define PD_CRACK_FRONT_HPP

#include "field_variable.hpp"
#include "point_selection.hpp"

namespace pd {

/// The tip is where Damage, followed along the direction, falls through the threshold. It is found at the foremost
/// point at or above the threshold; between that point and its next neighbour ahead the damage is taken as linear.
/// Points that are equally far ahead (the two lips of a crack between two rows of points) are averaged.
class CrackFront {
 public:
  static void declareParameters(ParameterDeclarations& declarations);
  CrackFront(const Teuchos::ParameterList& parameters, const ComputeParameters& globalData);

  struct Fields : FieldTable {
    FieldVariable damage;
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    explicit Fields(const Teuchos::ParameterList& parameters) : damage(FieldVariable::of(parameters)) {
      include(damage.fields());
    }
  };
  void initialize(const Blocks& blocks);

  /// Position of the tip in the reference configuration, m; the start where no point reaches the threshold. Collective.
  Vector3 locate(const Blocks& blocks, const Epetra_Comm& comm) const;

  const Vector3& start() const { return start_; }
  const Vector3& direction() const { return direction_; }

 private:
  struct Candidate;
  std::vector<Candidate> candidates(const Blocks& blocks) const;
  double stepAhead(const Candidate& candidate, const double* x, const double* damage) const;

  PointSelection points_;
  Fields fields_;
  double threshold_;
  Vector3 direction_, start_;
  bool isInterpolated_;
};

}  // namespace pd

#endif
