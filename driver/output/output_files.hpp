// The files of one Output Filename, which several Output sections may share.
#ifndef PD_OUTPUT_FILES_HPP
#define PD_OUTPUT_FILES_HPP

#include <memory>
#include <string>
#include <vector>

#include "../model/model.hpp"
#include "field_writer.hpp"
#include "history.hpp"
#include "output_section.hpp"

namespace pd {

/// Labels of an Output section's variables, by what they are.
struct OutputLabels {
  std::vector<std::string> point;   ///< fields of points, and Proc_Num
  std::vector<std::string> global;  ///< values for the whole body
};

class OutputFiles {
 public:
  explicit OutputFiles(std::string fileName) : fileName_(std::move(fileName)) {}

  const std::string& fileName() const { return fileName_; }
  void add(const OutputSection& section, const OutputLabels& labels);
  /// A column that no section asks for by name.
  void addColumn(const std::string& label);
  bool hasColumn(const std::string& label) const;

  /// Tells that another solver goes on, whose first state counts in decks of Peridigm.
  void startSolver();
  bool areFieldsDue(int step, bool isLast) const;
  bool isHistoryDue(int step, bool isLast) const;
  bool isCheckpointDue(int step, bool isLast) const;
  bool writesFields() const;

  /// Opens the files, which go on from `firstStep` (0: afresh). `order` must outlive this. Collective.
  void open(Model& model, const GlobalOrder& order, int firstStep, const std::string& timeUnit = "s");
  /// Writes what is due. Collective; throws RunError on all ranks.
  void write(Model& model, int step, double time, bool isLast);

 private:
  struct Part {
    OutputSection section;
    OutputLabels labels;
  };
  void writeFields(Model& model, int step, double time, bool isLast);
  void writeHistory(Model& model, int step, double time);

  std::string fileName_;
  std::vector<Part> parts_;
  std::vector<std::string> columns_;  ///< labels of the CSV file
  std::unique_ptr<FieldWriter> fields_;
  std::unique_ptr<History> history_;  ///< of the root rank alone
};

}  // namespace pd

#endif
