// What a solver goes on from after a restart, beyond the fields.
#ifndef PD_RESTART_STATE_HPP
#define PD_RESTART_STATE_HPP

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace pd {

/// Named numbers, the same on every rank. A solver gives the same names whatever it has done so far, so that those of
/// one that has just been made tell whether it can take up a state. Point data belong in fields, which checkpoints
/// move to whatever rank owns the point.
class RestartState {
 public:
  using Entry = std::pair<std::string, double>;

  RestartState() = default;
  RestartState(std::initializer_list<Entry> entries) : entries_(entries) {}

  const std::vector<Entry>& entries() const { return entries_; }
  bool has(const std::string& name) const;
  /// Throws std::out_of_range, naming what is missing.
  double operator[](const std::string& name) const;

  void add(const std::string& name, double value) { entries_.emplace_back(name, value); }
  /// Adds the entries of a part as "<part>/<name>".
  void addPart(const std::string& part, const RestartState& state);
  /// The entries "<part>/<name>" as "<name>".
  RestartState part(const std::string& part) const;

 private:
  std::vector<Entry> entries_;
};

}  // namespace pd

#endif
