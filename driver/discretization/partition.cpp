#include "partition.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Teuchos_ParameterList.hpp>
#include <Zoltan2_BasicVectorAdapter.hpp>
#include <Zoltan2_PartitioningProblem.hpp>

namespace pd {

namespace {

using Types = Zoltan2::BasicUserTypes<double, int, long long>;
using Adapter = Zoltan2::BasicVectorAdapter<Types>;

/// The points from `first` to before `last` are this rank's share of the input.
std::vector<int> partitionShare(const std::vector<double>& x, int first, int last, MPI_Comm comm) {
  std::vector<long long> ids;
  for (int i = first; i < last; ++i) ids.push_back(i);
  const double* start = x.data() + 3 * static_cast<std::size_t>(first);
  Adapter adapter(last - first, ids.data(), start, start + 1, start + 2, 3, 3, 3);

  const auto teuchosComm = Teuchos::rcp(new Teuchos::MpiComm<int>(comm));
  Teuchos::ParameterList parameters;
  parameters.set("algorithm", "multijagged");
  parameters.set("num_global_parts", teuchosComm->getSize());
  Zoltan2::PartitioningProblem<Adapter> problem(&adapter, &parameters, teuchosComm);
  problem.solve();
  const int* parts = problem.getSolution().getPartListView();
  return {parts, parts + (last - first)};
}

}  // namespace

std::vector<int> partitionPoints(const std::vector<double>& x, int nPoints, MPI_Comm comm) {
  int rank = 0, nRanks = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &nRanks);
  if (nRanks == 1) return std::vector<int>(static_cast<std::size_t>(nPoints), 0);

  std::vector<int> starts, counts;
  const auto startOf = [&](int r) { return static_cast<int>(static_cast<long long>(nPoints) * r / nRanks); };
  for (int r = 0; r < nRanks; ++r) {
    starts.push_back(startOf(r));
    counts.push_back(startOf(r + 1) - startOf(r));
  }
  const std::vector<int> share = partitionShare(x, startOf(rank), startOf(rank + 1), comm);
  std::vector<int> owner(static_cast<std::size_t>(nPoints));
  MPI_Allgatherv(share.data(), counts[rank], MPI_INT, owner.data(), counts.data(), starts.data(), MPI_INT, comm);
  return owner;
}

}  // namespace pd
