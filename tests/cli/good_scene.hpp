// A small scene with a bit of everything, which tests break in one place at a time.
#ifndef PD_TESTS_GOOD_SCENE_HPP
#define PD_TESTS_GOOD_SCENE_HPP

#include <fmt/format.h>

#include <string>

namespace pd_test {

/// Lines are counted on: change the numbers in the tests with them.
inline const char* const goodDeck = R"yaml(Discretization:
  Type: Text File
  Input Mesh File: mesh.txt
  Thickness: 1.0e-3
  Bond Filters:
    Notch:
      Type: Rectangular_Plane
      Normal_X: 0.0
      Normal_Y: 1.0
      Normal_Z: 0.0
      Lower_Left_Corner_X: -1.0e-3
      Lower_Left_Corner_Y: 0.5e-3
      Lower_Left_Corner_Z: -1.0
      Bottom_Unit_Vector_X: 1.0
      Bottom_Unit_Vector_Y: 0.0
      Bottom_Unit_Vector_Z: 0.0
      Bottom_Length: 3.0e-3
      Side_Length: 2.0
Materials:
  Steel:
    Material Model: PDHE
    Density: 7850.0
    Young's Modulus: 2.0e11
    Poisson's Ratio: 0.3
    Plane Stress: true
    Thickness: 1.0e-3
    Diffusivity: 1.0e-9
Damage Models:
  Brittle:
    Damage Model: Critical Stretch
    Critical Stretch: 0.01
Blocks:
  Plate:
    Block Names: block_1
    Material: Steel
    Damage Model: Brittle
    Horizon: 3.1e-3
Boundary Conditions:
  Left Node Set: left.txt
  Right Node Set: {Box: [[0.0095, -1.0, -1.0], [0.0105, 1.0, 1.0]]}
  Top Node Set: {Expression: "y > 0.0015"}
  Corner Node Set: 1 2 3
  Clamp:
    Type: Prescribed Displacement
    Node Set: Left Node Set
    Coordinate: x
    Value: 0.0
  Pull:
    Type: Prescribed Displacement
    Node Set: Right Node Set
    Coordinate: x
    Value: {Table: [[0.0, 0.0], [10.0, 1.0e-7]]}
  Charge:
    Type: Prescribed Concentration
    Node Set: Top Node Set
    Value: "1.0e-5*min(t/10, 1)"
  Keep:
    Type: No Failure
    Node Set: Corner Node Set
Solver:
  Initial Time: 0.0
  Final Time: 10.0
  Staggered:
    Load Steps: 2
    Diffusion:
      Method: Euler
      Sub Steps: 2
    Mechanics:
      Adaptive Dynamic Relaxation:
        Iterations Per Load Step: 3
Compute Class Parameters:
  Pulling Force:
    Compute Class: Reaction_Force
    Node Set: Right Node Set
    Output Label: Pulling_Force
Output:
  Output Filename: results
  Output Frequency: 1
  Output Variables: [Displacement, Damage, Concentration, Pulling_Force]
)yaml";

/// 11 x 5 points, 1 mm apart, around y = 0; node numbers run along x first, from 1 at the lower left.
inline std::string goodMesh() {
  std::string text = "# x y z block volume\n";
  for (int j = -2; j <= 2; ++j)
    for (int i = 0; i <= 10; ++i) text += fmt::format("{} {} 0.0 1 1.0e-9\n", 1.0e-3 * i, 1.0e-3 * j);
  return text;
}

inline const char* const goodNodeSet = "1 12 23\n34\n45\n";

}  // namespace pd_test

#endif
