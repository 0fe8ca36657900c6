// The Jacobian of a scalar over near points alone, as preconditioners want it.
#ifndef PD_COMPACT_JACOBIAN_HPP
#define PD_COMPACT_JACOBIAN_HPP

#include <vector>

#include "../../linear/sparse_rows.hpp"
#include "../../model/model.hpp"
#include "Peridigm_SerialMatrix.hpp"

namespace pd {

/// One for each owned point; those that are not free are zero.
struct PointUnknowns {
  std::vector<int> localId;            ///< by global id, of owned points and ghosts
  std::vector<double> column, isFree;  ///< [points] of the unknown; 1 at free points
  long long first = 0;                 ///< of this rank

  /// `isFree`: of owned points. Collective.
  void number(Model& model, const std::vector<double>& isFreeHere);
};

/// Collects what materials add. Entries of the nearest neighbours are kept, and others that are not small in their
/// row: what a flow carries. The many small ones of a nonlocal diffusion are not, which take most of the memory: the
/// nearest get as much more as makes the second moment of the row what it was, so that diffusion over long distances
/// is the same.
class CompactJacobian : public PeridigmNS::SerialMatrix {
 public:
  /// `reach`: spacings up to which neighbours are near, 1.5 unless there is no need to save: on lattices those along
  /// the axes and half way between them.
  CompactJacobian(const PointUnknowns& unknowns, const Discretization& mesh, double reach = 1.5);

  void addValue(int globalRow, int globalColumn, double value) override;
  void addValues(int n, const int* ids, const double* const* values) override;
  void addBlockDiagonalValues(int, const int*, const double* const*) override {}
  void putScalar(double) override {}

  /// Rows times factor[row], plus `diagonal`. Collective, as entries come to the ranks that have their rows.
  SparseRows finish(const Communicator& comm, const std::vector<double>& factor, const std::vector<double>& diagonal);

 private:
  struct Near {
    int point;  ///< local id; -1: an image, which is kept as it is
    long long column;
    double value;
  };
  struct Far {
    int point;
    float value;
  };
  struct Row {
    double diagonal = 0.0;
    std::vector<Near> near;
    std::vector<Far> far;
  };

  int localOf(int globalId) const;
  double squareOf(int point, int other) const;
  void addForeign(const Communicator& comm);
  void makeCompact(std::size_t row);

  const PointUnknowns& unknowns_;
  const Discretization& mesh_;
  const double reach_;
  std::vector<Row> rows_;
  std::vector<double> foreign_;  ///< row, column, value of other ranks' rows
};

}  // namespace pd

#endif
