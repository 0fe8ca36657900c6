// The files of one Output Filename: where they may lie, which of those that are there an earlier run has left.
//
// Every file carries a mark: HDF5 files the attribute `writer` of the root group, text files a line or an entry near
// their beginning, files that are not whole yet their ending. What has no mark belongs to somebody else: it is neither
// written over nor removed.
#ifndef PD_RESULT_FILES_HPP
#define PD_RESULT_FILES_HPP

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace pd {

/// The names of files that pdrun marks and finds again begin with the path of the results and go on with these.
namespace endings {
inline const std::string index = ".h5", xdmf = ".xdmf", history = ".csv", units = ".csv-metadata.json",
                         report = ".report.json", checkpoint = ".checkpoint.h5", resolved = ".resolved.yaml",
                         log = ".log", steps = ".steps";
// Of a study.
inline const std::string table = ".study.csv", errors = ".study.png", histories = ".histories.png", runs = ".study";
// Of a fit.
inline const std::string iterations = ".fit.csv", residuals = ".fit.residuals.csv", fitPicture = ".fit.png",
                         fitResult = ".fit.json", fitted = ".fitted.yaml", problem = ".fit.problem.json",
                         fitRuns = ".fit";
}  // namespace endings

/// The path of results "sub/plate" below `folder`, or below the working folder where that is empty.
std::string resultPath(const std::string& folder, const std::string& name);

/// Why results cannot lie at `base`, a path below `folder` (empty: the working folder): a link leads out of it, a file
/// is where a folder is needed, a folder cannot be written to. Empty where they can.
std::string obstacleOfPlace(const std::string& base, const std::string& folder);

/// Files, links and folders that stand where a run with this base would write, and that pdrun has not written, a
/// sentence each. Calls HDF5.
std::vector<std::string> obstaclesOfFiles(const std::string& base);

/// The same of a study: its table and pictures. Those of its runs are their own.
std::vector<std::string> obstaclesOfStudy(const std::string& base);

/// And of a fit: its tables, picture, results, and the decks that it writes.
std::vector<std::string> obstaclesOfFit(const std::string& base, const std::vector<std::string>& decks);

/// Removes what an earlier run has left of `base`: first the files that list others, so that no list names what is
/// gone, at last the steps. Leaves what has no mark. Throws RunError.
void removeResults(const std::string& base);
/// Of the report alone.
void removeReport(const std::string& base);
/// Of a study, with all of its runs.
void removeStudyResults(const std::string& base);

/// Of a fit, with its decks; of its runs, whose names begin with their origin, all but those of these origins.
void removeFitResults(const std::string& base, const std::vector<std::string>& decks,
                      const std::set<std::string>& origins);

/// Number of the step whose file has this name in a folder of steps, "000123.h5"; -1 where it is no step's.
long long stepOfFile(const std::filesystem::path& path);
std::string stepName(long long step);  ///< "000123"

/// Whether pdrun has written the file. Calls HDF5.
bool isOfPdrun(const std::filesystem::path& path);

}  // namespace pd

#endif
