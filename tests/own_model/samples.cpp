// What the contracts of all plug-ins are tested with.
#include "tests/plugin/samples.hpp"

namespace {

using pdtest::Sample;

Sample springs(const char* title, int dimension) {
  Sample sample{title, "Springs", dimension, {}};
  sample.parameters.set("Density", 2.0);
  sample.parameters.set("Micromodulus", 10.0);
  return sample;
}

Sample tiringBonds() {
  Sample sample{"Tiring", "Tiring Bonds", 2, {}};
  sample.parameters.set("Rate", 1500.0);
  return sample;
}

const bool areAdded = pdtest::addMaterialSample(springs("SpringsInAPlate", 2)) &&
                      pdtest::addMaterialSample(springs("SpringsInABody", 3)) && pdtest::addDamageSample(tiringBonds());

}  // namespace
