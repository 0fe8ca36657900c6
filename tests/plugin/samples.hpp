// What the contract of plug-ins is tested with: for every registered material and damage model a few parameter sets.
// A new plug-in adds its own, in samples.cpp or in a source of its own.
#ifndef PD_TESTS_SAMPLES_HPP
#define PD_TESTS_SAMPLES_HPP

#include <Teuchos_ParameterList.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "../support/small_body.hpp"

namespace pdtest {

struct Sample {
  std::string title;   ///< letters and digits
  std::string plugin;  ///< registered name
  int dimension;
  Teuchos::ParameterList parameters;  ///< without the horizon
  bool isUniform = false;             ///< needs a lattice without jitter
  // What a material claims beyond what all must keep.
  bool isObjective = true;  ///< forces turn with the body
  bool conservesAngularMomentum = true;
  bool breaksBonds = true;  ///< a damage model whose Damage counts them
  bool conserves = true;    ///< forces or fluxes add up to zero
  /// A damage model to which bonds that it has broken in a step count when it is called again in that step: then calls
  /// can be repeated at will only where N and NP1 are apart.
  bool seesItsStep = false;
};

std::vector<Sample> materialSamples();
std::vector<Sample> damageSamples();

/// Adds a sample, at start-up: `const bool isAdded = addDamageSample(...)` at file scope. True.
bool addMaterialSample(const Sample& sample);
bool addDamageSample(const Sample& sample);

/// What GoogleTest prints of a sample.
inline void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.plugin << ", " << sample.title; }

/// A lattice of spacing 0.5, jittered unless it is to be uniform, with volumes to match.
struct Scene {
  std::vector<Point> points;
  std::vector<double> volumes;
  double horizon;  ///< of the plug-in
  double reach;    ///< longest bond: points that reach into the horizon are neighbours
};
Scene sceneOf(const Sample& sample);

/// Parameters with the horizon of the scene, as a host hands them over.
Teuchos::ParameterList parametersOf(const Sample& sample);

/// A number in [-1, 1] that depends on its arguments alone.
double noise(int globalId, int salt);

}  // namespace pdtest

#endif
