// Cracks and voids between points as a part of a block's material: they take a part of the bonds of the others.
#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "Peridigm_Material.hpp"
#include "block_decomposition.hpp"
#include "plugins.hpp"
#include "share_bringer.hpp"

namespace pd {

using PeridigmNS::DataManager;

namespace {

const std::string decomposingMaterial = "material Bond Decomposition";

}  // namespace

/// A part of Combined, which carries nothing itself and is initialized before the others. Where a deck has Cracks and
/// Voids in its Discretization, as those of pdrun may, the host brings these fields.
class DecomposingMaterial : public PeridigmNS::Material, public FieldUser, public ShareBringer {
 public:
  struct Fields : FieldTable {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle interactionShare = writes(pd::fields::interactionShare());
    FieldHandle cellVolume = writes(pd::fields::cellVolume());
    FieldHandle countedBonds = writes(pd::fields::countedBonds());
  };

  static void declareParameters(ParameterDeclarations& declare) {
    declare.text("Material Model", "Name of this model.").defaultTo("Bond Decomposition");
    decomposition::BlockDecomposition::declareParameters(declare);
  }

  explicit DecomposingMaterial(const Teuchos::ParameterList& given)
      : DecomposingMaterial(completed<DecomposingMaterial>(given, decomposingMaterial), Completed()) {}

  std::string Name() const override { return "Bond Decomposition"; }
  double Density() const override {
    throw std::invalid_argument(decomposingMaterial +
                                " has no Density: it is a part of a material Combined, beside one that carries load");
  }
  double BulkModulus() const override { return 0.0; }
  double ShearModulus() const override { return 0.0; }
  const FieldTable& fields() const override { return fields_; }
  std::vector<int> FieldIds() const override { return fields_.ids(); }
  std::string sourceOfShares() const override { return source_; }

  void initialize(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  DataManager& data) override {
    const Call call{numOwnedPoints, ownedIDs, neighborhoodList};
    const double* volume = fields_.volume.of(data);
    const auto shares = decomposition_.of(call, fields_.modelCoordinates.of(data), volume, data);
    std::copy(shares.left.begin(), shares.left.end(), fields_.interactionShare.of(data));
    std::transform(volume, volume + fields_.volume.length(data), fields_.cellVolume.of(data),
                   [&](double v) { return decomposition_.cellVolume(v); });
    for (int p = 0; p < numOwnedPoints; ++p)
      fields_.countedBonds.of(data)[ownedIDs[p]] = shares.counted[static_cast<std::size_t>(p)];
  }

 private:
  struct Completed {};
  DecomposingMaterial(const Teuchos::ParameterList& whole, Completed)
      : Material(whole), decomposition_(whole, decomposingMaterial), source_(textOf(whole)) {}
  /// All but the block's own horizon.
  static std::string textOf(Teuchos::ParameterList params) {
    params.remove("Horizon", false);
    std::ostringstream text;
    params.print(text);
    return text.str();
  }

  decomposition::BlockDecomposition decomposition_;
  std::string source_;
  Fields fields_;
};

PD_REGISTER_MATERIAL(
    DecomposingMaterial, "Bond Decomposition",
    "Cracks and voids between points, which take a part of the bonds of the other materials of a list.")

}  // namespace pd
