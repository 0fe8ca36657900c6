// The error of a run against an exact solution that its deck names.
#ifndef PD_ERROR_NORMS_HPP
#define PD_ERROR_NORMS_HPP

#include <string>
#include <utility>
#include <vector>

#include "../deck/deck.hpp"
#include "../deck/function.hpp"
#include "model.hpp"

namespace pd {

/// Section `Exact Solution`: entries (a list, or a map of named entries)
///   {Field, Coordinate x|y|z (of a vector field), Value: function of x, y, z, t, Node Set (default: all points)}.
/// For each entry, over the owned points of all ranks and at time t, with u the field, e the exact value, V volumes:
///   "<name> relative L2 error"       sqrt(sum V (u - e)^2 / sum V e^2)
///   "<name> relative maximum error"  max|u - e| / max|e|
/// The errors are absolute, and named so, where e is 0 everywhere. Empty without the section. Collective.
class ErrorNorms {
 public:
  /// Throws DeckError where there is no such node set or field, and with all exact values that are not finite at the
  /// end of the run.
  ErrorNorms(const Deck& deck, Model& model);
  std::vector<std::pair<std::string, double>> evaluate(double t) const;

 private:
  struct Entry {
    std::string name, field;
    int component = 0, width = 1;
    std::vector<int> points;  ///< owned
    Function value = Function::constant(0.0);
  };
  Model& model_;
  std::vector<Entry> entries_;
};

}  // namespace pd

#endif
