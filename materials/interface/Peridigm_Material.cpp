#include "Peridigm_Material.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "Peridigm_DegreesOfFreedomManager.hpp"
#include "field_names.hpp"

namespace PeridigmNS {

Material::Material(const Teuchos::ParameterList& params) {
  if (params.isParameter("Finite Difference Probe Length"))
    m_finiteDifferenceProbeLength = params.get<double>("Finite Difference Probe Length");
}

double Material::lookupMaterialProperty(const std::string keyname) const {
  throw std::invalid_argument("material \"" + Name() + "\" has no property \"" + keyname + "\"");
}

namespace {

/// The elastic constants that a list gives; exactly two are needed.
struct GivenConstants {
  explicit GivenConstants(const Teuchos::ParameterList& params) {
    int count = 0;
    const auto read = [&](const char* name, double& value) {
      if (!params.isParameter(name)) return false;
      value = params.get<double>(name);
      ++count;
      return true;
    };
    hasBulk = read("Bulk Modulus", bulk);
    hasShear = read("Shear Modulus", shear);
    hasYoung = read("Young's Modulus", young);
    hasPoisson = read("Poisson's Ratio", poisson);
    if (count != 2)
      throw std::invalid_argument(
          "give exactly two of \"Bulk Modulus\", \"Shear Modulus\", \"Young's Modulus\", \"Poisson's Ratio\"");
  }
  bool hasBulk, hasShear, hasYoung, hasPoisson;
  double bulk = 0.0, shear = 0.0, young = 0.0, poisson = 0.0;
};

}  // namespace

double Material::calculateBulkModulus(const Teuchos::ParameterList& params) const {
  const GivenConstants c(params);
  if (c.hasBulk) return c.bulk;
  if (c.hasYoung && c.hasPoisson) return c.young / (3.0 * (1.0 - 2.0 * c.poisson));
  if (c.hasYoung) return c.young * c.shear / (3.0 * (3.0 * c.shear - c.young));
  return 2.0 * c.shear * (1.0 + c.poisson) / (3.0 * (1.0 - 2.0 * c.poisson));
}

double Material::calculateShearModulus(const Teuchos::ParameterList& params) const {
  const GivenConstants c(params);
  if (c.hasShear) return c.shear;
  if (c.hasYoung && c.hasPoisson) return c.young / (2.0 * (1.0 + c.poisson));
  if (c.hasYoung) return 3.0 * c.bulk * c.young / (9.0 * c.bulk - c.young);
  return 3.0 * c.bulk * (1.0 - 2.0 * c.poisson) / (2.0 * (1.0 + c.poisson));
}

void Material::computeJacobian(const double dt, const int numOwnedPoints, const int* ownedIDs,
                               const int* neighborhoodList, DataManager& dataManager, SerialMatrix& jacobian,
                               JacobianType jacobianType) const {
  computeFiniteDifferenceJacobian(dt, numOwnedPoints, ownedIDs, neighborhoodList, dataManager, jacobian,
                                  CENTRAL_DIFFERENCE, jacobianType);
}

namespace {

/// The scalar field whose flux divergence is among the fields of a material; Peridigm's Temperature where there is
/// none.
std::string diffusingField(const std::vector<int>& fieldIds) {
  FieldManager& fields = FieldManager::self();
  const auto isUsed = [&](const std::string& label) {
    return fields.hasField(label) &&
           std::find(fieldIds.begin(), fieldIds.end(), fields.getFieldId(label)) != fieldIds.end();
  };
  for (const int id : fieldIds) {
    const std::string label = fields.getFieldSpec(id).label;
    if (isUsed(pd::fluxDivergenceField(label))) return label;
  }
  return "Temperature";
}

/// One point with its neighbours, in a DataManager of its own: local id 0 is the point, k its k-th neighbour.
class Family {
 public:
  Family(int point, int nNeighbors, const int* neighbors, int firstBond, DataManager& source) {
    ids_.push_back(point);
    list_.push_back(nNeighbors);
    for (int k = 0; k < nNeighbors; ++k) {
      ids_.push_back(neighbors[k]);
      list_.push_back(k + 1);
    }
    for (const int id : ids_) globalIds.push_back(source.getOverlapScalarPointMap()->GID(id));
    const auto map = Teuchos::rcp(new PointMap(globalIds));
    data.setMaps(Teuchos::null, map, nNeighbors);  // no owned points, as in Peridigm
    const std::vector<int> fieldIds = source.getFieldIds();
    data.allocateData(fieldIds);
    for (const int fieldId : fieldIds) copyField(fieldId, firstBond, source);
  }

  int size() const { return static_cast<int>(ids_.size()); }
  const int* list() const { return list_.data(); }

  DataManager data;
  std::vector<int> globalIds;

