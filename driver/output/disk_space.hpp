// Room on a disk for a file that several processes write together.
#ifndef PD_DISK_SPACE_HPP
#define PD_DISK_SPACE_HPP

#include <cstddef>
#include <string>

namespace pd {

/// Has the file system set the first `bytes` bytes of a file aside; its size stays. The file is made where it is not
/// there. Where a file system cannot do so, its free space is compared with what the file lacks. Throws RunError where
/// there is no room. Of one process.
void setSpaceAside(const std::string& path, std::size_t bytes);

/// Gives back what a file has beyond its end of `bytes` bytes that were set aside.
void giveSpaceBack(const std::string& path, std::size_t bytes);

/// "; the disk has 12 KiB left" where that is little, to add to a message; MPI-IO does not say that a disk is full.
std::string littleSpaceLeft(const std::string& path);

}  // namespace pd

#endif
