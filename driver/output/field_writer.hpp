// Fields of points at chosen steps, written by all ranks together.
//
// Files of a run with Output Filename "plate":
//   plate.steps/mesh.h5     coordinates [n x 3] (reference, m), block_id [n], volume [n] (m3), connectivity [n]
//   plate.steps/000123.h5   the fields of step 123: Damage [n], Displacement [n x 3], ...; attributes time and step,
//                           and of each field units ("m", "J/m3"; "1" of a pure number), unless only the deck knows
//   plate.h5                links to these: /mesh/coordinates, /steps/000123/Damage, /steps/000123 with its time, ...
//   plate.xdmf              the same for ParaView and meshio
// In Python: h5py.File("plate.h5")["steps/000123/Damage"][:]. Copy plate.steps along with plate.h5 or plate.xdmf.
//
// Rows are in the order of global ids (the lines of the mesh file), so the files do not depend on the number of ranks.
//
// HDF5 keeps its own tables of contents inside a file, and a process killed while a file grows can lose all of it.
// So no file is ever changed after it is complete: each is written under another name and renamed when it is whole,
// first the step, then plate.h5, then plate.xdmf. A killed run leaves every step that these list readable.
#ifndef PD_FIELD_WRITER_HPP
#define PD_FIELD_WRITER_HPP

#include <memory>
#include <string>
#include <vector>

#include "../parallel/communicator.hpp"
#include "global_order.hpp"
#include "step_index.hpp"
#include "xdmf_writer.hpp"

namespace pd {

/// Values of owned points, [width x owned], point after point.
struct PointField {
  std::string name;
  int width = 1;
  const double* values = nullptr;
  std::string unit;  ///< empty where only the deck knows
};

/// Every call is collective and throws RunError on all ranks.
class FieldWriter {
 public:
  /// `baseName`: path of the files without their endings. Steps from `firstStep` on that an earlier run has left are
  /// removed, those before it stay part of the series: 0 starts afresh, a restart goes on.
  /// Coordinates [3 x owned], blockIds [owned], volumes [owned].
  FieldWriter(const std::string& baseName, const GlobalOrder& order, const double* coordinates, const int* blockIds,
              const double* volumes, int firstStep);

  void write(int step, double time, const std::vector<PointField>& fields);

 private:
  void writeMesh(const double* coordinates, const int* blockIds, const double* volumes);
  void takeOverSteps(int firstStep);
  void writeIndices();

  std::string baseName_, folder_;
  const GlobalOrder& order_;
  // Of the root rank alone.
  std::unique_ptr<StepIndex> index_;
  std::unique_ptr<XdmfWriter> xdmf_;
};

}  // namespace pd

#endif
