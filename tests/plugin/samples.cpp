#include "samples.hpp"

#include <Teuchos_Array.hpp>
#include <cmath>

namespace pdtest {

namespace {

constexpr double spacing = 0.5;
constexpr double thickness = 0.2;

Teuchos::ParameterList elastic(double poissonsRatio) {
  Teuchos::ParameterList list;
  list.set("Density", 2.0);
  list.set("Young's Modulus", 10.0);
  list.set("Poisson's Ratio", poissonsRatio);
  return list;
}

Teuchos::ParameterList diffusive(const char* kernel) {
  Teuchos::ParameterList list;
  list.set("Diffusivity", 3.0);
  list.set<std::string>("Diffusion Kernel", kernel);
  return list;
}

template <class Value>
Teuchos::ParameterList with(Teuchos::ParameterList list, const char* key, Value value) {
  list.set(key, value);
  return list;
}

Teuchos::ParameterList withText(Teuchos::ParameterList list, const char* key, const std::string& value) {
  return with(std::move(list), key, value);
}

Teuchos::ParameterList plate(Teuchos::ParameterList list, const char* plane) {
  return with(with(std::move(list), plane, true), "Thickness", thickness);
}

std::vector<Sample>& addedMaterials() {
  static std::vector<Sample> samples;
  return samples;
}

std::vector<Sample>& addedDamageModels() {
  static std::vector<Sample> samples;
  return samples;
}

struct PartSample {
  const char *name, *model;
  Teuchos::ParameterList parameters;
};

/// Parameters of "Combined", whose parts stand under `partsKey` ("Materials").
Teuchos::ParameterList combined(const char* partsKey, const char* modelKey, const std::vector<PartSample>& parts) {
  Teuchos::ParameterList list;
  Teuchos::Array<std::string> names;
  for (const PartSample& part : parts) {
    names.push_back(part.name);
    list.sublist(part.name) = withText(part.parameters, modelKey, part.model);
  }
  return with(list, partsKey, names);
}

Teuchos::Array<double> reals(const std::vector<double>& values) { return Teuchos::Array<double>(values); }

Teuchos::ParameterList gapsInAPlate() {
  Teuchos::ParameterList list;
  list.set("Thickness", thickness);
  list.sublist("Cracks").sublist("Slanting") =
      withText(with(Teuchos::ParameterList(), "Points", reals({0.9, 1.3, 2.2, 1.6})), "Type", "Polyline");
  list.sublist("Voids").sublist("Hole") =
      withText(with(with(Teuchos::ParameterList(), "Center", reals({2.6, 0.9})), "Radius", 0.2), "Type", "Circle");
  return list;
}

Teuchos::ParameterList gapsInASolid() {
  Teuchos::ParameterList list;
  list.set<std::string>("Rule", "Uniform");
  list.set("Partitions", 4);
  list.sublist("Cracks").sublist("Penny") = withText(
      with(with(with(Teuchos::ParameterList(), "Center", reals({1.2, 1.1, 1.3})), "Normal", reals({0.2, 0.1, 1.0})),
           "Radius", 0.8),
      "Type", "Disk");
  list.sublist("Voids").sublist("Pore") =
      withText(with(with(Teuchos::ParameterList(), "Center", reals({2.1, 0.6, 0.9})), "Radius", 0.2), "Type", "Sphere");
  return list;
}

}  // namespace

bool addMaterialSample(const Sample& sample) {
  addedMaterials().push_back(sample);
  return true;
}

bool addDamageSample(const Sample& sample) {
  addedDamageModels().push_back(sample);
  return true;
}

std::vector<Sample> materialSamples() {
  std::vector<Sample> samples{
      {"PlaneStress", "PDHE", 2, plate(elastic(0.29), "Plane Stress")},
      {"PlaneStressVolumeMethod", "PDHE", 2,
       withText(plate(elastic(0.1), "Plane Stress"), "Surface Correction", "Volume Method")},
      {"PlaneStrainEnergyMethod", "PDHE", 2,
       withText(plate(elastic(0.2), "Plane Strain"), "Surface Correction", "Energy Method")},
      {"BondBasedPlate", "PDHE", 2, plate(elastic(1.0 / 3.0), "Plane Stress")},
      {"LinearTangentialForce", "PDHE", 2, withText(plate(elastic(0.2), "Plane Stress"), "Tangential Force", "Linear")},
      {"RescaledPlate", "PDHE", 2, with(plate(elastic(0.2), "Plane Stress"), "Lattice Rescaling", true)},
      {"Solid", "PDHE", 3, withText(elastic(0.15), "Surface Correction", "Energy Method")},
      {"LatticeSolid", "PDHE", 3, withText(elastic(0.1), "Surface Correction", "Volume Method")},
      {"Bar", "PDHE", 1, with(with(elastic(0.25), "One Dimensional", true), "Cross Section Area", thickness)},
      {"DiffusionInAPlate", "PDHE", 2, plate(diffusive("Inverse Square"), "Plane Stress")},
      {"DiffusionOfTemperature", "PDHE", 3, withText(diffusive("Inverse"), "Diffusing Field", "Temperature")},
      {"DiffusionInABar", "PDHE", 1,
       with(with(diffusive("Constant"), "One Dimensional", true), "Cross Section Area", thickness)},
  };
  Teuchos::ParameterList both = plate(elastic(0.25), "Plane Strain");
  both.set("Diffusivity", 2.0);
  both.set("Diffusion Stops At Broken Bonds", true);
  samples.push_back({"MechanicsAndDiffusion", "PDHE", 2, both});
  samples.push_back({"LinearPeridynamicSolid", "Elastic", 3, elastic(0.35)});
  samples.push_back({"LinearSolidInPlaneStress", "Elastic", 2, plate(elastic(0.35), "Plane Stress")});
  samples.push_back({"LinearSolidInPlaneStrain", "Elastic", 2,
                     withText(plate(elastic(0.1), "Plane Strain"), "Volume Correction", "Ramp Beyond Horizon")});
  samples.push_back(
      {"LinearPeridynamicSolidRamp", "Elastic", 3, withText(elastic(0.1), "Volume Correction", "Ramp Beyond Horizon")});
  Teuchos::ParameterList bondBased = elastic(0.25);
  bondBased.remove("Poisson's Ratio");
  samples.push_back({"BondBasedOfPeridigm", "Elastic Bond Based", 3, bondBased});
  samples.push_back({"BondBasedPlateOfPeridigm", "Elastic Bond Based", 2,
                     with(with(bondBased, "Plane Stress", true), "Height", thickness)});
  Teuchos::ParameterList diffusion;
  diffusion.set("Coefficient", 3.0);
  samples.push_back({"DiffusionOfPeridigm", "Diffusion", 3, diffusion});
  samples.push_back({"DiffusionByFittedWeights", "Diffusion", 3, with(diffusion, "Use Improved Quadrature", true)});
  samples.back().conserves = false;
  Teuchos::ParameterList corrosion;
  corrosion.set("Diffusivity", 2.0);
  corrosion.set("Solid Concentration", 1.0);
  corrosion.set("Saturation Concentration", 0.4);
  corrosion.set("Charge Number", 2.0);
  corrosion.set<std::string>("Current Density", "1.0e5*exp(100.0*C)");
  samples.push_back({"Corrosion", "Corrosion Dissolution", 3, corrosion});
  samples.push_back({"CorrosionOfAPlate", "Corrosion Dissolution", 2, plate(corrosion, "Plane Strain")});
  Teuchos::ParameterList water;
  water.set("Density", 2.0);
  water.set("Viscosity", 0.3);
  for (const int dimension : {2, 3}) {
    samples.push_back(
        {dimension == 2 ? "FlowInThePlane" : "FlowInSpace", "Navier Stokes", dimension,
         dimension == 2 ? withText(plate(water, "Plane Strain"), "Viscous Kernel", "Transverse") : water});
    samples.back().conserves = false;  // nor need walls
  }
  Teuchos::ParameterList carried;
  carried.set("Diffusivity", 0.4);
  samples.push_back({"CarriedInThePlane", "Advection Diffusion", 2, plate(carried, "Plane Strain")});
  samples.push_back({"CarriedByUpwindEnds", "Advection Diffusion", 3,
                     with(withText(carried, "Scheme", "Upwind Biased"), "Upwind Share", 0.8)});
  const auto material = [](const std::vector<PartSample>& parts) {
    return combined("Materials", "Material Model", parts);
  };
  samples.push_back({"SteelAndElectrolyte", "Combined", 2,
                     material({{"Steel", "PDHE", plate(elastic(0.25), "Plane Strain")},
                               {"Electrolyte", "Corrosion Dissolution", plate(corrosion, "Plane Strain")}})});
  samples.push_back({"TwoSpringsAndTwoFluxes", "Combined", 2,
                     material({{"Stiff", "PDHE", plate(elastic(0.1), "Plane Strain")},
                               {"Soft", "PDHE", plate(both, "Plane Strain")},
                               {"Fast", "PDHE", plate(diffusive("Inverse"), "Plane Strain")}})});
  samples.push_back({"PlateWithACrackAndAHole", "Combined", 2,
                     material({{"Steel", "PDHE",
                                withText(plate(elastic(0.2), "Plane Strain"), "Surface Correction", "Energy Method")},
                               {"Gaps", "Bond Decomposition", gapsInAPlate()}})});
  samples.push_back({"SolidWithACrackAndAPore", "Combined", 3,
                     material({{"Steel", "Elastic", elastic(0.35)}, {"Gaps", "Bond Decomposition", gapsInASolid()}})});
  for (Sample& sample : samples) {
    sample.isUniform = sample.title == "RescaledPlate" || sample.title == "LatticeSolid";
    if (sample.title == "LinearTangentialForce") sample.isObjective = sample.conservesAngularMomentum = false;
  }
  samples.insert(samples.end(), addedMaterials().begin(), addedMaterials().end());
  return samples;
}

std::vector<Sample> damageSamples() {
  Teuchos::ParameterList stretch;
  stretch.set("Critical Stretch", 0.04);
  Teuchos::ParameterList energy = plate(elastic(1.0 / 3.0), "Plane Stress");
  energy.remove("Density");
  energy.remove("Thickness");
  energy.set("Fracture Energy", 0.01);
  energy.set("Horizon", 2.015 * spacing);
  energy.set("Critical Compressive Stretch", 0.06);
  Teuchos::ParameterList hydrogen = with(stretch, "Saturation Concentration", 0.8);
  Teuchos::ParameterList polynomial = withText(hydrogen, "Degradation Law", "Polynomial");
  Teuchos::Array<double> coefficients(2);
  coefficients[0] = 1.0;
  coefficients[1] = -0.5;
  polynomial.set("Polynomial", coefficients);
  const auto nodal = [](const char* title, const char* plugin, int dimension, Teuchos::ParameterList list) {
    list.remove("Density");
    list.set("Fracture Energy", 0.05);
    list.set("Horizon", 2.015 * spacing);
    Sample sample{title, plugin, dimension, list};
    sample.seesItsStep = true;
    return sample;
  };
  const Teuchos::ParameterList coverage = with(plate(elastic(0.2), "Plane Strain"), "Saturation Concentration", 0.8);
  Sample dissolution{"Dissolution", "Dissolution", 2, Teuchos::ParameterList()};
  dissolution.breaksBonds = false;
  const auto model = [](const std::vector<PartSample>& parts) {
    return combined("Damage Models", "Damage Model", parts);
  };
  Teuchos::ParameterList life;
  life.set("Initiation Coefficient", 60.0);
  life.set("Initiation Exponent", 2.0);
  life.set("Growth Coefficient", 200.0);
  life.set("Growth Exponent", 2.0);
  life.set("Growth Damage", 0.25);
  life.set("Cycles Per Step", 2.0);
  const Teuchos::ParameterList initiation = [&] {
    Teuchos::ParameterList list = with(with(life, "Load Ratio", -0.5), "Critical Stretch", 0.09);
    list.remove("Growth Coefficient");
    list.remove("Growth Exponent");
    return list;
  }();
  const Teuchos::ParameterList cumulative = [] {
    Teuchos::ParameterList list;
    list.set("Ductility Coefficient", 0.08);
    list.set("Ductility Exponent", -0.5);
    list.set("Strain Limit", 0.004);
    list.set("Growth Damage", 0.25);
    list.set("Cycles Per Step", 2.0);
    return list;
  }();
  Sample growing{"CumulativeFatigue", "Cumulative Fatigue", 2, cumulative};
  growing.isUniform = true;
  growing.parameters = plate(growing.parameters, "Plane Stress");
  growing.parameters.set("Cycles Per Step", 6.0);
  growing.parameters.set("Element Length", 0.2);
  growing.parameters.set("Yield Stress", 0.05);
  growing.parameters.set("Young's Modulus", 1.0);
  growing.parameters.set("Poisson's Ratio", 1.0 / 3.0);
  growing.parameters.set("Spacing", spacing);
  growing.parameters.set("Horizon", 2.015 * spacing);
  const Teuchos::ParameterList scattered = [&] {
    Teuchos::ParameterList list = withText(cumulative, "Strain Measure", "Range");
    list.set<std::string>("Scatter Between", "Bonds");
    list.set("Random Seed", 5);
    list.set("Scatter Of Limit", 0.2);
    list.set("Scatter Of Ductility", 0.3);
    list.set("Scatter Of Exponent", 0.05);
    return list;
  }();
  const Sample wearAndTear{
      "BreakageAndDissolution", "Combined", 2,
      model({{"Breakage", "Critical Stretch", stretch}, {"Dissolution", "Dissolution", Teuchos::ParameterList()}})};
  std::vector<Sample> samples{
      {"Plate", "Critical Stretch", 2, stretch},
      {"Solid", "Critical Stretch", 3, stretch},
      {"FromFractureEnergy", "Critical Stretch", 2, energy},
      {"Hydrogen", "Hydrogen Critical Stretch", 2, hydrogen},
      {"HydrogenInASolid", "Hydrogen Critical Stretch", 3, withText(hydrogen, "Degradation Law", "Fracture Energy")},
      {"HydrogenPolynomial", "Hydrogen Critical Stretch", 2, polynomial},
      nodal("NodalEnergy", "Nodal Energy", 2, plate(elastic(1.0 / 3.0), "Plane Stress")),
      nodal("NodalEnergyOfTwoParameters", "Nodal Energy", 2,
            with(plate(elastic(0.1), "Plane Stress"), "Lattice Rescaling", true)),
      nodal("NodalEnergyOfASolid", "Nodal Energy", 3, withText(elastic(0.2), "Volume Correction", "Ramp To Horizon")),
      nodal("NodalEnergyWithHydrogen", "Hydrogen Nodal Energy", 2, coverage),
      {"Bilinear", "Bilinear", 2, stretch},
      {"RemainingLife", "Remaining Life", 2, life},
      {"RemainingLifeBeforeACrack", "Remaining Life", 3, initiation},
      growing,
      {"CumulativeFatigueThatScatters", "Cumulative Fatigue", 3, scattered},
      dissolution,
      {"TwoLimits", "Combined", 2,
       model({{"Steel", "Critical Stretch", with(stretch, "Critical Compressive Stretch", 0.06)},
              {"Hydrogen", "Hydrogen Critical Stretch", hydrogen}})},
      wearAndTear,
  };
  samples.insert(samples.end(), addedDamageModels().begin(), addedDamageModels().end());
  return samples;
}

double noise(int globalId, int salt) {
  auto bits = static_cast<unsigned>(globalId) * 2654435761u + static_cast<unsigned>(salt) * 40503u + 12345u;
  bits = (bits ^ (bits >> 15)) * 2246822519u;
  bits = (bits ^ (bits >> 13)) * 3266489917u;
  bits ^= bits >> 16;
  return 2.0 * bits / 4294967295.0 - 1.0;
}

Scene sceneOf(const Sample& sample) {
  Scene scene;
  scene.horizon = 2.015 * spacing;
  scene.reach = scene.horizon + 0.5 * spacing;
  double volume = std::pow(spacing, sample.dimension);
  if (sample.dimension == 1) {
    scene.points = lattice(12, 1, 1, spacing);
    volume *= thickness;
  } else if (sample.dimension == 2) {
    scene.points = lattice(8, 7, 1, spacing);
    volume *= thickness;
  } else {
    scene.points = lattice(6, 5, 5, spacing);
  }
  scene.volumes.assign(scene.points.size(), volume);
  if (sample.isUniform) return scene;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    for (int axis = 0; axis < sample.dimension; ++axis)
      scene.points[i][static_cast<std::size_t>(axis)] += 0.1 * spacing * noise(static_cast<int>(i), axis);
    scene.volumes[i] *= 1.0 + 0.1 * noise(static_cast<int>(i), 7);
  }
  return scene;
}

Teuchos::ParameterList parametersOf(const Sample& sample) {
  return with(sample.parameters, "Horizon", sceneOf(sample).horizon);
}

}  // namespace pdtest
