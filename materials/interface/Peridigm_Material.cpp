#include "Peridigm_Material.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "Peridigm_DegreesOfFreedomManager.hpp"
#include "fields.hpp"

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

/// An unknown of which the material gives the rate.
struct Probed {
  int value, rate;  ///< fields
  int width, offset;
  bool isForce;
};

/// Of the unknowns that the host solves for.
std::vector<Probed> probedFields(const Material& material) {
  const auto& unknowns = DegreesOfFreedomManager::self();
  const pd::FieldTable table = pd::fieldsIn(material);
  const std::vector<int> sums = table.sums();
  std::vector<Probed> result;
  for (const auto& [field, width] : unknowns.unknowns()) {
    const bool isForce = field == pd::fields::displacement().label;
    const int force = pd::fields::forceDensity().id();
    const int ofForce = std::find(sums.begin(), sums.end(), force) != sums.end() ? force : -1;
    const int rate = isForce ? ofForce : table.rateOf(field);
    if (rate < 0) continue;
    const int value = isForce ? pd::fields::coordinates().id() : FieldManager::self().getFieldId(field);
    result.push_back({value, rate, width, unknowns.offsetOf(field), isForce});
  }
  return result;
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
  const bool central = scheme == CENTRAL_DIFFERENCE;
  const int perPoint = DegreesOfFreedomManager::self().totalNumberOfDegreesOfFreedom();
  const std::vector<Probed> unknowns = probedFields(*this);
  const int volumeField = pd::fields::volume().id();

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
    const auto volume = family.data.getData(volumeField, PeridigmField::STEP_NONE);

    /// Rates of all unknowns, [n].
    const auto evaluate = [&] {
      const auto isForce = [](const Probed& unknown) { return unknown.isForce; };
      if (std::any_of(unknowns.begin(), unknowns.end(), isForce))
        computeForce(dt, 1, &zero, family.list(), family.data);
      if (!std::all_of(unknowns.begin(), unknowns.end(), isForce))
        computeFluxDivergence(dt, 1, &zero, family.list(), family.data);
      std::vector<double> rates(static_cast<std::size_t>(n), 0.0);
      for (const Probed& unknown : unknowns) {
        const auto rate = family.data.getData(unknown.rate, PeridigmField::STEP_NP1);
        for (int i = 0; i < rate->MyLength(); ++i)
          rates[static_cast<std::size_t>((i / unknown.width) * perPoint + unknown.offset + i % unknown.width)] =
              (*rate)[i];
      }
      return rates;
    };
    for (const Probed& unknown : unknowns) {
      const auto value = family.data.getData(unknown.value, PeridigmField::STEP_NP1);
      for (int i = 0; i < value->MyLength(); ++i) {
        const double old = (*value)[i];
        (*value)[i] = central ? old - probe : old;
        const std::vector<double> low = evaluate();
        (*value)[i] = old + probe;
        const std::vector<double> high = evaluate();
        (*value)[i] = old;
        const int column = (i / unknown.width) * perPoint + unknown.offset + i % unknown.width;
        for (int row = 0; row < n; ++row)
          at(row, column) = (high[static_cast<std::size_t>(row)] - low[static_cast<std::size_t>(row)]) /
                            (central ? 2.0 * probe : probe) * (*volume)[row / perPoint];
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
