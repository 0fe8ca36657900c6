// Mistakes in node sets, conditions, solvers, computes, outputs and files.
#include "broken_decks.hpp"

namespace pd_test {

namespace {

/// What a list of solvers takes the place of.
const char* const staggeredPair =
    "    Diffusion:\n      Method: Euler\n      Sub Steps: 2\n    Mechanics:\n      Adaptive Dynamic Relaxation:\n"
    "        Iterations Per Load Step: 3\n";

}  // namespace

std::vector<Broken> brokenRuns() {
  return {
      {"NodeSetFileMissing",
       {{"left.txt", "lift.txt"}},
       {"deck.yaml:39:18: Boundary Conditions/Left Node Set: there is no file \"lift.txt\" (names start at the folder "
        "of the deck)"}},
      {"NodeSetBoxCorner",
       {{"[0.0095, -1.0, -1.0]", "[0.0095, -1.0]"}},
       {"deck.yaml:40:25: Boundary Conditions/Right Node Set/Box must be two corners, lowest first: [[x, y, z], [x, y, "
        "z]]"}},
      {"NodeSetBoxOrder",
       {{"[0.0095, -1.0, -1.0]", "[0.0195, -1.0, -1.0]"}},
       {"deck.yaml:40:27: Boundary Conditions/Right Node Set/Box: the first corner has x = 0.0195, above 0.0105 of the "
        "second; the lowest comes first"}},
      {"NodeSetExpression",
       {{"\"y > 0.0015\"", "\"y > q\""}},
       {"deck.yaml:41:30: cannot understand the function \"y > q\": unknown name \"q\""}},
      {"NodeSetExpressionTime",
       {{"\"y > 0.0015\"", "\"y > t\""}},
       {"deck.yaml:41:30: Boundary Conditions/Top Node Set/Expression depends on the time, but it is evaluated once; "
        "use x, y, z alone"}},
      {"NodeSetNotFinite",
       {{"\"y > 0.0015\"", "\"sqrt(y)\""}},
       {"deck.yaml:41:30: the value of \"sqrt(y)\" is not a number at point 1, (0, -0.002, 0) m"}},
      {"NodeSetBoxUnit",
       {{"[0.0095, -1.0, -1.0]", "[9.5 s, -1.0, -1.0]"}},
       {"deck.yaml:40:27: Boundary Conditions/Right Node Set/Box[1][1]: \"9.5 s\": s does not convert to m",
        "deck.yaml:40:25: Boundary Conditions/Right Node Set/Box must be two corners"}},
      {"TableUnit",
       {{"[10.0, 1.0e-7]", "[10.0 kg, 1.0e-7]"}},
       {"deck.yaml:52:34: Boundary Conditions/Pull/Value/Table[2][1] must be a number in s, not \"10.0 kg\": kg does "
        "not "
        "convert to s"}},
      {"ConditionUnit",
       {{"    Coordinate: x\n    Value: 0.0\n", "    Coordinate: x\n    Value: 3 mmm\n"}},
       {"deck.yaml:47:12: Boundary Conditions/Clamp/Value must be a number or a function of x, y, z, t in m, not \"3 "
        "mmm\": there is no unit \"mmm\""}},
      {"ConditionNotFinite",
       {{"\"1.0e-5*min(t/10, 1)\"", "\"1.0e-5*sqrt(0.004 - x)\""}},
       {"deck.yaml:56:12: the value of \"1.0e-5*sqrt(0.004 - x)\" is not a number at point 50, (0.005, 0.002, 0) m"}},
      {"ConditionNotFiniteLater",
       {{"\"1.0e-5*min(t/10, 1)\"", "\"1.0e-5*sqrt(6 - t)\""}},
       {"deck.yaml:56:12: the value of \"1.0e-5*sqrt(6 - t)\" is not a number at point 45, (0, 0.002, 0) m, at t = "
        "6.25 "
        "s"}},
      {"ExactSolutionNotFinite",
       {{"Output:\n", "Exact Solution:\n  Front: {Field: Concentration, Value: \"log(x)\"}\nOutput:\n"}},
       {"deck.yaml:77:40: the value of \"log(x)\" is infinite at point 1, (0, -0.002, 0) m"}},
      {"InfluenceNotFinite",
       {{"  Thickness: 1.0e-3\n  Bond", "  Thickness: 1.0e-3\n  Influence Function: log(zeta - 2e-3)\n  Bond"}},
       {"deck.yaml:5:23: the influence function \"log(zeta - 2e-3)\" is not a number at zeta = 2.4218"}},
      {"NodeSetBoth",
       {{"{Expression: \"y > 0.0015\"}", "{Expression: \"y > 0.0015\", Box: [[0, 0, 0], [1, 1, 1]]}"}},
       {"deck.yaml:41:3: Boundary Conditions/Top Node Set: give only one of \"Box\", \"Expression\""}},
      {"NodeSetKey",
       {{"{Expression: \"y > 0.0015\"}", "{Expresion: \"y > 0.0015\"}"}},
       {"deck.yaml:41:18: unknown key \"Expresion\" in Boundary Conditions/Top Node Set (did you mean "
        "\"Expression\"?)"}},
      {"NodeSetIsCondition",
       {{"  Keep:\n", "  Keep Node Set:\n"}},
       {"deck.yaml:57:3: Boundary Conditions/Keep Node Set is a condition, but names that contain \"Node Set\" are "
        "node sets; rename it"}},
      {"NodeSetTwice",
       {{"  Corner Node Set: 1 2 3\n", "  Corner Node Set: 1 2 3\n  Corner_Node_Set: 4\n"}},
       {"deck.yaml:43:3: another node set is called \"Corner_Node_Set\" too (case, blanks and underscores are not told "
        "apart); rename one"}},
      {"NodeSetListZero",
       {{"  Corner Node Set: 1 2 3\n", "  Corner Node Set: [1, 0, x]\n"}},
       {"deck.yaml:42:24: Boundary Conditions/Corner Node Set[2] must be a node number (from 1)",
        "deck.yaml:42:27: Boundary Conditions/Corner Node Set[3] must be a node number (from 1)"}},
      {"ConditionIsValue",
       {{"  Keep:\n    Type: No Failure\n    Node Set: Corner Node Set\n", "  Keep: 3\n"}},
       {"deck.yaml:57:3: Boundary Conditions/Keep must be a condition (a section with a Type); the names of node sets "
        "contain \"Node Set\""}},
      {"ConditionType",
       {{"Type: Prescribed Concentration", "Type: Prescribed Concentrations"}},
       {"deck.yaml:54:11: unknown Type \"Prescribed Concentrations\" in Boundary Conditions/Charge (did you mean "
        "\"Prescribed Concentration\"?)"}},
      {"ConditionWithoutType",
       {{"    Type: Prescribed Concentration\n", ""}},
       {"deck.yaml:53:3: Boundary Conditions/Charge lacks \"Type\""}},
      {"ConditionNodeSet",
       {{"Node Set: Left Node Set", "Node Set: Lefft Node Set"}},
       {"deck.yaml:45:15: Boundary Conditions/Clamp/Node Set: there is no node set \"Lefft Node Set\" in Boundary "
        "Conditions (did you mean \"Left Node Set\"?); there are: \"Left Node Set\", \"Right Node Set\", \"Top Node "
        "Set\", \"Corner Node Set\""}},
      {"ConditionCoordinate",
       {{"Node Set: Left Node Set\n    Coordinate: x", "Node Set: Left Node Set\n    Coordinate: w"}},
       {"deck.yaml:46:17: Boundary Conditions/Clamp/Coordinate \"w\" is not allowed here (one of \"x\", \"y\", "
        "\"z\")"}},
      {"ConditionWithoutValue",
       {{"    Value: 0.0\n", ""}},
       {"deck.yaml:43:3: Boundary Conditions/Clamp lacks \"Value\" (a number or a function of x, y, z, t in m): "
        "Displacement at all times."}},
      {"ConditionFunction",
       {{"\"1.0e-5*min(t/10, 1)\"", "\"1.0e-5*mim(t/10, 1)\""}},
       {"deck.yaml:56:12: cannot understand the function \"1.0e-5*mim(t/10, 1)\": unknown name \"mim\" (did you mean "
        "\"min\"?)"}},
      {"ConditionLoop",
       {{"\"1.0e-5*min(t/10, 1)\"", "\"while (1) { value = 1; }\""}},
       {"deck.yaml:56:12: cannot understand the function \"while (1) { value = 1; }\": \"while\" loops are not "
        "allowed, since they may never end; write the sum or the condition out"}},
      {"ConditionTableOrder",
       {{"[[0.0, 0.0], [10.0, 1.0e-7]]", "[[1.0, 0.0], [0.0, 1.0e-7]]"}},
       {"deck.yaml:52:34: Boundary Conditions/Pull/Value/Table[2][1] is earlier than the time before it; sort the "
        "table by time"}},
      {"ConditionTablePair",
       {{"[[0.0, 0.0], [10.0, 1.0e-7]]", "[[0.0, 0.0], [10.0]]"}},
       {"deck.yaml:52:33: Boundary Conditions/Pull/Value/Table[2] must be a [time, value] pair"}},
      {"ConditionField",
       {{"Type: Prescribed Concentration\n", "Type: Prescribed Value\n    Field: Concentraton\n"}},
       {"deck.yaml:55:12: Boundary Conditions/Charge/Field: nothing in this deck provides \"Concentraton\" (did you "
        "mean \"Concentration\"?)"}},
      {"ConditionVectorField",
       {{"Type: Prescribed Concentration\n", "Type: Prescribed Value\n    Field: Displacement\n"}},
       {"deck.yaml:55:12: Boundary Conditions/Charge/Field: \"Displacement\" is no scalar field"}},
      {"ConditionExtraKey",
       {{"    Value: \"1.0e-5*min", "    Coordinate: x\n    Value: \"1.0e-5*min"}},
       {"deck.yaml:56:5: unknown key \"Coordinate\" in Boundary Conditions/Charge"}},
      {"TractionWithoutArea",
       {{"    Type: Prescribed Displacement\n    Node Set: Right", "    Type: Traction\n    Node Set: Right"}},
       {"deck.yaml:48:3: Boundary Conditions/Pull lacks \"Area\" (a number > 0 m2): Area of the loaded face; its "
        "points share the force Value * Area in proportion to their volumes."}},
      {"NoDamageToKeep",
       {{"    Damage Model: Brittle\n", ""}},
       {"deck.yaml:56:3: Boundary Conditions/Keep: No Failure does nothing, since no block has a Damage Model",
        "deck.yaml:78:36: Output/Output Variables: nothing in this deck provides \"Damage\""}},
      {"Threshold",
       {{"    Type: No Failure\n    Node Set: Corner Node Set\n",
         "    Type: Saturated Crack Faces\n    Field: Concentration\n    Value: 1.0\n    Threshold: 1.5\n"}},
       {"deck.yaml:61:16: Boundary Conditions/Keep/Threshold is 1.5, must be in (0, 1)"}},
      {"FarFieldWithoutItsSolver",
       {{"Type: Prescribed Concentration\n",
         "Type: Far Field Concentration\n    Distance: 1.0e-3\n    Diffusivity: 1.0e-9\n    Area: 1.0e-6\n"}},
       {"deck.yaml:53:3: Boundary Conditions/Charge: Far Field Concentration does nothing, since no solver of this "
        "deck takes an electrolyte beyond the mesh into account for \"Concentration\", as Corrosion does for its "
        "Concentration Field; use Prescribed Concentration"}},
      {"InitialValueOfTheMesh",
       {{"Type: Prescribed Concentration\n", "Type: Initial Value\n    Field: Volume\n"}},
       {"deck.yaml:55:12: Boundary Conditions/Charge/Field: \"Volume\" cannot be set, since it is that of the mesh or "
        "of the motion"}},
      {"InitialValueOfDamage",
       {{"Type: Prescribed Concentration\n", "Type: Initial Value\n    Field: Damage\n"}},
       {"deck.yaml:55:12: Boundary Conditions/Charge/Field: \"Damage\" cannot be set, since damage models find it from "
        "broken bonds; a Bond Filter with \"Count In Damage: true\" breaks some at the start"}},
      {"PrescribedRate",
       {{"Type: Prescribed Concentration\n", "Type: Prescribed Value\n    Field: Concentration_Flux_Divergence\n"}},
       {"deck.yaml:55:12: Boundary Conditions/Charge/Field: \"Concentration_Flux_Divergence\" cannot be set, since it "
        "is the rate of Concentration, which a material computes"}},
      {"ConditionOnAFieldOfNobody",
       {{"Type: Prescribed Concentration\n", "Type: Prescribed Temperature\n"}},
       {"deck.yaml:53:3: Boundary Conditions/Charge: it acts on the field \"Temperature\", which no material, damage "
        "model or solver of this deck uses"}},
      {"ValueNobodyMeansAtAPoint",
       {{"    Value: \"1.0e-5*min(t/10, 1)\"", "    Value: \"1.0e105*x\""}},
       {"deck.yaml:56:12: the value of \"1.0e105*x\" is 1e+102, too large to be meant, at point "}},
      {"NodeSetOfNoValue",
       {{"{Expression: \"y > 0.0015\"}", "{Expression: \"sqrt(y) > 0.04\"}"}},
       {"deck.yaml:41:30: the value of \"sqrt(y) > 0.04\" is not a number at point 1, (0, -0.002, 0) m"}},
      {"VelocityInStatics",
       {{"Type: Prescribed Concentration\n", "Type: Initial Velocity\n"}},
       {"deck.yaml:53:3: Boundary Conditions/Charge: Initial Velocity does nothing, since no solver of this deck moves "
        "points by their velocity, as Verlet does"}},
      {"LoadWithoutMechanics",
       {{"Type: Prescribed Concentration\n", "Type: Force\n"},
        {"  Staggered:\n    Load Steps: 2\n    Diffusion:\n      Method: Euler\n      Sub Steps: 2\n    Mechanics:\n"
         "      Adaptive Dynamic Relaxation:\n        Iterations Per Load Step: 3\n",
         "  Diffusion: {Method: Euler, Sub Steps: 2}\n"}},
       {"deck.yaml:53:3: Boundary Conditions/Charge: Force does nothing, since no solver of this deck moves points by "
        "forces, as QuasiStatic does"}},
      {"LoadOutOfThePlane",
       {{"Type: Prescribed Concentration\n", "Type: Force\n    Coordinate: z\n"}},
       {"deck.yaml:53:3: condition \"Charge\" acts along z, but the points of this mesh are in one plane and move "
        "along x and y alone"}},
      {"DisplacementOutOfThePlane",
       {{"Coordinate: x\n    Value: {Table", "Coordinate: z\n    Value: {Table"}},
       {"deck.yaml:48:3: condition \"Pull\" acts along z, but the points of this mesh are in one plane and move along "
        "x "
        "and y alone"}},
      {"LoadOfHeldPoints",
       {{"Type: Prescribed Concentration\n    Node Set: Top Node Set\n", "Type: Force\n    Node Set: Left Node Set\n"}},
       {"deck.yaml:53:3: condition \"Charge\" moves nothing: the displacement of all of its points is prescribed along "
        "it. Give its points to one of the two conditions alone"}},
      {"PressureWithoutDirection",
       {{"Type: Prescribed Concentration\n", "Type: Pressure\n    Area: 1.0e-5\n"}},
       {"deck.yaml:53:3: Boundary Conditions/Charge: give one of \"Normal\", \"Center\""}},
      {"PressureInThePlane",
       {{"Type: Prescribed Concentration\n", "Type: Pressure\n    Area: 1.0e-5\n    Normal: [0, 1]\n"}},
       {"deck.yaml:56:13: Boundary Conditions/Charge/Normal must be three numbers, [x, y, z]"}},
      {"PressureAlongNothing",
       {{"Type: Prescribed Concentration\n", "Type: Pressure\n    Area: 1.0e-5\n    Normal: [0, 0, 0]\n"}},
       {"deck.yaml:56:13: Boundary Conditions/Charge/Normal has no length"}},
      {"PressureOnAPartOfARound",
       {{"Type: Prescribed Concentration\n", "Type: Pressure\n    Area: 1.0e-5\n    Center: [0.005, -0.001, 0]\n"}},
       {"deck.yaml:53:3: condition \"Charge\": the normals of its points do not cancel: they sum to 0.75 of the area"}},
      {"TimesReversed",
       {{"Final Time: 10.0", "Final Time: -1.0"}},
       {"deck.yaml:62:15: Solver: Final Time -1 must be after Initial Time 0"}},
      {"NoFinalTime",
       {{"  Final Time: 10.0\n", ""}},
       {"deck.yaml:60:1: Solver lacks \"Final Time\" (a number in s): Time at which this solver ends."}},
      {"UnknownSolver",
       {{"  Staggered:\n", "  Stagered:\n"}},
       {"deck.yaml:63:3: unknown key \"Stagered\" in Solver (did you mean \"Staggered\"?)"}},
      {"TwoSolvers",
       {{"  Staggered:\n", "  Verlet: {Safety Factor: 0.5}\n  Staggered:\n"}},
       {"deck.yaml:60:1: Solver has several solvers: \"Verlet\", \"Staggered\"; give each a section of its own "
        "(Solver1, Solver2, ...)"}},
      {"SolverKey",
       {{"    Load Steps: 2\n", "    Load Stepps: 2\n"}},
       {"deck.yaml:64:5: unknown key \"Load Stepps\" in Solver/Staggered (did you mean \"Load Steps\"?)"}},
      {"SolverIntegerPoint",
       {{"    Load Steps: 2\n", "    Load Steps: 2.0\n"}},
       {"deck.yaml:64:17: Solver/Staggered/Load Steps must be an integer >= 1, not \"2.0\" (write it without a "
        "point)"}},
      {"SolverHuge",
       {{"    Load Steps: 2\n", "    Load Steps: 99999999999\n"}},
       {"deck.yaml:64:17: Solver/Staggered/Load Steps must be an integer >= 1, not \"99999999999\" (too large)"}},
      {"SolverMethod",
       {{"Method: Euler", "Method: Heun"}},
       {"deck.yaml:66:15: Solver/Staggered/Diffusion/Method \"Heun\" is not allowed here"}},
      {"SolverForeignKey",
       {{"      Sub Steps: 2\n", "      Sub Steps: 2\n      Relative Tolerance: 1.0e-3\n"}},
       {"deck.yaml:65:5: Solver/Staggered/Diffusion: give only one of \"Sub Steps\", \"Time Step\", \"Relative "
        "Tolerance\""}},
      {"SolverTwoSteps",
       {{"      Sub Steps: 2\n", "      Sub Steps: 2\n      Time Step: 1.0\n"}},
       {"deck.yaml:65:5: Solver/Staggered/Diffusion: give only one of \"Sub Steps\", \"Time Step\"",
        "deck.yaml:65:5: Solver/Staggered/Diffusion: give only one of \"Sub Steps\", \"Time Step\", \"Relative "
        "Tolerance\""}},
      {"SolverMechanics",
       {{"      Adaptive Dynamic Relaxation:\n", "      Adaptive Relaxation:\n"}},
       {"deck.yaml:68:5: Solver/Staggered/Mechanics: give one of \"Adaptiv",
        "deck.yaml:69:7: unknown key \"Adaptive Relaxation\" in Solver/Staggered/Mechanics"}},
      {"StaggeredField",
       {{staggeredPair,
         "    Solvers:\n      Hydrogen:\n        Diffusion: {}\n        When: {Field: Damagee, Has Changed By: "
         "0.1}\n"}},
       {"deck.yaml:68:23: Solver/Staggered/Solvers/Hydrogen/When/Field: nothing in this deck provides \"Damagee\" (did "
        "you mean \"Damage\"?)"}},
      {"StaggeredKeys",
       {{staggeredPair,
         "    Solvers:\n      Hydrogen:\n        Diffusion: {Load Steps: 2}\n        Every: 0\n      Rest:\n        "
         "Evry: 2\n"
         "        Quasistatic: {}\n"}},
       {"deck.yaml:67:21: unknown key \"Load Steps\" in Solver/Staggered/Solvers/Hydrogen/Diffusion",
        "deck.yaml:68:16: Solver/Staggered/Solvers/Hydrogen/Every is 0, must be >= 1",
        "deck.yaml:70:9: unknown key \"Evry\" in Solver/Staggered/Solvers/Rest (did you mean \"Every\"?)",
        "deck.yaml:71:9: unknown key \"Quasistatic\" in Solver/Staggered/Solvers/Rest (did you mean "
        "\"QuasiStatic\"?)"}},
      {"StaggeredMethodKey",
       {{staggeredPair, "    Solvers:\n      Hydrogen: {Diffusion: {Method: RKL, Allow Unstable Step: true}}\n"}},
       {"deck.yaml:66:64: Solver/Staggered: Solvers/Hydrogen: Diffusion: \"Allow Unstable Step\" has no meaning with "
        "Method: RKL"}},
      {"StaggeredTwice",
       {{staggeredPair,
         "    Solvers:\n      One: {QuasiStatic: {}}\n      Two: {QuasiStatic: {Absolute Tolerance: 1.0}}\n"}},
       {"deck.yaml:66:7: Solver/Staggered: Solvers: \"One\" and \"Two\" are the same solver of the same fields"}},
      {"StaggeredEmpty",
       {{staggeredPair, "    Solvers: {}\n"}},
       {"deck.yaml:63:3: Solver/Staggered: Solvers is empty; it holds solvers by names of your choice"}},
      {"SecondSolverTime",
       {{"Compute Class Parameters:",
         "Solver2:\n  Initial Time: 11.0\n  Final Time: 20.0\n  Diffusion: {}\nCompute Class Parameters:"}},
       {"deck.yaml:72:17: Solver2: Initial Time 11 must be 10, the Final Time of Solver"}},
      {"ComputeClass",
       {{"Reaction_Force\n", "Reaction_Farce\n"}},
       {"deck.yaml:73:20: unknown Compute Class \"Reaction_Farce\" in Compute Class Parameters/Pulling Force (did you "
        "mean \"Reaction_Force\"?)"}},
      {"ComputeNodeSet",
       {{"    Compute Class: Reaction_Force\n    Node Set: Right",
         "    Compute Class: Reaction_Force\n    Node Set: Wrong"}},
       {"deck.yaml:74:15: Compute Class Parameters/Pulling Force/Node Set: there is no node set \"Wrong Node Set\" in "
        "Boundary Conditions (did you mean \"Top Node Set\"?); there are: \"Left Node Set\", \"Right Node Set\", \"Top "
        "Node Set\", \"Corner Node Set\""}},
      {"WorkOfNothing",
       {{"    Compute Class: Reaction_Force\n    Node Set: Right Node Set\n    Output Label: Pulling_Force\n",
         "    Compute Class: External_Work\n"},
        {"Concentration, Pulling_Force]", "Concentration, External_Work]"}},
       {"deck.yaml:72:3: Compute Class Parameters/Pulling Force: no condition of this deck is a load, so that it would "
        "stay 0; name the \"Node Set\""}},
      {"ComputeKey",
       {{"    Output Label: Pulling_Force\n", "    Output Lable: Pulling_Force\n"}},
       {"deck.yaml:75:5: unknown key \"Output Lable\" in Compute Class Parameters/Pulling Force (did you mean \"Output "
        "Label\"?)"}},
      {"ComputeVariable",
       {{"    Compute Class: Reaction_Force\n    Node Set: Right Node Set\n",
         "    Compute Class: Node_Set_Data\n    Node Set: Right Node Set\n    Variable: Displacment\n    Calculation "
         "Type: Sum\n"}},
       {"deck.yaml:75:15: Compute Class Parameters/Pulling Force: no field \"Displacment\" in this run"}},
      {"ComputeBlock",
       {{"    Compute Class: Reaction_Force\n    Node Set: Right Node Set\n",
         "    Compute Class: Block_Data\n    Block: block_7\n    Variable: Displacement\n    Calculation Type: Sum\n"}},
       {"deck.yaml:74:12: Compute Class Parameters/Pulling Force/Block: there is no block \"block_7\" (did you mean "
        "\"block_1\"?); there are: \"block_1\""}},
      {"OutputOfAClass",
       {{"Reaction_Force\n    Node Set: Right Node Set\n    Output Label: Pulling_Force\n",
         "Crack_Length\n    Output Label: Way\n"},
        {"Pulling_Force]", "Crack_Length]"}},
       {"deck.yaml:78:59: Output/Output Variables: \"Crack_Length\" is a class of computes, whose results are called "
        "\"Way\" here; name what is to be written"}},
      {"OutputVariable",
       {{"Displacement, Damage,", "Displacment, Damage,"}},
       {"deck.yaml:79:22: Output/Output Variables: nothing in this deck provides \"Displacment\" (did you mean "
        "\"Displacement\"?)"}},
      {"OutputOfBonds",
       {{"Displacement, Damage,", "Displacement, Bond_Damage,"}},
       {"deck.yaml:79:36: Output/Output Variables: \"Bond_Damage\" is a field of bonds; name the Output Label of a "
        "Bond_Field_Mean of it, a compute"}},
      {"OutputFrequency",
       {{"Output Frequency: 1", "Output Frequency: often"}},
       {"deck.yaml:78:21: Output/Output Frequency must be an integer >= -1, not \"often\""}},
      {"OutputSteps",
       {{"Output Frequency: 1", "Output Steps: 5"}},
       {"deck.yaml:78:17: Output/Output Steps must be a list of numbers >= 0, not \"5\""}},
      {"OutputStepPart",
       {{"Output Frequency: 1", "Output Steps: [1, 2.5]"}},
       {"deck.yaml:78:21: Output/Output Steps[2] must be an integer, not \"2.5\""}},
      {"OutputOrder",
       {{"Output Frequency: 1", "Output Frequency: 1\n  Initial Output Step: 5\n  Final Output Step: 2"}},
       {"deck.yaml:80:22: Output: Final Output Step 2 is before Initial Output Step 5"}},
      {"OutputTwoFiles",
       {{"Output:\n",
         "Output2: {Output Filename: results, Output Frequency: 1, Output Variables: [Damage]}\nOutput:\n"}},
       {"deck.yaml:78:20: Output: \"results\" is the Output Filename of Output2 already; each writes a file of its "
        "own"}},
      {"OutputNameAbove",
       {{"Output Filename: results", "Output Filename: out/../../results"}},
       {"deck.yaml:77:20: Output/Output Filename must not lead out of the folder of the run (\"..\"); the folder that "
        "results go to is named by pdrun --output-folder FOLDER"}},
      {"OutputNameAbsolute",
       {{"Output Filename: results", "Output Filename: /tmp/results"}},
       {"deck.yaml:77:20: Output/Output Filename must be a path below the folder of the run, not an absolute one; the "
        "folder that results go to is named by pdrun --output-folder FOLDER"}},
      {"OutputNameFolder",
       {{"Output Filename: results", "Output Filename: results/"}},
       {"deck.yaml:77:20: Output/Output Filename must end with a name, not with a folder"}},
      {"OutputNameColon",
       {{"Output Filename: results", "Output Filename: \"run:1\""}},
       {"deck.yaml:77:20: Output/Output Filename must not contain :, which XDMF and CSV files cannot tell from their "
        "own"}},
      {"OutputNameOfTwoLines",
       {{"Output Filename: results", "Output Filename: \"run\\n1\""}},
       {"deck.yaml:77:20: Output/Output Filename must not contain a line break, a tab or another control character, "
        "which XDMF and CSV files cannot tell from their own"}},
      {"OutputSameFileTwice",
       {{"Output:\n",
         "Output2: {Output Filename: ./results, Output Frequency: 1, Output Variables: [Damage]}\nOutput:\n"}},
       {"deck.yaml:78:20: Output: \"results\" is the Output Filename of Output2 already; each writes a file of its "
        "own"}},
      {"LabelComma",
       {{"Output Label: Pulling_Force", "Output Label: \"Pull, N\""},
        {"Concentration, Pulling_Force", "Concentration"}},
       {"deck.yaml:75:19: Compute Class Parameters/Pulling Force/Output Label must not contain ,: it is the heading of "
        "a column and the name of a table; use letters, digits and _"}},
      {"LabelOfTwoLines",
       {{"Output Label: Pulling_Force", "Output Label: \"Pull\\nN\""},
        {"Concentration, Pulling_Force", "Concentration"}},
       {"deck.yaml:75:19: Compute Class Parameters/Pulling Force/Output Label must not contain a line break, a tab or "
        "another control character: it is the heading of a column and the name of a table; use letters, digits and _"}},
      {"LabelTaken",
       {{"Output Label: Pulling_Force", "Output Label: time"}, {"Concentration, Pulling_Force", "Concentration"}},
       {"deck.yaml:75:19: Compute Class Parameters/Pulling Force/Output Label must not be \"time\": the history has a "
        "column of this name already"}},
      {"OutputFileType",
       {{"Output Frequency: 1", "Output Frequency: 1\n  Output File Type: ExodusII"}},
       {"deck.yaml:79:3: unknown key \"Output File Type\" in Output (did you mean \"Output Filename\"?)"}},
      {"ExactSolution",
       {{"Output:\n", "Exact Solution:\n  Front: {Field: Concentrate, Value: 0}\nOutput:\n"}},
       {"deck.yaml:77:18: Exact Solution/Front/Field: nothing in this deck provides \"Concentrate\" (did you mean "
        "\"Concentration\"?)"}},
      {"MeshFourNumbers",
       {},
       {"mesh.txt:4: a point has 5 numbers (x y z block_id volume), this line has 4"},
       "0.002 -0.002 0.0 1",
       ""},
      {"MeshText", {}, {"mesh.txt:4: z is \"zero\", not a finite number"}, "0.002 -0.002 zero 1 1.0e-9", ""},
      {"MeshNan", {}, {"mesh.txt:4: y is \"nan\", not a finite number"}, "0.002 nan 0.0 1 1.0e-9", ""},
      {"MeshNegativeVolume",
       {},
       {"mesh.txt:4: the volume (fifth column) must be greater than 0; the columns are x y z block_id volume"},
       "0.002 -0.002 0.0 1 -1.0e-9",
       ""},
      {"MeshZeroVolume",
       {},
       {"mesh.txt:4: the volume (fifth column) must be greater than 0; the columns are x y z block_id volume"},
       "0.002 -0.002 0.0 1 0.0",
       ""},
      {"MeshTinyVolume",
       {},
       {"deck.yaml:2:3: volumes and coordinates do not fit: the volume 1e-300 m3 of the point mesh.txt:4 means a "
        "spacing "
        "of 3.162e-149 m (square root of volume / thickness), but the next point is 0.001 m away"},
       "0.002 -0.002 0.0 1 1.0e-300",
       ""},
      {"MeshDuplicate",
       {},
       {"mesh.txt:4: this point is at the same place as the one in line 3; remove one of them"},
       "0.001 -0.002 0.0 1 1.0e-9",
       ""},
      {"MeshBlockZero",
       {},
       {"mesh.txt:4: the block number (fourth column) must be an integer of 1 or more; the columns are x y z block_id "
        "volume"},
       "0.002 -0.002 0.0 0 1.0e-9",
       ""},
      {"MeshOtherBlock",
       {},
       {"deck.yaml:32:1: no entry of Blocks gives a material and a horizon to block_2 of the mesh mesh.txt; name them "
        "in Block Names, or use \"default\""},
       "0.002 -0.002 0.0 2 1.0e-9",
       ""},
      {"MeshFarPoint",
       {},
       {"mesh.txt:4: the point (5, -0.002, 0) has no neighbours within its horizon of 0.0031 m; choose a larger "
        "Horizon, or set `Count In Damage: true` on the bond filter that takes its bonds away"},
       "5.0 -0.002 0.0 1 1.0e-9",
       ""},
      {"SetBeyondMesh", {}, {"left.txt:2: node 56 is not in the mesh, whose nodes are 1 to 55"}, "", "1 2\n56\n"},
      {"SetZero", {}, {"left.txt:1: node 0 is not in the mesh, whose nodes are 1 to 55"}, "", "0\n"},
      {"SetText", {}, {"left.txt:2: \"left\" is not a node number"}, "", "1\nleft\n"},
      {"SetEmpty", {}, {"left.txt: the node set has no node numbers (named in deck.yaml:39:18)"}, "", "# none\n"},
      {"SetInlineBeyond",
       {{"Corner Node Set: 1 2 3", "Corner Node Set: 1 2 99"}},
       {"deck.yaml:42:20: node 99 is not in the mesh, whose nodes are 1 to 55"}},
      {"SetBoxEmpty",
       {{"[[0.0095, -1.0, -1.0], [0.0105, 1.0, 1.0]]", "[[9.5, -1.0, -1.0], [10.5, 1.0, 1.0]]"}},
       {"deck.yaml:40:19: node set \"Right Node Set\" has no points (the mesh spans [0, 0.01] x [-0.002, 0.002] x [0, "
        "0] m)"}},
      {"ConflictingConditions",
       {{"  Keep:\n",
         "  Hold:\n    Type: Prescribed Displacement\n    Node Set: Left Node Set\n    Value: 1.0\n  Keep:\n"}},
       {"deck.yaml:57:3: conditions \"Clamp\" and \"Hold\" prescribe different values of the same Displacement "
        "component x where their node sets overlap; take those points out of one of the node sets"}},
      {"ConflictingInitialValues",
       {{"  Keep:\n",
         "  Start: {Type: Initial Concentration, Node Set: Left Node Set, Value: 1.0}\n"
         "  Spot: {Type: Initial Concentration, Node Set: Corner Node Set, Value: 2.0}\n  Keep:\n"}},
       {"deck.yaml:58:3: conditions \"Start\" and \"Spot\" start from different values of the same Concentration where "
        "their node sets overlap; take those points out of one of the node sets"}},
      {"Several",
       {{"Density: 7850.0", "Density: -1"},
        {"Horizon: 3.1e-3", "Horizn: 3.1e-3"},
        {"Coordinate: x\n    Value: 0.0", "Coordinate: q\n    Value: 0.0"},
        {"Final Time: 10.0", "Final Tim: 10.0"},
        {"Damage, Conc", "Damge, Conc"}},
       {"deck.yaml:22:14: Materials/Steel/Density is -1, must be > 0 kg/m3",
        "deck.yaml:37:5: unknown key \"Horizn\" in Blocks/Plate (did you mean \"Horizon\"?)",
        "deck.yaml:46:17: Boundary Conditions/Clamp/Coordinate \"q\" is not allowed here (one of \"x\", \"y\", \"z\")",
        "deck.yaml:62:3: unknown key \"Final Tim\" in Solver (did you mean \"Final Time\"?)",
        "deck.yaml:79:36: Output/Output Variables: unknown field or compute \"Damge\" (did you mean \"Damage\"?)"}},
  };
}

}  // namespace pd_test
