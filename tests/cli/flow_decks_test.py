#!/usr/bin/python3
"""What `pdrun --check` says of decks of flows."""
import copy
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from scene import CheckedDeck, lattice  # noqa: E402

DECK = {
    "Discretization": {"Type": "Text File", "Input Mesh File": "mesh.txt"},
    "Materials": {"Water": {"Material Model": "Navier Stokes", "Plane Strain": True, "Density": 1000.0,
                            "Viscosity": 1e-3}},
    "Blocks": {"Left": {"Block Names": "block_1", "Material": "Water", "Horizon": 0.3015},
               "Right": {"Block Names": "block_2", "Material": "Water", "Horizon": 0.3015}},
    "Boundary Conditions": {
        "Walls Node Set": {"Expression": "x < 0 || x > 1 || y < 0"}, "Lid Node Set": {"Expression": "y > 1"},
        "Walls": {"Type": "Prescribed Velocity", "Node Set": "Walls Node Set", "Surface": "min(min(x, 1 - x), y)"},
        "Lid": {"Type": "Prescribed Velocity", "Node Set": "Lid Node Set", "Velocity": [1e-6, 0.0],
                "Surface": "1 - y"}},
    "Solver": {"Final Time": 1.0, "Steady Flow": {}},
    "Output": {"Output Filename": "result", "Output Frequency": 1, "Output Variables": ["Velocity", "Pressure"]}}


def push_at(place, value=1.0):
    def push(deck):
        deck["Boundary Conditions"].update({
            "Pushed Node Set": {"Expression": place},
            "Weight": {"Type": "Flow Body Force", "Node Set": "Pushed Node Set", "Coordinate": "x", "Value": value}})
    return push


