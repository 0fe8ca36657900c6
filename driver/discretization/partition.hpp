// Which rank owns which point.
// No header of the plug-in interface here: Zoltan2 includes Epetra's headers, with which its Epetra_Comm.h clashes.
#ifndef PD_PARTITION_HPP
#define PD_PARTITION_HPP

#include <mpi.h>

#include <vector>

namespace pd {

/// [nPoints] Rank of every point: boxes that hold equally many points (Zoltan2, multijagged). `x` [3 nPoints, or
/// longer] is the same on all ranks, and so is the answer. Collective.
std::vector<int> partitionPoints(const std::vector<double>& x, int nPoints, MPI_Comm comm);

}  // namespace pd

#endif
