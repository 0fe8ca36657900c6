#include "text_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "../deck/deck_data.hpp"
#include "text_file.hpp"

namespace pd {

namespace {

constexpr std::size_t nColumns = 5;
constexpr std::array<const char*, nColumns> columnsOfPoints = {"x", "y", "z", "the block number", "the volume"};

constexpr double largestValue = 1e100;  ///< squares of distances stay far from overflow

using Row = std::array<double, nColumns>;

/// What is wrong with the line's words; empty where they are five finite numbers.
std::string readRow(DataLines& lines, Row& row) {
  std::size_t count = 0;
  std::string problem;
  for (std::string_view word = lines.word(); !word.empty(); word = lines.word(), ++count) {
    if (count >= nColumns || !problem.empty()) continue;
    const std::optional<double> value = parseReal(std::string(word));
    if (!value)
      problem = std::string(columnsOfPoints[count]) + " is " + quoted(word) + ", not a finite number";
    else if (std::abs(*value) > largestValue)
      problem = std::string(columnsOfPoints[count]) + " is " + quoted(word) + ", too large to be meant";
    else
      row[count] = *value;
  }
  if (count != nColumns) return "a point has 5 numbers (x y z block_id volume), this line has " + std::to_string(count);
  return problem;
}

bool isBlockNumber(double value) {
  return value >= 1.0 && value == std::floor(value) && value <= std::numeric_limits<int>::max();
}

/// What is wrong with the values of a row; empty where nothing is.
std::string complaint(const Row& row) {
  const double block = row[3], volume = row[4];
  if (!isBlockNumber(block))
    return "the block number (fourth column) must be an integer of 1 or more; the columns are x y z block_id volume";
  if (!(volume > 0.0)) return "the volume (fifth column) must be greater than 0; the columns are x y z block_id volume";
  return "";
}

std::uint64_t hashOf(const double* x) {
  std::uint64_t hash = 0;
  for (int k = 0; k < 3; ++k) {
    const double value = x[k] + 0.0;  // one zero for both signs
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15ULL;  // 2^64 / golden ratio (multiplicative hashing, Knuth)
    hash ^= hash >> 32;
  }
  return hash;
}

void findDuplicates(const MeshPoints& points, FileMistakes& mistakes) {
  std::vector<std::pair<std::uint64_t, int>> hashes;
  hashes.reserve(points.volume.size());
  for (int i = 0; i < points.size(); ++i) hashes.emplace_back(hashOf(points.at(i)), i);
  std::sort(hashes.begin(), hashes.end());
  std::vector<std::pair<int, int>> duplicates;  // (point, the first at its place)
  for (std::size_t first = 0; first < hashes.size(); ++first) {
    for (std::size_t other = first + 1; other < hashes.size() && hashes[other].first == hashes[first].first; ++other) {
      const double *a = points.at(hashes[first].second), *b = points.at(hashes[other].second);
      if (!std::equal(a, a + 3, b)) continue;
      duplicates.emplace_back(hashes[other].second, hashes[first].second);
      break;  // the next of equal points finds the one after it
    }
  }
  std::sort(duplicates.begin(), duplicates.end());
  for (const auto& [point, first] : duplicates) {
    const std::size_t i = static_cast<std::size_t>(point);
    mistakes.add(points.line[i], "this point is at the same place as the one in line " +
                                     std::to_string(points.line[first]) + "; remove one of them");
  }
}

}  // namespace

MeshPoints parseTextMesh(const std::string& text, const std::string& fileName, Mistakes& allMistakes) {
  MeshPoints points;
  points.fileName = fileName;
  FileMistakes mistakes(fileName, allMistakes);
  const auto nLines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
  points.x.reserve(3 * nLines);
  points.volume.reserve(nLines);
  points.blockId.reserve(nLines);
  points.line.reserve(nLines);

  std::vector<std::pair<int, std::string>> problems;  // (line, what is wrong)
  bool areExchanged = true;                           // volumes stand where the block numbers should, in every row
  DataLines lines(text);
  while (lines.next()) {
    ++points.nRows;
    Row row{};
    std::string problem = readRow(lines, row);
    areExchanged = areExchanged && problem.empty() && isBlockNumber(row[4]) && row[3] > 0.0;
    if (problem.empty()) problem = complaint(row);
    if (!problem.empty()) {
      problems.emplace_back(lines.number(), problem);
      continue;
    }
    points.x.insert(points.x.end(), row.begin(), row.begin() + 3);
    points.blockId.push_back(static_cast<int>(row[3]));
    points.volume.push_back(row[4]);
    points.line.push_back(lines.number());
  }
  if (areExchanged && !problems.empty())
    allMistakes.add(fileName, "columns 4 and 5 look exchanged; the columns are x y z block_id volume");
  else
    for (const auto& [line, problem] : problems) mistakes.add(line, problem);
  if (points.nRows == 0) allMistakes.add(fileName, "the mesh has no points (one a line: x y z block_id volume)");
  findDuplicates(points, mistakes);
  return points;
}

}  // namespace pd
