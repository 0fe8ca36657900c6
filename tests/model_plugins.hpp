// Plug-ins that are small enough to know their answers by hand, and decks that use them.
#ifndef PD_TEST_MODEL_PLUGINS_HPP
#define PD_TEST_MODEL_PLUGINS_HPP

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "Peridigm_Field.hpp"
#include "driver/deck/deck.hpp"
#include "fields.hpp"
#include "plugins.hpp"

namespace pd::test {

using namespace PeridigmNS;
using namespace PeridigmNS::PeridigmField;

/// Linear springs along the bonds: half of each bond's force comes from either end's block, so that with unit volumes
/// force density_i = sum_j (k_i + k_j)/2 (u_j - u_i). The scalar field Concentration diffuses by the same rule, with
/// the stiffness as diffusivity. Broken bonds carry nothing.
class SpringMaterial : public Material, public FieldUser {
 public:
  struct Fields : FieldTable {
    FieldHandle reference = reads(pd::fields::modelCoordinates());
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle prepared =
        writes(pd::fields::pointScalar("Prepared", "1", "How often precompute() was called."), Ghosts::AfterPrecompute);
    FieldHandle bondDamage, coordinates, force, concentration, flux;
    Fields(bool isBreakable, bool hasMechanics, bool hasDiffusion) {
      if (isBreakable) bondDamage = reads(pd::fields::bondDamage());
      if (hasMechanics) coordinates = reads(pd::fields::coordinates());
      if (hasMechanics) force = adds(pd::fields::forceDensity());
      if (hasDiffusion) concentration = reads(pd::fields::diffusingScalar("Concentration"));
      if (hasDiffusion) flux = adds(pd::fields::fluxDivergence("Concentration"));
    }
  };
  static void declareParameters(ParameterDeclarations& declare) {
    declare.real("Stiffness", "N/m", "Of a bond.").positive().required();
    declare.real("Finite Difference Probe Length", "m", "Of the tangent.").positive();
    declare.flag("Refuse", "Makes the constructor throw.").defaultTo(false);
    declare.flag("Mechanics", "Computes forces.").defaultTo(true);
    declare.flag("Diffusion", "Computes fluxes.").defaultTo(true);
    declare.flag("Breakable", "Knows broken bonds.").defaultTo(true);
  }
  explicit SpringMaterial(const Teuchos::ParameterList& list)
      : Material(list),
        parameters(list),
        stiffness_(list.get<double>("Stiffness")),
        isBreakable_(list.get<bool>("Breakable")),
        fields_(isBreakable_, list.get<bool>("Mechanics"), list.get<bool>("Diffusion")) {
    if (list.get<bool>("Refuse")) throw std::invalid_argument("this stiffness is refused");
  }
  std::string Name() const override { return "Test Springs"; }
  double Density() const override { return 1.0; }
  double BulkModulus() const override { return 1.0; }
  double ShearModulus() const override { return 1.0; }
  const Fields& fields() const override { return fields_; }
  std::vector<int> FieldIds() const override { return fields_.ids(); }
  std::vector<int> FieldIdsForSynchronizationAfterPrecompute() const override {
    return fields_.ids(Ghosts::AfterPrecompute);
  }

  void precompute(const double, const int n, const int* owned, const int*, DataManager& data) const override {
    ++nPrecomputes;
    for (int k = 0; k < n; ++k) fields_.prepared.of(data)[owned[k]] = nPrecomputes;
  }
  void computeForce(const double, const int n, const int* owned, const int* list, DataManager& data) const override {
    addDifferences(n, owned, list, data, 3, fields_.coordinates, &fields_.reference, fields_.force);
  }
  void computeFluxDivergence(const double, const int n, const int* owned, const int* list,
                             DataManager& data) const override {
    addDifferences(n, owned, list, data, 1, fields_.concentration, nullptr, fields_.flux);
  }

  Teuchos::ParameterList parameters;
  mutable int nPrecomputes = 0;

