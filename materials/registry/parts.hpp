// What plug-ins that combine others, their parts, have in common.
#ifndef PD_PARTS_HPP
#define PD_PARTS_HPP

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace pd {

/// Appends those of `more` that are not there yet.
inline void addNew(std::vector<int>& ids, const std::vector<int>& more) {
  for (const int id : more)
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
}

/// Throws std::invalid_argument with a line for each of `messages`, which begins with the owner's name; does nothing
/// where there are none.
inline void throwAll(const std::string& owner, const std::vector<std::string>& messages) {
  std::string all;
  for (const std::string& message : messages) all += (all.empty() ? "" : "\n") + owner + ": " + message;
  if (!all.empty()) throw std::invalid_argument(all);
}

}  // namespace pd

#endif
