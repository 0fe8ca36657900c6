// Movement of values between owners and ghosts, on a ring of points dealt out to the ranks.
#include "driver/parallel/ghost_exchange.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

constexpr int nGlobal = 40, reach = 3;

/// Rank r owns the points g with g % size == r (so that messages go everywhere), and sees `reach` points to either
/// side of each of its points as ghosts.
struct Ring {
  explicit Ring(const pd::Communicator& comm) {
    std::vector<char> isGhost(nGlobal, 0);
    for (int g = comm.rank(); g < nGlobal; g += comm.size()) ids.push_back(g);
    nOwned = static_cast<int>(ids.size());
    for (int i = 0; i < nOwned; ++i)
      for (int d = -reach; d <= reach; ++d) {
        const int g = (ids[static_cast<std::size_t>(i)] + d + nGlobal) % nGlobal;
        if (g % comm.size() != comm.rank()) isGhost[static_cast<std::size_t>(g)] = 1;
      }
    for (int g = nGlobal - 1; g >= 0; --g)
      if (isGhost[static_cast<std::size_t>(g)] != 0) ids.push_back(g);
  }
  int at(std::size_t i) const { return ids[i]; }
  std::vector<int> ids;
  int nOwned = 0;
};

double valueOf(int globalId, int component) { return 100.0 * globalId + component + 0.5; }

}  // namespace

TEST(GhostExchange, ImportCopiesOwnersValuesForAnyWidth) {
  const pd::Communicator comm(MPI_COMM_WORLD);
  const Ring ring(comm);
  const pd::GhostExchange exchange(comm, ring.ids, ring.nOwned);
  for (const int width : {1, 3, 9, 2}) {
    std::vector<double> values(ring.ids.size() * static_cast<std::size_t>(width), -1.0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(ring.nOwned * width); ++i)
      values[i] = valueOf(ring.at(i / static_cast<std::size_t>(width)), static_cast<int>(i) % width);
    exchange.import(values.data(), width);
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_EQ(values[i], valueOf(ring.at(i / static_cast<std::size_t>(width)), static_cast<int>(i) % width));
  }
}

TEST(GhostExchange, ExportAddSumsEveryHoldersValueAndLeavesGhosts) {
  const pd::Communicator comm(MPI_COMM_WORLD);
  const Ring ring(comm);
  const pd::GhostExchange exchange(comm, ring.ids, ring.nOwned);
  // Every holder of point g contributes g + 1 (exact in floating point), so the owner ends up with
  // (g + 1) x (number of ranks that hold it).
  std::vector<double> values;
  for (const int id : ring.ids) {
    values.push_back(id + 1.0);
    values.push_back(-2.0 * (id + 1.0));
  }
  exchange.exportAdd(values.data(), 2);
  for (std::size_t i = 0; i < ring.ids.size(); ++i) {
    const int g = ring.ids[i];
    int nHolders = 1;
    if (static_cast<int>(i) < ring.nOwned) {
      std::vector<char> holds(static_cast<std::size_t>(comm.size()), 0);
      for (int d = -reach; d <= reach; ++d)
        holds[static_cast<std::size_t>((g + d + nGlobal) % nGlobal % comm.size())] = 1;
      nHolders = static_cast<int>(std::count(holds.begin(), holds.end(), 1));
    }
    EXPECT_EQ(values[2 * i], nHolders * (g + 1.0)) << "point " << g;
    EXPECT_EQ(values[2 * i + 1], -2.0 * nHolders * (g + 1.0)) << "point " << g;
  }
}

TEST(GhostExchange, ARankMayOwnNothing) {
  const pd::Communicator comm(MPI_COMM_WORLD);
  std::vector<int> ids;
  int nOwned = 0;
  if (comm.isRoot()) {
    ids = {0, 1, 2};
    nOwned = 3;
  } else if (comm.rank() == 1) {
    ids = {2};
  }
  const pd::GhostExchange exchange(comm, ids, nOwned);
  std::vector<double> values(ids.size(), comm.isRoot() ? 7.0 : 0.0);
  exchange.import(values.data(), 1);
  for (const double value : values) EXPECT_EQ(value, 7.0);
  exchange.exportAdd(values.data(), 1);
  if (comm.isRoot()) {
    EXPECT_EQ(values[2], comm.size() > 1 ? 14.0 : 7.0);
  }
}

TEST(Communicator, Reductions) {
  const pd::Communicator comm(MPI_COMM_WORLD);
  const int n = comm.size();
  EXPECT_EQ(comm.sum(1.5 * (comm.rank() + 1)), 0.75 * n * (n + 1));
  EXPECT_EQ(comm.sum(3000000000LL), 3000000000LL * n);
  EXPECT_EQ(comm.max(static_cast<double>(comm.rank())), n - 1.0);
  EXPECT_EQ(comm.min(static_cast<double>(comm.rank())), 0.0);
  EXPECT_TRUE(comm.any(comm.rank() == n - 1));
  EXPECT_FALSE(comm.any(false));
  std::string expected;
  for (int rank = 0; rank < n; ++rank) expected += std::string(static_cast<std::size_t>(rank), 'a') + ";";
  EXPECT_EQ(comm.gather(std::string(static_cast<std::size_t>(comm.rank()), 'a') + ";"), expected);
  double partial[2] = {1.0, -2.0}, global[2] = {0.0, 0.0};
  comm.SumAll(partial, global, 2);
  EXPECT_EQ(global[1], -2.0 * n);
}
