// Mistakes in discretization, materials, damage models and blocks.
#include "broken_decks.hpp"

namespace pd_test {

namespace {

/// A metal that dissolves, as the last material of the good deck.
const std::string acid =
    "  Acid:\n    Material Model: Corrosion Dissolution\n    Plane Stress: true\n    Thickness: 1.0e-3\n"
    "    Diffusivity: 1.0e-9\n    Charge Number: 2.0\n    Solid Concentration: 1.0e5\n"
    "    Saturation Concentration: 5.0e3\n    Current Density: \"1.0\"";

}  // namespace

std::vector<Broken> brokenBodies() {
  return {
      {"UnknownRootKey",
       {{"Output:\n", "Ouput:\n"}},
       {"deck.yaml:76:1: unknown key \"Ouput\" at the top level (did you mean \"Output\"?)"}},
      {"MissingSection",
       {{"Materials:\n", "Material Kinds:\n"}},
       {"deck.yaml:19:1: unknown key \"Material Kinds\" at the top level",
        "deck.yaml:35:15: Blocks/Plate/Material: there is no \"Steel\" in Materials; it is empty",
        "deck.yaml: the deck has no section \"Materials\""}},
      {"MisspeltOutput",
       {{"Output:\n", "Outputt:\n"}},
       {"deck.yaml:76:1: unknown key \"Outputt\" at the top level (did you mean \"Output\"?)"}},
      {"SolverPutAside",
       {{"Output:\n", "Old Solver Disabled: {Final Time: 1.0, Verlet: {}}\nOutput:\n"}},
       {"deck.yaml:76:1: unknown key \"Old Solver Disabled\" at the top level"}},
      {"NoSolver",
       {{"Solver:\n", "Solvr:\n"}},
       {"deck.yaml:60:1: unknown key \"Solvr\" at the top level (did you mean \"Solver\"?)",
        "deck.yaml: the deck has no section \"Solver\""}},
      {"TwoDocuments",
       {{"Materials:\n", "---\nMaterials:\n"}},
       {"deck.yaml:20:1: a second YAML document starts here; a deck is one document (remove the \"---\")"}},
      {"Tab",
       {{"  Steel:\n", "\tSteel:\n"}},
       {"deck.yaml:20:7: YAML syntax: illegal map value; the line contains a tab: indent with blanks"}},
      {"OpenBracket",
       {{"[Displacement, Damage, Concentration, Pulling_Force]", "[Displacement, Damage"}},
       {"deck.yaml:80:1: YAML syntax: end of sequence flow not found; look at the indentation, colons, quotes and "
        "brackets here and just above"}},
      {"Duplicate",
       {{"    Density: 7850.0\n", "    Density: 7850.0\n    Density: 7860.0\n"}},
       {"deck.yaml:23:5: key \"Density\" is given twice in the same section (first in line 22); remove one of them"}},
      {"UnknownMeshType",
       {{"Type: Text File", "Type: Exodos"}},
       {"deck.yaml:2:9: Discretization/Type \"Exodos\" is not allowed here (one of \"Text File\", \"Exodus\", "
        "\"PdQuickGrid\"); did you mean \"Exodus\"?"}},
      {"NoGenerator",
       {{"Type: Text File\n  Input Mesh File: mesh.txt", "Type: PdQuickGrid"}},
       {"deck.yaml:1:1: Discretization: give one of \"TensorProduct3DMeshGenerator\", "
        "\"TensorProductCylinderMeshGenerator\""}},
      {"MissingMeshFile",
       {{"mesh.txt", "mash.txt"}},
       {"deck.yaml:3:20: Discretization/Input Mesh File: there is no file \"mash.txt\" (names start at the folder of "
        "the deck)"}},
      {"NoMeshKey",
       {{"  Input Mesh File: mesh.txt\n", ""}},
       {"deck.yaml:1:1: Discretization lacks \"Input Mesh File\" (text): Name of the mesh file, seen from the folder "
        "of the deck."}},
      {"HorizonInDiscretization",
       {{"  Thickness: 1.0e-3\n  Bond", "  Thickness: 1.0e-3\n  Horizon: 3.1e-3\n  Bond"}},
       {"deck.yaml:5:3: the Horizon belongs to the entries of Blocks, not to Discretization"}},
      {"NegativeThickness",
       {{"  Thickness: 1.0e-3\n  Bond", "  Thickness: -1.0e-3\n  Bond"}},
       {"deck.yaml:4:14: Discretization/Thickness is -0.001, must be > 0 m"}},
      {"ThicknessLeftOut",
       {{"  Thickness: 1.0e-3\n  Bond", "  Bond"}},
       {"deck.yaml:25:16: Materials/Steel/Thickness is 0.001, but Discretization has none; add \"Thickness: 0.001\" "
        "there too, since it is needed to find the distance of points from their volumes"}},
      {"ThicknessDiffers",
       {{"  Thickness: 1.0e-3\n  Bond", "  Thickness: 2.0e-3\n  Bond"}},
       {"deck.yaml:26:16: Materials/Steel/Thickness is 0.001, but Discretization/Thickness is 0.002; they must agree"}},
      {"BadInfluence",
       {{"  Thickness: 1.0e-3\n  Bond", "  Thickness: 1.0e-3\n  Influence Function: Gausian\n  Bond"}},
       {"deck.yaml:5:23: unknown influence function \"Gausian\" (did you mean \"Gaussian\"?); there are: \"One\", "
        "\"Parabolic Decay\", \"Gaussian\", or a function of zeta and horizon"}},
      {"OmitBonds",
       {{"  Thickness: 1.0e-3\n  Bond", "  Thickness: 1.0e-3\n  Omit Bonds Between Blocks: Some\n  Bond"}},
       {"deck.yaml:5:30: Discretization/Omit Bonds Between Blocks \"Some\" is not allowed here (one of \"None\", "
        "\"All\")"}},
      {"SymmetryPoint",
       {{"  Thickness: 1.0e-3\n  Bond",
         "  Thickness: 1.0e-3\n  Symmetry: {Left: {Point: [0, 0], Normal: [1, 0, 0]}}\n  Bond"}},
       {"deck.yaml:5:28: Discretization/Symmetry/Left/Point must be three numbers, [x, y, z]"}},
      {"SymmetryNormalZero",
       {{"  Thickness: 1.0e-3\n  Bond",
         "  Thickness: 1.0e-3\n  Symmetry: {Left: {Point: [0, 0, 0], Normal: [0, 0, 0]}}\n  Bond"}},
       {"deck.yaml:5:47: Discretization/Symmetry/Left: the normal has no length"}},
      {"SymmetrySlanting",
       {{"  Thickness: 1.0e-3\n  Bond",
         "  Thickness: 1.0e-3\n  Symmetry: {Left: {Point: [0, 0, 0], Normal: [1, 0, 0]}, Low: {Point: [0, 0, 0], "
         "Normal: [1, 1, 0]}}\n  Bond"}},
       {"deck.yaml:5:59: Discretization/Symmetry/Low is not perpendicular to Discretization/Symmetry/Left: there may "
        "be one plane of symmetry, or two or three that are perpendicular to each other"}},
      {"SymmetryUnknownKey",
       {{"  Thickness: 1.0e-3\n  Bond",
         "  Thickness: 1.0e-3\n  Symmetry: {Left: {Point: [0, 0, 0], Normel: [1, 0, 0]}}\n  Bond"}},
       {"deck.yaml:5:39: unknown key \"Normel\" in Discretization/Symmetry/Left (did you mean \"Normal\"?)"}},
      {"SymmetryThroughPoints",
       {{"  Thickness: 1.0e-3\n  Bond",
         "  Thickness: 1.0e-3\n  Symmetry: {Left: {Point: [0, 0, 0], Normal: [1, 0, 0]}}\n  Bond"}},
       {"deck.yaml:5:14: Discretization/Symmetry/Left: 5 point(s) lie on the plane or nearer to it than a quarter of a "
        "spacing"}},
      {"SymmetryThroughBody",
       {{"  Thickness: 1.0e-3\n  Bond",
         "  Thickness: 1.0e-3\n  Symmetry: {Left: {Point: [0.0025, 0, 0], Normal: [1, 0, 0]}}\n  Bond"}},
       {"deck.yaml:5:14: Discretization/Symmetry/Left: the plane cuts through the body: 15 of 55 points lie beyond "
        "it"}},
      {"FilterType",
       {{"Type: Rectangular_Plane", "Type: Rectangle"}},
       {"deck.yaml:7:13: unknown Type \"Rectangle\" in Discretization/Bond Filters/Notch"}},
      {"FilterWithoutType",
       {{"      Type: Rectangular_Plane\n", ""}},
       {"deck.yaml:6:5: Discretization/Bond Filters/Notch lacks \"Type\", one of \"Rectangular_Plane\", \"Disk\", "
        "\"Node Set Pair\""}},
      {"FilterNormalZero",
       {{"Normal_Y: 1.0", "Normal_Y: 0.0"}},
       {"deck.yaml:8:17: Discretization/Bond Filters/Notch: the normal has no length"}},
      {"FilterBottomNotInPlane",
       {{"Bottom_Unit_Vector_Y: 0.0", "Bottom_Unit_Vector_Y: 1.0"}},
       {"deck.yaml:14:29: Discretization/Bond Filters/Notch: the bottom vector must be perpendicular to the normal"}},
      {"FilterLength",
       {{"Bottom_Length: 3.0e-3", "Bottom_Length: 0.0"}},
       {"deck.yaml:17:22: Discretization/Bond Filters/Notch/Bottom_Length is 0, must be > 0 m"}},
      {"FilterMissingKey",
       {{"      Side_Length: 2.0\n", ""}},
       {"deck.yaml:6:5: Discretization/Bond Filters/Notch lacks \"Side_Length\" (a number > 0 m): Length of the other "
        "side."}},
      {"SolidInAPlane",
       {{"    Plane Stress: true\n    Thickness: 1.0e-3\n", ""}},
       {"deck.yaml:20:3: Materials/Steel: its constants are those of points that fill space, but those of mesh.txt "
        "fill a plane; set \"Plane Strain: true\" or \"Plane Stress: true\""}},
      {"LinearSolidInAPlane",
       {{"    Material Model: PDHE\n", "    Material Model: Elastic\n"},
        {"    Plane Stress: true\n    Thickness: 1.0e-3\n    Diffusivity: 1.0e-9\n", ""},
        {"Damage, Concentration,", "Damage,"},
        {"  Charge:\n    Type: Prescribed Concentration\n    Node Set: Top Node Set\n    Value: \"1.0e-5*min(t/10, "
         "1)\"\n",
         ""},
        {"  Staggered:\n    Load Steps: 2\n    Diffusion:\n      Method: Euler\n      Sub Steps: 2\n    Mechanics:\n"
         "      Adaptive Dynamic Relaxation:\n        Iterations Per Load Step: 3\n",
         "  QuasiStatic: {}\n"}},
       {"deck.yaml:20:3: Materials/Steel: its constants are those of points that fill space, but those of mesh.txt "
        "fill a plane; set \"Plane Strain: true\" or \"Plane Stress: true\""}},
      {"BarInAPlane",
       {{"    Plane Stress: true\n    Thickness: 1.0e-3\n", "    One Dimensional: true\n"}},
       {"deck.yaml:25:22: Materials/Steel: its constants are those of points that fill a line, but those of mesh.txt "
        "fill a plane; set \"Plane Strain: true\" or \"Plane Stress: true\" in place of \"One Dimensional\""}},
      {"UnknownMaterialModel",
       {{"Material Model: PDHE", "Material Model: PDEH"}},
       {"deck.yaml:21:21: unknown Material Model \"PDEH\" in Materials/Steel (did you mean \"PDHE\"?)"}},
      {"MaterialWithoutModel",
       {{"    Material Model: PDHE\n", ""}},
       {"deck.yaml:20:3: Materials/Steel lacks \"Material Model\""}},
      {"QuotedNumber",
       {{"Density: 7850.0", "Density: \"7850.0\""}},
       {"deck.yaml:22:14: Materials/Steel/Density must be a number > 0 kg/m3, not \"7850.0\" in quotes"}},
      {"NotANumber",
       {{"Density: 7850.0", "Density: heavy"}},
       {"deck.yaml:22:14: Materials/Steel/Density must be a number > 0 kg/m3, not \"heavy\""}},
      {"DensityInAnotherUnit",
       {{"7850.0", "3 GPa"}},
       {"deck.yaml:22:14: Materials/Steel/Density must be a number > 0 kg/m3, not \"3 GPa\": GPa does not convert to "
        "kg/m3"}},
      {"ModulusInNoUnit",
       {{"2.0e11", "200 Gpa"}},
       {"deck.yaml:23:22: Materials/Steel/Young's Modulus must be a number > 0 Pa, not \"200 Gpa\": there is no unit "
        "\"Gpa\" (did you mean \"GPa\"?); it is in Pa"}},
      {"PureNumberWithUnit",
       {{"Poisson's Ratio: 0.3", "Poisson's Ratio: 0.3 m"}},
       {"deck.yaml:24:22: Materials/Steel/Poisson's Ratio must be a number in (-1, 0.5), not \"0.3 m\": it takes a "
        "number "
        "without a unit"}},
      {"NegativeDensity",
       {{"Density: 7850.0", "Density: -7850.0"}},
       {"deck.yaml:22:14: Materials/Steel/Density is -7850, must be > 0 kg/m3"}},
      {"NumbersNobodyMeans",
       {{"Young's Modulus: 2.0e11", "Young's Modulus: 1.0e300"},
        {"Density: 7850.0", "Density: 1.0e-300"},
        {"    Value: 0.0\n", "    Value: -1.0e300\n"},
        {"Horizon: 3.1e-3", "Horizon: 1.0e-200"}},
       {"deck.yaml:22:14: Materials/Steel/Density is 1e-300, too small to be meant",
        "deck.yaml:23:22: Materials/Steel/Young's Modulus is 1e+300, too large to be meant",
        "deck.yaml:37:14: Blocks/Plate/Horizon is 1e-200, too small to be meant",
        "deck.yaml:47:12: Boundary Conditions/Clamp/Value is -1e+300, too large to be meant"}},
      {"InfiniteModulus",
       {{"Young's Modulus: 2.0e11", "Young's Modulus: 1.0e999"}},
       {"deck.yaml:23:22: Materials/Steel/Young's Modulus must be a number > 0 Pa, not \"1.0e999\""}},
      {"PoissonRange",
       {{"Poisson's Ratio: 0.3", "Poisson's Ratio: 0.5"}},
       {"deck.yaml:24:22: Materials/Steel/Poisson's Ratio is 0.5, must be in (-1, 0.5)"}},
      {"UnknownMaterialKey",
       {{"    Poisson's Ratio: 0.3", "    Poissons Ratio: 0.3"}},
       {"deck.yaml:24:5: unknown key \"Poissons Ratio\" in Materials/Steel (did you mean \"Poisson's Ratio\"?)"}},
      {"TwoPlanes",
       {{"Plane Stress: true", "Plane Stress: true\n    Plane Strain: true"}},
       {"deck.yaml:20:3: Materials/Steel: give only one of \"Plane Stress\", \"Plane Strain\", \"One Dimensional\""}},
      {"FlagAsNumber",
       {{"Plane Stress: true", "Plane Stress: 2"}},
       {"deck.yaml:25:19: Materials/Steel/Plane Stress must be true or false, not \"2\""}},
      {"EmptyValue",
       {{"Diffusivity: 1.0e-9", "Diffusivity:"}},
       {"deck.yaml:27:5: Materials/Steel/Diffusivity must be a number > 0 m2/s, not nothing"}},
      {"HorizonInMaterial",
       {{"    Diffusivity: 1.0e-9", "    Horizon: 3.1e-3\n    Diffusivity: 1.0e-9"}},
       {"deck.yaml:27:5: Materials/Steel gives a Horizon, which belongs to the block alone; remove it here"}},
      {"MaterialIsNoSection",
       {{"  Steel:\n    Material Model: PDHE\n", "  Steel: PDHE\n  Other:\n    Material Model: PDHE\n"}},
       {"deck.yaml:20:10: Materials/Steel must be a section with keys of its own"}},
      {"UnknownDamageModel",
       {{"Damage Model: Critical Stretch", "Damage Model: Critical Strech"}},
       {"deck.yaml:30:19: unknown Damage Model \"Critical Strech\" in Damage Models/Brittle (did you mean \"Critical "
        "Stretch\"?)"}},
      {"DamageWithoutLimit",
       {{"    Critical Stretch: 0.01\n", ""}},
       {"deck.yaml:29:3: Damage Models/Brittle: give one of \"Critical Stretch\", \"Fracture Energy\""}},
      {"DamageTwoLimits",
       {{"    Critical Stretch: 0.01\n",
         "    Critical Stretch: 0.01\n    Fracture Energy: 1.0e4\n    Young's Modulus: 2.0e11\n    Poisson's Ratio: "
         "0.3\n    Plane Stress: true\n    Horizon: 3.1e-3\n"}},
       {"deck.yaml:29:3: Damage Models/Brittle: give only one of \"Critical Stretch\", \"Fracture Energy\""}},
      {"DamageHorizonDiffers",
       {{"    Critical Stretch: 0.01\n",
         "    Fracture Energy: 1.0e4\n    Young's Modulus: 2.0e11\n    Poisson's Ratio: 0.3\n    Plane Stress: true\n  "
         "  Horizon: 3.2e-3\n"}},
       {"deck.yaml:35:14: Damage Models/Brittle/Horizon is 0.0032, but Blocks/Plate/Horizon is 0.0031; they must "
        "agree"}},
      {"DamagePlaneDiffers",
       {{"    Critical Stretch: 0.01\n",
         "    Fracture Energy: 1.0e4\n    Young's Modulus: 2.1e11\n    Poisson's Ratio: 0.3\n    Horizon: 3.1e-3\n"}},
       {"deck.yaml:29:3: Damage Models/Brittle/Plane Stress is false, but Materials/Steel/Plane Stress is true; they "
        "must agree",
        "deck.yaml:32:22: Damage Models/Brittle/Young's Modulus is 210000000000, but Materials/Steel/Young's Modulus "
        "is 200000000000; they must agree"}},
      {"NodalEnergyUnlikeItsMaterial",
       {{"    Damage Model: Critical Stretch\n    Critical Stretch: 0.01\n",
         "    Damage Model: Nodal Energy\n    Fracture Energy: 1.0e4\n    Young's Modulus: 2.0e11\n    Poisson's "
         "Ratio: "
         "0.3\n    Plane Stress: true\n    Horizon: 3.1e-3\n    Volume Correction: None\n"}},
       {"deck.yaml:6:5: Discretization/Bond Filters/Notch: Damage Models/Brittle would take the faces of this crack "
        "for "
        "free surfaces, which need more energy to break; add \"Count In Damage: true\"",
        "deck.yaml:29:3: Damage Models/Brittle/Thickness is 1, but Materials/Steel/Thickness is 0.001; they must agree",
        "deck.yaml:36:24: Damage Models/Brittle/Volume Correction is None, but Materials/Steel/Volume Correction is "
        "Ramp "
        "Beyond Horizon; they must agree"}},
      {"BlockMaterialUnknown",
       {{"Material: Steel", "Material: Steal"}},
       {"deck.yaml:35:15: Blocks/Plate/Material: there is no \"Steal\" in Materials (did you mean \"Steel\"?); there "
        "are: \"Steel\""}},
      {"BlockDamageUnknown",
       {{"    Damage Model: Brittle", "    Damage Model: Britle"}},
       {"deck.yaml:36:19: Blocks/Plate/Damage Model: there is no \"Britle\" in Damage Models (did you mean "
        "\"Brittle\"?); there are: \"Brittle\""}},
      {"BlockMaterials",
       {{"Material: Steel\n", "Material: [Steel, Steal, Steel]\n"}},
       {"deck.yaml:35:23: Blocks/Plate/Material[2]: there is no \"Steal\" in Materials (did you mean \"Steel\"?); "
        "there "
        "are: \"Steel\"",
        "deck.yaml:35:30: Blocks/Plate/Material[3]: \"Steel\" is in the list already"}},
      {"BlockMaterialEmpty",
       {{"Material: Steel\n", "Material: []\n"}},
       {"deck.yaml:35:15: Blocks/Plate/Material is empty; name an entry of Materials"}},
      {"BlockDamageNoneInList",
       {{"    Damage Model: Brittle", "    Damage Model: [Brittle, None]"}},
       {"deck.yaml:36:29: Blocks/Plate/Damage Model[2]: there is no \"None\" in Damage Models; there are: "
        "\"Brittle\""}},
      {"TwoOwnersOfAField",
       {{"Damage Models:\n",
         "  One: {Material Model: Elastic, Density: 1.0, Bulk Modulus: 1.0, Shear Modulus: 1.0}\n"
         "  Two: {Material Model: Elastic, Density: 1.0, Bulk Modulus: 2.0, Shear Modulus: 1.0}\nDamage Models:\n"},
        {"Material: Steel\n", "Material: [Steel, One, Two]\n"}},
       {"deck.yaml:37:15: Blocks/Plate/Material: material Combined: \"One\" and \"Two\" both write the field "
        "\"Weighted_Volume\", which can have one writer in a block",
        "deck.yaml:37:15: Blocks/Plate/Material: material Combined: \"One\" and \"Two\" both write the field "
        "\"Dilatation\", which can have one writer in a block"}},
      {"TwoDensities",
       {{"Damage Models:\n",
         "  Light: {Material Model: PDHE, Density: 1.0, Young's Modulus: 1.0, Poisson's Ratio: 0.3, Plane Stress: "
         "true, "
         "Thickness: 1.0e-3}\nDamage Models:\n"},
        {"Material: Steel\n", "Material: [Steel, Light]\n"}},
       {"deck.yaml:36:15: Blocks/Plate/Material: material Combined: \"Steel\" and \"Light\" differ in Density, but are "
        "one body"}},
      {"CombinedWithoutPart",
       {{"Damage Models:\n",
         "  Both:\n    Material Model: Combined\n    Materials: [Steel, Acid]\n    Steel: {Material Model: PDHE, "
         "Diffusivity: 1.0}\nDamage Models:\n"}},
       {"deck.yaml:30:24: Materials/Both lacks the part \"Acid\": give it a section under this name, with a \"Material "
        "Model\""}},
      {"CombinedPartKey",
       {{"Damage Models:\n",
         "  Both:\n    Material Model: Combined\n    Materials: [Acid]\n    Acid:\n      Material Model: PDHE\n      "
         "Diffusivty: 1.0\nDamage Models:\n"}},
       {"deck.yaml:33:7: unknown key \"Diffusivty\" in Materials/Both/Acid (did you mean \"Diffusivity\"?)"}},
      {"DecompositionWithoutThickness",
       {{"Damage Models:\n",
         "  Both:\n    Material Model: Combined\n    Materials: [Gaps]\n    Gaps:\n      Material Model: Bond "
         "Decomposition\n      Cracks: {C: {Type: Polyline, Points: [0.0, 0.0, 1.0e-3, 0.0]}}\nDamage Models:\n"}},
       {"deck.yaml:31:5: Materials/Both/Gaps/Thickness is 1, but Discretization/Thickness is 0.001; they must agree"}},
      {"LoadBesideDissolution",
       {{"Damage Models:\n",
         "  Acid: {Material Model: Corrosion Dissolution, Plane Strain: true, Thickness: 1.0e-3, Diffusivity: 1.0, "
         "Charge "
         "Number: 2.0, Solid Concentration: 10.0, Saturation Concentration: 1.0, Current Density: \"1.0\"}\nDamage "
         "Models:\n  Phases: {Damage Model: Dissolution}\n"},
        {"Boundary Conditions:\n",
         "  Other:\n    Block Names: block_2\n    Material: [Steel, Acid]\n    Damage Model: Phases\n    Horizon: "
         "3.1e-3\nBoundary Conditions:\n"}},
       {"deck.yaml:35:3: Blocks/Plate: its bonds to points that dissolve in Blocks/Other would go on carrying load; "
        "add "
        "the damage model by which points dissolve to its list, as in \"Damage Model: [Breakage, Dissolving]\""}},
      {"BlockKey",
       {{"    Horizon: 3.1e-3", "    Horizn: 3.1e-3"}},
       {"deck.yaml:37:5: unknown key \"Horizn\" in Blocks/Plate (did you mean \"Horizon\"?)"}},
      {"BlockHorizonZero",
       {{"    Horizon: 3.1e-3", "    Horizon: 0.0"}},
       {"deck.yaml:37:14: Blocks/Plate/Horizon is 0, must be > 0 m"}},
      {"BlockHorizonPlace",
       {{"    Horizon: 3.1e-3", "    Horizon: \"3.1e-3 + 0.01*x\""}},
       {"deck.yaml:37:14: Blocks/Plate/Horizon depends on the place, but \"PDHE\" takes one horizon for all points of "
        "a "
        "block; give a number"}},
      {"BlockHorizonHuge",
       {{"    Horizon: 3.1e-3", "    Horizon: 1.0e99"}},
       {"deck.yaml:37:14: the horizon of 1e+99 m at the point of mesh.txt:2 reaches far beyond the mesh, which spans "
        "[0, "
        "0.01] x [-0.002, 0.002] x [0, 0] m; horizons are usually 3 to 6 spacings of points"}},
      {"PhaseBlock",
       {{"Damage Models:\n", acid + "\n    Phase Blocks: [block_1, block_7]\n    Phase Current Densities: [\"1.0\", "
                                    "\"2.0\"]\nDamage Models:\n"}},
       {"deck.yaml:37:20: Materials/Acid/Phase Blocks[1]: \"block_1\" is a block of Blocks/Plate, which has another "
        "material",
        "deck.yaml:37:29: Materials/Acid/Phase Blocks[2]: there is no block \"block_7\" (did you mean \"block_1\"?); "
        "there are: \"block_1\""}},
      {"PhaseBlockTwice",
       {{"Damage Models:\n", acid + "\n    Phase Blocks: [block_1, block_1]\n    Phase Current Densities: [\"1.0\", "
                                    "\"2.0\"]\nDamage Models:\n  Phases: {Damage Model: Dissolution}\n"},
        {"Material: Steel", "Material: Acid"},
        {"    Damage Model: Brittle", "    Damage Model: Phases"}},
       {"deck.yaml:37:29: Materials/Acid/Phase Blocks[2]: \"block_1\" is in the list already"}},
      {"FilmSharesWithoutFilm",
       {{"Damage Models:\n",
         acid + "\n    Phase Blocks: [block_1]\n    Phase Current Densities: [\"1.0\"]\n    Phase Film Shares: [0.5]\n"
                "Damage Models:\n  Phases: {Damage Model: Dissolution}\n"},
        {"Material: Steel", "Material: Acid"},
        {"    Damage Model: Brittle", "    Damage Model: Phases"}},
       {"Materials/Acid/Phase Film Shares does nothing, since nothing in this deck gives \"Film_Coverage\"; let a "
        "condition set it, or leave this key out"}},
      {"PhaseBlockOfTheMesh",
       {{"Damage Models:\n", acid + "\n    Phase Blocks: [block_7]\n    Phase Current Densities: [\"1.0\"]\nDamage "
                                    "Models:\n"},
        {"Block Names: block_1", "Block Names: default"}},
       {"deck.yaml:37:20: Materials/Acid/Phase Blocks[1]: the mesh mesh.txt has no block \"block_7\" (did you mean "
        "\"block_1\"?); it has: \"block_1\""}},
      {"BlockHorizonTime",
       {{"    Horizon: 3.1e-3", "    Horizon: \"3.1e-3*(1 + t)\""}},
       {"deck.yaml:37:14: Blocks/Plate/Horizon depends on the time, but it is evaluated once; use x, y, z alone"}},
      {"BlockTwice",
       {{"Boundary Conditions:\n",
         "  Other:\n    Block Names: block_1\n    Material: Steel\n    Horizon: 3.1e-3\nBoundary Conditions:\n"}},
       {"deck.yaml:39:18: block_1 is named in Blocks/Plate already; a block of the mesh has one entry"}},
      {"BlocksEmpty",
       {{"  Plate:\n    Block Names: block_1\n    Material: Steel\n    Damage Model: Brittle\n    Horizon: 3.1e-3\n",
         ""}},
       {"deck.yaml:32:1: Blocks is empty; give each block of the mesh a material and a horizon"}},
      {"BlockNotInMesh",
       {{"Block Names: block_1", "Block Names: block_2"}},
       {"deck.yaml:34:18: the mesh mesh.txt has no block \"block_2\"; it has: block_1",
        "deck.yaml:32:1: no entry of Blocks gives a material and a horizon to block_1 of the mesh mesh.txt; name them "
        "in Block Names, or use \"default\""}},
  };
}

}  // namespace pd_test
