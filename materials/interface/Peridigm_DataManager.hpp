// Field storage of a block, with the access calls of Peridigm's DataManager.
// Inside a Peridigm tree Peridigm's own header of this name is found instead.
#ifndef PERIDIGM_DATAMANAGER_HPP
#define PERIDIGM_DATAMANAGER_HPP

#include <Teuchos_RCP.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include "Peridigm_Field.hpp"

namespace PeridigmNS {

/// Contiguous values of one field at one step: `dimension` values a point (or bond), point after point.
/// Point fields are over the overlap: owned points first, then ghosts.
class FieldVector {
 public:
  FieldVector(std::size_t length, double value) : storage(length + padding, value), size(length) {}

  int ExtractView(double** view) {
    *view = storage.data();
    return 0;
  }
  int PutScalar(double value) {
    std::fill(storage.begin(), storage.begin() + static_cast<std::ptrdiff_t>(size), value);
    return 0;
  }
  int MyLength() const { return static_cast<int>(size); }
  double& operator[](int i) { return storage[static_cast<std::size_t>(i)]; }
  const double& operator[](int i) const { return storage[static_cast<std::size_t>(i)]; }

 private:
  static constexpr std::size_t padding = 16;  ///< lets vector kernels read past the last point
  std::vector<double> storage;
  std::size_t size;
};

/// A numbering of points: what plug-ins use of Peridigm's Epetra_BlockMap.
class PointMap {
 public:
  explicit PointMap(std::vector<int> globalIds);
  int GID(int localId) const { return globalIds_[static_cast<std::size_t>(localId)]; }
  int LID(int globalId) const;
  int NumMyElements() const { return static_cast<int>(globalIds_.size()); }

 private:
  std::vector<int> globalIds_;
  std::vector<std::pair<int, int>> byGlobalId_;
};

/// The fields of a set of points at the steps N, NP1 and NONE. Several DataManagers (one a block) may share
/// their point fields; bond fields are always a block's own.
/// NP1 follows from N: updateState() alone makes NP1 to N.
class DataManager {
 public:
  DataManager() = default;

  /// Sizes and numbering. `numBonds`: length of the block's bond data.
  void setMaps(Teuchos::RCP<const PointMap> ownedPoints, Teuchos::RCP<const PointMap> overlapPoints, int numBonds);

  /// STEP_N and STEP_NP1 of these bond fields are one memory: for values that only ever grow, where all users of the
  /// block say that they may find the later value at N. Call it before allocateData().
  void shareSteps(const std::vector<int>& bondFieldIds) { sharedSteps_ = bondFieldIds; }

  /// Swaps STEP_N and STEP_NP1 of bond fields at the end of a step, as Peridigm does, and shares none: NP1 then starts
  /// as the state of the step before. Call it before allocateData().
  void swapBondSteps() { swapsBondSteps_ = true; }

  /// Allocates the fields that are not there yet, filled with zeros.
  void allocateData(const std::vector<int>& fieldIds);

  /// Makes this block use the point and global fields of another one.
  void sharePointData(const DataManager& other);

  /// Gives this block a vector of its own for a point field that others share. Materials zero Force_Density and the
  /// flux divergence before they add to them (as Peridigm's do), so a host with several blocks keeps those apart and
  /// adds them up itself.
  void allocatePrivateData(int fieldId);

  bool hasData(int fieldId, PeridigmField::Step step);

  /// Throws std::logic_error where the field was not allocated at this step.
  Teuchos::RCP<FieldVector> getData(int fieldId, PeridigmField::Step step);

  std::vector<int> getFieldIds();

  Teuchos::RCP<const PointMap> getOwnedScalarPointMap() { return ownedPoints_; }
  Teuchos::RCP<const PointMap> getOverlapScalarPointMap() { return overlapPoints_; }

  /// Ends a step: N becomes a copy of NP1, which stays as the first guess of the next step. Of point fields, only those
  /// that somebody has asked for at STEP_N are stored and copied.
  void updateState();
  /// The same for point fields alone, which blocks may share, and for bond fields alone, which are the block's own.
  void updatePointState();
  void updateBondState();
  /// A step that is not taken: NP1 becomes a copy of N, of bond fields whose steps are apart.
  void restoreBondState();
  /// The same of a point field; nothing where nobody has asked for it at STEP_N.
  void restorePointState(int fieldId);

  /// Bytes held in bond fields.
  std::size_t bondBytes() const;

 private:
  struct Slot {
    FieldSpec spec;
    Teuchos::RCP<FieldVector> none, n, np1;
  };
  using Slots = std::map<int, Slot>;

  const Slot* find(int fieldId) const;
  Slot makeSlot(int fieldId) const;

  Teuchos::RCP<const PointMap> ownedPoints_, overlapPoints_;
  int numBonds_ = 0;
  std::vector<int> sharedSteps_;  ///< ids of bond fields
  bool swapsBondSteps_ = false;
  std::shared_ptr<Slots> pointData_ = std::make_shared<Slots>();
  Slots ownData_;  ///< bond fields and private point fields
};

}  // namespace PeridigmNS

#endif
