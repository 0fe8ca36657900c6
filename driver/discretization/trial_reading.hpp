// Files tried in a process of their own, since libraries die of damaged ones.
#ifndef PD_TRIAL_READING_HPP
#define PD_TRIAL_READING_HPP

#include <cstddef>
#include <functional>
#include <string>

namespace pd {

/// Runs `read` in a copy of this process, which has some seconds and some memory more than this one for a file of
/// `fileSize` bytes; what it writes and throws is lost. Returns what became of it where it did not come to its end by
/// itself ("dies of it"), and an empty text where it did. HDF5 frees what it never allocated, or runs in circles,
/// where the inner structure of a file is damaged. `read` must not communicate.
std::string misfortuneOf(const std::function<void()>& read, std::size_t fileSize);

}  // namespace pd

#endif
