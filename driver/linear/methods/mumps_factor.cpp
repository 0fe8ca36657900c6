#include "mumps_factor.hpp"

#include "mumps_jobs.hpp"

namespace pd {

struct MumpsFactor::Implementation {
  DMUMPS_STRUC_C state{};
  MPI_Comm comm = MPI_COMM_NULL;
  int rank = 0;
  std::vector<int> rows, columns, counts, starts;  ///< counts, starts: rows of each rank
  std::vector<double> values, all;                 ///< all: on the root, a whole vector
  std::string trouble;

  int info(int number) const { return state.infog[number - 1]; }
};

MumpsFactor::MumpsFactor(MPI_Comm comm, int size, int ownRows, std::vector<int> rows, std::vector<int> columns,
                         std::vector<double> values)
    : implementation_(std::make_unique<Implementation>()) {
  Implementation& self = *implementation_;
  self.comm = comm;
  self.rows = std::move(rows);
  self.columns = std::move(columns);
  self.values = std::move(values);
  int ranks = 1;
  MPI_Comm_rank(comm, &self.rank);
  MPI_Comm_size(comm, &ranks);
  self.counts.resize(static_cast<std::size_t>(ranks));
  self.starts.assign(self.counts.size(), 0);
  MPI_Allgather(&ownRows, 1, MPI_INT, self.counts.data(), 1, MPI_INT, comm);
  for (std::size_t r = 1; r < self.counts.size(); ++r) self.starts[r] = self.starts[r - 1] + self.counts[r - 1];
  if (self.rank == 0) self.all.resize(static_cast<std::size_t>(size));

  mumps::begin(self.state, comm, 0);
  mumps::control(self.state, 18) = ranks > 1 ? 3 : 0;  // entries are where their rows are
  self.state.n = size;
  if (ranks > 1) {
    self.state.nnz_loc = static_cast<MUMPS_INT8>(self.values.size());
    self.state.irn_loc = self.rows.data();
    self.state.jcn_loc = self.columns.data();
    self.state.a_loc = self.values.data();
  } else {
    self.state.nnz = static_cast<MUMPS_INT8>(self.values.size());
    self.state.irn = self.rows.data();
    self.state.jcn = self.columns.data();
    self.state.a = self.values.data();
  }
  self.trouble = mumps::factor(self.state);
}

MumpsFactor::~MumpsFactor() { mumps::run(implementation_->state, mumps::end); }

const std::string& MumpsFactor::trouble() const { return implementation_->trouble; }

double MumpsFactor::entries() const {
  const int entries = implementation_->info(29);  // in millions, where negative
  return entries < 0 ? -1e6 * entries : entries;
}

void MumpsFactor::solve(const double* b, double* x) const {
  Implementation& self = *implementation_;
  const int own = self.counts[static_cast<std::size_t>(self.rank)];
  MPI_Gatherv(b, own, MPI_DOUBLE, self.all.data(), self.counts.data(), self.starts.data(), MPI_DOUBLE, 0, self.comm);
  self.state.nrhs = 1;
  self.state.lrhs = self.state.n;
  self.state.rhs = self.all.data();
  mumps::run(self.state, mumps::substitute);
  MPI_Scatterv(self.all.data(), self.counts.data(), self.starts.data(), MPI_DOUBLE, x, own, MPI_DOUBLE, 0, self.comm);
}

}  // namespace pd
