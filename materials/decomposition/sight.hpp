// How much of a cell places of another one see past cracks and voids.
#ifndef PD_SIGHT_HPP
#define PD_SIGHT_HPP

#include "lined_cells.hpp"

namespace pd::decomposition {

/// The lines of a cell, as seen from elsewhere. Screens whose shadows are half-spaces cost about a ns a line and place.
class Sight {
 public:
  /// Turns to lines of a cell behind these screens. What is given stays there until it turns elsewhere.
  void turnTo(const Cell& cell, const LineGrid& grid, const LineMeasure& measure, const Taken& taken,
              const std::vector<const Screen*>& screens);

  int nLines() const { return grid_.size(); }
  /// Of what counts, over all lines.
  double counted() const { return measure_.whole() * grid_.size() - taken_->sum; }
  /// The part of it that is seen, summed over the first `nPlaces` of `places`.
  double seen(const Places& places, int nPlaces);

 private:
  enum class Cover { Nothing, Something, All };
  Cover coverOfShadow() const;
  void castShadow();
  void castHidden(const Screen& screen, const Places& places);
  /// By inclusion and exclusion over n ranges a line.
  template <int n>
  kernels::Vector takenOf() const;
  double takenBySorting(int nPlaces) const;

  const Cell* cell_ = nullptr;
  LineGrid grid_;
  LineMeasure measure_{0};
  const Taken* taken_ = nullptr;
  const std::vector<const Screen*>* screens_ = nullptr;
  std::vector<HalfSpace> shadow_;  ///< of one screen
  Lines lines_;                    ///< where a screen needs them
  /// What is hidden of each line from each place, in the measure but for counts not rounded up yet: [screens that hide
  /// something][lines]
  std::vector<std::vector<kernels::Vector>> low_, high_;
  std::size_t nCasts_ = 0;
};

}  // namespace pd::decomposition

#endif
