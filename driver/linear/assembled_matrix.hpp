// A distributed matrix over points: where contributions go, what is sent to other ranks, what is held fixed.
#ifndef PD_ASSEMBLED_MATRIX_HPP
#define PD_ASSEMBLED_MATRIX_HPP

#include <unordered_map>
#include <vector>

#include "methods/tpetra_types.hpp"
#include "point_graph.hpp"

namespace pd {

/// The matrix of a LinearSystem: a Tpetra matrix with a static graph, into whose values contributions go directly.
/// Those to rows and columns of images go, mirrored back, to what these mirror.
class AssembledMatrix {
 public:
  AssembledMatrix(const Communicator& comm, const Discretization& discretization, int width, bool couplesFamilies);

  int nOwned() const { return graph_.nOwned; }
  int width() const { return width_; }
  int kept() const { return kept_; }  ///< components of a point that are in the matrix: the first ones
  const Teuchos::RCP<tpetra::Matrix>& matrix() const { return matrix_; }
  bool graphIsTooSmall() const { return graphIsTooSmall_; }

  void fill(double value);
  void scale(double factor);
  void addValue(int globalRow, int globalColumn, double value);
  /// `onlyDiagonal`: only the entries that couple a point with itself.
  void addBlock(int numIndices, const int* globalIndices, const double* const* block, bool onlyDiagonal);
  double& ownEntry(int ownedPoint, int component, int columnComponent);  ///< what couples a point with itself
  /// Sends rows of ghosts to their owners, then replaces constrained rows and columns by those of the identity.
  void finish(const std::vector<char>& isConstrained);

  /// Constants for a scalar; translations and linear rotations for displacements.
  Teuchos::RCP<tpetra::MultiVector> makeNullspace(const Discretization& discretization) const;

  Teuchos::RCP<tpetra::MultiVector> vectorOf(const double* full) const;
  /// The components that are not in the matrix are copied from `droppedFrom`: their rows are those of the identity.
  void copyBack(const tpetra::MultiVector& vector, const double* droppedFrom, double* full) const;

 private:
  /// The row of a point: for each kept component, `degree` groups of kept() values.
  struct PointRow {
    const int* columns;
    std::size_t degree;
    double* values;
  };
  /// A local point; of an image what it mirrors, and the copy of the body that the image is in.
  struct Place {
    int point, copy;
  };
  /// Consecutive indices of a contribution that belong to one point.
  struct Run {
    int point, copy, column, begin, end;
  };

  void makeMatrix();
  std::size_t pairs() const { return static_cast<std::size_t>(kept_) * static_cast<std::size_t>(kept_); }
  PointRow row(int point);
  double* entry(const PointRow& target, int component, const int* place, int columnComponent) const;
  Place placeOf(int globalDegree) const;
  void collectRuns(int numIndices, const int* globalIndices);
  void requireWholePoint(const Run& run) const;
  const double* const* mirroredBack(int numIndices, const double* const* block);
  void addRun(const Run& rowRun, bool onlyDiagonal, const double* const* block);
  void sendGhostRows();
  Teuchos::RCP<tpetra::MultiVector> eliminatedColumns(const std::vector<char>& isConstrained) const;
  void eliminate(const std::vector<char>& isConstrained);

  const Communicator& comm_;
  PointGraph graph_;
  const int width_, kept_;
  const Symmetry symmetry_;
  std::unordered_map<int, Place> placeOfGlobalId_;
  Teuchos::RCP<tpetra::Matrix> matrix_;
  double* values_ = nullptr;  ///< of matrix_
  std::size_t nValues_ = 0;
  std::vector<double> ghostValues_;
  bool graphIsTooSmall_ = false;
  std::vector<Run> runs_;        ///< scratch of addBlock
  std::vector<int> components_;  ///< scratch of addBlock
  std::vector<double> mirrored_, half_;
  std::vector<const double*> mirroredRows_;
};

}  // namespace pd

#endif
