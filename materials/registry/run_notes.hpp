// What a plug-in has found out about a run that its user should know.
#ifndef PD_RUN_NOTES_HPP
#define PD_RUN_NOTES_HPP

#include <string>
#include <vector>

namespace pd {

/// A host that knows of it asks materials after initialize(), and computes after compute(), of which each line is a
/// warning, and puts the lines into its report; others need not.
class RunNotes {
 public:
  virtual ~RunNotes() = default;
  /// The same on every rank that has points of the block.
  virtual std::vector<std::string> runNotes() const = 0;
};

}  // namespace pd

#endif
