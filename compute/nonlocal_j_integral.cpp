// Nonlocal_J_Integral: energy release rate of a crack in a plane body, J/m2, as an integral over a rectangle around the
// tip, of the bonds themselves.
//
// Peridynamics' own form (Hu, Ha, Bobaru and Silling, Int. J. Fract. 176 (2012) 195): with the inside R of a contour,
//   J h = contour integral of W n_d - sum over bonds from i in R to j outside of 1/2 f_ij.(u_i,d + u_j,d),
// d the direction of growth, W the energy density, f_ij the force that j exerts on i, h the thickness. It needs no
// stress and no elastic constants of the continuum, and holds in a lattice as it does in an isotropic body. The sides
// of the rectangle are as wide as two spacings: with q, which falls from 1 inside to 0 outside across them,
//   J h = - sum of W V q_,d - sum over bonds of 1/2 f_ij.(u_i,d + u_j,d) (q_i - q_j),
// so that J does not jump as the tip moves. Energies and forces are those of small displacements. The crack must leave
// the rectangle through its side behind the tip, and be free of traction.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

#include "families.hpp"
#include "partial_reader.hpp"
#include "plugins.hpp"
#include "rectangle_cover.hpp"
#include "run_notes.hpp"
#include "spring_state.hpp"
#include "tip_place.hpp"
#include "whole_body.hpp"

namespace pd {

namespace {

/// Of a place, m: how far ahead of the tip it is, and how far above.
std::array<double, 2> fromTip(const double* x, const TipPlace::Tip& tip) {
  const double along[2] = {x[0] - tip.place[0], x[1] - tip.place[1]};
  return {along[0] * tip.direction[0] + along[1] * tip.direction[1],
          along[1] * tip.direction[0] - along[0] * tip.direction[1]};
}

const char* const nonlocalJName = "Nonlocal_J_Integral";

/// A step from 1 to 0 about 0 that is one spacing wide either way; `slope`: its derivative.
double softStep(double t, double& slope) {
  slope = -std::max(0.0, 1.0 - std::abs(t));
  if (t <= -1.0) return 1.0;
  if (t >= 1.0) return 0.0;
  return t < 0.0 ? 1.0 - 0.5 * (1.0 + t) * (1.0 + t) : 0.5 * (1.0 - t) * (1.0 - t);
}

}  // namespace

class NonlocalJIntegral : public TabledCompute, public RunNotes, public PartialReader {
 public:
  struct Fields : TipFields {
    SpringState::Fields springs;
    FieldHandle energyReleaseRate;
    explicit Fields(const Teuchos::ParameterList& parameters) : TipFields(parameters) {
      include(springs);
      energyReleaseRate = writes(outputField(parameters, pd::fields::globalScalar, "J/m2", "Energy release rate."));
    }
  };
  static void declareParameters(ParameterDeclarations& declarations);
  NonlocalJIntegral(ComputeParameters params, ComputeComm comm, ComputeParameters globalData);

  const Fields& fields() const override { return fields_; }
  void initialize(Blocks blocks) override;
  int compute(Blocks blocks) const override;
  std::vector<std::string> runNotes() const override;
  void markRead(const Blocks& blocks, std::vector<char>& isRead) const override;

 private:
  struct Inside {
    double share = 0.0, slope = 0.0;  ///< q; 1/m, its derivative along d
  };
  using Slopes = std::vector<Vector3>;  ///< [points of a block] u_,d; no number where it is not known
  /// The points of a block, and owned ones of them that count.
  struct Sides {
    std::vector<Inside> inside;   ///< [points]
    std::vector<Family> beside;   ///< with a bond whose ends are not equally far inside
    std::vector<Family> between;  ///< the same, and where q falls along d
  };
  /// Of a block: what the rectangle and what is beside it may be about, while the tip is near a place.
  struct Surroundings {
    Vector3 centre{};
    std::vector<int> points;            ///< local ids, rising
    std::vector<std::size_t> families;  ///< of the owned ones
  };
  const Surroundings& around(const Blocks& blocks, std::size_t b, const TipPlace::Tip& tip) const;
  Inside insideOf(const double* x, double volume, const TipPlace::Tip& tip) const;
  /// m, from the sides of the rectangle: less than 0 inside.
  double beyondSides(const double* x, const TipPlace::Tip& tip) const;
  /// Whether q may be another at the point or at one of its neighbours than where the rectangle's inside or outside is.
  bool isNearASide(const double* x, const TipPlace::Tip& tip) const;
  Sides sidesIn(const Blocks& blocks, std::size_t b, const TipPlace::Tip& tip) const;
  std::vector<Slopes> slopesBeside(const Blocks& blocks, const std::vector<Sides>& sides,
                                   const TipPlace::Tip& tip) const;
  /// Notes where the body does not fill the rectangle, the first time. Collective.
  void watchCover(const Blocks& blocks, const TipPlace::Tip& tip) const;
  double sumOver(PeridigmNS::Block& block, const LinearSprings& springs, const Sides& sides,
                 const Slopes& slopes) const;

