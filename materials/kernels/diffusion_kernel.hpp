// Nonlocal diffusion: the rate of a scalar field from its differences over bonds.
#ifndef PD_DIFFUSION_KERNEL_HPP
#define PD_DIFFUSION_KERNEL_HPP

#include <vector>

#include "alive_bonds.hpp"
#include "chunked_neighborhood.hpp"

namespace pd::kernels {

/// rate_i += sum_j w_ij (C_j - C_i). `weights`: width 1, w_ij = d kernel(|xi|) (volume share) V_j in 1/s.
/// `alive`: null, or the bonds that carry flux; `only`: null, or the chunks that have such bonds. C and rate by local
/// id; both must be readable for `lanes` values past their end.
void addFluxDivergence(const ChunkedNeighborhood& neighborhood, const BondConstants& weights, const AliveBonds* alive,
                       const double* concentration, double* rate, const std::vector<std::size_t>* only = nullptr);

/// rate_i += sum_j w_ij (s_i + s_j)/2 (C_j - C_i) over the bonds whose bits are set, in the chunks `only`. `scale`: s,
/// by local id, readable as C is.
void addScaledFluxDivergence(const ChunkedNeighborhood& neighborhood, const BondConstants& weights,
                             const AliveBonds& alive, const std::vector<std::size_t>& only, const double* scale,
                             const double* concentration, double* rate);

}  // namespace pd::kernels

#endif
