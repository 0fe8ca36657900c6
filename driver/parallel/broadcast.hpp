// Values of the root rank handed to all.
#ifndef PD_BROADCAST_HPP
#define PD_BROADCAST_HPP

#include <algorithm>
#include <string>
#include <vector>

#include "communicator.hpp"

namespace pd {

/// Resizes `values` on the other ranks. Collective.
template <class Value>
void broadcast(std::vector<Value>& values, const Communicator& comm) {
  long long size = static_cast<long long>(values.size());
  MPI_Bcast(&size, 1, MPI_LONG_LONG, 0, comm.mpi());
  values.resize(static_cast<std::size_t>(size));
  constexpr long long portion = 1LL << 24;  // MPI counts in int
  for (long long start = 0; start < size; start += portion)
    MPI_Bcast(values.data() + start, static_cast<int>(std::min(portion, size - start) * sizeof(Value)), MPI_BYTE, 0,
              comm.mpi());
}

inline void broadcast(std::string& text, const Communicator& comm) {
  std::vector<char> characters(text.begin(), text.end());
  broadcast(characters, comm);
  text.assign(characters.begin(), characters.end());
}

}  // namespace pd

#endif
