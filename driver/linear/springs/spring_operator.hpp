// Products with the stiffness of a spring network, without a matrix.
#ifndef PD_SPRING_OPERATOR_HPP
#define PD_SPRING_OPERATOR_HPP

#include <tuple>
#include <utility>
#include <vector>

#include "../../discretization/point_exchange.hpp"
#include "spring_network.hpp"

namespace pd {

/// The stiffness K of a network: K x is minus the forces that displacements x cause, in units of the network. Vectors
/// are over all local points; their owned values count.
class SpringOperator {
 public:
  /// Refers to both. `isDistributed`: some rank has ghosts or images. What families make of a rotation is not known
  /// before the first refresh(), of all points.
  SpringOperator(const SpringNetwork& network, const PointExchange& exchange, bool isDistributed);

  /// After the network's damage has changed, at these owned points alone.
  void refresh(const std::vector<int>& changed);
  /// Degrees of freedom [3 nOwned] that apply() leaves out, and what it adds to the diagonal at single ones.
  void hold(const std::vector<char>& isHeld);
  struct Addition {
    int point, component;
    double value;
    bool operator==(const Addition& other) const {
      return point == other.point && component == other.component && value == other.value;
    }
  };
  void setAdditions(std::vector<Addition> additions) { additions_ = std::move(additions); }

  const SpringNetwork& network() const { return network_; }
  bool isHeld(int point, int component) const { return isHeld_[static_cast<std::size_t>(3 * point + component)] != 0; }
  const std::vector<char>& held() const { return isHeld_; }  ///< [3 nOwned]
  const std::vector<Addition>& additions() const { return additions_; }
  bool isDistributed() const { return isDistributed_; }
  const PointExchange& exchange() const { return exchange_; }
  /// [1 or 6][nOwned] what the families make of their s (LinearSprings): a factor, or in three dimensions of a
  /// rotation the upper triangle of a matrix.
  template <class Real>
  const PointVector<Real>& response() const {
    return std::get<PointVector<Real>>(response_);
  }

  /// y = K x with whatever x is at held degrees of freedom. Writes x of ghosts and images. Collective.
  template <class Real>
  void applyToAll(PointVector<Real>& x, PointVector<Real>& y);
  /// y = (K + additions) x, zero at held degrees of freedom, where x must be zero. Collective.
  template <class Real>
  void apply(PointVector<Real>& x, PointVector<Real>& y);

  /// What the families made of their s in the last applyToAll() in this precision.
  template <class Real = double>
  const PointVector<Real>& responses() const {
    return std::get<PointVector<Real>>(families_);
  }
  /// Brings y = K x up to date where only bonds of the owned points `changed` have changed since it was found by
  /// applyToAll(), which left `responses` and x of ghosts and images; no spring may be a half. Both are written.
  /// Collective.
  void updateAll(const std::vector<int>& changed, const PointVector<double>& x, PointVector<double>& responses,
                 PointVector<double>& y);

  /// Gives ghosts and images what owned points have: x, and what their families made of their s. Collective.
  void bringToOthers(PointVector<double>& x, PointVector<double>& responses);

  /// The same for a smoother of what is short: there families hardly turn, and are taken not to, which saves a loop.
  void applyStiffly(PointVector<float>& x, PointVector<float>& y);

  template <class Real>
  void addAdditions(const PointVector<Real>& x, PointVector<Real>& y) const;
  template <class Real>
  void zeroHeld(PointVector<Real>& x) const;

 private:
  template <class Real>
  void importInto(PointVector<Real>& x) {
    import(x, 3, 0, Reflection::Vector);
  }
  template <class Real>
  void importResponses(PointVector<Real>& t);
  /// Components of x are those of the exchange, which has `width`, from `first` on.
  template <class Real>
  void import(PointVector<Real>& x, int width, int first, Reflection rule);
  template <class Real>
  void exportFrom(PointVector<Real>& y);

  void findSources();
  void findResponse(const std::vector<int>& changed);
  void updateResponses(const std::vector<int>& changed, const PointVector<double>& x, PointVector<double>& responses);
  std::vector<int> pointsThatFeel(const std::vector<int>& changed, const std::vector<char>& otherHasChanged) const;

  const SpringNetwork& network_;
  const PointExchange& exchange_;
  bool isDistributed_;
  std::vector<char> isHeld_;
  std::vector<std::pair<int, int>> held_;  ///< component, point
  std::vector<Addition> additions_;
  std::tuple<PointVector<double>, PointVector<float>> response_, families_;
  std::vector<double> exchanged_;  ///< [3 nPoints]
  std::vector<int> sources_;       ///< of ghosts and images: the owned points that an exchange is about
};

}  // namespace pd

#endif
