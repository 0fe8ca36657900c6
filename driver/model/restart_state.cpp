#include "restart_state.hpp"

#include <algorithm>
#include <stdexcept>

namespace pd {

bool RestartState::has(const std::string& name) const {
  return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.first == name; });
}

double RestartState::operator[](const std::string& name) const {
  for (const auto& [known, value] : entries_)
    if (known == name) return value;
  throw std::out_of_range("the state of the solver lacks \"" + name + "\"");
}

void RestartState::addPart(const std::string& part, const RestartState& state) {
  for (const auto& [name, value] : state.entries_) add(part + "/" + name, value);
}

RestartState RestartState::part(const std::string& part) const {
  const std::string prefix = part + "/";
  RestartState result;
  for (const auto& [name, value] : entries_)
    if (name.compare(0, prefix.size(), prefix) == 0) result.add(name.substr(prefix.size()), value);
  return result;
}

}  // namespace pd
