// How the process gets its memory from the system.
#ifndef PD_HEAP_HPP
#define PD_HEAP_HPP

namespace pd {

/// Freed memory is kept for what comes next, and the heap grows in pages of 2 MB where the system has such and asks to
/// be asked for them (/sys/kernel/mm/transparent_hugepage/enabled: madvise). Once, before anything large is allocated.
/// Where the environment says how glibc's malloc is to take, keep, give back or fill memory (MALLOC_MMAP_MAX_,
/// MALLOC_PERTURB_ and the like, or the same in GLIBC_TUNABLES), the heap stays as it is.
void prepareHeap();

}  // namespace pd

#endif
