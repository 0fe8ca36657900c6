// Several damage models of one block as one: bonds have one state, which each may only make worse.
#include <algorithm>
#include <stdexcept>

#include "bond_damage_model.hpp"
#include "parts.hpp"
#include "plugins.hpp"
#include "step_listener.hpp"

namespace pd {

using PeridigmNS::DamageModel;
using PeridigmNS::DataManager;

namespace {

const std::string combinedDamageModel = "damage model Combined";

/// A field's values at NP1, kept to be compared with what a model makes of them.
class Worst {
 public:
  Worst(const FieldHandle& field, DataManager& data) : field_(field) {
    if (!field.isIn(data)) return;
    const double* values = field.of(data);
    before_.assign(values, values + field.length(data));
  }
  /// The worse of then and now.
  void restore(DataManager& data) const {
    for (std::size_t i = 0; i < before_.size(); ++i) {
      double& value = field_.of(data)[i];
      value = std::max(value, before_[i]);
    }
  }

 private:
  FieldHandle field_;
  std::vector<double> before_;
};

}  // namespace

/// `Damage Models` names the parts; each has a sub-list of its parameters under its name. pdrun makes it of a list of
/// names in a block. Models of this library (BondDamageModel) worsen the bonds in turn, one that says which points are
/// liquid last. Of others, which know of no one beside them, the worse of what they find and of what is there counts.
class CompositeDamageModel : public DamageModel, public FieldUser, public StepListener {
 public:
  static constexpr const char* partsKey = "Damage Models";
  static void declareParameters(ParameterDeclarations& declare) {
    declare.text("Damage Model", "Name of this model.");
    declare.texts(partsKey, "Names of the parts; each has a list of its parameters under its name.").required();
  }

  explicit CompositeDamageModel(const Teuchos::ParameterList& given) : DamageModel(given) {
    const Teuchos::ParameterList params =
        completedParts<CompositeDamageModel>(DamageModelRegistry::self(), given, combinedDamageModel);
    std::vector<NamedTable> tables;
    for (const std::string& name : params.get<Teuchos::Array<std::string>>(partsKey)) {
      const Teuchos::ParameterList& list = params.sublist(name);
      const auto part = DamageModelRegistry::self().create(list.get<std::string>("Damage Model"), list);
      tables.push_back({name, fieldsIn(*part)});
      fields_.include(tables.back().table);
      parts_.push_back(part);
      const auto* own = dynamic_cast<const BondDamageModel*>(part.get());
      (own == nullptr ? foreign_ : own->marksLiquid() ? liquefying_ : breaking_).push_back(part.get());
    }
    throwAll(combinedDamageModel, contestedFields(tables));
  }

  std::string Name() const override { return "Combined"; }
  const FieldTable& fields() const override { return fields_; }
  std::vector<int> FieldIds() const override { return fields_.ids(); }
  std::vector<int> FieldIdsForSynchronizationAfterInitialize() const override {
    std::vector<int> ids;
    for (const auto& part : parts_) addNew(ids, part->FieldIdsForSynchronizationAfterInitialize());
    return ids;
  }
  std::vector<int> FieldIdsForSynchronizationAfterPrecompute() const override {
    std::vector<int> ids;
    for (const auto& part : parts_) addNew(ids, part->FieldIdsForSynchronizationAfterPrecompute());
    return ids;
  }

  void initialize(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  DataManager& dataManager) const override {
    const Call call{numOwnedPoints, ownedIDs, neighborhoodList};
    double* damage = fields_.damage.of(dataManager);
    const LiquidPoints liquid(call, damage);
    for (const auto& part : parts_) part->initialize(dt, numOwnedPoints, ownedIDs, neighborhoodList, dataManager);
    if (!liquefying_.empty()) liquid.restore(call, damage);
  }
  void precompute(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  DataManager& dataManager) const override {
    for (const auto& part : parts_) part->precompute(dt, numOwnedPoints, ownedIDs, neighborhoodList, dataManager);
  }
  void computeDamage(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                     DataManager& dataManager) const override {
    const Call call{numOwnedPoints, ownedIDs, neighborhoodList};
    double* damage = fields_.damage.of(dataManager);
    const bool hasLiquid = !liquefying_.empty();
    const LiquidPoints before(call, damage);
    BondDamageModel::carryOver(fields_, call, dataManager);
    worsen(breaking_, dt, call, dataManager);
    if (hasLiquid) before.restore(call, damage);
    worsen(liquefying_, dt, call, dataManager);
    BondDamageModel::weighBonds(fields_, call, dataManager);
    if (foreign_.empty()) return;
    const LiquidPoints liquid(call, damage);
    for (const DamageModel* model : foreign_) {
      const Worst bonds(fields_.bondDamage, dataManager), points(fields_.damage, dataManager);
      model->computeDamage(dt, numOwnedPoints, ownedIDs, neighborhoodList, dataManager);
      bonds.restore(dataManager);
      points.restore(dataManager);
    }
    if (hasLiquid) liquid.restore(call, damage);
  }

  void stepAccepted(const Call& call, DataManager& data, double time, double dt) const override {
    for (const auto& part : parts_) tellStepAccepted(*part, call, data, time, dt);
  }
  void stepTakenBack() const override {
    for (const auto& part : parts_) tellStepTakenBack(*part);
  }

 private:
  /// Bonds are brought by the parts that need them.
  struct Fields : BondDamageModel::Fields {
    Fields() : BondDamageModel::Fields(false) {}
  };

  static void worsen(const std::vector<const DamageModel*>& models, double dt, const Call& call, DataManager& data) {
    for (const DamageModel* model : models) dynamic_cast<const BondDamageModel&>(*model).worsen(dt, call, data);
  }

  std::vector<Teuchos::RCP<DamageModel>> parts_;
  std::vector<const DamageModel*> breaking_, liquefying_, foreign_;
  Fields fields_;
};

PD_REGISTER_DAMAGE_MODEL(CompositeDamageModel, "Combined",
                         "Several damage models of one block, each making bonds worse.")

}  // namespace pd