  DeformationGradients gradients_;
  Fields fields_;
  TipPlace place_;
  double ahead_, behind_, above_, below_;                    ///< m
  double longestBond_ = 0.0;                                 ///< m
  std::vector<Families> families_;                           ///< [blocks]
  mutable std::vector<std::optional<Surroundings>> around_;  ///< [blocks] once they have been asked for
  mutable std::vector<LinearSprings> springs_;               ///< [blocks] once they have been asked for
  mutable std::optional<Vector3> watched_;                   ///< the tip for which the cover was looked at last
  mutable std::string gap_;                                  ///< what there is to note
};

void NonlocalJIntegral::declareParameters(ParameterDeclarations& declarations) {
  TipPlace::declareParameters(declarations, nonlocalJName);
  declarations.real("Ahead", "m", "From the tip to the side of the rectangle that the crack grows to.")
      .positive()
      .required();
  declarations.real("Behind", "m", "From the tip to the side that the crack comes through.").positive().required();
  declarations.real("Above", "m", "From the tip to the side on the left of the direction of growth.")
      .positive()
      .required();
  declarations.real("Below", "m", "From the tip to the side on the right; as Above where it is not given.").positive();
}

NonlocalJIntegral::NonlocalJIntegral(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
    : TabledCompute(completeParameters<NonlocalJIntegral>(params, nonlocalJName), params, comm, globalData),
      fields_(parameters_),
      place_(parameters_, nonlocalJName),
      ahead_(parameters_.get<double>("Ahead")),
      behind_(parameters_.get<double>("Behind")),
      above_(parameters_.get<double>("Above")),
      below_(parameters_.isParameter("Below") ? parameters_.get<double>("Below") : above_) {
  if (WholeBody::of(globalData)->nCopies() > 1)
    throw std::invalid_argument(std::string(nonlocalJName) +
                                ": a rectangle does not go through planes of symmetry; use J_Integral");
}

void NonlocalJIntegral::initialize(Blocks blocks) {
  place_.requireTip(blocks->front(), fields_.tip);
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest, longest = 0.0;
  for (PeridigmNS::Block& block : *blocks) {
    SpringState::require(block, nonlocalJName);
    const double* x = view(block, fields_.modelCoordinates);
    const auto points = block.getNeighborhoodData();
    const int* list = points->NeighborhoodList();
    for (int p = 0; p < points->NumOwnedPoints(); ++p) {
      const double* own = x + 3 * points->OwnedIDs()[p];
      lowest = std::min(lowest, own[2]);
      highest = std::max(highest, own[2]);
      for (int n = *list++; n > 0; --n, ++list)
        longest = std::max(longest, std::hypot(x[3 * *list] - own[0], x[3 * *list + 1] - own[1]));
    }
  }
  longest = longestBond_ = maxOverRanks(*epetraComm, longest);
  springs_.clear();
  around_.clear();
  families_ = Families::of(*blocks);
  if (std::min({ahead_, behind_, above_, below_}) < longest)
    throw std::invalid_argument(
        std::string(nonlocalJName) +
        ": \"Ahead\", \"Behind\", \"Above\" and \"Below\" must be no less than the longest bond, " +
        std::to_string(longest) + " m: bonds around the tip must end within the rectangle");
  if (maxOverRanks(*epetraComm, highest) > minOverRanks(*epetraComm, lowest))
    throw std::invalid_argument(std::string(nonlocalJName) + ": the body is no plane one; use J_Integral");
}

NonlocalJIntegral::Inside NonlocalJIntegral::insideOf(const double* x, double volume, const TipPlace::Tip& tip) const {
  const double spacing = std::sqrt(volume / place_.thickness());
  const auto [a, b] = fromTip(x, tip);
  double atFront = 0.0, atBack = 0.0, unused = 0.0;
  const double front = softStep((a - ahead_) / spacing, atFront), back = softStep(-(a + behind_) / spacing, atBack);
  const double high = softStep((b - above_) / spacing, unused) * softStep(-(b + below_) / spacing, unused);
  return {front * back * high, (atFront * back - front * atBack) * high / spacing};
}

double NonlocalJIntegral::beyondSides(const double* x, const TipPlace::Tip& tip) const {
  const auto [a, b] = fromTip(x, tip);
  return std::max(std::max(a - ahead_, -a - behind_), std::max(b - above_, -b - below_));
}

bool NonlocalJIntegral::isNearASide(const double* x, const TipPlace::Tip& tip) const {
  return std::abs(beyondSides(x, tip)) <= 2.0 * longestBond_;  // of a bond, and of a spacing, which is shorter
}

/// Few of many points: they are sought anew once the tip has moved by some bonds.
const NonlocalJIntegral::Surroundings& NonlocalJIntegral::around(const Blocks& blocks, std::size_t b,
                                                                 const TipPlace::Tip& tip) const {
  const double margin = 4.0 * longestBond_;
  const auto squaredDistance = [](const double* x, const Vector3& place) {
    return (x[0] - place[0]) * (x[0] - place[0]) + (x[1] - place[1]) * (x[1] - place[1]);
  };
  around_.resize(blocks->size());
  if (around_[b] && squaredDistance(tip.place.data(), around_[b]->centre) < margin * margin) return *around_[b];
  PeridigmNS::Block& block = (*blocks)[b];
  const double* x = view(block, fields_.modelCoordinates);
  // Three bonds: two to either side of the sides, and a spacing.
  const double reach = std::hypot(std::max(ahead_, behind_), std::max(above_, below_)) + 3.0 * longestBond_ + margin;
  const auto isAround = [&](int i) { return squaredDistance(x + 3 * i, tip.place) <= reach * reach; };
  Surroundings found{tip.place, {}, {}};
  for (int i = 0; i < fields_.volume.length(*block.getDataManager()); ++i)
    if (isAround(i)) found.points.push_back(i);
  for (std::size_t p = 0; p < families_[b].size(); ++p)
    if (isAround(families_[b].id(p))) found.families.push_back(p);
  return around_[b].emplace(std::move(found));
}

/// The points beside the sides, and their neighbours.
void NonlocalJIntegral::markRead(const Blocks& blocks, std::vector<char>& isRead) const {
  const TipPlace::Tip tip = place_.tip(blocks->front(), fields_);
  for (std::size_t b = 0; b < blocks->size(); ++b) {
    const double *x = view((*blocks)[b], fields_.modelCoordinates), *volume = view((*blocks)[b], fields_.volume);
    for (const int i : around(blocks, b, tip).points) {
      const double spacing = std::sqrt(volume[i] / place_.thickness());
      if (std::abs(beyondSides(x + 3 * i, tip)) <= 2.0 * longestBond_ + spacing)
        isRead[static_cast<std::size_t>(i)] = 1;
    }
  }
}

NonlocalJIntegral::Sides NonlocalJIntegral::sidesIn(const Blocks& blocks, std::size_t b,
                                                    const TipPlace::Tip& tip) const {
  PeridigmNS::Block& block = (*blocks)[b];
  const double *x = view(block, fields_.modelCoordinates), *volume = view(block, fields_.volume);
  const Surroundings& near = around(blocks, b, tip);
  Sides sides;
  sides.inside.resize(static_cast<std::size_t>(fields_.volume.length(*block.getDataManager())));
  for (const int i : near.points)
    sides.inside[static_cast<std::size_t>(i)] = isNearASide(x + 3 * i, tip)
                                                    ? insideOf(x + 3 * i, volume[i], tip)
                                                    : Inside{beyondSides(x + 3 * i, tip) < 0.0 ? 1.0 : 0.0, 0.0};
  for (const std::size_t p : near.families) {
    const int i = families_[b].id(p);
    const Inside& own = sides.inside[static_cast<std::size_t>(i)];
    if (!isNearASide(x + 3 * i, tip)) continue;
    const Family family = families_[b][p];
    const auto differs = [&](int j) { return sides.inside[static_cast<std::size_t>(j)].share != own.share; };
    const bool isBeside = std::any_of(family.neighbors, family.neighbors + family.n, differs);
    if (isBeside) sides.beside.push_back(family);
    if (isBeside || own.slope != 0.0) sides.between.push_back(family);
  }
  return sides;
}

/// Of points of all ranks that are beside the sides.
std::vector<NonlocalJIntegral::Slopes> NonlocalJIntegral::slopesBeside(const Blocks& blocks,
                                                                       const std::vector<Sides>& sides,
                                                                       const TipPlace::Tip& tip) const {
  std::vector<double> found;  // id, slope
  for (std::size_t b = 0; b < sides.size(); ++b) {
    PeridigmNS::Block& block = (*blocks)[b];
    const std::vector<Tensor> gradients = gradients_.of(block, TipPlace::leastIntact, sides[b].beside);
    const auto map = block.getOverlapScalarPointMap();
    for (std::size_t p = 0; p < gradients.size(); ++p) {
      found.push_back(map->GID(sides[b].beside[p].id));
      for (std::size_t k = 0; k < 3; ++k) {
        double slope = 0.0;
        for (std::size_t d = 0; d < 3; ++d)
          slope += (gradients[p][3 * k + d] - (k == d ? 1.0 : 0.0)) * tip.direction[d];
        found.push_back(slope);
      }
    }
  }
  const std::vector<double> all = gatherFromRanks(*epetraComm, found);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<Slopes> slopes;
  for (std::size_t b = 0; b < sides.size(); ++b) {
    const auto map = (*blocks)[b].getOverlapScalarPointMap();
    slopes.emplace_back(sides[b].inside.size(), Vector3{none, none, none});
    for (std::size_t at = 0; at < all.size(); at += 4)
      if (const int i = map->LID(static_cast<int>(all[at])); i >= 0)
        slopes[b][static_cast<std::size_t>(i)] = {all[at + 1], all[at + 2], all[at + 3]};
  }
  return slopes;
}

/// J h of this rank's points of a block.
double NonlocalJIntegral::sumOver(PeridigmNS::Block& block, const LinearSprings& springs, const Sides& sides,
                                  const Slopes& slopes) const {
  const SpringState state(block, fields_.springs, springs, sides.between);
  double sum = 0.0;
  std::size_t point = 0, bond = 0;
  for (const Family& family : sides.between) {
    const auto i = static_cast<std::size_t>(family.id);
    const Inside& inside = sides.inside[i];
    sum -= state.energy[point++] * inside.slope;
    for (int k = 0; k < family.n; ++k, ++bond) {
      const auto j = static_cast<std::size_t>(family.neighbors[k]);
      const double difference = inside.share - sides.inside[j].share;
      if (difference == 0.0) continue;
      const Vector3 &own = slopes[i], &other = slopes[j];
      const Vector3 both{own[0] + other[0], own[1] + other[1], own[2] + other[2]};
      sum -= 0.5 * difference * dot(both, state.force[bond].data());
    }
  }
  return sum;
}

void NonlocalJIntegral::watchCover(const Blocks& blocks, const TipPlace::Tip& tip) const {
  if (!gap_.empty() || watched_ == tip.place) return;
  watched_ = tip.place;
  RectangleCover cover(ahead_, behind_, above_, below_, longestBond_);
  for (std::size_t b = 0; b < blocks->size(); ++b) {
    const double *x = view((*blocks)[b], fields_.modelCoordinates), *volume = view((*blocks)[b], fields_.volume);
    for (const std::size_t p : around(blocks, b, tip).families) {
      const int i = families_[b].id(p);
      const auto [a, b] = fromTip(x + 3 * i, tip);
      cover.add(a, b, volume[i] / place_.thickness());
    }
  }
  const auto gap = cover.gap(*epetraComm);
  if (!gap) return;
  const auto [a, b] = *gap;
  const double x = tip.place[0] + a * tip.direction[0] - b * tip.direction[1];
  const double y = tip.place[1] + a * tip.direction[1] + b * tip.direction[0];
  std::ostringstream text;
  text << parameters_.get<std::string>("Output Label") << ": with the tip at (" << tip.place[0] << ", " << tip.place[1]
       << ") m the body does not fill the rectangle, as around (" << x << ", " << y
       << ") m: across an end of the body, or over a hole, this is not the energy release rate; make the rectangle "
          "smaller";
  gap_ = text.str();
}

std::vector<std::string> NonlocalJIntegral::runNotes() const {
  return gap_.empty() ? std::vector<std::string>() : std::vector<std::string>{gap_};
}

int NonlocalJIntegral::compute(Blocks blocks) const {
  const TipPlace::Tip tip = place_.tip(blocks->front(), fields_);
  watchCover(blocks, tip);
  std::vector<Sides> sides;
  for (std::size_t b = 0; b < blocks->size(); ++b) {
    if (springs_.size() < blocks->size()) springs_.push_back(SpringState::springsOf((*blocks)[b]));
    sides.push_back(sidesIn(blocks, b, tip));
  }
  const std::vector<Slopes> slopes = slopesBeside(blocks, sides, tip);
  double sum = 0.0;
  for (std::size_t b = 0; b < sides.size(); ++b) sum += sumOver((*blocks)[b], springs_[b], sides[b], slopes[b]);
  setGlobal(blocks, fields_.energyReleaseRate, sumOverRanks(*epetraComm, sum) / place_.thickness());
  return 0;
}

}  // namespace pd

using pd::NonlocalJIntegral;
PD_REGISTER_COMPUTE(NonlocalJIntegral, "Nonlocal_J_Integral",
                    "Energy release rate of a crack in a plane body, over a rectangle around its tip, of its bonds.")
