#include "life_scatter.hpp"

#include <cmath>
#include <stdexcept>

namespace pd {

namespace {

const char* const keys[] = {"Scatter Of Limit", "Scatter Of Ductility", "Scatter Of Exponent"};

double deviation(const Teuchos::ParameterList& params, const char* key) {
  return params.isParameter(key) ? params.get<double>(key) : 0.0;
}

}  // namespace

void LifeScatter::declareParameters(ParameterDeclarations& declare) {
  constexpr double largest = 2.0;  // a factor of seven and a half either way, one time in three beyond it
  declare
      .text("Scatter Between",
            "What has constants of its own. Specimens: a run, by its Random Seed. Bonds: each bond of it; the weakest "
            "of many then fails first, so that lives fall with their number, finer points included.")
      .oneOf({"Specimens", "Bonds"});
  declare.real(keys[0], "1", "Standard deviation of the natural logarithm of the Strain Limit, whose median is given.")
      .positive()
      .atMost(largest);
  declare.real(keys[1], "1", "The same of the Ductility Coefficient.").positive().atMost(largest);
  declare.real(keys[2], "1", "The same of the Ductility Exponent.").positive().atMost(largest);
  declare
      .integer("Random Seed",
               "Number of the specimen: each has its own numbers, the same on any number of ranks and after restarts.")
      .atLeast(0);
  declare.needs("Scatter Between", {"Random Seed"});
  declare.needs("Random Seed", {"Scatter Between"});
  for (const char* key : keys) declare.needs(key, {"Scatter Between"});
}

LifeScatter::LifeScatter(const Teuchos::ParameterList& params, const std::string& owner)
    : limit_(deviation(params, keys[0])),
      ductility_(deviation(params, keys[1])),
      exponent_(deviation(params, keys[2])) {
  if (!params.isParameter("Scatter Between")) return;
  if (limit_ + ductility_ + exponent_ == 0.0)
    throw std::invalid_argument(owner + ": \"Scatter Between\" of what? Give " +
                                quotedList({keys[0], keys[1], keys[2]}) + " or some of them");
  between_ = params.get<std::string>("Scatter Between") == "Bonds" ? Between::Bonds : Between::Specimens;
  seed_ = static_cast<std::uint32_t>(params.get<int>("Random Seed"));
}

kernels::StrainLife LifeScatter::drawn(const kernels::StrainLife& median, const kernels::Normals& normals) const {
  kernels::StrainLife own = median;
  own.limit *= std::exp(limit_ * normals[0]);
  own.ductility *= std::exp(ductility_ * normals[1]);
  own.exponent *= std::exp(exponent_ * normals[2]);
  return own;
}

kernels::StrainLife LifeScatter::ofSpecimen(const kernels::StrainLife& median) const {
  return isBetweenSpecimens() ? drawn(median, kernels::bodyNormals(seed_)) : median;
}

kernels::StrainLife LifeScatter::ofBond(const kernels::StrainLife& median, int firstId, int secondId, int shift) const {
  return isBetweenBonds() ? drawn(median, kernels::bondNormals(seed_, firstId, secondId, shift)) : median;
}

}  // namespace pd
