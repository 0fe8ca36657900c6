// How much of a cell places of another one see past cracks and voids.
#ifndef PD_SIGHT_HPP
#define PD_SIGHT_HPP

#include "lined_cells.hpp"
#include "middles_per_lane.hpp"

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
  Cover coverOfShadow();
  /// Both find what one screen hides of the lines, in the measure, but for counts not rounded up yet.
  void castShadow();
  bool castHidden(const Screen& screen, const Places& places);
  /// Puts it to what others hide.
  void keepHidden();
  /// What of the lines is hidden from each place, or taken.
  kernels::Vector unseenMiddles() const;
  kernels::Vector unseenLength();

  const Cell* cell_ = nullptr;
  LineGrid grid_;
  LineMeasure measure_{0};
  const Taken* taken_ = nullptr;
  const std::vector<const Screen*>* screens_ = nullptr;
  std::vector<HalfSpace> shadow_;                             ///< of one screen
  Lines lines_;                                               ///< where a screen needs them
  std::vector<kernels::Vector> low_, high_;                   ///< [lines] what one screen hides of each
  std::vector<MiddlesPerLane> takenMiddles_, hiddenMiddles_;  ///< [lines]
  std::vector<std::vector<RangePerLane>> hidden_;             ///< [lines][screens that hide something of it]
  bool isHidden_ = false;                                     ///< something, from some place
};

}  // namespace pd::decomposition

#endif
