// Exit code: number of things that a host should find and does not.
#include <iostream>
#include <stdexcept>

#include "factories.hpp"

namespace {

int nMistakes = 0;

void expect(bool isTrue, const char* what) {
  if (isTrue) return;
  std::cerr << "not true: " << what << "\n";
  ++nMistakes;
}

bool isHosts(const Teuchos::RCP<PeridigmNS::Compute>& compute) {
  return dynamic_cast<const HostCompute*>(compute.get()) != nullptr;
}

}  // namespace

int main() {
  Teuchos::ParameterList steel;
  steel.set("Material Model", std::string("PDHE"));
  steel.set("Young's Modulus", 200e9);
  steel.set("Poisson's Ratio", 0.2);
  steel.set("Density", 7800.0);
  steel.set("Horizon", 0.003);
  const auto material = createMaterial(steel);
  expect(!material.is_null() && material->Name() == "PDHE", "PDHE is registered");

  Teuchos::ParameterList hydrogen;
  hydrogen.set("Damage Model", std::string("Hydrogen Critical Stretch"));
  hydrogen.set("Critical Stretch", 0.01);
  hydrogen.set("Saturation Concentration", 1.0);
  const auto damage = createDamageModel(hydrogen);
  expect(!damage.is_null() && damage->Name() == "Hydrogen Critical Stretch", "the damage models are registered");

  expect(createDamageModel(hydrogen).get() == damage.get(), "a damage model of the same parameters is made once");
  hydrogen.set("Critical Stretch", 0.02);
  expect(createDamageModel(hydrogen).get() != damage.get(), "one of other parameters is another one");

  steel.set("Material Model", std::string("Viscoelastic"));
  hydrogen.set("Damage Model", std::string("Johnson Cook"));
  expect(createMaterial(steel).is_null() && createDamageModel(hydrogen).is_null(), "other names stay the host's");

  // Cracks and voids are a part of a material here.
  Teuchos::ParameterList porous;
  porous.set("Material Model", std::string("Combined"));
  porous.set("Materials", Teuchos::Array<std::string>(std::vector<std::string>{"Steel", "Gaps"}));
  porous.set("Horizon", 0.003);
  porous.sublist("Steel") = steel;
  porous.sublist("Steel").set("Material Model", std::string("PDHE"));
  porous.sublist("Gaps").set("Material Model", std::string("Bond Decomposition"));
  auto& pore = porous.sublist("Gaps").sublist("Voids").sublist("Pore");
  pore.set("Type", std::string("Sphere"));
  pore.set("Center", Teuchos::Array<double>(3, 0.0));
  const auto isRefused = [&] {
    try {
      return createMaterial(porous).is_null();
    } catch (const std::invalid_argument&) {
      return true;
    }
  };
  expect(isRefused(), "a sphere without a radius is refused");
  pore.set("Radius", 1.0e-3);
  expect(!isRefused(), "cracks and voids are registered");
  porous.sublist("Gaps").set("Cell Volume", 1.0e-9);
  expect(isRefused(), "neighbours beyond the horizon by volumes of material are refused");
  porous.sublist("Steel").set("Volume Correction", std::string("Ramp To Horizon"));
  expect(!isRefused(), "with none beyond the horizon it is right");

  // Expressions are read here, too, by the library that the plug-ins bring along.
  Teuchos::ParameterList electrolyte;
  electrolyte.set("Material Model", std::string("Corrosion Dissolution"));
  electrolyte.set("Horizon", 1.0e-5);
  electrolyte.set("Diffusivity", 8.6e-10);
  electrolyte.set("Solid Concentration", 142900.0);
  electrolyte.set("Saturation Concentration", 4000.0);
  electrolyte.set("Charge Number", 2.19);
  electrolyte.set("Current Density", std::string("value = 5.1e3*sqrt(1 - C/4.0);"));
  expect(!createMaterial(electrolyte).is_null(), "an expression that ends at saturation is one");
  electrolyte.set("Current Density", std::string("while (1) value = C;"));
  try {
    createMaterial(electrolyte);
    expect(false, "loops are refused");
  } catch (const std::invalid_argument&) {
  }

  // The host's own compute wins; names of fields are no computes; the others are this library's.
  const auto computes = createComputes({"Displacement", "Kinetic_Energy", "Damage", "Broken_Bonds", "Strain_Energy"});
  expect(computes.size() == 3, "three of the names are computes");
  expect(computes.size() == 3 && isHosts(computes[0]) && !isHosts(computes[1]) && !isHosts(computes[2]),
         "each compute is made once, by the one who knows it");
  return nMistakes;
}
