// MPI as the driver uses it: reductions by value, and the interface that compute plug-ins see.
#ifndef PD_COMMUNICATOR_HPP
#define PD_COMMUNICATOR_HPP

#include <Epetra_Comm.h>
#include <mpi.h>

#include <string>
#include <vector>

namespace pd {

class Communicator : public PeridigmNS::Communicator {
 public:
  explicit Communicator(MPI_Comm comm);

  MPI_Comm mpi() const { return comm_; }
  int rank() const { return rank_; }
  int size() const { return size_; }
  bool isRoot() const { return rank_ == 0; }

  double sum(double value) const;
  long long sum(long long value) const;
  double max(double value) const;
  double min(double value) const;
  bool any(bool value) const;
  /// Concatenation of every rank's text, in the order of ranks, on every rank.
  std::string gather(const std::string& text) const;
  /// The same of numbers.
  std::vector<double> gather(const std::vector<double>& values) const;
  void barrier() const;

  int MyPID() const override { return rank_; }
  int NumProc() const override { return size_; }
  int SumAll(double* partial, double* global, int count) const override;
  int SumAll(int* partial, int* global, int count) const override;
  int MaxAll(double* partial, double* global, int count) const override;
  int MaxAll(int* partial, int* global, int count) const override;
  int MinAll(double* partial, double* global, int count) const override;
  int MinAll(int* partial, int* global, int count) const override;

 private:
  MPI_Comm comm_;
  int rank_ = 0, size_ = 1;
};

}  // namespace pd

#endif
