#include "communicator.hpp"

namespace pd {

namespace {

template <class T>
T reduce(T value, MPI_Datatype type, MPI_Op operation, MPI_Comm comm) {
  T result{};
  MPI_Allreduce(&value, &result, 1, type, operation, comm);
  return result;
}

/// Every rank's values, in the order of ranks.
template <class Values>
Values concatenation(const Values& own, MPI_Datatype type, MPI_Comm comm) {
  int size = 0;
  MPI_Comm_size(comm, &size);
  const int length = static_cast<int>(own.size());
  std::vector<int> lengths(static_cast<std::size_t>(size)), starts(static_cast<std::size_t>(size));
  MPI_Allgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, comm);
  int total = 0;
  for (std::size_t rank = 0; rank < lengths.size(); ++rank) {
    starts[rank] = total;
    total += lengths[rank];
  }
  Values all;
  all.resize(static_cast<std::size_t>(total));
  MPI_Allgatherv(own.data(), length, type, all.data(), lengths.data(), starts.data(), type, comm);
  return all;
}

}  // namespace

Communicator::Communicator(MPI_Comm comm) : comm_(comm) {
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &size_);
}

double Communicator::sum(double value) const { return reduce(value, MPI_DOUBLE, MPI_SUM, comm_); }

long long Communicator::sum(long long value) const { return reduce(value, MPI_LONG_LONG, MPI_SUM, comm_); }

double Communicator::max(double value) const { return reduce(value, MPI_DOUBLE, MPI_MAX, comm_); }

double Communicator::min(double value) const { return reduce(value, MPI_DOUBLE, MPI_MIN, comm_); }

bool Communicator::any(bool value) const { return reduce(value ? 1 : 0, MPI_INT, MPI_MAX, comm_) != 0; }

std::string Communicator::gather(const std::string& text) const { return concatenation(text, MPI_CHAR, comm_); }

std::vector<double> Communicator::gather(const std::vector<double>& values) const {
  return concatenation(values, MPI_DOUBLE, comm_);
}

void Communicator::barrier() const { MPI_Barrier(comm_); }

int Communicator::SumAll(double* partial, double* global, int count) const {
  return MPI_Allreduce(partial, global, count, MPI_DOUBLE, MPI_SUM, comm_);
}

int Communicator::SumAll(int* partial, int* global, int count) const {
  return MPI_Allreduce(partial, global, count, MPI_INT, MPI_SUM, comm_);
}

int Communicator::MaxAll(double* partial, double* global, int count) const {
  return MPI_Allreduce(partial, global, count, MPI_DOUBLE, MPI_MAX, comm_);
}

int Communicator::MaxAll(int* partial, int* global, int count) const {
  return MPI_Allreduce(partial, global, count, MPI_INT, MPI_MAX, comm_);
}

int Communicator::MinAll(double* partial, double* global, int count) const {
  return MPI_Allreduce(partial, global, count, MPI_DOUBLE, MPI_MIN, comm_);
}

int Communicator::MinAll(int* partial, int* global, int count) const {
  return MPI_Allreduce(partial, global, count, MPI_INT, MPI_MIN, comm_);
}

}  // namespace pd
