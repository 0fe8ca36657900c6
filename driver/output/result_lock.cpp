#include "result_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <fstream>
#include <sstream>

#include "../model/model.hpp"
#include "atomic_file.hpp"

namespace pd {

namespace {

std::string hostName() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

/// Of the system since it was started, in all of its containers; empty where it has none.
std::string systemId() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string id;
  std::getline(file, id);
  return id;
}

/// What a lock file holds, a line each.
struct Owner {
  std::string name;  ///< thisRun()
  std::string host, system;
  long long process = 0;

  static Owner self() { return {thisRun(), hostName(), systemId(), static_cast<long long>(getpid())}; }

  static Owner readFrom(int descriptor) {
    std::array<char, 4096> content{};
    const ssize_t size = pread(descriptor, content.data(), content.size(), 0);
    std::istringstream lines(std::string(content.data(), size > 0 ? static_cast<std::size_t>(size) : 0));
    Owner owner;
    std::string process;
    std::getline(lines, owner.name);
    std::getline(lines, owner.host);
    std::getline(lines, owner.system);
    if (std::getline(lines, process)) owner.process = std::strtoll(process.c_str(), nullptr, 10);
    return owner;
  }

  std::string text() const { return name + "\n" + host + "\n" + system + "\n" + std::to_string(process) + "\n"; }
};

/// What the system says of a lock that was asked for.
enum class Hold { Ours, Another, Unknown };

Hold ask(int descriptor) {
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) return Hold::Ours;
  return errno == EWOULDBLOCK ? Hold::Another : Hold::Unknown;
}

/// Whether the owner may be at work, where its lock is free or the file system knows no locks.
bool mayBeAtWork(const Owner& owner, Hold hold) {
  const Owner self = Owner::self();
  if (owner.process == 0) return false;  // it was killed before it wrote its name
  const bool isOfThisSystem = owner.system == self.system;
  if (!isOfThisSystem && owner.host == self.host) return false;  // this host has been started anew since
  if (!isOfThisSystem) return true;                              // locks need not reach other hosts
  if (hold == Hold::Ours) return false;
  const auto process = static_cast<pid_t>(owner.process);
  return process != getpid() && (kill(process, 0) == 0 || errno == EPERM);
}

/// Whether the open file still has this name: its owner may have removed it in between.
bool isStill(int descriptor, const std::string& path) {
  struct stat open {};
  struct stat named {};
  return fstat(descriptor, &open) == 0 && lstat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino &&
         open.st_dev == named.st_dev;
}

[[noreturn]] void refuse(const std::string& path, const Owner& owner, bool isSure) {
  const std::string base = path.substr(0, path.find_last_of('.'));
  throw RunError("another run writes the results \"" + base +
                 "\": " + (owner.name.empty() ? "one that has only begun" : owner.name) +
                 "; wait for its end, or give these another name" +
                 (isSure ? "" : " (if it has ended: that host left \"" + path + "\" behind; remove it)"));
}

}  // namespace

std::string thisRun() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::array<char, 32> time{};
  std::strftime(time.data(), time.size(), "%Y-%m-%d %H:%M:%S", &local);
  return "pdrun on " + hostName() + ", process " + std::to_string(getpid()) + ", since " + time.data();
}

ResultLock::ResultLock(const std::string& base) : path_(base + ".lock") {
  makeFolderOf(path_);
  while (descriptor_ < 0) {
    const int descriptor = open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
    if (descriptor < 0) throwFileError("create", path_, errno);
    const Owner owner = Owner::readFrom(descriptor);
    struct stat status {};
    const bool isOurs = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
                        (status.st_size == 0 || owner.name.compare(0, 6, "pdrun ") == 0);
    const Hold hold = isOurs ? ask(descriptor) : Hold::Unknown;
    const bool isTaken = hold == Hold::Another || (isOurs && mayBeAtWork(owner, hold));
    const bool isGone = hold == Hold::Ours && !isStill(descriptor, path_);
    if (isOurs && !isTaken && !isGone) {
      descriptor_ = descriptor;
      continue;
    }
    const Owner last = Owner::readFrom(descriptor);
    close(descriptor);
    if (!isOurs)
      throw RunError("\"" + path_ +
                     "\" is in the way and was not written by pdrun; move it away, or give the results "
                     "another name");
    if (isTaken) refuse(path_, last, hold == Hold::Another);
  }
  const std::string text = Owner::self().text();
  if (ftruncate(descriptor_, 0) != 0 ||
      pwrite(descriptor_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) {
    const int error = errno;
    unlink(path_.c_str());
    close(descriptor_);
    throwFileError("write", path_, error);
  }
}

ResultLock::~ResultLock() {
  if (isStill(descriptor_, path_)) unlink(path_.c_str());
  close(descriptor_);
}

}  // namespace pd
