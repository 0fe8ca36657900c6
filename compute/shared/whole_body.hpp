// The whole of a body of which the mesh is one part, beside planes of symmetry.
#ifndef PD_WHOLE_BODY_HPP
#define PD_WHOLE_BODY_HPP

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>
#include <array>

namespace pd {

/// Copies of the part that make up the whole; copy 0 is the part. This one is of a body without planes of symmetry; a
/// host that has them derives from it and hands it to computes as "whole body", a Teuchos::RCP<const WholeBody> in the
/// global data, complete before they are initialised.
class WholeBody {
 public:
  virtual ~WholeBody() = default;
  virtual int nCopies() const { return 1; }
  /// Takes vectors of the part to those of a copy; row by row, symmetric, its own inverse.
  virtual std::array<double, 9> reflection(int /*copy*/) const { return {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}; }
  /// Of a point of the part at x, m.
  virtual std::array<double, 3> place(int /*copy*/, const double* x) const { return {x[0], x[1], x[2]}; }

  /// The global id of what `id` is in the part. Images have ids: point i of `nPoints` is c nPoints + i in copy c, and
  /// copy b of copy c is copy b ^ c.
  static int idInCopy(int copy, int id, int nPoints) { return ((id / nPoints) ^ copy) * nPoints + id % nPoints; }

  /// What the host has handed over; the part alone where that is nothing.
  static Teuchos::RCP<const WholeBody> of(const Teuchos::RCP<const Teuchos::ParameterList>& globalData) {
    constexpr const char* key = "whole body";
    if (globalData.is_null() || !globalData->isParameter(key)) return Teuchos::rcp(new WholeBody);
    return globalData->get<Teuchos::RCP<const WholeBody>>(key);
  }
};

}  // namespace pd

#endif
