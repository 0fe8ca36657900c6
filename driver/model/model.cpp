#include "model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <sstream>

#include "../deck/block_plugins.hpp"
#include "../deck/function.hpp"
#include "../discretization/mesh_points.hpp"
#include "Peridigm_Field.hpp"
#include "collective.hpp"
#include "field_names.hpp"
#include "for_each_plugin.hpp"
#include "influence.hpp"
#include "linear_bonds.hpp"
#include "rates.hpp"
#include "run_notes.hpp"
#include "share_bringer.hpp"

namespace pd {

using namespace PeridigmNS;

namespace {

/// The entry of section Blocks that covers the block of the mesh; one named "default" covers what no other names.
DeckNode blockEntry(const Deck& deck, const std::string& name) {
  DeckNode fallback;
  for (const auto& [key, entry] : deck["Blocks"].entries()) {
    std::istringstream names(entry.text("Block Names", ""));
    for (std::string word; names >> word;) {
      if (word == name) return entry;
      if (word == "default") fallback = entry;
    }
  }
  return fallback;
}

/// The block's horizon where it is one number for all its points.
bool constantHorizon(const DeckNode& entry, double& horizon) {
  const Function function = Function::fromDeck(entry["Horizon"]);
  horizon = function(0.0, 0.0, 0.0, 0.0);
  return function.isConstant();
}

/// The plug-in that a block names by `key`, or several as one; `adjust(list, declarations)` adds what the host knows.
template <class Registry, class Adjust>
typename Registry::Created createPlugin(const Registry& registry, const DeckNode& section, const DeckNode& names,
                                        const Adjust& adjust) {
  std::vector<NamedPlugin> parts;
  DeckNode node;
  for (const DeckNode& name : names.each()) {
    node = section[name.text()];
    if (!node) throw DeckError(name.place() + ": no entry of this name in section " + section.path());
    parts.push_back({name.text(), node[modelKey(registry)].text(), node.parameters(declarationsOf(registry, node))});
  }
  NamedPlugin whole = asOne(registry, parts);
  const std::string place = parts.size() == 1 ? node.keyPlace() : names.place();
  adjust(whole.parameters, registry.find(whole.plugin)->declare());
  try {
    return registry.create(whole.plugin, whole.parameters);
  } catch (const DeckError&) {
    throw;
  } catch (const std::exception& error) {
    throw DeckError(place + ": " + error.what());
  }
}

Teuchos::RCP<Material> createMaterial(const Deck& deck, const DeckNode& blockNode, double shortestBond) {
  return createPlugin(MaterialRegistry::self(), deck["Materials"], blockNode["Material"],
                      [&](Teuchos::ParameterList& list, const ParameterDeclarations& declarations) {
                        double horizon = 0.0;
                        if (constantHorizon(blockNode, horizon)) list.set("Horizon", horizon);
                        giveAxisOfRevolution(deck, declarations, list);
                        // Peridigm's default: far below the smallest distance that the material sees.
                        const std::string probe = "Finite Difference Probe Length";
                        if (declarations.find(probe) != nullptr && !list.isParameter(probe))
                          list.set(probe, 1.0e-6 * shortestBond);
                      });
}

/// Null where the block names no damage model.
Teuchos::RCP<DamageModel> createDamageModel(const Deck& deck, const DeckNode& blockNode) {
  const DeckNode names = blockNode["Damage Model"];
  if (!names || (names.isScalar() && names.text() == "None")) return Teuchos::null;
  return createPlugin(DamageModelRegistry::self(), deck["Damage Models"], names,
                      [](Teuchos::ParameterList&, const ParameterDeclarations&) {});
}

Teuchos::RCP<NeighborhoodData> blockNeighborhood(const Discretization& points, int blockNumber) {
  std::vector<int> owned, list;
  if (points.blockNumbers.size() == 1) {
    owned.resize(static_cast<std::size_t>(points.nOwned));
    std::iota(owned.begin(), owned.end(), 0);
    return Teuchos::rcp(new NeighborhoodData(std::move(owned), points.neighborhoodList.data(),
                                             static_cast<int>(points.neighborhoodList.size())));
  }
  // Memory is taken once: growing the list would need twice as much.
  std::size_t length = 0;
  for (int i = 0; i < points.nOwned; ++i) {
    if (points.blockId[i] != blockNumber) continue;
    owned.push_back(i);
    length += static_cast<std::size_t>(points.neighborhoodStart[i + 1] - points.neighborhoodStart[i]);
  }
  list.reserve(length);
  const auto begin = points.neighborhoodList.begin();
  for (const int i : owned)
    list.insert(list.end(), begin + points.neighborhoodStart[i], begin + points.neighborhoodStart[i + 1]);
  return Teuchos::rcp(new NeighborhoodData(std::move(owned), std::move(list)));
}

/// Refuses Cracks and Voids of materials that are not those of all blocks, and those beside Cracks and Voids of the
/// mesh.
void checkBringersOfShares(const Deck& deck, std::vector<Block>& blocks, bool isDecomposed) {
  const auto sourceOf = [](Block& block) {
    const auto* bringer = dynamic_cast<const ShareBringer*>(block.getMaterialModel().get());
    return bringer == nullptr ? std::string() : bringer->sourceOfShares();
  };
  const auto bringsShares = [&](Block& block) { return !sourceOf(block).empty(); };
  const auto first = std::find_if(blocks.begin(), blocks.end(), bringsShares);
  if (first == blocks.end()) return;
  const std::string source = sourceOf(*first),
                    remedy = ", so that bonds between them would differ from end to end; give all blocks the same";
  Mistakes mistakes;
  for (Block& block : blocks) {
    const std::string place = blockEntry(deck, block.getName())["Material"].place();
    if (!bringsShares(block))
      mistakes.add(
          place, "materials of other blocks have Cracks and Voids, those of " + block.getName() + " have not" + remedy);
    else if (isDecomposed)
      mistakes.add(place, "a material of " + block.getName() +
                              " has Cracks and Voids, and Discretization has some; give all of them in one place");
    else if (sourceOf(block) != source)
      mistakes.add(place, "a material of " + block.getName() + " has other Cracks and Voids than that of " +
                              first->getName() + ", or the same in another order or by another rule" + remedy);
  }
  mistakes.report();
}

/// Whether no point has moved, and all that carries load are springs, which then are without force. Collective.
bool isAtRest(Model& model) {
  const double* displacement = model.field("Displacement");
  const bool hasMoved =
      std::any_of(displacement, displacement + 3LL * model.nOwned(), [](double value) { return value != 0.0; });
  const bool mayPush = std::any_of(model.blocks()->begin(), model.blocks()->end(), [](Block& block) {
    if (!computesForces(block)) return false;
    const auto* bonds = dynamic_cast<const LinearBonds*>(block.getMaterialModel().get());
    return bonds == nullptr || !bonds->springsObstacle().empty() || derivesFields(block);
  });
  return !model.comm().any(hasMoved || mayPush);
}

}  // namespace

Model::Model(const Deck& deck, const Communicator& comm, Discretization discretization,
             const std::vector<int>& extraFields)
    : comm_(comm),
      discretization_(std::move(discretization)),
      exchange_(comm, discretization_),
      shared_(Teuchos::rcp(new DataManager)),
      blocks_(Teuchos::rcp(new std::vector<Block>)) {
  setInfluenceFunction(deck);
  createBlocks(deck);
  allocatePluginFields();
  allocateFields(extraFields);
  if (!discretization_.symmetry.empty()) prepareImages(deck);
  collectively(comm_, [&] { checkBringersOfShares(deck, *blocks_, discretization_.isDecomposed); });
  if (discretization_.isDecomposed) collectively(comm_, [&] { decomposeBonds(deck); });
  if (comm_.any(!discretization_.bondIsCut.empty())) collectively(comm_, [&] { cutBonds(deck); });
}

void Model::prepareImages(const Deck& deck) {
  using namespace PeridigmField;
  for (Block& block : *blocks_) forEachFieldUse(block, [&](const FieldUse& use) { reflections_.include(use); });
  allocateFields({FieldManager::self().getFieldId(NODE, SCALAR, CONSTANT, imageShiftField)});
  for (const FieldSpec& spec : FieldManager::self().getFieldSpecs())
    if (spec.length == VECTOR && spec.relation != BOND && spec.relation != GLOBAL && hasField(spec.label) &&
        reflectionOf(spec.label) == Reflection::Even && !discretization_.symmetry.isAlongAxes())
      throw DeckError(deck["Discretization"]["Symmetry"].keyPlace() + ": the field " + spec.label +
                      " has a value for each of x, y and z, and planes of symmetry must be perpendicular to one of "
                      "them; turn the mesh, or choose a model without this field (Surface Correction: Volume Method)");
}

void Model::createBlocks(const Deck& deck) {
  const auto& points = discretization_;
  const auto owned =
      Teuchos::rcp(new PointMap(std::vector<int>(points.globalIds.begin(), points.globalIds.begin() + points.nOwned)));
  const auto overlap = Teuchos::rcp(new PointMap(points.globalIds));
  shared_->setMaps(owned, overlap, 0);
  Mistakes mistakes;
  for (const int number : points.blockNumbers) {
    const std::string name = nameOfBlock(points.blockNames, number);
    const DeckNode entry = blockEntry(deck, name);
    if (!entry) {
      mistakes.add(deck["Blocks"].place(), name +
                                               " of the mesh has no material: name it in the `Block Names` of an "
                                               "entry of Blocks, or give an entry the block name `default`");
      continue;
    }
    Block block(name, number);
    try {
      block.setMaterialModel(createMaterial(deck, entry, points.shortestBond));
      block.setDamageModel(createDamageModel(deck, entry));
    } catch (const DeckError& error) {
      mistakes.add("", error.what());
      continue;
    }
    block.setNeighborhoodData(blockNeighborhood(points, number));
    const auto data = Teuchos::rcp(new DataManager);
    data->setMaps(owned, overlap, block.getNeighborhoodData()->NumBonds());
    data->sharePointData(*shared_);
    block.setDataManager(data);
    blocks_->push_back(block);
  }
  mistakes.report();
}

void Model::allocatePluginFields() {
  auto& fields = FieldManager::self();
  using namespace PeridigmField;
  shared_->allocateData({fields.getFieldId(NODE, VECTOR, CONSTANT, "Model_Coordinates"),
                         fields.getFieldId(ELEMENT, SCALAR, CONSTANT, "Volume")});
  for (Block& block : *blocks_) {
    shareBondSteps(block);
    forEachPlugin(block, [&](const auto& plugin) { block.getDataManager()->allocateData(plugin.FieldIds()); });
    if (discretization_.blockNumbers.size() == 1) continue;
    for (const int id : fieldsIn(*block.getMaterialModel()).sums()) block.getDataManager()->allocatePrivateData(id);
  }
  if (hasMechanics()) shared_->allocateData({pd::fields::coordinates().id(), pd::fields::displacement().id()});
  fillConstantFields();
}

/// Of bond fields that only grow, as every plug-in of the block that uses them says.
void Model::shareBondSteps(Block& block) {
  std::vector<int> growing, others;
  forEachPlugin(block, [&](const auto& plugin) {
    const FieldTable* table = fieldTableOf(plugin);
    if (table == nullptr) {
      const std::vector<int> ids = plugin.FieldIds();
      others.insert(others.end(), ids.begin(), ids.end());
      return;
    }
    for (const FieldUse& use : table->uses()) (use.field.onlyGrows ? growing : others).push_back(use.id);
  });
  const auto isNotShared = [&](int id) { return std::find(others.begin(), others.end(), id) != others.end(); };
  growing.erase(std::remove_if(growing.begin(), growing.end(), isNotShared), growing.end());
  block.getDataManager()->shareSteps(growing);
}

void Model::allocateFields(const std::vector<int>& fieldIds) {
  for (const int id : fieldIds) {
    if (FieldManager::self().getFieldSpec(id).relation != PeridigmField::BOND) {
      shared_->allocateData({id});
      continue;
    }
    for (Block& block : *blocks_) block.getDataManager()->allocateData({id});
  }
  fillConstantFields();
}

void Model::fillConstantFields() {
  const auto& points = discretization_;
  const auto fill = [&](const std::string& label, const auto& value) {
    if (!hasField(label)) return;
    double* values = field(label);
    for (int i = 0; i < points.nPoints; ++i) values[i] = value(i);
  };
  std::copy(points.x.begin(), points.x.end(), field("Model_Coordinates"));
  fill("Volume", [&](int i) { return points.volume[i]; });
  if (points.isDecomposed) {
    fill(fields::cellVolume().label, [&](int i) { return points.cellVolume[i]; });
    fill(fields::countedBonds().label, [&](int i) { return i < points.nOwned ? points.countedBonds[i] : 0.0; });
  }
  fill("Horizon", [&](int i) { return points.horizon[i]; });
  fill("Block_Id", [&](int i) { return points.blockId[i]; });
  fill("Element_Id", [&](int i) { return points.globalIds[i] + 1; });  // node numbers start at 1 in files
  fill(imageShiftField, [&](int i) { return points.globalIds[i] - points.globalIds[points.sourceOf(i)]; });
  if (hasField("Coordinates")) std::copy(points.x.begin(), points.x.end(), field("Coordinates"));
}

void Model::decomposeBonds(const Deck& deck) {
  const auto& points = discretization_;
  const int share = fields::interactionShare().id();
  Mistakes mistakes;
  for (Block& block : *blocks_) {
    const FieldTable* table = fieldTableOf(*block.getMaterialModel());
    if (table != nullptr && table->find(share) != nullptr) continue;
    const DeckNode names = blockEntry(deck, block.getName())["Material"];
    mistakes.add(names.place(),
                 "the material of " + block.getName() +
                     " does not know that Cracks and Voids of Discretization take a part of bonds (field " +
                     fields::interactionShare().label +
                     "); choose PDHE, Elastic, Elastic Bond Based or Diffusion, or use Bond Filters");
  }
  mistakes.report();
  allocateFields({share, fields::cellVolume().id(), fields::countedBonds().id()});
  for (Block& block : *blocks_) {
    double* ofBond = nullptr;
    block.getData(share, PeridigmField::STEP_NONE)->ExtractView(&ofBond);
    const auto neighborhood = block.getNeighborhoodData();
    for (int k = 0; k < neighborhood->NumOwnedPoints(); ++k) {
      const int point = neighborhood->OwnedIDs()[k];
      const long long first = points.neighborhoodStart[point] - point;
      const int n = points.neighborhoodList[points.neighborhoodStart[point]];
      const double left = std::accumulate(&points.interactionShare[first], &points.interactionShare[first] + n, 0.0);
      ofBond = std::copy_n(&points.interactionShare[first], n, ofBond);
      if (hasField("Damage") && block.getDamageModel().is_null() && points.countedBonds[point] > 0.0)
        field("Damage")[point] = 1.0 - left / points.countedBonds[point];
    }
  }
}

void Model::cutBonds(const Deck& deck) {
  if (discretization_.bondIsCut.empty()) return;
  for (Block& block : *blocks_) {
    const auto neighborhood = block.getNeighborhoodData();
    const bool hasBondDamage = FieldManager::self().hasField("Bond_Damage") &&
                               block.hasData(FieldManager::self().getFieldId("Bond_Damage"), PeridigmField::STEP_NP1);
    const bool hasDamage = hasField("Damage") && block.getDamageModel().is_null();
    long long bond = 0;
    for (int k = 0; k < neighborhood->NumOwnedPoints(); ++k) {
      const int point = neighborhood->OwnedIDs()[k];
      const long long first = discretization_.neighborhoodStart[point] - point;
      const int nNeighbors = discretization_.neighborhoodList[discretization_.neighborhoodStart[point]];
      int nCut = 0;
      for (int n = 0; n < nNeighbors; ++n, ++bond) {
        if (!discretization_.bondIsCut[first + n]) continue;
        ++nCut;
        if (!hasBondDamage)
          throw DeckError(deck["Discretization"]["Bond Filters"].place() + ": bonds of " + block.getName() +
                          " are to be kept as broken (`Count In Damage: true`), but neither its material nor a damage "
                          "model knows broken bonds; give the block a damage model or set `Count In Damage: false`");
        (*block.getData(FieldManager::self().getFieldId("Bond_Damage"), PeridigmField::STEP_NP1))[bond] = 1.0;
      }
      if (hasDamage && nCut > 0) field("Damage")[point] = static_cast<double>(nCut) / nNeighbors;
    }
  }
}

void Model::initialize() {
  std::set<int> toSynchronise;
  const auto note = [&](const std::vector<int>& ids) { toSynchronise.insert(ids.begin(), ids.end()); };
  for (const FieldSpec& spec : FieldManager::self().getFieldSpecs())
    if (hasField(spec.label) && spec.relation != PeridigmField::GLOBAL) fillImages(spec.label);
  if (hasField("Displacement")) updateCoordinates();
  collectively(comm_, [&] {
    const Timers::Scope timer(timers_, "initialization");
    for (Block& block : *blocks_) {
      const auto points = block.getNeighborhoodData();
      const auto call = [&](auto&& plugin) {
        if (points->NumOwnedPoints() > 0)
          plugin->initialize(0.0, points->NumOwnedPoints(), points->OwnedIDs(), points->NeighborhoodList(),
                             *block.getDataManager());
      };
      call(block.getMutableMaterialModel());
      if (!block.getDamageModel().is_null()) call(block.getDamageModel());
    }
  });
  for (Block& block : *blocks_) {
    forEachPlugin(block, [&](const auto& plugin) { note(plugin.FieldIdsForSynchronizationAfterInitialize()); });
  }
  synchronise({toSynchronise.begin(), toSynchronise.end()});
  adoptState();
  evaluateDamage(0.0);
  if (hasMechanics() && !isAtRest(*this)) evaluateForce(0.0);  // else they stay zero, as they were allocated
  for (const std::string& label : summedFields(*blocks_))
    if (label != "Force_Density") evaluateFluxDivergence(0.0, label);
  restoreHistories();
}

std::vector<std::string> Model::notes() const {
  std::string own;
  for (Block& block : *blocks_)
    forEachPlugin(block, [&](const auto& plugin) {
      if (const auto* notes = dynamic_cast<const RunNotes*>(&plugin))
        for (const std::string& line : notes->runNotes()) own += line + "\n";
    });
  std::istringstream lines(comm_.gather(own));
  std::vector<std::string> found;
  for (std::string line; std::getline(lines, line);)
    if (std::find(found.begin(), found.end(), line) == found.end()) found.push_back(line);
  return found;
}

Teuchos::RCP<FieldVector> Model::vector(const std::string& label, bool atN) const {
  if (!hasField(label))
    throw std::invalid_argument("no plug-in, solver or output of this run uses a point field \"" + label + "\"");
  const FieldSpec spec = FieldManager::self().getFieldSpec(label);
  if (spec.temporal == PeridigmField::CONSTANT) return shared_->getData(spec.id, PeridigmField::STEP_NONE);
  return shared_->getData(spec.id, atN ? PeridigmField::STEP_N : PeridigmField::STEP_NP1);
}

bool Model::hasField(const std::string& label) const {
  auto& fields = FieldManager::self();
  if (!fields.hasField(label)) return false;
  const FieldSpec spec = fields.getFieldSpec(label);
  if (spec.relation == PeridigmField::BOND) return false;
  return shared_->hasData(
      spec.id, spec.temporal == PeridigmField::CONSTANT ? PeridigmField::STEP_NONE : PeridigmField::STEP_NP1);
}

double* Model::field(const std::string& label) {
  double* values = nullptr;
  vector(label, false)->ExtractView(&values);
  return values;
}

double* Model::fieldAtN(const std::string& label) {
  double* values = nullptr;
  vector(label, true)->ExtractView(&values);
  return values;
}

int Model::fieldWidth(const std::string& label) const {
  return PeridigmField::variableDimension(FieldManager::self().getFieldSpec(label).length);
}

bool Model::hasDamage() const {
  return std::any_of(blocks_->begin(), blocks_->end(), [](Block& block) { return !block.getDamageModel().is_null(); });
}

double Model::dot(const double* a, const double* b, int width) const {
  double sum = 0.0;
  const long long n = static_cast<long long>(width) * discretization_.nOwned;
  for (long long i = 0; i < n; ++i) sum += a[i] * b[i];
  return comm_.sum(sum);
}

std::size_t Model::bondBytes() const {
  std::size_t bytes = discretization_.neighborhoodList.capacity() * sizeof(int) +
                      discretization_.neighborhoodStart.capacity() * sizeof(long long) +
                      discretization_.bondIsCut.capacity();
  for (Block& block : *blocks_) bytes += block.getNeighborhoodData()->bytes() + block.getDataManager()->bondBytes();
  return bytes;
}

}  // namespace pd
