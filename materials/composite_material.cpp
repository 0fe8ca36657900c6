#include "composite_material.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "diffusivity_field.hpp"
#include "parts.hpp"
#include "plugins.hpp"
#include "unknowns.hpp"

namespace pd {

using PeridigmNS::DataManager;

namespace {

const std::string combinedMaterial = "material Combined";
const std::string probeLength = "Finite Difference Probe Length";

int forceField() { return fields::forceDensity().id(); }

}  // namespace

bool CompositeMaterial::Part::adds(int field) const {
  const FieldUse* use = table.find(field);
  return use != nullptr && use->access == FieldAccess::Adds && !use->isOptional;
}

bool CompositeMaterial::Part::hasForce() const { return adds(forceField()); }

bool CompositeMaterial::Part::bringsShares() const {
  const FieldUse* use = table.find(fields::interactionShare().id());
  return use != nullptr && use->access == FieldAccess::Writes;
}

void CompositeMaterial::declareParameters(ParameterDeclarations& declare) {
  declare.text("Material Model", "Name of this model.").defaultTo("Combined");
  declare.texts(partsKey, "Names of the parts; each has a list of its parameters under its name.").required();
  declare.real("Horizon", "m", "Radius of the neighbourhood; given by the block.").positive();
  declare
      .text(axisOfRevolution,
            "Axis of a body of revolution, for the parts that know such bodies; given by Discretization.")
      .oneOf({"x", "y"});
  declare.real(probeLength, "m", "Step of finite-difference tangents of parts that give none.").positive();
}

CompositeMaterial::CompositeMaterial(const Teuchos::ParameterList& given) : Material(given) {
  const Teuchos::ParameterList params =
      completedParts<CompositeMaterial>(MaterialRegistry::self(), given, combinedMaterial);
  for (const std::string& name : params.get<Teuchos::Array<std::string>>(partsKey)) {
    Teuchos::ParameterList list(params.sublist(name));
    const auto model = list.get<std::string>("Material Model");
    const ParameterDeclarations declarations = MaterialRegistry::self().find(model)->declare();
    for (const std::string& key : {std::string("Horizon"), probeLength})
      if (params.isParameter(key) && !list.isParameter(key) && declarations.find(key) != nullptr)
        list.set(key, params.get<double>(key));
    if (params.isParameter(axisOfRevolution) && declarations.find(axisOfRevolution) != nullptr)
      list.set(axisOfRevolution, params.get<std::string>(axisOfRevolution));
    const auto material = MaterialRegistry::self().create(model, list);
    parts_.push_back({name, material, fieldsIn(*material)});
  }
  // What others ask for as they are initialized comes first.
  std::stable_partition(parts_.begin(), parts_.end(), [](const Part& part) { return part.bringsShares(); });
  if (!parts_.empty() && parts_.front().bringsShares()) requireSharesKnown();
  std::vector<NamedTable> tables;
  for (const Part& part : parts_) {
    fields_.include(part.table);
    tables.push_back({part.name, part.table});
  }
  throwAll(combinedMaterial, contestedFields(tables));
  checkDensities();
  checkVolumeCorrections(params);
  bringBonds();
  findSharedSums();
}

void CompositeMaterial::checkDensities() const {
  const Part* first = nullptr;
  double density = 0.0;
  for (const Part& part : parts_) {
    if (!part.hasForce()) continue;
    double own = 0.0;
    try {
      own = part.material->Density();
    } catch (const std::invalid_argument&) {
      continue;  // static solvers need none
    }
    if (first != nullptr && own != density)
      throwAll(combinedMaterial,
               {"\"" + first->name + "\" and \"" + part.name + "\" differ in Density, but are one body"});
    first = &part;
    density = own;
  }
}

void CompositeMaterial::checkVolumeCorrections(const Teuchos::ParameterList& params) {
  const auto names = params.get<Teuchos::Array<std::string>>(partsKey);
  const auto hasCellVolume = [&](const std::string& name) { return params.sublist(name).isParameter("Cell Volume"); };
  const auto bringer = std::find_if(names.begin(), names.end(), hasCellVolume);
  if (bringer == names.end()) return;
  const std::string key = "Volume Correction", beyond = "Ramp Beyond Horizon";
  std::vector<std::string> messages;
  for (const std::string& name : names)
    if (params.sublist(name).isParameter(key) && params.sublist(name).get<std::string>(key) == beyond)
      messages.push_back("\"" + name + "\" has the " + key + " " + beyond +
                         ", for which neighbours are sought by volumes of the mesh; by the \"Cell Volume\" of \"" +
                         *bringer + "\" these are not those of cells. Give \"" + key +
                         ": Ramp To Horizon\" or \"None\"");
  throwAll(combinedMaterial, messages);
}

void CompositeMaterial::bringBonds() {
  const int damage = fields::damage().id(), bondDamage = fields::bondDamage().id();
  const auto follows = [&](const Part& part) {
    const FieldUse* use = part.hasForce() ? nullptr : part.table.find(damage);
    return use != nullptr && !use->isOptional;
  };
  const auto dissolves = std::find_if(parts_.begin(), parts_.end(), follows);
  if (dissolves == parts_.end()) return;
  std::vector<std::string> messages;
  for (const Part& part : parts_) {
    if (!part.hasForce()) continue;
    if (part.table.find(bondDamage) == nullptr)
      messages.push_back("\"" + part.name + "\" knows no broken bonds (Bond_Damage): where \"" + dissolves->name +
                         "\" has dissolved it would go on carrying load; choose another material");
    fields_.bringBondDamage();
  }
  throwAll(combinedMaterial, messages);
}

void CompositeMaterial::findSharedSums() {
  for (const int id : fields_.sums())
    if (std::count_if(parts_.begin(), parts_.end(), [id](const Part& part) { return part.adds(id); }) > 1)
      sharedSums_.push_back(id);
  for (const FieldUse& use : fields_.uses())
    if (isDiffusivity(use.field) && std::count_if(parts_.begin(), parts_.end(), [&](const Part& part) {
                                      return part.table.find(use.id) != nullptr;
                                    }) > 1)
      sharedDiffusivities_.emplace_back(use.id, use.field.temporal);
}

double CompositeMaterial::Density() const {
  for (const bool wantsForce : {true, false})
    for (const Part& part : parts_) {
      if (part.hasForce() != wantsForce) continue;
      try {
        return part.material->Density();
      } catch (const std::invalid_argument&) {
        continue;
      }
    }
  throw std::invalid_argument(combinedMaterial + ": no part has a Density, which this solver needs");
}

double CompositeMaterial::BulkModulus() const {
  double sum = 0.0;
  for (const Part& part : parts_) sum += part.hasForce() ? part.material->BulkModulus() : 0.0;
  return sum;
}

double CompositeMaterial::ShearModulus() const {
  double sum = 0.0;
  for (const Part& part : parts_) sum += part.hasForce() ? part.material->ShearModulus() : 0.0;
  return sum;
}

double CompositeMaterial::lookupMaterialProperty(const std::string keyname) const {
  for (const Part& part : parts_) try {
      return part.material->lookupMaterialProperty(keyname);
    } catch (const std::exception&) {
      continue;
    }
  throw std::invalid_argument(combinedMaterial + ": no part has a property \"" + keyname + "\"");
}

std::vector<int> CompositeMaterial::FieldIdsForSynchronizationAfterInitialize() const {
  std::vector<int> ids;
  for (const Part& part : parts_) addNew(ids, part.material->FieldIdsForSynchronizationAfterInitialize());
  return ids;
}

std::vector<int> CompositeMaterial::FieldIdsForSynchronizationAfterPrecompute() const {
  std::vector<int> ids;
  for (const Part& part : parts_) addNew(ids, part.material->FieldIdsForSynchronizationAfterPrecompute());
  return ids;
}

std::vector<std::string> CompositeMaterial::runNotes() const {
  std::vector<std::string> notes;
  for (const Part& part : parts_)
    if (const auto* own = dynamic_cast<const RunNotes*>(part.material.get()))
      for (const std::string& line : own->runNotes()) notes.push_back(line);
  return notes;
}

void CompositeMaterial::requireSharesKnown() const {
  std::vector<std::string> messages;
  for (const Part& part : parts_)
    if (part.table.find(fields::interactionShare().id()) == nullptr)
      messages.push_back("\"" + part.name +
                         "\" does not know that Cracks and Voids of the deck take a part of bonds (" +
                         fields::interactionShare().label + "); leave one of them out");
  throwAll(combinedMaterial, messages);
}

void CompositeMaterial::initialize(const double dt, const int numOwnedPoints, const int* ownedIDs,
                                   const int* neighborhoodList, DataManager& dataManager) {
  if (dataManager.hasData(fields::interactionShare().id(), PeridigmNS::PeridigmField::STEP_NONE)) requireSharesKnown();
  const auto n = static_cast<std::size_t>(numOwnedPoints);
  std::vector<std::vector<double>> sums(sharedDiffusivities_.size(), std::vector<double>(n, 0.0));
  for (const Part& part : parts_) {
    part.material->initialize(dt, numOwnedPoints, ownedIDs, neighborhoodList, dataManager);
    for (std::size_t k = 0; k < sums.size(); ++k) {
      if (part.table.find(sharedDiffusivities_[k].id()) == nullptr) continue;
      const double* own = sharedDiffusivities_[k].of(dataManager);
      for (std::size_t p = 0; p < n; ++p) sums[k][p] += own[ownedIDs[p]];
    }
  }
  for (std::size_t k = 0; k < sums.size(); ++k)
    for (std::size_t p = 0; p < n; ++p) sharedDiffusivities_[k].of(dataManager)[ownedIDs[p]] = sums[k][p];
}

void CompositeMaterial::precompute(const double dt, const int numOwnedPoints, const int* ownedIDs,
                                   const int* neighborhoodList, DataManager& dataManager) const {
  for (const Part& part : parts_)
    part.material->precompute(dt, numOwnedPoints, ownedIDs, neighborhoodList, dataManager);
}

void CompositeMaterial::addUp(const std::function<bool(const Part&)>& isAsked,
                              const std::function<void(const Part&)>& work, DataManager& data) const {
  std::vector<std::vector<double>> sums(sharedSums_.size());
  const auto viewOf = [&](std::size_t k) {
    double* values = nullptr;
    const auto field = data.getData(sharedSums_[k], PeridigmNS::PeridigmField::STEP_NP1);
    field->ExtractView(&values);
    sums[k].resize(static_cast<std::size_t>(field->MyLength()), 0.0);
    return values;
  };
  for (const Part& part : parts_) {
    if (!isAsked(part)) continue;
    // Parts may rely on it that where they add nothing they find nothing.
    for (std::size_t k = 0; k < sums.size(); ++k)
      if (part.adds(sharedSums_[k])) std::fill_n(viewOf(k), sums[k].size(), 0.0);
    work(part);
    for (std::size_t k = 0; k < sums.size(); ++k) {
      if (!part.adds(sharedSums_[k])) continue;
      const double* own = viewOf(k);
      for (std::size_t i = 0; i < sums[k].size(); ++i) sums[k][i] += own[i];
    }
  }
  for (std::size_t k = 0; k < sums.size(); ++k)
    if (!sums[k].empty()) std::copy(sums[k].begin(), sums[k].end(), viewOf(k));
}

void CompositeMaterial::computeForce(const double dt, const int numOwnedPoints, const int* ownedIDs,
                                     const int* neighborhoodList, DataManager& dataManager) const {
  addUp([](const Part& part) { return part.hasForce(); },
        [&](const Part& part) {
          part.material->computeForce(dt, numOwnedPoints, ownedIDs, neighborhoodList, dataManager);
        },
        dataManager);
}

void CompositeMaterial::computeFluxDivergence(const double dt, const int numOwnedPoints, const int* ownedIDs,
                                              const int* neighborhoodList, DataManager& dataManager) const {
  addUp(
      [](const Part& part) {
        const std::vector<int> sums = part.table.sums();
        return std::any_of(sums.begin(), sums.end(), [](int id) { return id != forceField(); });
      },
      [&](const Part& part) {
        part.material->computeFluxDivergence(dt, numOwnedPoints, ownedIDs, neighborhoodList, dataManager);
      },
      dataManager);
}

void CompositeMaterial::prepareRate(int rateField, double dt, const Call& call, DataManager& data) const {
  for (const Part& part : parts_)
    if (part.adds(rateField) && !part.hasForce())
      part.material->precompute(dt, call.nOwned, call.ownedIds, call.neighborhoodList, data);
}

void CompositeMaterial::computeRate(int rateField, double dt, const Call& call, DataManager& data) const {
  addUp([rateField](const Part& part) { return part.adds(rateField); },
        [&](const Part& part) {
          part.material->computeFluxDivergence(dt, call.nOwned, call.ownedIds, call.neighborhoodList, data);
        },
        data);
}

void CompositeMaterial::computeStoredElasticEnergyDensity(const double dt, const int numOwnedPoints,
                                                          const int* ownedIDs, const int* neighborhoodList,
                                                          DataManager& dataManager) const {
  double* energy = nullptr;
  dataManager.getData(fields::storedEnergyDensity().id(), PeridigmNS::PeridigmField::STEP_NONE)->ExtractView(&energy);
  std::vector<double> sum(static_cast<std::size_t>(numOwnedPoints), 0.0);
  for (const Part& part : parts_) {
    for (int p = 0; p < numOwnedPoints; ++p) energy[ownedIDs[p]] = 0.0;
    part.material->computeStoredElasticEnergyDensity(dt, numOwnedPoints, ownedIDs, neighborhoodList, dataManager);
    for (std::size_t p = 0; p < sum.size(); ++p) sum[p] += energy[ownedIDs[p]];
  }
  for (std::size_t p = 0; p < sum.size(); ++p) energy[ownedIDs[p]] = sum[p];
}

void CompositeMaterial::computeJacobian(const double dt, const int numOwnedPoints, const int* ownedIDs,
                                        const int* neighborhoodList, DataManager& dataManager,
                                        PeridigmNS::SerialMatrix& jacobian, JacobianType jacobianType) const {
  for (const Part& part : parts_)
    if (givesUnknownRate(part.table))
      part.material->computeJacobian(dt, numOwnedPoints, ownedIDs, neighborhoodList, dataManager, jacobian,
                                     jacobianType);
}

const LinearBonds* CompositeMaterial::springPart() const {
  const LinearBonds* found = nullptr;
  for (const Part& part : parts_) {
    if (!part.hasForce()) continue;
    const auto* bonds = dynamic_cast<const LinearBonds*>(part.material.get());
    if (found != nullptr || bonds == nullptr || !bonds->hasSprings()) return nullptr;
    found = bonds;
  }
  return found;
}

std::string CompositeMaterial::springsObstacle() const {
  if (hasSprings()) return "";
  std::string loaded;
  int nLoaded = 0;
  for (const Part& part : parts_) {
    if (!part.hasForce()) continue;
    loaded += (nLoaded++ == 0 ? "\"" : ", \"") + part.name + "\"";
  }
  if (nLoaded == 0) return "none of its materials carries load";
  return nLoaded == 1 ? "its material " + loaded + " has none"
                      : "its materials " + loaded + " all carry load, not one alone";
}

const FlowLaw* CompositeMaterial::flowLaw() const {
  for (const Part& part : parts_)
    if (const auto* flow = dynamic_cast<const FlowMaterial*>(part.material.get())) return flow->flowLaw();
  return nullptr;
}

bool CompositeMaterial::isAsymmetric(const std::string& label) const {
  return std::any_of(parts_.begin(), parts_.end(), [&](const Part& part) {
    const auto* rate = dynamic_cast<const AsymmetricRate*>(part.material.get());
    return rate != nullptr && rate->isAsymmetric(label);
  });
}

std::string CompositeMaterial::sourceOfShares() const {
  for (const Part& part : parts_)
    if (const auto* bringer = dynamic_cast<const ShareBringer*>(part.material.get())) return bringer->sourceOfShares();
  return "";
}

void CompositeMaterial::stepAccepted(const Call& call, DataManager& data, double time, double dt) const {
  for (const Part& part : parts_) tellStepAccepted(*part.material, call, data, time, dt);
}

void CompositeMaterial::stepTakenBack() const {
  for (const Part& part : parts_) tellStepTakenBack(*part.material);
}

PD_REGISTER_MATERIAL(CompositeMaterial, "Combined", "Several materials of one block, each with its own physics.")

}  // namespace pd
