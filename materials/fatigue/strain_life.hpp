// The strain-life relation of Coffin and Manson with a limit of strain, and the plastic strain beside a crack tip.
#ifndef PD_STRAIN_LIFE_HPP
#define PD_STRAIN_LIFE_HPP

namespace pd::kernels {

/// Which strain of a cycle the relation is of: half the range, with reversals 2 N, or the range, with cycles N.
enum class StrainMeasure { Amplitude, Range };

///   Amplitude   d_eps/2 - limit = ductility (2 N)^exponent
///   Range       d_eps - limit = ductility N^exponent
/// Coffin (1954) and Manson (1953) without a limit; that it is taken from the strain is derived, from what is known of
/// Liu, Bao & Sui, Chin. J. Aeronaut. 34(2) (2021): parameters, and that their law is of the form of Coffin and Manson.
struct StrainLife {
  StrainMeasure measure = StrainMeasure::Amplitude;
  double ductility = 1.0;  ///< eps_f'
  double exponent = -0.5;  ///< c < 0
  double limit = 0.0;      ///< of the measure

  /// m of 1/N = A (d_eps - limit)^m.
  double power() const { return -1.0 / exponent; }
  double limitOfRange() const { return measure == StrainMeasure::Amplitude ? 2.0 * limit : limit; }
  /// 1/N of a strain range; 0 up to the limit.
  double lossRate(double strainRange) const;
};

/// Strain range at a place that an elastic body would strain by `elasticRange`, in a material that flows at the stress
/// `yieldStrain` E without hardening, in cycles twice that: the rule of Neuber, d_sigma d_eps = E elasticRange^2
/// (J. Appl. Mech. 28 (1961) 544), of a place whose elastic stress is the mean over an element at the tip.
double neuberStrainRange(double elasticRange, double yieldStrain);

}  // namespace pd::kernels

#endif
