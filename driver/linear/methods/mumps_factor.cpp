#include "mumps_factor.hpp"

#include <vector>

#include "mumps_jobs.hpp"

namespace pd {

struct MumpsFactor::Implementation {
  MPI_Comm comm;
  int rank = 0;
  std::vector<int> counts, starts;  ///< rows of each rank
  std::vector<double> all;          ///< on the root, a whole vector
  std::string trouble;

  Implementation(MPI_Comm given, const SparseRows& matrix) : comm(given) {
    int ranks = 1;
    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &ranks);
    const auto ownRows = static_cast<int>(matrix.count());
    counts.resize(static_cast<std::size_t>(ranks));
    starts.assign(counts.size(), 0);
    MPI_Allgather(&ownRows, 1, MPI_INT, counts.data(), 1, MPI_INT, comm);
    for (std::size_t r = 1; r < counts.size(); ++r) starts[r] = starts[r - 1] + counts[r - 1];
    if (rank == 0) all.resize(static_cast<std::size_t>(size()));
  }
  virtual ~Implementation() = default;

  int size() const { return starts.back() + counts.back(); }
  virtual double entries() const = 0;
  /// all = A^-1 all, on the root.
  virtual void substitute() = 0;
};

template <class State, class Real>
struct MumpsFactor::OfPrecision : Implementation {
  State state{};
  std::vector<int> rows, columns;  ///< of the entries of this rank, counted from 1 over all ranks
  std::vector<Real> values, right;

  OfPrecision(MPI_Comm given, const SparseRows& matrix) : Implementation(given, matrix) {
    takeEntries(matrix);
    right.resize(all.size());
    mumps::begin(state, comm, 0);
    mumps::control(state, 18) = counts.size() > 1 ? 3 : 0;  // entries are where their rows are
    state.n = size();
    if (counts.size() > 1) {
      state.nnz_loc = static_cast<MUMPS_INT8>(values.size());
      state.irn_loc = rows.data();
      state.jcn_loc = columns.data();
      state.a_loc = values.data();
    } else {
      state.nnz = static_cast<MUMPS_INT8>(values.size());
      state.irn = rows.data();
      state.jcn = columns.data();
      state.a = values.data();
    }
    trouble = mumps::factor(state);
    rows = columns = {};
    values = {};
  }
  ~OfPrecision() override { mumps::run(state, mumps::end); }

  void takeEntries(const SparseRows& matrix) {
    for (std::size_t row = 0; row < matrix.count(); ++row)
      for (std::size_t k = matrix.start[row]; k < matrix.start[row + 1]; ++k) {
        if (matrix.values[k] == 0.0) continue;
        rows.push_back(starts[static_cast<std::size_t>(rank)] + static_cast<int>(row) + 1);
        columns.push_back(static_cast<int>(matrix.columns[k]) + 1);
        values.push_back(static_cast<Real>(matrix.values[k]));
      }
  }
  double entries() const override {
    const int entries = state.infog[28];  // in millions, where negative
    return entries < 0 ? -1e6 * entries : entries;
  }
  void substitute() override {
    std::copy(all.begin(), all.end(), right.begin());
    state.nrhs = 1;
    state.lrhs = state.n;
    state.rhs = right.data();
    mumps::run(state, mumps::substitute);
    std::copy(right.begin(), right.end(), all.begin());
  }
};

MumpsFactor::MumpsFactor(MPI_Comm comm, const SparseRows& matrix, FactorPrecision precision) {
  if (precision == FactorPrecision::Single)
    implementation_ = std::make_unique<OfPrecision<SMUMPS_STRUC_C, float>>(comm, matrix);
  else
    implementation_ = std::make_unique<OfPrecision<DMUMPS_STRUC_C, double>>(comm, matrix);
}

MumpsFactor::~MumpsFactor() = default;

const std::string& MumpsFactor::trouble() const { return implementation_->trouble; }
double MumpsFactor::entries() const { return implementation_->entries(); }

void MumpsFactor::solve(const double* b, double* x) const {
  Implementation& self = *implementation_;
  const int own = self.counts[static_cast<std::size_t>(self.rank)];
  MPI_Gatherv(b, own, MPI_DOUBLE, self.all.data(), self.counts.data(), self.starts.data(), MPI_DOUBLE, 0, self.comm);
  self.substitute();
  MPI_Scatterv(self.all.data(), self.counts.data(), self.starts.data(), MPI_DOUBLE, x, own, MPI_DOUBLE, 0, self.comm);
}

}  // namespace pd
