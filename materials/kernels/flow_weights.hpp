// The nonlocal operators of flow at one point, as weights of the ends of its bonds.
#ifndef PD_FLOW_WEIGHTS_HPP
#define PD_FLOW_WEIGHTS_HPP

#include <array>
#include <vector>

namespace pd::kernels {

/// What a bond xi = |xi| n passes on of a difference of velocities: all of it, or what is across the bond.
enum class ViscousKernel { Laplacian, Transverse };

/// Constant alpha of the viscous operator
///   lap v = alpha / V_H  int K (v' - v) / |xi|^2 dV',  K = 1 (Laplacian) or 1 - n n (Transverse),
/// V_H the volume of the neighbourhood. With v' - v = 1/2 (xi.grad)^2 v, the mean of n n over all directions 1/d, and
/// that of n_a n_b n_c n_d (sum of the three products of deltas)/(d (d + 2)):
///   Laplacian   alpha/(2 d) lap v                                  alpha = 2 d: 4 in the plane, 6 in space
///   Transverse  alpha/(2 d) [(1 - 1/(d+2)) lap v - 2/(d+2) grad div v]
///                                                                  alpha = 2 d (d+2)/(d+1): 16/3 and 15/2
/// The second is that of Zhao, Larios & Bobaru, CMAME 2022, doi 10.1016/j.cma.2022.114815, for flows without
/// divergence; 10 in space, as is also found, is a third too much.
double viscousConstant(int dimension, ViscousKernel kernel);

/// Ends of the bonds of one point. A bond that meets a wall ends there.
struct BondEnds {
  int dimension = 2;
  std::vector<double> xi;      ///< [dimension n] from the point to the end, m
  std::vector<double> volume;  ///< [n] what counts of the volume of the neighbour, m3

  std::size_t count() const { return volume.size(); }
  /// `bond` [dimension], or more.
  void add(const double* bond, double itsVolume) {
    xi.insert(xi.end(), bond, bond + dimension);
    volume.push_back(itsVolume);
  }
  /// K of the bond to end k; 3 by 3, row by row, zero beyond the dimension.
  std::array<double, 9> viscousShare(std::size_t k, ViscousKernel kernel) const;
};

/// Weights [n], 1/m2, with lap v = sum_k w_k K (v_k - v), K as above. Those of the kernel 1/|xi|^2, with the least
/// change that makes them exact (with K = 1) for quadratic fields; for the Transverse kernel times the ratio of both
/// alpha. Empty where the ends cannot do it.
std::vector<double> viscousWeights(const BondEnds& ends, double horizonVolume, ViscousKernel kernel);

/// Weights [dimension n], 1/m, with grad f = sum_k w_k (f_k - f): the kernel n/|xi|^2, with the least change that makes
/// them exact for quadratic fields. Empty where the ends cannot do it.
std::vector<double> gradientWeights(const BondEnds& ends);

/// The same, exact for linear fields alone. Along directions in which there is no end the gradient is none.
std::vector<double> linearGradientWeights(const BondEnds& ends);

/// Weights [n] with f(place) = f + sum_k w_k (f_k - f), exact for fields of this degree (1 or 2), from the ends near
/// `place` [dimension], m, seen from the point. Empty where the ends cannot do it.
std::vector<double> interpolationWeights(const BondEnds& ends, const double* place, int degree);

/// Symmetric weight of the bond of length |xi| between the points i and j, whose cells have edges about `spacing`, in
///   sum_j s(|xi|) [p_j - p_i - 1/2 (g_i + g_j).xi], g the gradients of p at both ends:
/// a fourth difference that is zero for quadratic p and adds up to zero over all points, by which pressures that
/// alternate from point to point are seen. spacing^2/|xi|^4, so that without the gradients it is about the Laplacian,
/// 1/m^2.
double pressureSmoothing(int dimension, double spacing, double length);

}  // namespace pd::kernels

#endif
