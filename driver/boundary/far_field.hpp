// Exchange with an electrolyte that reaches beyond the mesh.
#ifndef PD_FAR_FIELD_HPP
#define PD_FAR_FIELD_HPP

#include <vector>

namespace pd {

/// What is beyond the mesh: a rate coefficient_i (value_i - field_i) at owned point i.
struct FarField {
  std::vector<double> coefficient;  ///< [nOwned] 1/s, 0 where there is nothing; empty without any such condition
  std::vector<double> value;        ///< [nOwned] in the unit of the field
};

/// Rate k, 1/s, of the sink k (C_far - C) in a layer of `thickness` m at the end of the mesh, by which it draws the
/// steady flux D (C - C_far) / (thickness + distance) from what lies before it: as if the electrolyte went on for
/// `distance` m past the layer, to where C is C_far. From D C'' = k (C - C_far) in the layer and no flux through its
/// end: with y = thickness sqrt(k / D), y tanh y = thickness / (thickness + distance); for long distances k is
/// D / (thickness distance). `diffusivity`, m2/s, and `thickness` positive, `distance` 0 or more.
double exchangeRate(double diffusivity, double distance, double thickness);

}  // namespace pd

#endif
