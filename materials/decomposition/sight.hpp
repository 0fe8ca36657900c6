// How much of a cell places of another one see past cracks and voids.
#ifndef PD_SIGHT_HPP
#define PD_SIGHT_HPP

#include "lined_cells.hpp"

namespace pd::decomposition {

/// The lines of a cell, as seen from elsewhere. Screens whose shadows are half-spaces cost some ns a line and place.
class Sight {
 public:
  Sight(const Cell& cell, std::size_t axis, int n, const LineMeasure& measure, const Taken& taken,
        const std::vector<const Screen*>& screens);

  int nLines() const { return grid_.size(); }
  /// Of what counts, over all lines.
  double counted() const { return counted_; }
  /// The part of it that is seen, summed over the first `nPlaces` of `places`.
  double seen(const Places& places, int nPlaces);

 private:
  enum class Cover { Nothing, Something, All };
  Cover coverOf(const std::vector<HalfSpace>& shadow) const;
  void castShadow();
  void castHidden(const Screen& screen, const Places& places);
  double takenBySorting(int nPlaces);

  const Cell& cell_;
  const LineGrid grid_;
  const LineMeasure measure_;
  const Taken& taken_;
  const std::vector<const Screen*>& screens_;
  double counted_;
  std::vector<HalfSpace> shadow_;
  Lines lines_;  ///< of screens that need them
  /// What each screen hides of each line from each place: [screens that hide something][lines]
  std::vector<std::vector<kernels::Vector>> low_, high_;
  std::size_t nCasts_ = 0;
};

}  // namespace pd::decomposition

#endif
