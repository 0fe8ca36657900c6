// Gershgorin bounds of a material's tangent, without a matrix.
#ifndef PD_ABSOLUTE_ROW_SUMS_HPP
#define PD_ABSOLUTE_ROW_SUMS_HPP

#include <vector>

#include "../model/model.hpp"
#include "Peridigm_SerialMatrix.hpp"

namespace pd {

/// Takes what a material adds to its tangent and keeps, for each displacement component, the sum of the absolute values
/// of its row. Entries that couple a point to itself are added up with their signs first, others one contribution at a
/// time: an upper bound, and exact for pairwise forces. Rows of images are, mirrored back, part of the rows of what
/// these mirror; their columns count as those of other points.
class AbsoluteRowSums : public PeridigmNS::SerialMatrix {
 public:
  /// Refers to the model.
  explicit AbsoluteRowSums(const Model& model);

  void addValue(int globalRow, int globalCol, double value) override;
  void addValues(int numIndices, const int* globalIndices, const double* const* values) override;
  void addBlockDiagonalValues(int numIndices, const int* globalIndices, const double* const* values) override;
  void putScalar(double value) override;

  /// [3 nOwned] with what other ranks have added to the rows of this one. Collective.
  std::vector<double> ownedSums() const;

 private:
  /// Consecutive indices of one point.
  struct Run {
    int first, last;  ///< behind the last
    int point;        ///< local id; -1: of another rank
  };
  Run runFrom(int first, int numIndices, const int* globalIndices) const;
  void addRun(const Run& rows, int numIndices, const int* globalIndices, const double* const* values);
  void addMirrored(const Run& rows, const Run& columns, const int* globalIndices, const double* const* values);

  const Model& model_;
  Teuchos::RCP<const PeridigmNS::PointMap> overlap_;
  std::vector<double> ownBlock_;  ///< [9 points] entries between components of one point
  std::vector<double> otherSum_;  ///< [3 points]
};

}  // namespace pd

#endif
