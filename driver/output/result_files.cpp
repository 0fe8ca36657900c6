#include "result_files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <functional>

#include "../model/model.hpp"
#include "atomic_file.hpp"
#include "hdf5_file.hpp"

namespace pd {

namespace fs = std::filesystem;

namespace {

/// A kind of files, in the order in which they are removed: what lists others comes first. The units
/// of a history are its mark, so that they go last of the two.
struct FileKind {
  std::string ending;
  std::string mark;  ///< in the first bytes; empty of HDF5 files
};

const std::vector<FileKind>& kindsOfRuns() {
  static const std::vector<FileKind> all = {{endings::xdmf, "<!-- written by pdrun -->"},
                                            {endings::index, ""},
                                            {endings::report, "\"writer\": \"pdrun\""},
                                            {endings::checkpoint, ""},
                                            {endings::history, "step,time"},
                                            {endings::units, "\"dc:creator\": \"pdrun\""},
                                            {endings::resolved, "with all defaults written out by pdrun"},
                                            {endings::log, "pdrun "}};
  return all;
}

const std::vector<FileKind>& kindsOfStudies() {
  static const std::string software("Software\0pdstudy", 16);  // as PNG files say it
  static const std::vector<FileKind> all = {
      {endings::errors, software}, {endings::histories, software}, {endings::table, ",overrides,results"}};
  return all;
}

const std::vector<FileKind>& kindsOfFits() {
  static const std::string software("Software\0pdfit", 14);
  static const std::vector<FileKind> all = {
      {endings::fitPicture, software},          {endings::residuals, "series,place,"},
      {endings::iterations, "iteration,runs,"}, {endings::fitResult, "\"writer\": \"pdfit\""},
      {endings::fitted, "# Fitted by pdrun"},   {endings::problem, "\"writer\": \"pdrun\""}};
  return all;
}

bool endsWith(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/// Of endings that end alike the longest.
const FileKind* kindOf(const std::string& fileName) {
  const FileKind* found = nullptr;
  for (const std::vector<FileKind>* kinds : {&kindsOfRuns(), &kindsOfStudies(), &kindsOfFits()})
    for (const FileKind& kind : *kinds)
      if (endsWith(fileName, kind.ending) && (found == nullptr || kind.ending.size() > found->ending.size()))
        found = &kind;
  return found;
}

std::string beginningOf(const fs::path& path) {
  std::array<char, 4096> bytes{};
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), bytes.size());
  return {bytes.data(), static_cast<std::size_t>(file.gcount())};
}

bool isWithin(const fs::path& path, const fs::path& folder) {
  const auto difference = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return difference.first == folder.end();
}

/// Calls `use` for each entry; a folder that is not there has none.
void forEachEntry(const fs::path& folder, const std::function<void(const fs::path&)>& use) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    use(entry->path());
  if (error && error != std::errc::no_such_file_or_directory)
    throw RunError("cannot read the folder \"" + folder.string() + "\": " + error.message());
}

void removeFile(const fs::path& path) {
  if (unlink(path.c_str()) != 0 && errno != ENOENT) throwFileError("remove", path.string(), errno);
}

/// With what Open MPI leaves beside a file that a killed run had open: "NAME.data.RANK", "NAME.metadata.RANK".
void removeWithUnfinished(const std::string& path) {
  if (isOfPdrun(path)) removeFile(path);
  const fs::path unfinished = unfinishedName(path);
  removeFile(unfinished);
  const std::string beside = unfinished.filename().string() + ".";
  const fs::path folder = unfinished.parent_path();
  forEachEntry(folder.empty() ? "." : folder, [&](const fs::path& entry) {
    if (entry.filename().string().compare(0, beside.size(), beside) == 0) removeFile(entry);
  });
}

bool isNamedAsOfSteps(const fs::path& path) { return stepOfFile(path) >= 0 || path.filename() == "mesh.h5"; }

/// Of all runs in a folder but those whose names begin with one of `kept` and "_".
void removeRuns(const fs::path& folder, const std::set<std::string>& kept) {
  std::set<fs::path> runs;
  forEachEntry(folder, [&](const fs::path& path) {
    const std::string name = path.filename().string();
    if (kept.count(name.substr(0, name.find('_'))) == 0) runs.insert(folder / name.substr(0, name.find('.')));
  });
  for (const fs::path& run : runs) removeResults(run.string());
  rmdir(folder.c_str());
}

/// Adds why it stands in the way, where it does.
void addObstacleOf(const fs::path& path, std::vector<std::string>& found) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(path, error);
  if (!fs::exists(status) || isOfPdrun(path)) return;
  const char* const what = fs::is_symlink(status)         ? "is a symbolic link, which results do not follow"
                           : !fs::is_regular_file(status) ? "is in the way and is no plain file"
                                                          : "is there already and was not written by pdrun";
  found.push_back(fmt::format("\"{}\" {}; move it away, or give another name", path.string(), what));
}

}  // namespace

