// A body of a few points with its blocks, made by hand: what tests of plug-ins run on in place of a driver.
#ifndef PD_TESTS_SMALL_BODY_HPP
#define PD_TESTS_SMALL_BODY_HPP

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>
#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "Peridigm_Compute.hpp"
#include "Peridigm_Discretization.hpp"

namespace pdtest {

using Point = std::array<double, 3>;

/// One rank alone.
class SerialComm : public PeridigmNS::Communicator {
 public:
  int MyPID() const override { return 0; }
  int NumProc() const override { return 1; }
  int SumAll(double* partial, double* global, int count) const override { return copy(partial, global, count); }
  int SumAll(int* partial, int* global, int count) const override { return copy(partial, global, count); }
  int MaxAll(double* partial, double* global, int count) const override { return copy(partial, global, count); }
  int MaxAll(int* partial, int* global, int count) const override { return copy(partial, global, count); }
  int MinAll(double* partial, double* global, int count) const override { return copy(partial, global, count); }
  int MinAll(int* partial, int* global, int count) const override { return copy(partial, global, count); }

 private:
  template <class T>
  static int copy(const T* partial, T* global, int count) {
    std::copy(partial, partial + count, global);
    return 0;
  }
};

/// Points of a lattice, x fastest; the first is at `origin`.
std::vector<Point> lattice(int nx, int ny, int nz, double spacing, Point origin = {0.0, 0.0, 0.0});

/// How N and NP1 of Bond_Damage are kept: in one memory, apart and copied at the end of a step as in pdrun of fields
/// that are not known to grow only, or swapped as in Peridigm.
enum class BondSteps { Shared, Copied, Swapped };

struct BodyOptions {
  double horizon = 1.0;         ///< longest bond (relative tolerance 1e-10)
  std::vector<double> volumes;  ///< one a point; empty: 1
  std::function<int(int globalId)> blockOf = [](int) { return 1; };
  std::function<bool(int globalId)> isOwned = [](int) { return true; };  ///< the rest are ghosts
  bool isBare = false;  ///< without any field until allocate() is called
  BondSteps bondSteps = BondSteps::Shared;
};

/// Blocks share their point fields, as in the driver. Local numbering: owned points in the order of their global ids,
/// then ghosts. Volume, Model_Coordinates and Coordinates (undeformed) are filled when they are allocated, which the
/// constructor does unless the body is to be bare.
class SmallBody {
 public:
  SmallBody(const std::vector<Point>& points, BodyOptions options);
  SmallBody(const SmallBody&) = delete;
  SmallBody& operator=(const SmallBody&) = delete;

  Teuchos::RCP<std::vector<PeridigmNS::Block>> blocks() { return blocks_; }
  PeridigmNS::Block& block(std::size_t b = 0) { return (*blocks_)[b]; }
  int nOwned() const { return nOwned_; }
  int nPoints() const { return static_cast<int>(globalIds_.size()); }
  int globalId(int localId) const { return globalIds_[static_cast<std::size_t>(localId)]; }
  const Point& point(int localId) const { return points_[static_cast<std::size_t>(globalId(localId))]; }

  /// Allocates what is not there yet, in all blocks.
  void allocate(const std::vector<int>& fieldIds);
  bool hasField(const std::string& label);
  /// Values of a field as the block sees it, at STEP_NP1, or STEP_NONE where it has no steps.
  double* field(const std::string& label, std::size_t block = 0);
  double value(const std::string& label, int component = 0) { return field(label)[component]; }

  /// Coordinates = map(point), Displacement too, where they are allocated; ghosts included.
  void deform(const std::function<Point(const Point&)>& map);
  /// Sets Bond_Damage to 1, at both steps, for bonds (of all blocks) that the predicate picks.
  void breakBonds(const std::function<bool(const Point& from, const Point& to)>& isBroken);

  void addNodeSet(const std::string& name, const std::vector<int>& globalIds) { (*nodeSets_)[name] = globalIds; }
  Teuchos::RCP<const Teuchos::ParameterList> globalData() const { return globalData_; }

 private:
  std::vector<Point> points_;
  std::vector<double> volumes_;
  std::vector<int> globalIds_;
  int nOwned_ = 0;
  Teuchos::RCP<std::vector<PeridigmNS::Block>> blocks_;
  Teuchos::RCP<PeridigmNS::Discretization::NodeSets> nodeSets_;
  Teuchos::RCP<PeridigmNS::Discretization> discretization_;
  Teuchos::RCP<Teuchos::ParameterList> globalData_;
};

/// Creates a registered compute, allocates its fields and initialises it.
Teuchos::RCP<PeridigmNS::Compute> makeCompute(SmallBody& body, const std::string& name,
                                              const Teuchos::ParameterList& parameters = Teuchos::ParameterList(),
                                              Teuchos::RCP<const Epetra_Comm> comm = Teuchos::rcp(new SerialComm));

}  // namespace pdtest

#endif
