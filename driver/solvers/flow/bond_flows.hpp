// What volume a flow moves along each bond.
#ifndef PD_BOND_FLOWS_HPP
#define PD_BOND_FLOWS_HPP

#include <vector>

#include "../../linear/sparse_rows.hpp"
#include "flow_geometry.hpp"

namespace pd {

/// Writes the bond fields Bond_Flow and Bond_Opening (flow_fields.hpp) of the velocities in the fields, for materials
/// that carry a scalar along.
///
/// Bonds within `reach` move volume: with v the mean velocity of both ends and e the direction of the bond,
///   U_ij = 2 d V_j/M v.e/|xi|,  M = sum_j V_j within reach, the mean of both ends,
/// whose sum over a whole neighbourhood is the divergence; of rings with their share, V and M of the plane. At a wall
/// or an inlet v is what it has along its normal, at an outflow that of the point. Then the sum of a point is not quite
/// zero, since the divergence of the solver is another one: a potential, zero beyond outflows, takes what is left, U_ij
/// - 2 d V_j/(M |xi|^2) (p_i - p_j), so that as much arrives at each point of the flow as leaves it, to rounding:
/// constant scalars stay constant. In a part that nothing can leave, what its walls and inlets let through too much is
/// taken out of their flows, each by the same share.
class BondFlows {
 public:
  BondFlows(Simulation& simulation, const FlowGeometry& geometry, double reach);

  /// At the solver's time t. Throws RunError, as where flows are not balanced. Collective.
  void update(double t);

  double largestImbalance() const { return largestImbalance_; }    ///< of what a point passes on, all ranks
  double largestCorrection() const { return largestCorrection_; }  ///< of the largest flow of a bond, all ranks

 private:
  struct Bond {
    int neighbor;
    bool isOpen;               ///< to a point of the flow or beyond an outflow
    double flow, conductance;  ///< 1/s, 1/m2
    std::size_t place;         ///< in the neighbourhood of the point
  };
  struct Row {
    int point;
    std::vector<Bond> bonds;
    std::vector<double> openings;  ///< of all bonds of the point
  };
  static std::size_t index(int point) { return static_cast<std::size_t>(point); }
  void findFamilyVolumes();
  Row rowOf(int point, double t) const;
  double ringShare(int point, int neighbor, const FlowGeometry::End& end) const;
  double flowOf(int point, const FlowGeometry::End& end, int neighbor, double t) const;
  void applyPotential(const double* x, double* y) const;
  double diagonal(std::size_t row, double sum) const;
  SparseRows potentialMatrix() const;
  /// Parts of the flow that no open bond connects.
  struct Part {
    bool isOpen = false;                            ///< it has an outflow
    double net = 0.0, passing = 0.0, volume = 0.0;  ///< m3/s out, m3/s through what is not open, m3: of all ranks
  };
  void findParts();
  void sumParts();
  void closeParts();
  void balance();
  void measure();
  void requireBalance(double t) const;
  void removeNetFlow(std::vector<double>& excess) const;
  void write() const;

  Simulation& simulation_;
  const FlowGeometry& geometry_;
  const double reach_;
  std::vector<double> familyVolume_;  ///< [points] within reach, of the plane, m3
  std::vector<Row> rows_;             ///< by owned point of the flow
  std::vector<Part> parts_;
  std::vector<std::size_t> partOf_;  ///< [rows_] index into parts_
  std::vector<char> isPinned_;       ///< [rows_] 1 where the potential of a part that nothing can leave is zero
  double largestImbalance_ = 0.0, largestCorrection_ = 0.0;
};

}  // namespace pd

#endif