std::string resultPath(const std::string& folder, const std::string& name) {
  return folder.empty() ? name : (fs::path(folder) / name).string();
}

std::string obstacleOfPlace(const std::string& base, const std::string& folder) {
  std::error_code error;
  const fs::path root = fs::weakly_canonical(fs::absolute(folder.empty() ? "." : folder), error);
  for (const fs::path& place : {fs::path(base).parent_path(), fs::path(base + endings::steps)}) {
    if (fs::is_symlink(fs::symlink_status(place, error)) && !fs::exists(place, error))
      return "\"" + place.string() + "\" is a symbolic link to nothing; remove it";
    // Absolute first: of a relative path nothing of which is there, the library leaves the path as it is.
    const fs::path real = fs::weakly_canonical(fs::absolute(place.empty() ? "." : place), error);
    if (error) return "\"" + place.string() + "\": " + error.message();
    if (!isWithin(real, root))
      return fmt::format(
          "\"{}\" leads out of \"{}\" by a symbolic link, to \"{}\"; results stay below the folder that "
          "pdrun is started in, or that pdrun --output-folder FOLDER names",
          place.string(), root.string(), real.string());
    // Of its parents the first that is there.
    fs::path there = real;
    while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
    if (!fs::is_directory(there, error)) return "\"" + there.string() + "\" is a file where a folder is needed";
    if (access(there.c_str(), W_OK | X_OK) != 0)
      return "nothing can be written to the folder \"" + there.string() + "\": " + std::strerror(errno);
  }
  return "";
}

std::vector<std::string> obstaclesOfFiles(const std::string& base) {
  std::vector<std::string> found;
  for (const FileKind& kind : kindsOfRuns()) addObstacleOf(base + kind.ending, found);
  forEachEntry(base + endings::steps, [&](const fs::path& path) {
    if (isNamedAsOfSteps(path)) addObstacleOf(path, found);
  });
  return found;
}

std::vector<std::string> obstaclesOfStudy(const std::string& base) {
  std::vector<std::string> found;
  for (const FileKind& kind : kindsOfStudies()) addObstacleOf(base + kind.ending, found);
  return found;
}

std::vector<std::string> obstaclesOfFit(const std::string& base, const std::vector<std::string>& decks) {
  std::vector<std::string> found;
  for (const FileKind& kind : kindsOfFits()) addObstacleOf(base + kind.ending, found);
  for (const std::string& deck : decks)
    if (deck != base + endings::fitted) addObstacleOf(deck, found);
  return found;
}

void removeReport(const std::string& base) { removeWithUnfinished(base + endings::report); }

void removeResults(const std::string& base) {
  for (const FileKind& kind : kindsOfRuns()) removeWithUnfinished(base + kind.ending);
  const fs::path steps = base + endings::steps;
  std::vector<fs::path> removed;
  forEachEntry(steps, [&](const fs::path& path) {
    if (isUnfinished(path.string()) || (isNamedAsOfSteps(path) && isOfPdrun(path))) removed.push_back(path);
  });
  for (const fs::path& path : removed) removeFile(path);
  rmdir(steps.c_str());  // where nothing of anybody else is in it
}

void removeStudyResults(const std::string& base) {
  for (const FileKind& kind : kindsOfStudies()) removeWithUnfinished(base + kind.ending);
  removeRuns(base + endings::runs, {});
}

void removeFitResults(const std::string& base, const std::vector<std::string>& decks,
                      const std::set<std::string>& origins) {
  for (const FileKind& kind : kindsOfFits()) removeWithUnfinished(base + kind.ending);
  for (const std::string& deck : decks) removeWithUnfinished(deck);
  removeRuns(base + endings::fitRuns, origins);
}

std::string stepName(long long step) { return fmt::format("{:06}", step); }

long long stepOfFile(const fs::path& path) {
  const std::string stem = path.stem().string();
  if (path.extension() != ".h5" || stem.empty() || stem.size() > 18) return -1;
  if (stem.find_first_not_of("0123456789") != std::string::npos) return -1;
  const long long step = std::stoll(stem);
  return stepName(step) == stem ? step : -1;
}

bool isOfPdrun(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(path, error))) return false;
  const std::string name = path.string();
  const FileKind* kind = kindOf(name);
  if (kind == nullptr) return false;
  if (fs::file_size(path, error) == 0) return true;  // nothing in it can be lost, and a kill may have left it so
  if (kind->mark.empty()) return isMarkedHdf5(name);
  const std::string beginning = beginningOf(path);
  if (kind->ending == endings::log) return beginning.compare(0, kind->mark.size(), kind->mark) == 0;
  if (kind->ending != endings::history) return beginning.find(kind->mark) != std::string::npos;
  const std::string units = name.substr(0, name.size() - kind->ending.size()) + endings::units;
  return beginning.compare(0, kind->mark.size(), kind->mark) == 0 && isOfPdrun(units);
}

}  // namespace pd
