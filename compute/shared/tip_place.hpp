// Where a crack in a plane body ends and where it grows to: of the deck, or of a Crack_Tip.
#ifndef PD_TIP_PLACE_HPP
#define PD_TIP_PLACE_HPP

#include <string>

#include "plugins.hpp"
#include "point_deformation.hpp"

namespace pd {

/// Of the direction of the crack that a Crack_Tip with this label finds.
inline std::string crackDirectionLabel(const std::string& tipLabel) { return tipLabel + "_Direction"; }

/// Of computes that integrate deformation around a tip.
struct TipFields : DeformationGradients::Fields {
  FieldHandle tip, direction;  ///< unused where the deck gives a position, or the label of no such field
  explicit TipFields(const Teuchos::ParameterList& parameters);
};

class TipPlace {
 public:
  static void declareParameters(ParameterDeclarations& declarations, const char* compute);
  /// From a completed list. Throws std::invalid_argument.
  TipPlace(const Teuchos::ParameterList& parameters, std::string compute);
  /// Throws std::invalid_argument where the deck's Tip Field is not the result of a Crack_Tip.
  void requireTip(PeridigmNS::Block& block, const FieldHandle& tip) const;
  struct Tip {
    Vector3 place, direction;
  };
  Tip tip(PeridigmNS::Block& block, const TipFields& fields) const;
  double thickness() const { return thickness_; }  ///< m
  /// Of their neighbours: points that keep less than that hang on the lips of the crack as they happen to, and their
  /// strain is none of the body's. A straight cut leaves 0.5 to 0.6, steps of a path across rows of points 0.44.
  static constexpr double leastIntact = 0.4;

 protected:
  std::string compute_;

 private:
  std::string tipField_;
  Vector3 tip_, direction_;
  double thickness_;
  bool isDirectionGiven_ = false;
};

}  // namespace pd

#endif
