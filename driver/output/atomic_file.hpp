// Files that a reader sees whole or not at all, even where the writer is killed.
#ifndef PD_ATOMIC_FILE_HPP
#define PD_ATOMIC_FILE_HPP

#include <cstdio>
#include <string>

namespace pd {

/// Name under which `path` is written before it is complete, and whether a name is such a one.
std::string unfinishedName(const std::string& path);
/// Such a name, or that of what Open MPI keeps beside such a file while it is open: "NAME.data.RANK".
bool isUnfinished(const std::string& path);

/// Opens a file for writing, never through a symbolic link: `isContinued` at the end of what is there, else empty.
/// Throws RunError.
std::FILE* openForWriting(const std::string& path, bool isContinued);

/// Gives the file written as unfinishedName(path) its own name, in one step of the file system, after its content
/// has reached the disk. Throws RunError.
void finishFile(const std::string& path);

/// Writes `content` under the unfinished name, then gives it its own. Does not wait for the disk: for what a restart
/// makes anew, and small files written often. Throws RunError naming the path and the reason.
void writeFileAtomically(const std::string& path, const std::string& content);

/// "; its folder is not there ..." where the folder of `path` does not exist; empty otherwise.
std::string missingFolder(const std::string& path);

/// Throws RunError "cannot <what> <path>: <reason of the system>", with missingFolder().
[[noreturn]] void throwFileError(const std::string& what, const std::string& path, int errorNumber);

/// Creates the folder that `path` lies in, and its parents. Throws RunError.
void makeFolderOf(const std::string& path);

}  // namespace pd

#endif
