// Bare loops that show what a machine can do: rates of the plug-ins are compared with theirs. No code of the project.
#ifndef PD_YARDSTICK_HPP
#define PD_YARDSTICK_HPP

#include <array>
#include <cstddef>
#include <vector>

namespace pd_benchmark {

/// A cube of n^3 points a metre apart, each displaced at random by up to a thousandth of that. Bonds reach over 3.015
/// spacings and carry the bond-based force of a micromodulus of 1: V_j (l - l0) / l0 along the bond, a point's cell
/// whole (S. A. Silling, E. Askari, Computers & Structures 83 (2005) 1526-1535, eq. 12).
class BareBody {
 public:
  explicit BareBody(int n);

  /// Directed bonds.
  double nBonds() const { return static_cast<double>(list_.size()) - static_cast<double>(nPoints()); }
  std::size_t nPoints() const { return volume_.size(); }
  const std::vector<double>& reference() const { return reference_; }  ///< [3 nPoints] xyz of each point
  const std::vector<double>& current() const { return current_; }      ///< [3 nPoints]

  /// The force as anybody would write it: a list of neighbours, two square roots a bond.
  void forceByList();
  const std::vector<double>& listForce() const { return listForce_; }  ///< [3 nPoints]

  /// The same force without a list: neighbours sit at fixed offsets, so that a row of points goes through the vector
  /// unit side by side and the lengths of undeformed bonds are known.
  void forceByOffsets();
  const std::array<std::vector<double>, 3>& latticeForce() const { return latticeForce_; }  ///< x, y, z of all points

 private:
  struct Offset {
    int i, j, k;
  };
  void makeList();
  void addForceOfRow(int j, int k, const Offset& offset);
  std::size_t number(int i, int j, int k) const;

  int n_;
  std::vector<Offset> offsets_;
  std::vector<int> list_;  ///< number of neighbours, then these, for each point
  std::vector<double> reference_, current_, volume_, listForce_;
  std::array<std::vector<double>, 3> row_, latticeForce_;  ///< current coordinates and forces, an array a component
};

/// a = b + 3 c, as in STREAM (J. D. McCalpin, 1995): 24 bytes an element, without those that a cache reads to write.
void triad(std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& c);

}  // namespace pd_benchmark

#endif
