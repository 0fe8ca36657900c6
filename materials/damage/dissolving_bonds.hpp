// Mechanical bonds of a dissolving metal, which break as the metal at their ends goes.
#ifndef PD_DISSOLVING_BONDS_HPP
#define PD_DISSOLVING_BONDS_HPP

#include <cstdint>
#include <optional>
#include <vector>

#include "bond_damage_model.hpp"
#include "field_names.hpp"

namespace pd {

/// A bond breaks, for both ends and for good, when the metal at either end is gone, or before that at random: then each
/// end of a bond has a threshold of its own, drawn once (kernels/bond_thresholds.hpp), and the bond breaks as soon as
/// the expected damage d_c of either end exceeds its threshold.
///
/// The latter is the step-wise rule of Chen & Bobaru, J. Mech. Phys. Solids 78 (2015) 352, and Jafarzadeh, Zhao,
/// Shakouri & Bobaru, Electrochim. Acta 401 (2022) 139512, section 2.2.2, without its steps. There each end breaks each
/// of its bonds with probability (d_c' - d_c)/(1 - d_c) while d_c rises to d_c': a bond outlives that with probability
/// (1 - d_c')/(1 - d_c), hence any sequence of rises from 0 to d_c with probability 1 - d_c, which is that of a uniform
/// threshold above d_c. But what breaks no longer depends on how d_c came there: on steps, on repeated ones, on ranks.
class DissolvingBonds {
 public:
  /// At random it brings bonds, else it breaks those that others bring.
  struct Fields : BondDamageModel::Fields {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle loose;
    FieldHandle imageShift = readsIfThere(pd::fields::pointScalar(
        imageShiftField, "1", "Of images beyond planes of symmetry: how far ids are from what they mirror."));
    explicit Fields(bool isRandom) : BondDamageModel::Fields(isRandom) {
      if (isRandom)
        loose =
            writes(pd::fields::pointScalar("Loose", "1", "1 at solid points that have lost all their bonds.").state());
    }
  };

  /// Without a seed bonds do not break at random.
  explicit DissolvingBonds(std::optional<std::uint32_t> seed) : seed_(seed), fields_(seed.has_value()) {}
  const Fields& fields() const { return fields_; }
  void forget() const { caches_.clear(); }
  /// Damage was put back: all bonds are looked at again.
  void lookAtAllAgain() const;

  /// Brings Bond_Damage, which must be there and as at N or worse, Damage and Loose at NP1 up to date with `expected`:
  /// d_c by local id, ghosts included, 1 of liquid. Damage is the share of broken bonds, of solid points below 1; Loose
  /// is 1 where a solid point has none left.
  void update(const Call& call, const std::vector<double>& expected, PeridigmNS::DataManager& dataManager) const;

 private:
  /// The list that a cache is for, by its address.
  struct ListKey {
    const int* list = nullptr;
    int nOwned = 0;
    bool isFor(int n, const int*, const int* other) const { return n == nOwned && other == list; }
  };
  /// Notes that save work: which points have changed since their bonds were last looked at.
  struct Cache {
    ListKey neighborhood;
    std::vector<std::size_t> starts;       ///< [nOwned] of the neighbours in the list
    std::vector<int> position;             ///< by local id: which of the owned points; -1: none
    std::vector<std::vector<int>> around;  ///< by local id, of points that are not owned: positions of their neighbours
    std::vector<double> seenExpected, seenDamage;  ///< NaN: not yet
  };

  static Cache makeCache(const Call& call, std::size_t nPoints);
  /// Positions of owned points with a bond whose state may have changed.
  static std::vector<int> pointsToVisit(const Call& call, const std::vector<double>& expected, const double* damage,
                                        Cache& cache);
  /// Whether the bond from i to j breaks at d_c of these ends, `ids` global. `imageShift`: of j.
  bool breaks(int id, double own, int neighborId, double other, int imageShift) const;

  std::optional<std::uint32_t> seed_;
  Fields fields_;
  mutable NeighborhoodCache<Cache> caches_;
};

}  // namespace pd

#endif
