// Values of the root rank handed to all.
#ifndef PD_BROADCAST_HPP
#define PD_BROADCAST_HPP

#include <algorithm>

#include "communicator.hpp"

namespace pd {

/// Resizes `values`, a vector of plain values or a string, on the other ranks. Collective.
template <class Values>
void broadcast(Values& values, const Communicator& comm) {
  constexpr long long valueSize = sizeof(typename Values::value_type);
  long long size = static_cast<long long>(values.size());
  MPI_Bcast(&size, 1, MPI_LONG_LONG, 0, comm.mpi());
  values.resize(static_cast<std::size_t>(size));
  constexpr long long portion = (1LL << 30) / valueSize;  // MPI counts in int
  for (long long start = 0; start < size; start += portion)
    MPI_Bcast(values.data() + start, static_cast<int>(std::min(portion, size - start) * valueSize), MPI_BYTE, 0,
              comm.mpi());
}

}  // namespace pd

#endif
