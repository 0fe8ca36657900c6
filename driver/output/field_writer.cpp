#include "field_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <numeric>

#include "../model/collective.hpp"
#include "../model/model.hpp"
#include "atomic_file.hpp"
#include "hdf5_file.hpp"
#include "result_files.hpp"

namespace pd {

FieldWriter::FieldWriter(const std::string& baseName, const GlobalOrder& order, const double* coordinates,
                         const int* blockIds, const double* volumes, int firstStep)
    : baseName_(baseName), folder_(baseName + endings::steps), order_(order) {
  onRoot(order_.comm(), [&] { makeFolderOf(folder_ + "/mesh.h5"); });
  writeMesh(coordinates, blockIds, volumes);
  onRoot(order_.comm(), [&] { takeOverSteps(firstStep); });
}

void FieldWriter::writeMesh(const double* coordinates, const int* blockIds, const double* volumes) {
  const RowRange& rows = order_.rows();
  const std::string path = folder_ + "/mesh.h5";
  Hdf5File file(unfinishedName(path), Hdf5File::Mode::Create, order_.comm());
  file.write("coordinates", order_.toRows(coordinates, 3), rows, 3);
  file.write("block_id", order_.toRows(blockIds, 1), rows, 1);
  file.write("volume", order_.toRows(volumes, 1), rows, 1);
  std::vector<int> numbers(static_cast<std::size_t>(rows.count));
  std::iota(numbers.begin(), numbers.end(), static_cast<int>(rows.first));
  file.write("connectivity", numbers, rows, 1);
  file.close();
  onRoot(order_.comm(), [&] { finishFile(path); });
}

void FieldWriter::takeOverSteps(int firstStep) {
  const std::filesystem::path base(baseName_);
  const std::string folderName = base.filename().string() + ".steps";
  index_ = std::make_unique<StepIndex>(baseName_ + ".h5", folderName + "/mesh.h5");
  xdmf_ = std::make_unique<XdmfWriter>(folderName + "/mesh.h5", order_.rows().total);

  std::map<long long, std::string> kept;
  std::vector<std::filesystem::path> removed;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    const long long step = stepOfFile(entry.path());
    const bool isOurs = isUnfinished(entry.path().string()) || (step >= 0 && isOfPdrun(entry.path()));
    if (isOurs && step >= 0 && step < firstStep)
      kept[step] = entry.path().filename().string();
    else if (isOurs)
      removed.push_back(entry.path());
  }
  for (const auto& [step, name] : kept) {
    const FoundStep found = readStepFile(folder_ + "/" + name);
    if (found.nPoints != order_.rows().total)
      throw RunError("\"" + folder_ + "/" + name + "\" of an earlier run has " + std::to_string(found.nPoints) +
                     " points, this mesh " + std::to_string(order_.rows().total) +
                     "; give another Output Filename or remove the folder");
    std::vector<FieldShape> shapes;
    for (std::size_t i = 0; i < found.names.size(); ++i) shapes.push_back({found.names[i], found.widths[i]});
    index_->addStep(stepName(step), folderName + "/" + name);
    xdmf_->addStep(found.time, folderName + "/" + name, shapes);
  }
  // The indices go first, so that they never list a step that is gone.
  writeIndices();
  for (const auto& path : removed) std::filesystem::remove(path);
}

void FieldWriter::writeIndices() {
  index_->write();
  writeFileAtomically(baseName_ + ".xdmf", xdmf_->text());
}

void FieldWriter::write(int step, double time, const std::vector<PointField>& fields) {
  const std::string path = folder_ + "/" + stepName(step) + ".h5";
  Hdf5File file(unfinishedName(path), Hdf5File::Mode::Create, order_.comm());
  file.writeAttribute("/", "time", time);
  file.writeAttribute("/", "step", static_cast<long long>(step));
  std::vector<FieldShape> shapes;
  for (const PointField& field : fields) {
    file.write(field.name, order_.toRows(field.values, field.width), order_.rows(), field.width);
    if (!field.unit.empty()) file.writeAttribute(field.name, "units", field.unit);
    shapes.push_back({field.name, field.width});
  }
  // As HDF5 lists them, so that a restart, which finds them so, writes the same.
  std::sort(shapes.begin(), shapes.end(), [](const FieldShape& a, const FieldShape& b) { return a.name < b.name; });
  file.close();
  onRoot(order_.comm(), [&] {
    finishFile(path);
    const std::string folderName = std::filesystem::path(folder_).filename().string();
    index_->addStep(stepName(step), folderName + "/" + stepName(step) + ".h5");
    xdmf_->addStep(time, folderName + "/" + stepName(step) + ".h5", shapes);
    writeIndices();
  });
}

}  // namespace pd
