// The XDMF description of a run's field files, for ParaView and meshio.
#ifndef PD_XDMF_WRITER_HPP
#define PD_XDMF_WRITER_HPP

#include <string>
#include <vector>

namespace pd {

/// Name and values a point of a table in a step's file.
struct FieldShape {
  std::string name;
  int width = 1;
};

/// Builds the text of an XDMF file (version 3): a temporal collection of point clouds (Polyvertex) whose numbers lie
/// in HDF5 files beside it.
class XdmfWriter {
 public:
  /// `meshFile`: HDF5 file, relative to the XDMF file, with /coordinates [n x 3] and /connectivity [n].
  XdmfWriter(std::string meshFile, long long nPoints);

  /// `stepFile`: HDF5 file, relative to the XDMF file, with a table for each field.
  void addStep(double time, const std::string& stepFile, const std::vector<FieldShape>& fields);
  std::string text() const;

 private:
  std::string dataItem(const std::string& file, const std::string& table, int width, const std::string& type) const;
  std::string meshFile_;
  long long nPoints_;
  std::string steps_;
};

}  // namespace pd

#endif
