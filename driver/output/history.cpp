#include "history.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "atomic_file.hpp"
#include "result_files.hpp"

namespace pd {

History::History(const std::string& path, const std::vector<std::string>& columns, int firstStep) : path_(path) {
  std::string header = "step,time";
  for (const std::string& column : columns) header += "," + column;
  makeFolderOf(path_);
  takeOver(header, firstStep);
  file_.reset(openForWriting(path_, true));
}

void History::takeOver(const std::string& header, int firstStep) {
  std::string rows = header + "\n";
  std::ifstream old(path_);
  std::string line;
  if (firstStep > 0 && std::getline(old, line)) {
    if (line == header) {
      // A row that the end of the earlier run cut short has no end of line.
      while (std::getline(old, line) && !old.eof()) {
        int step = -1;
        if (std::istringstream(line) >> step && step >= 0 && step < firstStep) rows += line + "\n";
      }
    } else {
      std::string kept = path_ + ".old";
      for (int n = 2; std::filesystem::exists(std::filesystem::symlink_status(kept)); ++n)
        kept = path_ + ".old" + std::to_string(n);
      if (std::rename(path_.c_str(), kept.c_str()) != 0) throwFileError("rename", path_, errno);
    }
  }
  writeFileAtomically(path_, rows);
}

void History::row(int step, double time, const std::vector<double>& values) {
  std::string line = fmt::format("{},{}", step, time);
  for (const double value : values) line += fmt::format(",{}", value);
  line += '\n';
  if (std::fwrite(line.data(), 1, line.size(), file_.get()) != line.size() || std::fflush(file_.get()) != 0)
    throwFileError("write", path_, errno);
}

void writeColumnUnits(const std::string& base, const std::vector<std::string>& columns,
                      const std::vector<std::string>& units, const std::string& timeUnit) {
  using nlohmann::ordered_json;
  ordered_json described = {{{"name", "step"}}, {{"name", "time"}, {"schema:unitText", timeUnit}}};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    ordered_json column = {{"name", columns[k]}};
    if (!units[k].empty()) column["schema:unitText"] = units[k];
    described.push_back(column);
  }
  const ordered_json json = {{"@context", "http://www.w3.org/ns/csvw"},
                             {"dc:creator", "pdrun"},
                             {"url", std::filesystem::path(base + endings::history).filename().string()},
                             {"tableSchema", {{"columns", described}}}};
  writeFileAtomically(base + endings::units, json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

std::vector<std::string> columnNames(const std::string& label, int width) {
  if (width == 1) return {label};
  std::vector<std::string> names;
  const std::string axes = "XYZ";
  for (int k = 0; k < width; ++k) {
    const auto axis = [&](int i) { return std::string(1, axes[static_cast<std::size_t>(i)]); };
    if (width == 3)
      names.push_back(label + axis(k));
    else if (width == 9)
      names.push_back(label + axis(k / 3) + axis(k % 3));
    else
      names.push_back(label + "_" + std::to_string(k + 1));
  }
  return names;
}

}  // namespace pd
