#include "heap.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>

#ifdef __has_feature
#define PD_HAS_FEATURE(name) __has_feature(name)
#else
#define PD_HAS_FEATURE(name) 0
#endif

namespace pd {

namespace {

/// The address sanitizer has a heap of its own, which marks all that is taken.
#if defined(__SANITIZE_ADDRESS__) || PD_HAS_FEATURE(address_sanitizer)
constexpr bool isGlibcsHeap = false;
#else
constexpr bool isGlibcsHeap = true;
#endif

/// glibc gives large arrays back to the system as they are freed, and has the next ones as pages that the system clears
/// and maps one by one: on a virtual machine a third of an equilibrium of 90 000 points from nothing, for a sixth more
/// memory if they stay.
void keepFreedMemory() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
}

/// Whether addresses cost nothing: no limit of this process counts them, and the system promises more than it has.
bool addressesAreFree() {
  for (const auto resource : {RLIMIT_AS, RLIMIT_DATA}) {
    rlimit limit{};
    if (getrlimit(resource, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY) return false;
  }
  char mode = '2';  // every promise is counted
  std::ifstream("/proc/sys/vm/overcommit_memory") >> mode;
  return mode != '2';
}

/// glibc has no call for large pages of its heap. So the heap takes the addresses of half of the machine's memory at
/// once, which are marked, and gives them back untouched: with keepFreedMemory() it keeps them, and grows into them.
void takeLargePages() {
  constexpr std::uintptr_t pageSize = std::uintptr_t(1) << 21;
  if (!addressesAreFree()) return;
  const auto size =
      static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) / 2 * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  void* const taken = std::malloc(size);
  if (taken == nullptr) return;
  const auto start = reinterpret_cast<std::uintptr_t>(taken);
  const std::uintptr_t first = (start + pageSize - 1) / pageSize * pageSize,
                       last = (start + size) / pageSize * pageSize;
  if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
  std::free(taken);
}

/// Whether the environment says how glibc is to take, keep, give back or fill memory.
bool userHasSetHeap() {
  for (const char* const name : {"MALLOC_MMAP_MAX_", "MALLOC_MMAP_THRESHOLD_", "MALLOC_TRIM_THRESHOLD_",
                                 "MALLOC_TOP_PAD_", "MALLOC_PERTURB_", "MALLOC_CHECK_"})
    if (std::getenv(name) != nullptr) return true;
  const char* const given = std::getenv("GLIBC_TUNABLES");
  const std::string tunables = given == nullptr ? "" : given;
  for (const char* const name :
       {"mmap_max", "mmap_threshold", "trim_threshold", "top_pad", "perturb", "check", "hugetlb"})
    if (tunables.find(std::string("glibc.malloc.") + name + "=") != std::string::npos) return true;
  return false;
}

}  // namespace

void prepareHeap() {
  if (userHasSetHeap()) return;
  keepFreedMemory();
  if (isGlibcsHeap) takeLargePages();
}

}  // namespace pd