class FlowDecks(CheckedDeck):
    DECK = DECK

    def setUp(self):
        super().setUp()
        points = lattice([1.8, 1.8], 0.1, origin=[-0.4, -0.4])
        self.write_mesh(points, 0.01, block=np.where(points[:, 0] < 0.5, 1, 2))

    def test_the_deck_is_good(self):
        result = self.check(lambda deck: None)
        self.assertEqual(result.code, 0, result.text)

    def test_points_on_the_wrong_side_of_a_surface(self):
        def turn_round(deck):
            deck["Boundary Conditions"]["Lid"]["Surface"] = "y - 1"
        self.assert_refused(turn_round, 'condition "Lid"', "of its node set is not beyond its Surface",
                            "which is fluid; it must be positive there")

    def test_surfaces_stay_where_they_are(self):
        def move(deck):
            deck["Boundary Conditions"]["Lid"]["Surface"] = "1 - y - t"
        self.assert_refused(move, "Boundary Conditions/Lid/Surface depends on the time")

    def test_velocities_have_values_on_the_boundary(self):
        def break_velocity(deck):
            deck["Boundary Conditions"]["Lid"]["Velocity"] = ["sqrt(y - 1.01)", 0.0]
        self.assert_refused(break_velocity, "has no finite value at")

    def test_an_outflow_says_where_it_is(self):
        def open_lid(deck):
            deck["Boundary Conditions"]["Lid"] = {"Type": "Outflow", "Node Set": "Lid Node Set"}
        self.assert_refused(open_lid, '"Surface"')

    def test_fluids_of_different_viscosity(self):
        def change_right(deck):
            deck["Materials"]["Oil"] = {**deck["Materials"]["Water"], "Viscosity": 0.1}
            deck["Blocks"]["Right"]["Material"] = "Oil"
        self.assert_refused(change_right, 'the fluids of the blocks "block_1" and "block_2" differ')

    def test_a_flow_needs_a_fluid(self):
        def solidify(deck):
            deck["Materials"]["Water"] = {"Material Model": "Diffusion", "Plane Strain": True, "Coefficient": 1.0}
        self.assert_refused(solidify, "Navier Stokes")

    def test_a_channel_without_fluid(self):
        def swap(deck):
            # The fluid is named for the walls alone.
            deck["Materials"]["Stone"] = {"Material Model": "Diffusion", "Coefficient": 1e-9, "Plane Strain": True}
            deck["Blocks"]["Left"]["Material"] = deck["Blocks"]["Right"]["Material"] = "Stone"
            deck["Blocks"]["Far"] = {"Block Names": "block_3", "Material": "Water", "Horizon": 0.3015}
        points = lattice([1.8, 1.8], 0.1, origin=[-0.4, -0.4])
        inside = np.all((points[:, :2] > 0) & (points[:, :2] < 1), axis=1)
        self.write_mesh(points, 0.01, block=np.where(inside, np.where(points[:, 0] < 0.5, 1, 2), 3))
        self.assert_refused(swap, "no point is fluid")

        def leave_out(deck):
            self.carry(deck, Diffusivity=1e-6)
            deck["Blocks"]["Left"]["Material"] = "Salt"
        self.assert_refused(leave_out, "Blocks/Left", "no material of this block is a fluid")

    def test_gradients_of_neighbours_lie_within_the_horizon(self):
        def reach_further(deck):
            deck["Materials"]["Water"]["Gradient Horizon"] = 0.25
        self.assert_refused(reach_further, '"Gradient Horizon"')

    def test_a_gap_without_neighbours(self):
        def narrow(deck):
            deck["Boundary Conditions"]["Walls Node Set"]["Expression"] = "x < 0 || x > 1 || y < 0 || y < 0.9"
            deck["Boundary Conditions"]["Walls"]["Surface"] = "min(min(x, 1 - x), y - 0.9)"
        result = self.check(narrow)  # one row of points: its neighbours are walls, which is enough for viscosity
        self.assertIn(result.code, (0, 2), result.text)
        if result.code == 2:
            self.assertIn("the gap is too narrow", result.text)

    def test_a_plane_flow_has_no_velocity_along_z(self):
        def slant(deck):
            deck["Boundary Conditions"]["Lid"]["Velocity"] = [1e-6, 0.0, 1e-6]
        self.assert_refused(slant, 'condition "Lid"', "has a component along z")

    def test_one_boundary_has_one_velocity(self):
        def give_another(deck):
            deck["Boundary Conditions"]["Second"] = {"Type": "Prescribed Velocity", "Node Set": "Lid Node Set",
                                                     "Velocity": [2e-6, 0.0], "Surface": "1 - y"}
        self.assert_refused(give_another, 'conditions "Lid" and "Second" give the flow different values at one Surface where '
                            "their node sets overlap")

    def test_two_surfaces_at_one_place(self):
        def split(deck, velocity, surface="2*(1 - y)"):
            conditions = deck["Boundary Conditions"]
            conditions["Right Node Set"] = {"Expression": "y > 1 && x > 0.5"}
            conditions["Lid Node Set"]["Expression"] = "y > 1 && x < 0.5"
            conditions["Right"] = {**conditions["Lid"], "Node Set": "Right Node Set", "Velocity": [velocity, 0.0],
                                   "Surface": surface}
            return deck

        def follow(deck, velocity):
            split(deck, velocity)["Boundary Conditions"]["Lid"]["Velocity"] = ["1e-6*t", 0.0]
        self.assert_refused(lambda deck: split(deck, 2e-6), 'condition "Right"', "its Surface and that of",
                            'condition "Lid" are one place there, to which they give different values')
        self.assertEqual(self.check(lambda deck: split(deck, 1e-6)).code, 0)
        self.assert_refused(lambda deck: split(deck, 2e-6, "1 - y - 1e-7"), "are one place there")
        self.assert_refused(lambda deck: follow(deck, "2e-6*t"), "are one place there")
        self.assertEqual(self.check(lambda deck: follow(deck, "1e-6*t")).code, 0)

        def part(deck):
            conditions = split(deck, 2e-6)["Boundary Conditions"]
            conditions["Lid"]["Surface"], conditions["Right"]["Surface"] = "max(1 - y, x - 0.5)", "max(1 - y, 0.5 - x)"
        self.assertEqual(self.check(part).code, 0)

    def test_an_outflow_in_parts(self):
        def part(pressure, surface="1 - y", first=0.0):
            def change(deck):
                conditions = deck["Boundary Conditions"]
                conditions["Lid Node Set"]["Expression"] = "y > 1 && x < 0.5"
                conditions["Right Node Set"] = {"Expression": "y > 1 && x >= 0.5"}
                conditions["Lid"] = {"Type": "Outflow", "Node Set": "Lid Node Set", "Surface": surface, "Pressure": first}
                conditions["Right"] = {"Type": "Outflow", "Node Set": "Right Node Set", "Surface": "1 - y",
                                       "Pressure": pressure} if pressure is not None else {
                                           "Type": "Prescribed Velocity", "Node Set": "Right Node Set"}
            return change
        for pressure in (0.1, "0.1*t"):
            result = self.check(part(pressure, first=pressure))
            self.assertEqual(result.code, 0, result.text)
        self.assert_refused(part(0.2), "are one place there, to which they give different values")
        # The other half is a wall without a Surface, of which that of the outflow would make a hole.
        self.assert_refused(part(None, "0.98 - y"), 'condition "Lid"', "its Surface also ends bonds into", 'condition "Right"')
        result = self.check(part(None, "0.98 - y + 9*(x >= 0.5)"))
        self.assertEqual(result.code, 0, result.text)

    def test_points_are_reflected_at_surfaces(self):
        def reflect(deck):
            deck["Materials"]["Water"]["Walls"] = "Reflected Points"
        self.assertEqual(self.check(reflect).code, 0)

        def take_away(deck):
            reflect(deck)
            deck["Boundary Conditions"]["Walls"].pop("Surface")
        self.assert_refused(take_away, 'has no Surface, by which "Walls: Reflected Points" of Navier Stokes mirrors')

    def test_nothing_breaks_in_a_fluid(self):
        def break_it(deck):
            deck["Damage Models"] = {"Brittle": {"Damage Model": "Critical Stretch", "Critical Stretch": 0.01}}
            deck["Blocks"]["Left"]["Damage Model"] = "Brittle"
        self.assert_refused(break_it, "Blocks/Left: Damage Models/Brittle breaks bonds that deform, but no material of this "
                            "block carries load")

    def test_a_ring_through_a_wall(self):
        def measure(deck):
            deck["Compute Class Parameters"] = {"Drag": {
                "Compute Class": "Flow_Force", "Center X": 0.5, "Center Y": 0.5, "Inner Radius": 0.3, "Outer Radius": 0.6,
                "Output Label": "Drag"}}
            deck["Output"]["Output Variables"].append("Drag")
        self.assert_refused(measure, "points between \"Inner Radius\" and \"Outer Radius\" are not fluid")

    def test_computes_without_a_point(self):
        def go_past(deck):
            deck["Compute Class Parameters"] = {"Past": {"Compute Class": "Mass_Flow", "Point X": 2.0, "Normal X": 1.0,
                                                         "Width": 0.2}}
        self.assert_refused(go_past, "no point lies within \"Width\" of the plane")

        def go_round_nothing(deck):
            deck["Compute Class Parameters"] = {"Drag": {"Compute Class": "Flow_Force", "Center X": 5.0,
                                                         "Inner Radius": 0.1, "Outer Radius": 0.4}}
            deck["Output"]["Output Variables"] = ["Velocity", "Flow_Force"]
        self.assert_refused(go_round_nothing, "no point lies between \"Inner Radius\" and \"Outer Radius\"")

    def test_the_force_of_a_flow_is_that_of_steady_flow(self):
        def measure(deck):
            deck["Compute Class Parameters"] = {"Drag": {
                "Compute Class": "Flow_Force", "Center X": 0.5, "Center Y": 0.5, "Inner Radius": 0.1,
                "Outer Radius": 0.4}}

        def push(deck):
            measure(deck)
            push_at("x > 0 && x < 1 && y > 0 && y < 1")(deck)
        self.assert_refused(push, "Compute Class Parameters/Drag: Flow_Force does not count Boundary Conditions/Weight")

        def start(deck):
            measure(deck)
            deck["Solver"] = {"Final Time": 1e-3, "Weakly Compressible Flow": {"Sound Speed": 1.0}}
        result = self.check(start)
        self.assertEqual(result.code, 0, result.text)
        self.assertIn("it counts once the flow has become steady", result.text)

    def test_forces_act_on_fluid(self):
        self.assert_refused(push_at("y > 1"), 'condition "Weight" moves nothing: none of its points is fluid')
        self.assert_refused(push_at("x > 0 && x < 1 && y > 0 && y < 1", "1/(x-x)"),
                            'the value of "1/(x-x)" is infinite')

    def test_a_flow_that_runs_away(self):
        deck = copy.deepcopy(DECK)
        push_at("x > 0 && x < 1 && y > 0 && y < 1", 1e100)(deck)
        deck["Solver"] = {"Final Time": 1.0, "Weakly Compressible Flow": {"Sound Speed": 1.0}}
        result = self.run_deck(deck)
        self.assertEqual(result.code, 3, result.text)
        self.assertIn("s: velocities or pressures are no longer finite: the flow is not stable", result.text)

    def test_what_flows_into_a_closed_part_must_leave_it(self):
        deck = copy.deepcopy(DECK)
        deck["Boundary Conditions"]["Lid"]["Velocity"] = [0.0, "-6e-6*x*(1 - x)"]
        result = self.run_deck(deck)
        self.assertEqual(result.code, 3, result.text)
        self.assertIn("Give it an Outflow", result.text)


    def carry(self, deck, **more):
        deck["Materials"]["Salt"] = {"Material Model": "Advection Diffusion", "Plane Strain": True, **more}
        for name in ("Left", "Right"):
            deck["Blocks"][name]["Material"] = ["Water", "Salt"]
        deck["Solver1"] = {"Final Time": 1.0, "Steady Flow": {}}
        deck["Solver2"] = {"Initial Time": 1.0, "Final Time": 2.0,
                           "ImplicitDiffusion": {"Field": "Concentration", "Linear Solver": "GMRES"}}
        deck["Boundary Conditions"]["Lid Salt"] = {"Type": "Prescribed Concentration", "Node Set": "Lid Node Set",
                                                   "Value": 1.0}
        deck.pop("Solver")

    def test_what_a_flow_carries_needs_a_flow(self):
        self.assertEqual(self.check(lambda deck: self.carry(deck, Diffusivity=1e-6)).code, 0)

        def rest(deck):
            self.carry(deck)
            deck["Solver"] = deck.pop("Solver2")
            deck["Solver"].pop("Initial Time")
            deck.pop("Solver1")
            for name in ("Walls", "Lid"):
                deck["Boundary Conditions"].pop(name)
            deck["Output"]["Output Variables"] = ["Concentration"]
        self.assert_refused(rest, "Bond_Flow")

    def test_keys_of_what_a_flow_carries(self):
        self.assert_refused(lambda deck: self.carry(deck, **{"Upwind Share": 0.5}), "Upwind Share", "Upwind Biased")
        self.assert_refused(lambda deck: self.carry(deck, **{"Gradient Horizon": 0.2}), "Gradient Horizon", "half")
        self.assert_refused(lambda deck: deck["Materials"]["Water"].update({"Flux Horizon": 0.4}), "Flux Horizon")

    def test_one_material_lets_ions_diffuse(self):
        def diffuse_twice(deck):
            self.carry(deck, Diffusivity=1e-9)
            deck["Materials"]["Wire"] = {"Material Model": "Corrosion Dissolution", "Plane Strain": True,
                                         "Diffusivity": 1e-9, "Solid Concentration": 71508.0,
                                         "Saturation Concentration": 20.0, "Charge Number": 2.0,
                                         "Current Density": "5.73"}
            deck["Damage Models"] = {"Phases": {"Damage Model": "Dissolution"}}
            deck["Blocks"]["Left"].update({"Material": ["Water", "Salt", "Wire"], "Damage Model": "Phases"})
        self.assert_refused(diffuse_twice, "Materials/Salt/Diffusivity", "leave it out here")

    def test_what_leaves_by_an_outflow_is_taken_up(self):
        def leave(deck):
            self.carry(deck, Diffusivity=1e-6)
            deck["Boundary Conditions"]["Lid"] = {"Type": "Outflow", "Node Set": "Lid Node Set", "Surface": "1 - y"}
        self.assertEqual(self.check(leave).code, 0)

        def pile_up(deck):
            leave(deck)
            deck["Boundary Conditions"]["Lid Salt"]["Node Set"] = "Walls Node Set"
            deck["Boundary Conditions"]["Walls Node Set"]["Expression"] = "y <= 1 && (x < 0 || x > 1 || y < 0)"
        self.assert_refused(pile_up, 'condition "Lid"', '"Concentration"', "pile up")

    def test_blocks_downstream_carry_it_too(self):
        def forget(deck):
            self.carry(deck, Diffusivity=1e-6)
            deck["Blocks"]["Right"]["Material"] = "Water"
        self.assert_refused(forget, 'from block "block_1" into block "block_2"', '"Concentration"')

    def test_the_flow_comes_first(self):
        def swap(deck):
            self.carry(deck, Diffusivity=1e-6)
            deck["Solver1"]["ImplicitDiffusion"] = deck["Solver2"].pop("ImplicitDiffusion")
            deck["Solver2"]["Steady Flow"] = deck["Solver1"].pop("Steady Flow")
        self.assert_refused(swap, "Solver1", "before Solver2", "finds the flow")
        deck = copy.deepcopy(DECK)
        self.carry(deck, Diffusivity=1e-6)
        deck["Solver"] = {"Final Time": 1.0, "Staggered": {"Load Steps": 2, "Solvers": {
            "Flow": {"Steady Flow": {}, "When": {"Field": "Concentration", "Has Changed By": 1e9}},
            "Salt": deck.pop("Solver2")}}}
        deck["Solver"]["Staggered"]["Solvers"]["Salt"].pop("Initial Time")
        deck["Solver"]["Staggered"]["Solvers"]["Salt"].pop("Final Time")
        deck.pop("Solver1")
        result = self.run_deck(deck)
        self.assertEqual(result.code, 3, result.text)
        self.assertIn("none has been found yet", result.text)

    def test_bonds_that_carry_reach_a_neighbour(self):
        def shorten(deck):
            self.carry(deck, Diffusivity=1e-6)
            deck["Materials"]["Water"]["Flux Horizon"] = 0.09
        self.assert_refused(shorten, "within the Flux Horizon")

    def test_later_solvers_refuse_at_once(self):
        for solver in ({"ImplicitDiffusion": {"Field": "Concentration"}}, {"Diffusion": {"Method": "RKL"}},
                       {"Staggered": {"Load Steps": 1, "Solvers": {"Salt": {"Diffusion": {"Method": "Euler"}}}}}):
            def explicit(deck):
                self.carry(deck, Diffusivity=1e-6)
                deck["Solver2"].pop("ImplicitDiffusion")
                deck["Solver2"].update(solver)
            self.assert_refused(explicit, f": Solver2/{next(iter(solver))}: ", "a flow carries \"Concentration\"")

    def test_what_a_flow_carries_is_advanced(self):
        self.assert_refused(lambda deck: self.carry(deck, Field="Ions"), "Materials/Salt", 'advances "Ions"')

    def test_explicit_steps(self):
        def explicit(**solver):
            def change(deck):
                del deck["Solver"]["Steady Flow"]
                deck["Solver"]["Weakly Compressible Flow"] = {"Sound Speed": 1e-4, **solver}
                deck["Solver"]["Final Time"] = 1e5
            return change
        result = self.check(explicit())
        self.assertEqual(result.code, 0, result.text)
        self.assert_refused(explicit(**{"Time Step": 1e4}), "is above the critical one", "CFL number", '"Sound Speed"')
        self.assert_refused(explicit(**{"Sound Speed": 4e-6}), "Mach number of 0.25", '"Sound Speed" of 1e-05 m/s or more')
        def without_sound(deck):
            deck["Solver"]["Weakly Compressible Flow"] = deck["Solver"].pop("Steady Flow")
        self.assert_refused(without_sound, "Sound Speed")

    def test_forces_on_flows(self):
        force = {"Type": "Flow Body Force", "Node Set": "Lid Node Set", "Coordinate": "z", "Value": 1.0}
        self.assert_refused(lambda deck: deck["Boundary Conditions"].update(Force=force), "acts along z")

    def test_films_need_metal_that_dissolves(self):
        film = {"Type": "Film Coverage", "Node Set": "Walls Node Set", "Value": 0.5}
        self.assert_refused(lambda deck: deck["Boundary Conditions"].update(Film=film), "dissolves metal")


if __name__ == "__main__":
    unittest.main()
