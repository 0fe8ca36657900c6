// The file <name>.h5: all steps of a run as one tree, by links to the files of the steps.
#ifndef PD_STEP_INDEX_HPP
#define PD_STEP_INDEX_HPP

#include <memory>
#include <string>
#include <vector>

namespace pd {

/// Built in memory, and written whole after every step. Used by the root rank alone; throws RunError.
class StepIndex {
 public:
  /// `meshFile`: linked as /mesh. File names are relative to the folder of `path`.
  StepIndex(const std::string& path, const std::string& meshFile);
  ~StepIndex();
  /// Links the step's file as /steps/<name>.
  void addStep(const std::string& name, const std::string& stepFile);
  void write();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// A step's file as it was found.
struct FoundStep {
  long long nPoints = 0;
  double time = 0.0;
  std::vector<std::string> names;
  std::vector<int> widths;
};

/// What the file of a step holds. Throws RunError where it cannot be read.
FoundStep readStepFile(const std::string& path);

}  // namespace pd

#endif
