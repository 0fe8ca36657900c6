#include "xdmf_writer.hpp"

#include <fmt/format.h>

#include <utility>

namespace pd {

namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

const char* attributeType(int width) {
  switch (width) {
    case 1:
      return "Scalar";
    case 3:
      return "Vector";
    case 6:
      return "Tensor6";
    case 9:
      return "Tensor";
    default:
      return "Matrix";
  }
}

}  // namespace

XdmfWriter::XdmfWriter(std::string meshFile, long long nPoints) : meshFile_(std::move(meshFile)), nPoints_(nPoints) {}

std::string XdmfWriter::dataItem(const std::string& file, const std::string& table, int width,
                                 const std::string& type) const {
  const std::string dimensions = width > 1 ? fmt::format("{} {}", nPoints_, width) : std::to_string(nPoints_);
  return fmt::format("<DataItem Dimensions=\"{}\" {} Format=\"HDF\">{}:/{}</DataItem>", dimensions, type, escaped(file),
                     escaped(table));
}

void XdmfWriter::addStep(double time, const std::string& stepFile, const std::vector<FieldShape>& fields) {
  const std::string real = "NumberType=\"Float\" Precision=\"8\"";
  // The connectivity is a table of its own, though it only counts: meshio asks for one.
  const std::string points = fmt::format(
      "<DataItem Dimensions=\"{} 1\" NumberType=\"Int\" Precision=\"4\" "
      "Format=\"HDF\">{}:/connectivity</DataItem>",
      nPoints_, escaped(meshFile_));
  steps_ += fmt::format("<Grid Name=\"Points\" GridType=\"Uniform\">\n<Time Value=\"{}\"/>\n", time);
  steps_ += fmt::format(
      "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\" NodesPerElement=\"1\">{}"
      "</Topology>\n",
      nPoints_, points);
  steps_ += fmt::format("<Geometry GeometryType=\"XYZ\">{}</Geometry>\n", dataItem(meshFile_, "coordinates", 3, real));
  for (const FieldShape& field : fields)
    steps_ +=
        fmt::format("<Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">{}</Attribute>\n", escaped(field.name),
                    attributeType(field.width), dataItem(stepFile, field.name, field.width, real));
  steps_ += "</Grid>\n";
}

std::string XdmfWriter::text() const {
  return "<?xml version=\"1.0\"?>\n<!-- written by pdrun -->\n<Xdmf Version=\"3.0\">\n<Domain>\n"
         "<Grid Name=\"Run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n" +
         steps_ + "</Grid>\n</Domain>\n</Xdmf>\n";
}

}  // namespace pd
