// Coefficients of the second-order stabilised explicit Runge-Kutta methods RKC and RKL, as numbers alone.
#ifndef PD_STABILIZED_SCHEME_HPP
#define PD_STABILIZED_SCHEME_HPP

#include <vector>

namespace pd {

/// One stage of the three-term recursion (Y_0 = y_n, F_j = f(t + c_j h, Y_j)):
///   Y_j = mu Y_{j-1} + nu Y_{j-2} + (1 - mu - nu) Y_0 + muTilde h F_{j-1} + gammaTilde h F_0.
/// The first stage is the case mu = 1, nu = 0, gammaTilde = 0.
struct StabilizedStage {
  double mu = 1.0, nu = 0.0, muTilde = 0.0, gammaTilde = 0.0;
  double c = 0.0;  ///< Y_j belongs to t + c h
};

enum class StabilizedFamily {
  Chebyshev,  ///< RKC2: B.P. Sommeijer, L.F. Shampine, J.G. Verwer, J. Comput. Appl. Math. 88 (1998) 315
  Legendre    ///< RKL2: C.D. Meyer, D.S. Balsara, T.D. Aslam, J. Comput. Phys. 257 (2014) 594
};

struct StabilizedScheme {
  std::vector<StabilizedStage> stages;
  double stability = 0.0;  ///< stable where h times the largest eigenvalue of -df/dy does not exceed this
};

/// Scheme of `nStages` >= 2 (Legendre: odd, >= 3, where the stability polynomial does not touch -1).
StabilizedScheme stabilizedScheme(StabilizedFamily family, int nStages);

/// The least number of stages that is stable for h times the largest eigenvalue = `stiffness`.
int requiredStages(StabilizedFamily family, double stiffness);

}  // namespace pd

#endif
