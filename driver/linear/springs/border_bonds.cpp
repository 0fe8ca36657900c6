#include "border_bonds.hpp"

#include <mpi.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace pd {

namespace {

/// A bond by the global ids of its ends, the one in whose list it is first.
using Ends = std::pair<int, int>;

}  // namespace

BorderBonds::Shares::Shares(const std::vector<int>& countOfRank) : counts(countOfRank), starts(counts.size(), 0) {
  std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
}

BorderBonds::BorderBonds(const Communicator& comm, const PointExchange& exchange, const Discretization& points)
    : comm_(comm), wanted_({0}), given_({0}) {
  const auto nRanks = static_cast<std::size_t>(comm.size());
  std::vector<double> rankOf(static_cast<std::size_t>(points.nPoints), comm.rank());
  exchange.import(rankOf.data(), 1, Reflection::Even);

  std::vector<std::pair<Ends, std::size_t>> own;  // border bonds by their ends, and their places among all bonds
  std::vector<Ends> reverse;
  std::vector<std::size_t> owner;
  std::vector<int> counts(nRanks, 0);
  const auto nGlobal = static_cast<int>(points.nGlobal);
  const int* entry = points.neighborhoodList.data();
  std::size_t bond = 0;
  for (int i = 0; i < points.nOwned; ++i)
    for (int left = *entry++; left > 0; --left, ++entry, ++bond) {
      if (*entry < points.nOwned) continue;
      const int here = points.globalIds[static_cast<std::size_t>(i)];
      const int there = points.globalIds[static_cast<std::size_t>(*entry)];
      own.emplace_back(Ends{here, there}, bond);
      // Mirrored again, an image is its source, and what it was the image of is one in the same copy of the body.
      reverse.emplace_back(there % nGlobal, here + there / nGlobal * nGlobal);
      owner.push_back(static_cast<std::size_t>(rankOf[static_cast<std::size_t>(*entry)]));
      ++counts[owner.back()];
    }
  wanted_ = Shares(counts);
  std::vector<int> next = wanted_.starts, asked(counts.size());
  std::vector<Ends> asks(wanted_.total());
  for (std::size_t b = 0; b < reverse.size(); ++b) {
    place_.push_back(static_cast<std::size_t>(next[owner[b]]++));
    asks[place_.back()] = reverse[b];
  }
  MPI_Alltoall(counts.data(), 1, MPI_INT, asked.data(), 1, MPI_INT, comm.mpi());
  given_ = Shares(asked);
  std::vector<Ends> questions(given_.total());
  MPI_Alltoallv(asks.data(), wanted_.counts.data(), wanted_.starts.data(), MPI_2INT, questions.data(),
                given_.counts.data(), given_.starts.data(), MPI_2INT, comm.mpi());
  std::sort(own.begin(), own.end());
  for (const Ends& ends : questions) {
    const auto found = std::lower_bound(own.begin(), own.end(), std::make_pair(ends, std::size_t{0}));
    areMutual_ = areMutual_ && found != own.end() && found->first == ends;
    served_.push_back(areMutual_ ? found->second : 0);
  }
  areMutual_ = !comm.any(!areMutual_);
}

std::vector<double> BorderBonds::ofOtherEnds(const std::vector<double>& ofBonds) const {
  std::vector<double> sent, received(wanted_.total()), result;
  for (const std::size_t bond : served_) sent.push_back(ofBonds[bond]);
  MPI_Alltoallv(sent.data(), given_.counts.data(), given_.starts.data(), MPI_DOUBLE, received.data(),
                wanted_.counts.data(), wanted_.starts.data(), MPI_DOUBLE, comm_.mpi());
  for (const std::size_t place : place_) result.push_back(received[place]);
  return result;
}

}  // namespace pd
