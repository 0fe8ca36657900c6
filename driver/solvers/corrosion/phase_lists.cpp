#include "phase_lists.hpp"

#include <algorithm>
#include <iterator>

namespace pd {

void PhaseLists::markNeighborsOf(const Discretization& d, int point) {
  const auto mark = [&](int neighbor) {
    if (neighbor >= d.nOwned || state_[static_cast<std::size_t>(neighbor)] != State::Intact) return;
    state_[static_cast<std::size_t>(neighbor)] = State::Dissolving;
    dissolving_.push_back(neighbor);
  };
  if (point >= d.nOwned) {
    for (const int neighbor : aroundGhost_[static_cast<std::size_t>(point - d.nOwned)]) mark(neighbor);
    return;
  }
  const int* list = &d.neighborhoodList[static_cast<std::size_t>(d.neighborhoodStart[static_cast<std::size_t>(point)])];
  for (int k = 1; k <= *list; ++k) mark(list[k]);
}

void PhaseLists::reset(Model& model) {
  const Discretization& d = model.discretization();
  const double *damage = model.field("Damage"), *saturation = model.field("Saturation_Concentration");
  const auto nGhosts = static_cast<std::size_t>(d.nPoints - d.nOwned);
  if (aroundGhost_.size() != nGhosts) {
    aroundGhost_.resize(nGhosts);
    for (int i = 0; i < d.nOwned; ++i) {
      const int* list = &d.neighborhoodList[static_cast<std::size_t>(d.neighborhoodStart[static_cast<std::size_t>(i)])];
      for (int k = 1; k <= *list; ++k)
        if (list[k] >= d.nOwned) aroundGhost_[static_cast<std::size_t>(list[k] - d.nOwned)].push_back(i);
    }
  }
  liquid_.clear();
  dissolving_.clear();
  state_.assign(static_cast<std::size_t>(d.nPoints), State::Intact);
  for (int i = 0; i < d.nPoints; ++i) {
    if (saturation[i] == 0.0) state_[static_cast<std::size_t>(i)] = State::Wall;
    if (damage[i] < 1.0 || saturation[i] == 0.0) continue;
    state_[static_cast<std::size_t>(i)] = State::Liquid;
    if (i < d.nOwned) liquid_.push_back(i);
  }
  for (int i = 0; i < d.nPoints; ++i)
    if (state_[static_cast<std::size_t>(i)] == State::Liquid) markNeighborsOf(d, i);
}

std::vector<int> PhaseLists::update(Model& model) {
  const Discretization& d = model.discretization();
  const double* damage = model.field("Damage");
  std::vector<int> turned;
  const auto isTurned = [&](int i) { return damage[i] >= 1.0; };
  std::copy_if(dissolving_.begin(), dissolving_.end(), std::back_inserter(turned), isTurned);
  dissolving_.erase(std::remove_if(dissolving_.begin(), dissolving_.end(), isTurned), dissolving_.end());
  std::sort(turned.begin(), turned.end());
  const auto middle = static_cast<std::ptrdiff_t>(liquid_.size());
  liquid_.insert(liquid_.end(), turned.begin(), turned.end());
  std::inplace_merge(liquid_.begin(), liquid_.begin() + middle, liquid_.end());
  for (int i = d.nOwned; i < d.nPoints; ++i)
    if (isTurned(i) && state_[static_cast<std::size_t>(i)] == State::Intact) turned.push_back(i);
  for (const int i : turned) state_[static_cast<std::size_t>(i)] = State::Liquid;
  const auto known = static_cast<std::ptrdiff_t>(dissolving_.size());
  for (const int i : turned) markNeighborsOf(d, i);
  return {dissolving_.begin() + known, dissolving_.end()};
}

}  // namespace pd
