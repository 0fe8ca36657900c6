// The tip of a crack: what Crack_Tip and Crack_Length have in common.
#ifndef PD_CRACK_FRONT_HPP
#define PD_CRACK_FRONT_HPP

#include "families.hpp"
#include "field_variable.hpp"
#include "point_selection.hpp"
#include "whole_body.hpp"

namespace pd {

/// The crack is made of the points at or above the threshold that hang together, each a neighbour of the next, with one
/// on the line from the start along the direction (nearer to it than that point's longest bond, by the coordinates of
/// the start that are given): damage elsewhere is no part of it, and without a start all damage is. The tip is where
/// Damage, followed along the direction from a point of the crack to its next neighbour ahead, falls through the
/// threshold, linear between the two; the foremost such place, and never behind a start that is given. As long as
/// damage does not heal it never goes back. Points that are equally far ahead (the two lips of a crack between two rows
/// of points) are averaged.
/// A crack with a curved path is that of crack_path.hpp: its tip is where it is longest, and damage is followed there
/// along its direction over the last two longest bonds. Beside planes of symmetry all this is that of the whole body.
class CrackFront {
 public:
  struct Tip {
    Vector3 place, direction;  ///< m, 1; in the reference configuration
    double length;             ///< m; along a curved path, else the advance along the direction
  };
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

  /// At the start where there is no crack. Collective.
  Tip locate(const Blocks& blocks, const Epetra_Comm& comm) const {
    return isCurved_ ? locateAlongPath(blocks, comm) : locateAhead(blocks, comm);
  }

  const Vector3& start() const { return start_; }
  const Vector3& direction() const { return direction_; }
  bool isCurved() const { return isCurved_; }

 private:
  struct Candidate;
  struct Surroundings;
  /// Those of which isWanted(global id).
  template <class IsWanted>
  std::vector<Candidate> candidates(const Blocks& blocks, const Epetra_Comm& comm, const Vector3& direction,
                                    const IsWanted& isWanted) const;
  std::vector<Candidate> candidates(const Blocks& blocks, const Epetra_Comm& comm) const;
  Candidate candidate(const Surroundings& around, int copy, const Vector3& directionOfCopy) const;
  double fromStart(const Candidate& candidate) const;
  bool isOnItsLine(const Candidate& candidate) const;
  std::vector<Candidate> crack(const Blocks& blocks, const Epetra_Comm& comm) const;
  Tip locateAhead(const Blocks& blocks, const Epetra_Comm& comm) const;
  Tip locateAlongPath(const Blocks& blocks, const Epetra_Comm& comm) const;

  PointSelection points_;
  Fields fields_;
  std::vector<Families> families_;  ///< [blocks]
  double threshold_;
  Vector3 direction_, start_;
  std::array<bool, 3> isStartGiven_{};
  bool isInterpolated_, isCurved_;
  Teuchos::RCP<const WholeBody> whole_;
};

}  // namespace pd

#endif
