#include "session.hpp"

#include <hdf5.h>

#include <Tpetra_Core.hpp>
#include <cstdlib>
#include <utility>

#include "blas.hpp"
#include "heap.hpp"
#include "launch.hpp"

namespace pd {

namespace {

/// Open MPI 4 guards the shared file pointer of every file it opens, which nothing here uses, by a semaphore that is
/// named after the file. A run that is killed as it opens a file leaves the semaphore behind, taken, and every later
/// run waits without end as it opens a file of that name. Of Open MPI's kinds of shared file pointer, "individual"
/// makes none unless it is asked to (and a file must have a kind). What the user has set stays.
void leaveOutSharedFilePointers() { setenv("OMPI_MCA_sharedfp", "individual", 0); }

/// A process alone would start a daemon (orted) that could start others, and load what carries messages over networks,
/// neither of which anything here asks for. Without the daemon it would share its session directory with all other
/// such processes, and the one that ends first would remove it as the next one starts: it makes none. What the user
/// has set stays.
void keepToItself() {
  if (isWithinJob()) return;
  for (const auto& [name, value] :
       {std::pair("OMPI_MCA_ess_singleton_isolated", "1"), std::pair("OMPI_MCA_orte_create_session_dirs", "0"),
        std::pair("OMPI_MCA_pml", "ob1"), std::pair("OMPI_MCA_btl", "self")})
    setenv(name, value, 0);
}

/// Open MPI asks hwloc what the machine is like, which would look for graphics cards too: at ten X servers, and OpenCL.
void leaveOutGraphicsCards() { setenv("HWLOC_PLUGINS_BLACKLIST", "hwloc_gl.so,hwloc_opencl.so", 0); }

/// HDF5 locks each file that one process opens, which some network file systems do not know. Here no file changes once
/// it has its name, and runs that would write the same ones keep each other out (driver/output/result_lock.hpp).
void leaveOutFileLocks() { setenv("HDF5_USE_FILE_LOCKING", "FALSE", 0); }

}  // namespace

ParallelSession::ParallelSession(int& argc, char**& argv) {
  prepareHeap();
  prepareBlas();
  leaveOutSharedFilePointers();
  keepToItself();
  leaveOutGraphicsCards();
  leaveOutFileLocks();
  Tpetra::initialize(&argc, &argv);
}

ParallelSession::~ParallelSession() {
  // What a damaged file has left open inside HDF5, which MPI_Finalize closes, was told when the file was refused.
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  Tpetra::finalize();
}

}  // namespace pd
