// Pressure on a face, in a hole, a bore or a cavity, or around a body.
#include <fmt/format.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_LAPACK.hpp>
#include <array>
#include <cmath>
#include <complex>
#include <numeric>

#include "../../deck/vector3.hpp"
#include "../load.hpp"

namespace pd {

namespace {

void add(Vector3& sum, double factor, const Vector3& a) {
  for (std::size_t d = 0; d < 3; ++d) sum[d] += factor * a[d];
}

/// Pressure p on a surface of `Area` A whose points, a layer behind it, have the unit normals n_i out of the body.
/// Point i stands for the share a_i = V_i / h of the area, where h = (sum of all V) / A is the mean depth of the layer,
/// and carries the force -p a_i n_i. The shares sum to A, so that p on a flat face gives p A. Around a Center normals
/// are radial. The steps of a lattice leave a part of a closed surface more points than another, which is worth a few
/// parts in a hundred of a share, but gives a resultant and bends a ring, which is soft that way. Shares of a closed
/// surface are therefore a_i (1 + sum_l c_l f_l(n_i)) such that their sums with all functions f_l, harmonics of low
/// degree but for f_0 = 1, are those of the whole circle or sphere: 0 but for A. Areas and normals are of the
/// undeformed body.
class Pressure : public Load {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  explicit Pressure(const ConditionSection& section);

  void measure(const Discretization& mesh, const Communicator& comm) override;
  std::string note() const override { return note_; }
  void addForceDensity(const Discretization& mesh, double t, double* forceDensity) const override;

 private:
  bool isAroundCenter() const { return static_cast<bool>(node()["Center"]); }
  Vector3 vectorOf(const ConditionSection& section, const std::string& key) const;
  Vector3 directionOf(const ConditionSection& section, const std::string& key) const;
  void requireFittingDirections(const Discretization& mesh) const;
  Vector3 radial(const Discretization& mesh, int point) const;
  std::vector<Vector3> normals(const Discretization& mesh, const Communicator& comm) const;
  std::vector<double> harmonics(const Vector3& n, const Discretization& mesh) const;
  std::vector<std::size_t> harmonicsByDegree(const Discretization& mesh) const;
  std::vector<double> correction(const std::vector<double>& products, std::size_t nAll, std::size_t n) const;
  double close(std::vector<double>& shares, const std::vector<Vector3>& normals, const Discretization& mesh,
               const Communicator& comm) const;

