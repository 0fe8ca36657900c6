#include "mumps_factor.hpp"

#include <dmumps_c.h>
#include <fmt/format.h>

namespace pd {

namespace {

// MUMPS' jobs, as its guide numbers them.
constexpr int start = -1, end = -2, analyseAndFactor = 4, substitute = 3;

}  // namespace

struct MumpsFactor::Implementation {
  DMUMPS_STRUC_C state{};
  MPI_Comm comm = MPI_COMM_NULL;
  int rank = 0;
  std::vector<int> rows, columns, counts, starts;  ///< counts, starts: rows of each rank
  std::vector<double> values, all;                 ///< all: on the root, a whole vector
  std::string trouble;

  int& control(int number) { return state.icntl[number - 1]; }
  int info(int number) const { return state.infog[number - 1]; }
  void run(int job) {
    state.job = job;
    dmumps_c(&state);
  }
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

  self.state.par = 1;  // the root computes, too
  self.state.sym = 0;
  self.state.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(comm));
  self.run(start);
  for (const int output : {1, 2, 3, 4}) self.control(output) = 0;
  self.control(18) = ranks > 1 ? 3 : 0;  // entries are where their rows are
  self.control(14) = 60;                 // per cent of memory beyond what the analysis expects
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
  self.run(analyseAndFactor);
  constexpr int needsMoreMemory = -9;
  for (int pass = 0; pass < 3 && self.info(1) == needsMoreMemory; ++pass) {
    self.control(14) *= 3;
    self.run(analyseAndFactor);
  }
  if (self.info(1) < 0)
    self.trouble = self.info(1) == -6 || self.info(1) == -10
                       ? "the matrix is singular"
                       : fmt::format("MUMPS ended with INFOG(1) = {}, INFOG(2) = {}", self.info(1), self.info(2));
}

MumpsFactor::~MumpsFactor() { implementation_->run(end); }

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
  self.run(substitute);
  MPI_Scatterv(self.all.data(), self.counts.data(), self.starts.data(), MPI_DOUBLE, x, own, MPI_DOUBLE, 0, self.comm);
}

}  // namespace pd