 private:
  void copyField(int fieldId, int firstBond, DataManager& source) {
    const FieldSpec spec = FieldManager::self().getFieldSpec(fieldId);
    const int width = PeridigmField::variableDimension(spec.length);
    const auto copy = [&](PeridigmField::Step step) {
      const auto from = source.getData(fieldId, step), to = data.getData(fieldId, step);
      for (int i = 0; i < to->MyLength(); ++i) {
        const int place = i / width, component = i % width;
        int at = place;
        if (spec.relation == PeridigmField::BOND)
          at = firstBond + place;
        else if (spec.relation != PeridigmField::GLOBAL)
          at = ids_[static_cast<std::size_t>(place)];
        (*to)[i] = (*from)[at * width + component];
      }
    };
    if (spec.temporal == PeridigmField::CONSTANT) {
      copy(PeridigmField::STEP_NONE);
      return;
    }
    copy(PeridigmField::STEP_NP1);
    copy(PeridigmField::STEP_N);
  }

  std::vector<int> ids_, list_;
};

}  // namespace

void Material::computeFiniteDifferenceJacobian(const double dt, const int numOwnedPoints, const int* ownedIDs,
                                               const int* neighborhoodList, DataManager& dataManager,
                                               SerialMatrix& jacobian, FiniteDifferenceScheme scheme,
                                               JacobianType jacobianType) const {
  if (m_finiteDifferenceProbeLength == DBL_MAX)
    throw std::invalid_argument("material \"" + Name() +
                                "\": a tangent by finite differences needs \"Finite Difference Probe Length\"");
  const double probe = m_finiteDifferenceProbeLength;
  const auto& unknowns = DegreesOfFreedomManager::self();
  const int perPoint = unknowns.totalNumberOfDegreesOfFreedom();
  FieldManager& fields = FieldManager::self();
  const bool central = scheme == CENTRAL_DIFFERENCE;

  // Unknown field, its rate field, components, offset.
  struct Unknown {
    std::string field, rate;
    int components, offset;
  };
  std::vector<Unknown> kinds;
  if (unknowns.displacementTreatedAsUnknown())
    kinds.push_back({"Coordinates", "Force_Density", 3, unknowns.displacementDofOffset()});
  if (unknowns.temperatureTreatedAsUnknown()) {
    const std::string field = diffusingField(FieldIds());
    kinds.push_back({field, pd::fluxDivergenceField(field), 1, unknowns.temperatureDofOffset()});
  }

  const int* entry = neighborhoodList;
  int firstBond = 0;
  const int zero = 0;
  for (int p = 0; p < numOwnedPoints; ++p) {
    const int nNeighbors = *entry;
    Family family(ownedIDs[p], nNeighbors, entry + 1, firstBond, dataManager);
    entry += nNeighbors + 1;
    firstBond += nNeighbors;
    const int n = family.size() * perPoint;
    std::vector<double> block(static_cast<std::size_t>(n) * static_cast<std::size_t>(n), 0.0);
    const auto at = [&](int row, int column) -> double& {
      return block[static_cast<std::size_t>(row) * static_cast<std::size_t>(n) + static_cast<std::size_t>(column)];
    };
    const auto volume = family.data.getData(fields.getFieldId("Volume"), PeridigmField::STEP_NONE);

    for (const Unknown& kind : kinds) {
      const auto value = family.data.getData(fields.getFieldId(kind.field), PeridigmField::STEP_NP1);
      const auto rate = family.data.getData(fields.getFieldId(kind.rate), PeridigmField::STEP_NP1);
      const auto evaluate = [&] {
        if (kind.components == 3)
          computeForce(dt, 1, &zero, family.list(), family.data);
        else
          computeFluxDivergence(dt, 1, &zero, family.list(), family.data);
        std::vector<double> result(static_cast<std::size_t>(rate->MyLength()));
        for (int i = 0; i < rate->MyLength(); ++i) result[static_cast<std::size_t>(i)] = (*rate)[i];
        return result;
      };
      for (int i = 0; i < value->MyLength(); ++i) {
        const double old = (*value)[i];
        (*value)[i] = central ? old - probe : old;
        const std::vector<double> low = evaluate();
        (*value)[i] = old + probe;
        const std::vector<double> high = evaluate();
        (*value)[i] = old;
        const int column = (i / kind.components) * perPoint + kind.offset + i % kind.components;
        for (int r = 0; r < rate->MyLength(); ++r) {
          const int row = (r / kind.components) * perPoint + kind.offset + r % kind.components;
          at(row, column) = (high[static_cast<std::size_t>(r)] - low[static_cast<std::size_t>(r)]) /
                            (central ? 2.0 * probe : probe) * (*volume)[r / kind.components];
        }
      }
    }
    std::vector<int> indices;
    std::vector<const double*> rows;
    for (int i = 0; i < n; ++i) {
      indices.push_back(family.globalIds[static_cast<std::size_t>(i / perPoint)] * perPoint + i % perPoint);
      rows.push_back(&at(i, 0));
    }
    if (jacobianType == BLOCK_DIAGONAL)
      jacobian.addBlockDiagonalValues(n, indices.data(), rows.data());
    else
      jacobian.addValues(n, indices.data(), rows.data());
  }
}

}  // namespace PeridigmNS