  double area_;                 ///< m2
  Vector3 normal_{};            ///< of a flat face
  Vector3 center_{}, axis_{};   ///< of a curved one; an axis of no length: a sphere, or a circle in the plane
  double outward_ = 1.0;        ///< normals point to the Center (-1) or away from it (1)
  bool isClosed_;               ///< it surrounds its Center
  std::vector<Vector3> loads_;  ///< [points()] of unit pressure, 1/m; those of owned points count
  std::string note_;
};

void Pressure::declareParameters(ParameterDeclarations& declare) {
  declareNodeSet(declare);
  declare.function("Value", "Pa", "Pressure; positive pushes into the body.").required();
  declare
      .real("Area", "m2",
            "Area of the loaded surface (of a round hole 2 pi radius thickness). The node set is a layer of points "
            "behind it; each carries a share of the area in proportion to its volume.")
      .positive()
      .required();
  declare.reals("Normal", "1", "Of a flat face: direction out of the body, [x, y, z].");
  declare.reals("Center", "m",
                "Of a curved surface: [x, y, z] of the middle of a round hole, of a point on the axis of a bore, or of "
                "the middle of a spherical cavity. Normals are radial.");
  declare.reals("Axis", "1", "Direction of a bore, [x, y, z]; without it a curved surface in 3D is a sphere.");
  declare.text("Side", "Where the pressure is: inside the curved surface (a hole), or outside of it, around the body.")
      .oneOf({"Inside", "Outside"})
      .defaultTo("Inside");
  declare
      .flag("Closed",
            "The curved surface surrounds its Center, so that constant pressure has no resultant; false for a part of "
            "one, such as a quarter of a hole.")
      .defaultTo(true);
  declare.exactlyOneOf({"Normal", "Center"});
  for (const char* key : {"Axis", "Side", "Closed"}) declare.needs(key, {"Center"});
}

Pressure::Pressure(const ConditionSection& section)
    : Load(section), area_(section.list.get<double>("Area")), isClosed_(section.list.get<bool>("Closed")) {
  if (!isAroundCenter()) {
    normal_ = directionOf(section, "Normal");
    return;
  }
  center_ = vectorOf(section, "Center");
  if (node()["Axis"]) axis_ = directionOf(section, "Axis");
  if (section.list.get<std::string>("Side") == "Inside") outward_ = -1.0;
}

Vector3 Pressure::vectorOf(const ConditionSection& section, const std::string& key) const {
  const auto given = section.list.get<Teuchos::Array<double>>(key);
  if (given.size() != 3)
    throw DeckError(node()[key].place() + ": " + node()[key].path() + " must be three numbers, [x, y, z]");
  return {given[0], given[1], given[2]};
}

/// Of unit length.
Vector3 Pressure::directionOf(const ConditionSection& section, const std::string& key) const {
  const Vector3 given = vectorOf(section, key);
  if (length(given) == 0.0) throw DeckError(node()[key].place() + ": " + node()[key].path() + " has no length");
  Vector3 unit{};
  add(unit, 1.0 / length(given), given);
  return unit;
}

void Pressure::requireFittingDirections(const Discretization& mesh) const {
  for (int d = mesh.dimension; d < 3; ++d)
    if (normal_[static_cast<std::size_t>(d)] != 0.0) requireMotionAlong(d, mesh);
  if (length(axis_) > 0.0 && mesh.dimension < 3 && !(mesh.dimension == 2 && std::abs(axis_[2]) == 1.0))
    throw DeckError(node()["Axis"].place() + ": " + node()["Axis"].path() +
                    " must be along z, across the plane of the points; leave it out");
}

/// From the Center, or its axis, to the point.
Vector3 Pressure::radial(const Discretization& mesh, int point) const {
  Vector3 result{};
  for (int d = 0; d < mesh.dimension; ++d)
    result[static_cast<std::size_t>(d)] = mesh.x[3 * static_cast<std::size_t>(point) + d] - center_[d];
  add(result, -dot(result, axis_), axis_);
  return result;
}

std::vector<Vector3> Pressure::normals(const Discretization& mesh, const Communicator& comm) const {
  if (!isAroundCenter()) return std::vector<Vector3>(points().size(), normal_);
  std::vector<Vector3> result(points().size());
  bool isUndefined = false;
  for (std::size_t k = 0; k < result.size(); ++k) {
    const Vector3 away = radial(mesh, points()[k]);
    if (length(away) == 0.0)
      isUndefined = true;
    else
      add(result[k], outward_ / length(away), away);
  }
  if (comm.any(isUndefined))
    throw DeckError(node()["Center"].place() + ": " + title() +
                    " has a point of its node set at the Center, where no normal is; a surface surrounds it");
  return result;
}

/// Harmonics of a normal, 1 first: to degree 4 on a circle (around a bore at any place along it), 2 on a sphere.
std::vector<double> Pressure::harmonics(const Vector3& n, const Discretization& mesh) const {
  if (mesh.dimension == 1) return {1.0, n[0]};
  const bool hasAxis = length(axis_) > 0.0;
  if (mesh.dimension == 3 && !hasAxis)
    return {1.0,
            n[0],
            n[1],
            n[2],
            n[0] * n[1],
            n[1] * n[2],
            n[2] * n[0],
            n[0] * n[0] - n[1] * n[1],
            3.0 * n[2] * n[2] - 1.0};
  // Two directions across the axis, the first one across a coordinate direction too.
  const Vector3 axis = hasAxis ? axis_ : Vector3{0.0, 0.0, 1.0};
  const Vector3 across = std::abs(axis[2]) < 0.9 ? Vector3{0.0, 0.0, 1.0} : Vector3{0.0, 1.0, 0.0};
  Vector3 first = cross(across, axis);
  const double scale = 1.0 / length(first);
  for (double& value : first) value *= scale;
  const std::complex<double> turn(dot(n, first), dot(n, cross(axis, first)));
  std::vector<double> result{1.0};
  std::complex<double> power = turn;
  for (int degree = 1; degree <= 4; ++degree, power *= turn) result.insert(result.end(), {power.real(), power.imag()});
  return result;
}

/// How many of them there are up to degree 1, 2 ...
std::vector<std::size_t> Pressure::harmonicsByDegree(const Discretization& mesh) const {
  if (mesh.dimension == 1) return {2};
  return mesh.dimension == 3 && length(axis_) == 0.0 ? std::vector<std::size_t>{4, 9}
                                                     : std::vector<std::size_t>{3, 5, 7, 9};
}

/// Coefficients c of the first `n` harmonics f, by which shares a (1 + c.f) sum to the area, and with the others to 0.
/// `products`: sums of a f f^T with all `nAll`. Empty where there are none.
std::vector<double> Pressure::correction(const std::vector<double>& products, std::size_t nAll, std::size_t n) const {
  std::vector<double> matrix(n * n), c(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) matrix[i * n + j] = products[i * nAll + j];
    c[i] = (i == 0 ? area_ : 0.0) - products[i];
  }
  std::vector<int> pivots(n);
  int info = 0;
  const int size = static_cast<int>(n);
  Teuchos::LAPACK<int, double>().GESV(size, 1, matrix.data(), size, pivots.data(), c.data(), size, &info);
  return info == 0 ? c : std::vector<double>();
}

/// Corrects the shares of a closed surface, by the highest degree for which that is a correction and no more (few
/// points cannot tell high degrees apart); returns by what part of itself a share changes at most.
double Pressure::close(std::vector<double>& shares, const std::vector<Vector3>& normals, const Discretization& mesh,
                       const Communicator& comm) const {
  const std::vector<std::size_t> nByDegree = harmonicsByDegree(mesh);
  const std::size_t nAll = nByDegree.back();
  std::vector<std::vector<double>> f;
  for (const Vector3& normal : normals) f.push_back(harmonics(normal, mesh));
  std::vector<double> own(nAll * nAll, 0.0), products(nAll * nAll);
  for (std::size_t k = 0; k < shares.size(); ++k)
    for (std::size_t i = 0; points()[k] < mesh.nOwned && i < own.size(); ++i)
      own[i] += shares[k] * f[k][i / nAll] * f[k][i % nAll];
  comm.SumAll(own.data(), products.data(), static_cast<int>(own.size()));

  double resultant = 0.0;
  for (std::size_t i = 1; i < nByDegree.front(); ++i) resultant = std::hypot(resultant, products[i] / area_);
  // A coarse hole, 3 points in radius, comes to 0.1; three quarters of one to 0.3.
  if (resultant > 0.2)
    throw DeckError(node().keyPlace() + ": " + title() +
                    fmt::format(": the normals of its points do not cancel: they sum to {:.2g} of the area; a node set "
                                "that is a part of a round surface needs \"Closed: false\", a whole one its Center in "
                                "the middle of the points",
                                resultant));
  for (auto n = nByDegree.rbegin(); n != nByDegree.rend(); ++n) {
    const std::vector<double> c = correction(products, nAll, *n);
    std::vector<double> changes(shares.size(), 1.0);
    for (std::size_t k = 0; !c.empty() && k < shares.size(); ++k)
      changes[k] = std::inner_product(c.begin(), c.end(), f[k].begin(), 0.0);
    double largest = 0.0;
    for (const double change : changes) largest = std::max(largest, std::abs(change));
    largest = comm.max(largest);
    if (largest > 0.5) continue;
    for (std::size_t k = 0; k < shares.size(); ++k) shares[k] *= 1.0 + changes[k];
    return largest;
  }
  throw DeckError(node().keyPlace() + ": " + title() +
                  " has too few points around its Center, or too uneven ones, for a closed surface; refine the mesh "
                  "there, or give a layer that is deeper");
}

void Pressure::measure(const Discretization& mesh, const Communicator& comm) {
  requireFittingDirections(mesh);
  const double volume = volumeOf(points(), mesh, comm), depth = volume / area_;
  const std::vector<Vector3> outward = normals(mesh, comm);
  std::vector<double> shares(points().size());
  for (std::size_t k = 0; k < shares.size(); ++k)
    shares[k] = mesh.volume[static_cast<std::size_t>(points()[k])] / depth;
  note_ = fmt::format("{}: pressure on {:.6g} m2 shared by {}, a layer {:.4g} m deep", title(), area_,
                      spread(volume, mesh, comm), depth);
  if (isAroundCenter() && isClosed_)
    note_ += fmt::format("; shares corrected by up to {:.2g} % for the steps of the mesh",
                         100.0 * close(shares, outward, mesh, comm));
  loads_.assign(points().size(), Vector3{});
  for (std::size_t k = 0; k < shares.size(); ++k)
    add(loads_[k], -shares[k] / mesh.volume[static_cast<std::size_t>(points()[k])], outward[k]);
}

void Pressure::addForceDensity(const Discretization& mesh, double t, double* forceDensity) const {
  const std::vector<double>& given = evaluate(mesh, t);
  for (std::size_t k = 0; k < given.size(); ++k)
    for (std::size_t d = 0; points()[k] < mesh.nOwned && d < 3; ++d)
      forceDensity[3 * static_cast<std::size_t>(points()[k]) + d] += given[k] * loads_[k][d];
}

}  // namespace

PD_REGISTER_CONDITION(Pressure, "Pressure", "Pressure on a flat face, in a hole, bore or cavity, or around a body")

}  // namespace pd
