#include "small_body.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "plugins.hpp"

namespace pdtest {

using namespace PeridigmNS;
using PeridigmField::STEP_NONE;
using PeridigmField::STEP_NP1;

std::vector<Point> lattice(int nx, int ny, int nz, double spacing, Point origin) {
  std::vector<Point> points;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        points.push_back({origin[0] + i * spacing, origin[1] + j * spacing, origin[2] + k * spacing});
  return points;
}

namespace {

bool areNeighbors(const Point& a, const Point& b, double horizon) {
  return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]) <= horizon * (1.0 + 1e-10);
}

int fieldId(PeridigmField::Relation relation, PeridigmField::Length length, PeridigmField::Temporal temporal,
            const char* label) {
  return FieldManager::self().getFieldId(relation, length, temporal, label);
}

}  // namespace

SmallBody::SmallBody(const std::vector<Point>& points, BodyOptions options)
    : points_(points),
      volumes_(options.volumes.empty() ? std::vector<double>(points.size(), 1.0) : options.volumes),
      blocks_(Teuchos::rcp(new std::vector<Block>)),
      nodeSets_(Teuchos::rcp(new Discretization::NodeSets)),
      discretization_(Teuchos::rcp(new Discretization(nodeSets_))),
      globalData_(Teuchos::rcp(new Teuchos::ParameterList)) {
  const int n = static_cast<int>(points.size());
  std::set<int> blockIds;
  for (int g = 0; g < n; ++g) blockIds.insert(options.blockOf(g));
  for (const bool owned : {true, false})
    for (int g = 0; g < n; ++g)
      if (options.isOwned(g) == owned) globalIds_.push_back(g);
  nOwned_ = static_cast<int>(std::count_if(globalIds_.begin(), globalIds_.end(), options.isOwned));

  const auto overlapMap = Teuchos::rcp(new PointMap(globalIds_));
  const auto ownedMap = Teuchos::rcp(new PointMap(std::vector<int>(globalIds_.begin(), globalIds_.begin() + nOwned_)));
  for (const int id : blockIds) {
    std::vector<int> ownedIds, list;
    for (int i = 0; i < nOwned_; ++i) {
      if (options.blockOf(globalId(i)) != id) continue;
      ownedIds.push_back(i);
      std::vector<int> neighbors;
      for (int j = 0; j < n; ++j)
        if (j != i && areNeighbors(point(i), point(j), options.horizon)) neighbors.push_back(j);
      list.push_back(static_cast<int>(neighbors.size()));
      list.insert(list.end(), neighbors.begin(), neighbors.end());
    }
    const int nBonds = static_cast<int>(list.size() - ownedIds.size());
    Block block("block_" + std::to_string(id), id);
    block.setNeighborhoodData(Teuchos::rcp(new NeighborhoodData(ownedIds, list)));
    block.setDataManager(Teuchos::rcp(new DataManager));
    block.getDataManager()->setMaps(ownedMap, overlapMap, nBonds);
    if (options.bondSteps == BondSteps::Swapped) block.getDataManager()->swapBondSteps();
    if (options.bondSteps == BondSteps::Shared)
      block.getDataManager()->shareSteps(
          {fieldId(PeridigmField::BOND, PeridigmField::SCALAR, PeridigmField::TWO_STEP, "Bond_Damage")});
    if (!blocks_->empty()) block.getDataManager()->sharePointData(*blocks_->front().getDataManager());
    blocks_->push_back(block);
  }
  globalData_->set("discretization", &discretization_);

  if (options.isBare) return;
  using namespace PeridigmField;
  allocate({fieldId(ELEMENT, SCALAR, CONSTANT, "Volume"), fieldId(NODE, VECTOR, CONSTANT, "Model_Coordinates"),
            fieldId(NODE, VECTOR, TWO_STEP, "Coordinates")});
}

void SmallBody::allocate(const std::vector<int>& fieldIds) {
  const bool wasDeformed = hasField("Coordinates");
  for (Block& block : *blocks_) block.getDataManager()->allocateData(fieldIds);
  for (int i = 0; i < nPoints(); ++i) {
    if (hasField("Volume")) field("Volume")[i] = volumes_[static_cast<std::size_t>(globalId(i))];
    if (hasField("Model_Coordinates")) std::copy(point(i).begin(), point(i).end(), field("Model_Coordinates") + 3 * i);
  }
  if (!wasDeformed) deform([](const Point& x) { return x; });
}

bool SmallBody::hasField(const std::string& label) {
  if (!FieldManager::self().hasField(label)) return false;
  const int id = FieldManager::self().getFieldId(label);
  return block().hasData(id, STEP_NONE) || block().hasData(id, STEP_NP1);
}

double* SmallBody::field(const std::string& label, std::size_t b) {
  const int id = FieldManager::self().getFieldId(label);
  double* values = nullptr;
  block(b).getData(id, block(b).hasData(id, STEP_NONE) ? STEP_NONE : STEP_NP1)->ExtractView(&values);
  return values;
}

void SmallBody::deform(const std::function<Point(const Point&)>& map) {
  for (int i = 0; i < nPoints(); ++i) {
    const Point y = map(point(i));
    for (int k = 0; k < 3; ++k) {
      const std::size_t axis = static_cast<std::size_t>(k);
      if (hasField("Coordinates")) field("Coordinates")[3 * i + k] = y[axis];
      if (hasField("Displacement")) field("Displacement")[3 * i + k] = y[axis] - point(i)[axis];
    }
  }
}

void SmallBody::breakBonds(const std::function<bool(const Point&, const Point&)>& isBroken) {
  using namespace PeridigmField;
  const int id = fieldId(BOND, SCALAR, TWO_STEP, "Bond_Damage");
  allocate({id});
  for (std::size_t b = 0; b < blocks_->size(); ++b) {
    const auto neighborhood = block(b).getNeighborhoodData();
    const int* list = neighborhood->NeighborhoodList();
    FieldVector& now = *block(b).getData(id, STEP_NP1);
    FieldVector& before = *block(b).getData(id, PeridigmField::STEP_N);
    int bond = 0;
    for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i)
      for (int n = *list++; n > 0; --n, ++list, ++bond)
        if (isBroken(point(neighborhood->OwnedIDs()[i]), point(*list))) now[bond] = before[bond] = 1.0;
  }
}

Teuchos::RCP<Compute> makeCompute(SmallBody& body, const std::string& name, const Teuchos::ParameterList& parameters,
                                  Teuchos::RCP<const Epetra_Comm> comm) {
  const auto compute = pd::ComputeRegistry::self().create(name, Teuchos::rcp(new Teuchos::ParameterList(parameters)),
                                                          comm, body.globalData());
  body.allocate(compute->FieldIds());
  compute->initialize(body.blocks());
  return compute;
}

}  // namespace pdtest