 private:
  void addDifferences(int n, const int* owned, const int* list, DataManager& data, int width,
                      const FieldHandle& valueField, const FieldHandle* referenceField,
                      const FieldHandle& resultField) const {
    const double* isBroken = isBreakable_ ? fields_.bondDamage.of(data) : nullptr;
    const double *volume = fields_.volume.of(data), *value = valueField.of(data);
    const double* reference = referenceField == nullptr ? nullptr : referenceField->of(data);
    double* result = resultField.of(data);
    std::fill(result, result + resultField.length(data), 0.0);
    int bond = 0;
    for (int k = 0; k < n; ++k) {
      const int i = owned[k];
      for (int nNeighbors = *list++; nNeighbors > 0; --nNeighbors, ++bond) {
        const int j = *list++;
        if (isBreakable_ && isBroken[bond] > 0.0) continue;
        for (int c = 0; c < width; ++c) {
          double difference = value[width * j + c] - value[width * i + c];
          if (reference != nullptr) difference -= reference[width * j + c] - reference[width * i + c];
          result[width * i + c] += 0.5 * stiffness_ * difference * volume[j];
          result[width * j + c] -= 0.5 * stiffness_ * difference * volume[i];
        }
      }
    }
  }

  double stiffness_;
  bool isBreakable_;
  Fields fields_;
};
inline const bool hasSpringMaterial =
    registerPlugin<MaterialRegistry, SpringMaterial>("Test Springs", "Linear springs.");

/// Breaks a bond whose ends are farther apart than a length. Damage = broken / all bonds.
class LengthDamage : public DamageModel {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declare.real("Greatest Length", "m", "Of a bond.").positive().required();
  }
  explicit LengthDamage(const Teuchos::ParameterList& list)
      : DamageModel(list), greatest_(list.get<double>("Greatest Length")) {
    auto& fields = FieldManager::self();
    coordinates_ = fields.getFieldId(NODE, VECTOR, TWO_STEP, "Coordinates");
    bondDamage_ = fields.getFieldId(BOND, SCALAR, TWO_STEP, "Bond_Damage");
    damage_ = fields.getFieldId(ELEMENT, SCALAR, TWO_STEP, "Damage");
  }
  std::string Name() const override { return "Test Length"; }
  std::vector<int> FieldIds() const override { return {coordinates_, bondDamage_, damage_}; }
  void computeDamage(const double, const int n, const int* owned, const int* list, DataManager& data) const override {
    const auto y = data.getData(coordinates_, STEP_NP1);
    const auto isBroken = data.getData(bondDamage_, STEP_NP1);
    const auto damage = data.getData(damage_, STEP_NP1);
    int bond = 0;
    for (int k = 0; k < n; ++k) {
      const int i = owned[k], nNeighbors = *list++;
      double nBroken = 0.0;
      for (int m = 0; m < nNeighbors; ++m, ++bond) {
        const int j = *list++;
        double squared = 0.0;
        for (int c = 0; c < 3; ++c) squared += std::pow((*y)[3 * j + c] - (*y)[3 * i + c], 2);
        if (squared > greatest_ * greatest_) (*isBroken)[bond] = 1.0;
        nBroken += (*isBroken)[bond];
      }
      (*damage)[i] = nNeighbors > 0 ? nBroken / nNeighbors : 0.0;
    }
  }

 private:
  double greatest_;
  int coordinates_ = -1, bondDamage_ = -1, damage_ = -1;
};
inline const bool hasLengthDamage =
    registerPlugin<DamageModelRegistry, LengthDamage>("Test Length", "Bonds of limited length.");

/// A folder of this process, removed when it ends.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_(std::filesystem::temp_directory_path() / ("pd_test_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// A deck from its text, read from a file named test.yaml.
inline Deck deckOf(const std::string& text) {
  static const TemporaryFolder folder;
  std::ofstream(folder.file("test.yaml")) << text;
  return Deck::read(folder.file("test.yaml"));
}

/// Materials, damage model and blocks; block_2 has twice the stiffness of block_1.
inline std::string plateText(const std::string& moreOfBlocks = "") {
  return "Materials:\n"
         "  Soft: {Material Model: Test Springs, Stiffness: 1}\n"
         "  Stiff: {Material Model: Test Springs, Stiffness: 2.0}\n"
         "Damage Models:\n"
         "  Length: {Damage Model: Test Length, Greatest Length: 1.5}\n"
         "Blocks:\n"
         "  First: {Block Names: block_1, Material: Soft, Horizon: 1.0" +
         moreOfBlocks +
         "}\n"
         "  Second: {Block Names: block_2, Material: Stiff, Horizon: 1.0" +
         moreOfBlocks + "}\n";
}

}  // namespace pd::test

#endif
