// Constants of bonds in bar, plane and solid problems: where every formula of that kind lives.
#ifndef PD_BOND_CONSTANTS_HPP
#define PD_BOND_CONSTANTS_HPP

#include <functional>

namespace pd::kernels {

enum class Geometry { Bar, PlaneStress, PlaneStrain, Solid };

/// Dimension of the space that neighbourhoods fill: 1, 2 or 3.
int dimensionOf(Geometry geometry);

/// Geometry with its cross-section: area of a bar (m2), thickness of a plane problem (m), 1 for a solid.
struct Section {
  Geometry geometry = Geometry::Solid;
  double size = 1.0;
};

/// omega(|xi|, horizon).
using Influence = std::function<double(double, double)>;

/// Edge of the cell that a point stands for: V/A, sqrt(V/h), cbrt(V). Metres.
double spacingOf(double volume, const Section& section);

/// Volume of a whole neighbourhood: 2 A delta, pi h delta^2, 4/3 pi delta^3.
double horizonVolume(double horizon, const Section& section);

/// Which part of a neighbour's cell counts.
enum class VolumeCorrection {
  None,              ///< all of it up to the horizon
  EveryNeighbor,     ///< all of it, however far: the neighbourhoods say who is one
  RampToHorizon,     ///< linear from horizon - dx/2 on, nothing beyond the horizon (Madenci & Oterkus 2014)
  RampBeyondHorizon  ///< linear between horizon - dx/2 and horizon + dx/2 (Hu, Ha & Bobaru 2010)
};

/// Share in [0, 1] of a neighbour at `distance` whose cell has the edge `spacing`.
double volumeShare(VolumeCorrection rule, double distance, double horizon, double spacing);

/// Factor of the volume method of surface correction, 2 V0 / (V_i + V_j), from the family volumes of both ends.
double surfaceFactor(double wholeVolume, double familyVolume, double neighborFamilyVolume);

/// Sum of the neighbours' shares of volume on an ideal lattice: what horizonVolume() becomes for a whole neighbourhood.
double latticeFamilyVolume(const Section& section, double horizon, double spacing, VolumeCorrection rule);

/// Stiffness constants of the two-parameter bond model, N/m6. tangential = 0 is bond-based peridynamics.
struct ElasticConstants {
  double normal = 0.0;
  double tangential = 0.0;
};

/// C11 and C12 (Pa) of the bar, plane or solid problem.
struct Stiffness {
  double c11 = 0.0, c12 = 0.0;
};
Stiffness stiffness(Geometry geometry, double youngsModulus, double poissonsRatio);

/// From equal strain energy under uniform strain (reference: C11 and C12 of the plane or solid problem are exact):
///   bar          k_n = 2E/(A delta^2)
///   plane stress k_n = 6E/(pi h delta^3 (1-nu)),              k_t = k_n (1-3nu)/(1+nu)
///   plane strain k_n = 6E/(pi h delta^3 (1+nu)(1-2nu)),       k_t = k_n (1-4nu)
///   solid        k_n = 6E/(pi delta^4 (1-2nu)),               k_t = k_n (1-4nu)/(1+nu)
/// divided by the moment of the influence function relative to that of omega = 1.
ElasticConstants elasticConstants(const Section& section, double youngsModulus, double poissonsRatio, double horizon,
                                  const Influence& influence);

/// The same from the sums over an ideal square or cubic lattice of this spacing, so that bulk E and nu on that lattice
/// are exact. `isBondBased`: k_t = 0, and E alone is exact, since bond-based PD has one constant.
ElasticConstants latticeElasticConstants(const Section& section, double youngsModulus, double poissonsRatio,
                                         double horizon, double spacing, VolumeCorrection rule,
                                         const Influence& influence, bool isBondBased);

/// Critical stretch from the fracture energy G (J/m2): the work to break all bonds across a plane equals G.
///   bar sqrt(3G/(E delta)), plane sqrt(4G/(c h delta^4)), solid sqrt(10G/(pi c delta^5)), c = k_n above.
double criticalStretch(const Section& section, double youngsModulus, double poissonsRatio, double fractureEnergy,
                       double horizon, const Influence& influence);

/// The same for a point whose bonds have the constant k_n = `normal` and add up to sum g |xi|^2 V = `moment` (m5): the
/// mean over all directions of the plane. No moment: 0.
double criticalStretchOfPoint(const Section& section, double normal, double fractureEnergy, double moment);

enum class DiffusionKernel { InverseSquare, Inverse, Constant };  ///< of |xi|

/// Micro-diffusivity d of dC/dt = sum_j d kernel(|xi|) (C_j - C_i) V_j, such that linear fields' fluxes are exact:
///   1/xi^2: D/(A delta), 4D/(pi h delta^2), 9D/(2 pi delta^3);
///   1/xi:   2D/(A delta^2), 6D/(pi h delta^3), 6D/(pi delta^4);
///   1:      3D/(A delta^3), 8D/(pi h delta^4), 15D/(2 pi delta^5).
double microDiffusivity(const Section& section, DiffusionKernel kernel, double diffusivity, double horizon);

/// The same from sums over an ideal lattice.
double latticeMicroDiffusivity(const Section& section, DiffusionKernel kernel, double diffusivity, double horizon,
                               double spacing, VolumeCorrection rule);

/// Constant c of a flux c q/|xi| (mol/(m6 s)) over the bonds between two phases, such that a plane between them passes
/// the flux q: 1/(A delta), 1/(h delta^2), 3/(pi delta^3). (In solids the kernel of Jafarzadeh, Wang, Gobbert & Bobaru,
/// PeriFast/Corrosion, 2023.)
double interfaceFluxConstant(const Section& section, double horizon);

/// kernel(|xi|) of a diffusion bond.
double kernelValue(DiffusionKernel kernel, double distance);

}  // namespace pd::kernels

#endif
