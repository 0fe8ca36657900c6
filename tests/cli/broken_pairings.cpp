// Solvers, materials, damage models and times that are good alone and cannot work together.
#include "broken_decks.hpp"

namespace pd_test {

namespace {

using Edit = std::pair<std::string, std::string>;

const std::string staggered =
    "  Staggered:\n    Load Steps: 2\n    Diffusion:\n      Method: Euler\n      Sub Steps: 2\n    Mechanics:\n"
    "      Adaptive Dynamic Relaxation:\n        Iterations Per Load Step: 3\n";

/// Another solver in line 63.
Edit solver(const std::string& text) { return {staggered, "  " + text + "\n"}; }

/// Metal that dissolves in place of the steel, lines 20 to 28, and its damage model in lines 30 to 32.
const Edit metal{
    "    Material Model: PDHE\n    Density: 7850.0\n    Young's Modulus: 2.0e11\n    Poisson's Ratio: 0.3\n    Plane "
    "Stress: true\n    Thickness: 1.0e-3\n    Diffusivity: 1.0e-9\n",
    "    Material Model: Corrosion Dissolution\n    Plane Stress: true\n    Thickness: 1.0e-3\n    Diffusivity: "
    "1.0e-9\n"
    "    Charge Number: 2.0\n    Solid Concentration: 1.0e5\n    Saturation Concentration: 5.0e3\n    Current Density: "
    "\"1.0\"\n"};
const Edit dissolution{"    Damage Model: Critical Stretch\n    Critical Stretch: 0.01\n",
                       "    Damage Model: Dissolution\n"};

/// The good deck's conditions, compute and output of displacements go.
const std::vector<Edit> withoutMechanics{
    {"  Clamp:\n    Type: Prescribed Displacement\n    Node Set: Left Node Set\n    Coordinate: x\n    Value: 0.0\n  "
     "Pull:\n"
     "    Type: Prescribed Displacement\n    Node Set: Right Node Set\n    Coordinate: x\n    Value: {Table: [[0.0, "
     "0.0], "
     "[10.0, 1.0e-7]]}\n",
     ""},
    {"Compute Class Parameters:\n  Pulling Force:\n    Compute Class: Reaction_Force\n    Node Set: Right Node Set\n   "
     " "
     "Output Label: Pulling_Force\n",
     ""},
    {"[Displacement, Damage, Concentration, Pulling_Force]", "[Damage, Concentration]"}};

std::vector<Edit> with(std::vector<Edit> edits, const std::vector<Edit>& more) {
  edits.insert(edits.end(), more.begin(), more.end());
  return edits;
}

}  // namespace

std::vector<Broken> brokenPairings() {
  return {
      {"DissolutionWithoutItsDamageModel",
       with({metal, solver("Corrosion: {}")}, withoutMechanics),
       {"deck.yaml:37:19: Blocks/Plate: the metal of Materials/Steel dissolves, and needs a damage model that changes "
        "its "
        "phase: \"Dissolution\""}},
      {"TooLittleMetal",
       with({metal,
             dissolution,
             solver("Corrosion: {}"),
             {"Type: Prescribed Concentration", "Type: Initial Concentration"},
             {"    Value: \"1.0e-5*min(t/10, 1)\"", "    Value: 5.5e3"},
             {"Horizon: 3.1e-3", "Horizon: 4.1e-3"}},
            withoutMechanics),
       {"begins with 5500 mol/m3, above the Saturation Concentration 5000, by which it is metal, but with less than a "
        "tenth of "
        "its Solid Concentration 100000"}},
      {"LimitOfBondsThatDoNotTire",
       {{"    Damage Model: Critical Stretch\n    Critical Stretch: 0.01\n",
         "    Damage Model: Remaining Life\n    Growth Coefficient: 1.0e4\n    Growth Exponent: 3.0\n    Cycles Per "
         "Step: "
         "1.0\n    Fatigue Limit: 1.0e-3\n"}},
       {"deck.yaml:34:20: Damage Models/Brittle: damage model Remaining Life: \"Fatigue Limit\" is of bonds away from "
        "cracks, which lose no life here"}},
      {"LimitThatIsNot",
       {{"    Damage Model: Critical Stretch\n    Critical Stretch: 0.01\n",
         "    Damage Model: Remaining Life\n    Growth Coefficient: 1.0e4\n    Growth Exponent: 3.0\n    Cycles Per "
         "Step: "
         "1.0\n    Fatigue Limit In Growth: true\n"}},
       {"deck.yaml:34:30: Damage Models/Brittle: damage model Remaining Life: \"Fatigue Limit In Growth\" does nothing "
        "without a \"Fatigue Limit\""}},
      {"DissolutionIntoOtherIons",
       with({metal, dissolution, solver("Corrosion: {Concentration Field: Ions}")}, withoutMechanics),
       {"deck.yaml:53:36: Solver/Corrosion: it does not advance \"Concentration\", into which the metal of "
        "Materials/Steel dissolves; give both the same \"Concentration Field\""}},
      {"PhasesOfOtherIons",
       with({metal,
             {dissolution.first, dissolution.second + "    Concentration Field: Ions\n"},
             solver("Corrosion: {}")},
            withoutMechanics),
       {"deck.yaml:32:26: Damage Models/Brittle: it does not follow \"Concentration\", into which the metal of "
        "Materials/Steel dissolves; give both the same \"Concentration Field\""}},
      {"DiffusionOfMetal",
       with({metal, dissolution, solver("Diffusion: {}")}, withoutMechanics),
       {"deck.yaml:20:3: Materials/Steel: nothing in this deck provides \"Salt_Coverage\", \"Dissolution_Demand\", "
        "which "
        "Corrosion Dissolution needs; given by the solver \"Corrosion\""}},
      {"CorrosionOfSteel",
       {solver("Corrosion: {}")},
       {"deck.yaml:63:3: Solver/Corrosion: nothing in this deck provides \"Interface_Area_Density\", "
        "\"Dissolution_Rate\", "
        "\"Dissolution_Rate_Slope\", \"Solid_Concentration\", \"Saturation_Concentration\", \"Current_Density\", which "
        "Corrosion needs; given by the material \"Corrosion Dissolution\""}},
      {"DissolutionOfSteel",
       {dissolution},
       {"deck.yaml:29:3: Damage Models/Brittle: nothing in this deck provides \"Solid_Concentration\", "
        "\"Saturation_Concentration\", which Dissolution needs; given by the material \"Corrosion Dissolution\""}},
      {"HydrogenOfNobody",
       {{"    Damage Model: Critical Stretch\n",
         "    Damage Model: Hydrogen Critical Stretch\n    Saturation Concentration: 1.0\n    Concentration Field: "
         "Hydrogen\n"}},
       {"deck.yaml:32:26: Damage Models/Brittle: nothing in this deck provides \"Hydrogen\", which Hydrogen Critical "
        "Stretch needs; let a solver advance it, or a condition set it"}},
      {"DiffusionOfNothing",
       {solver("Diffusion: {Field: Hydrogen}")},
       {"deck.yaml:63:22: Solver/Diffusion: nothing in this deck provides \"Hydrogen_Flux_Divergence\", which "
        "Diffusion "
        "needs; materials of this deck give rates of \"Concentration\""}},
      {"StaticsOfDiffusion",
       {{"    Young's Modulus: 2.0e11\n    Poisson's Ratio: 0.3\n", ""}},
       {"deck.yaml:61:3: Solver/Staggered: nothing in this deck provides \"Force_Density\", which Staggered needs; "
        "given by the material \"Elastic\", \"Elastic Bond Based\", \"PDHE\""}},
      {"DynamicsWithoutDensity",
       {solver("Verlet: {}"), {"    Density: 7850.0\n", ""}},
       {"deck.yaml:20:3: Materials/Steel: Solver/Verlet needs a mass density, in kg/m3: material PDHE: \"Density\" is "
        "missing, and this solver needs it"}},
      {"TimeStepsOfAnotherRun",
       {solver("QuasiStatic: {Time Steps: 0 1 2}")},
       {"deck.yaml:63:29: Solver/QuasiStatic: QuasiStatic: \"Time Steps\" go from 0 to 2 s, the run from 0 to 10 s; "
        "make "
        "Initial Time and Final Time the same as the first and the last of them"}},
      {"CountlessSteps",
       {solver("Verlet: {Fixed dt: 1.0e-90}")},
       {"deck.yaml:63:3: Solver/Verlet: 1e+91 steps at least from 0 to 10 s: more than the 2.1e9 that can be counted; "
        "take longer steps, or shorten the run"}},
      {"CountlessStepsOfDiffusion",
       {{"      Sub Steps: 2\n", "      Time Step: 1.0e-90\n"}},
       {"deck.yaml:63:3: Solver/Staggered: 1e+91 steps at least from 0 to 10 s: more than the 2.1e9"}},
      {"CountlessStepsOfCorrosion",
       with({metal, dissolution, solver("Corrosion: {Fixed dt: 1.0e-90}")}, withoutMechanics),
       {"deck.yaml:53:3: Solver/Corrosion: 1e+91 steps at least from 0 to 10 s: more than the 2.1e9"}},
      {"CountlessStepsTogether",
       {{"    Load Steps: 2\n", "    Load Steps: 1500000000\n"}},
       {"deck.yaml:63:3: Solver/Staggered: 9e+09 steps at least from 0 to 10 s: more than the 2.1e9"}},
      {"OutputTooLong",
       {{"Output Filename: results", "Output Filename: " + std::string(250, 'a')}},
       {"deck.yaml:77:20: Output/Output Filename has a part of 250 characters; names of files end at 200"}},
  };
}

std::vector<Broken> refusedStarts() {
  return {
      {"UnstableStep",
       {solver("Verlet: {Fixed dt: 1.0e-3}")},
       {"deck.yaml:63:3: Solver/Verlet: Verlet: the time step 0.001 s is above the critical one"}},
      {"UnstableDiffusion",
       {{"    Diffusivity: 1.0e-9", "    Diffusivity: 1.0"}},
       {"deck.yaml:63:3: Solver/Staggered: Diffusion: the time step 2.5 s of \"Concentration\" is above the stability "
        "limit"}},
      {"FewSubSteps",
       {{staggered, "  Staggered: {Load Steps: 1, Solvers: {Waves: {Verlet: {Fixed dt: 1.0e-8}, Sub Steps: 3}}}\n"}},
       {"deck.yaml:63:3: Solver/Staggered: Staggered: Waves: Verlet needs 1000000000 increments from 0 to 10 s of its "
        "time, "
        "more than \"Sub Steps: 3\""}},
      {"TroublesOfTwoParts",
       {{"    Diffusivity: 1.0e-9", "    Diffusivity: 1.0"},
        {staggered,
         "  Staggered: {Load Steps: 1, Solvers: {Hydrogen: {Diffusion: {Method: Euler, Sub Steps: 2}}, Waves: {Verlet: "
         "{Fixed dt: 1.0e-8}, Sub Steps: 3}}}\n"}},
       {"deck.yaml:63:3: Solver/Staggered: Diffusion: the time step 5 s of \"Concentration\" is above the stability "
        "limit",
        "deck.yaml:63:3: Solver/Staggered: Staggered: Waves: Verlet needs 1000000000 increments"}},
      {"MoreMetalThanSolid",
       with({metal,
             dissolution,
             solver("Corrosion: {}"),
             {"    Value: \"1.0e-5*min(t/10, 1)\"", "    Value: 2.0e5"},
             {"Horizon: 3.1e-3", "Horizon: 4.1e-3"}},
            withoutMechanics),
       {"deck.yaml:53:3: Solver/Corrosion: Corrosion: concentration 200000 mol/m3 at point "}},
      {"LoadThatNothingHolds",
       {solver("QuasiStatic: {}"),
        {"    Type: Prescribed Displacement\n    Node Set: Left Node Set\n    Coordinate: x\n    Value: 0.0\n",
         "    Type: Force\n    Node Set: Left Node Set\n    Coordinate: y\n    Value: 22400.0\n"}},
       {"deck.yaml:63:3: Solver/QuasiStatic: QuasiStatic: load step 0 (t = 10 s): nothing holds the body against its "
        "loads: no prescribed displacement carries a force of (0, 2.24e+04, 0) N"}},
      {"SteadyStateOfNothing",
       {solver("ImplicitDiffusion: {Field: Concentration}"),
        {"Type: Prescribed Concentration", "Type: Initial Concentration"}},
       {"deck.yaml:63:3: Solver/ImplicitDiffusion: ImplicitDiffusion: no point has a prescribed Concentration"}},
  };
}

}  // namespace pd_test
