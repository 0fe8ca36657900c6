// How the process gets its memory from the system.
#ifndef PD_HEAP_HPP
#define PD_HEAP_HPP

namespace pd {

/// Freed memory is kept for what comes next, and the heap grows in pages of 2 MB where the system has such and asks to
/// be asked for them (/sys/kernel/mm/transparent_hugepage/enabled: madvise). Once, before anything large is allocated.
/// What the user has set for glibc's malloc in the environment stays.
void prepareHeap();

}  // namespace pd

#endif
