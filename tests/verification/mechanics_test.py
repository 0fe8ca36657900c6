#!/usr/bin/python3
"""Statics of PDHE and Elastic against exact solutions: patch tests, moduli of lattices, strips with free edges."""
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
sys.path.insert(0, sys.path[0] + "/../../decks/fracture_energy")
from lattices import lattice_points  # noqa: E402
from scene import SceneTest, lattice, plate_deck  # noqa: E402

E = 207.0e9


def share(rule, distance, horizon, spacing):
    """Volume share of a neighbour: FA, PV and HHB of the field's literature."""
    inside = distance <= horizon * (1.0 + 1e-10)
    ramp = np.clip((horizon + 0.5 * spacing - distance) / spacing, 0.0, 1.0)
    return {"None": inside * 1.0, "Ramp To Horizon": inside * ramp, "Ramp Beyond Horizon": ramp}[rule]


def lattice_moduli(m, nu, rule):
    """C11 and C12 of the two-parameter model on the unit square lattice of unit thickness, plane stress."""
    reach = int(m) + 2
    i, j = np.meshgrid(np.arange(-reach, reach + 1), np.arange(-reach, reach + 1))
    x, y = i[(i != 0) | (j != 0)].astype(float), j[(i != 0) | (j != 0)].astype(float)
    r = np.hypot(x, y)
    kn = 6.0 * E / (np.pi * m**3 * (1.0 - nu))
    kt = kn * (1.0 - 3.0 * nu) / (1.0 + nu)
    w, c2, s2 = 0.5 * r * share(rule, r, m, 1.0), (x / r) ** 2, (y / r) ** 2
    return np.sum(w * (kn * c2**2 + kt * c2 * s2)), np.sum(w * (kn - kt) * c2 * s2)


def blocks_of(deck, materials):
    """Sections of the deck in which block k has the k-th of these parameters besides those of its own material."""
    material, block = deck["Materials"]["Steel"], deck["Blocks"]["Body"]
    names = [f"Steel {k}" for k in range(1, len(materials) + 1)]
    return {"Materials": {name: {**material, **parameters} for name, parameters in zip(names, materials)},
            "Blocks": {name: {**block, "Block Names": f"block_{k}", "Material": name}
                       for k, name in enumerate(names, 1)}}


class Patch(SceneTest):
    """Uniform deformation, prescribed in a layer around the plate, is a solution inside. The layer is two horizons deep:
    within one of the edge, neighbourhoods are cut off, and their rotation is not that of the deformation."""

    def error_of(self, ux, uy, nu, steps=1, **material):
        self.write_mesh(lattice([0.026, 0.022], 1e-3), 1e-6 * 4e-3)
        collar = "x < 0.0075 || x > 0.0185 || y < 0.0075 || y > 0.0145"
        hold = {"Type": "Prescribed Displacement", "Node Set": "Collar Node Set"}
        deck = plate_deck(
            3.015e-3, 4e-3, {"Young's Modulus": E, "Poisson's Ratio": nu, "Density": 7850.0, **material},
            conditions={"Collar Node Set": {"Expression": collar},
                        "Hold x": {**hold, "Coordinate": "x", "Value": ux},
                        "Hold y": {**hold, "Coordinate": "y", "Value": uy}},
            solver={"QuasiStatic": {"Load Steps": steps, "Relative Tolerance": 1e-9}},
            output={"Output Variables": ["Displacement"]},
            Exact_Solution={"X": {"Field": "Displacement", "Coordinate": "x", "Value": ux},
                            "Y": {"Field": "Displacement", "Coordinate": "y", "Value": uy}})
        norms = self.solve(deck).report["error_norms"]
        return max(value for name, value in norms.items() if "L2" in name)

    def test_uniaxial_strain_shear_and_translation(self):
        """Plates of four Poisson's ratios above each other in one run."""
        ratios, plate, rise = (0.0, 0.29, 1.0 / 3.0, 0.4), lattice([0.026, 0.022], 1e-3), 0.03
        points = np.vstack([plate + [0.0, k * rise, 0.0] for k in range(len(ratios))])
        self.write_mesh(points, 1e-6 * 4e-3, block=1 + np.repeat(np.arange(len(ratios)), len(plate)))
        within = " || ".join(f"abs(y - {0.011 + k * rise}) < 0.0036" for k in range(len(ratios)))
        hold = {"Type": "Prescribed Displacement", "Node Set": "Collar Node Set"}
        for ux, uy in (("1e-4*x*t", "-2e-5*y*t"), ("1e-4*y*t", "3e-5*x*t"), ("1e-3*t + 0*x", "-2e-3*t + 0*x")):
            deck = plate_deck(
                3.015e-3, 4e-3, conditions={
                    "Collar Node Set": {"Expression": f"!(x >= 0.0075 && x <= 0.0185 && ({within}))"},
                    "Hold x": {**hold, "Coordinate": "x", "Value": ux},
                    "Hold y": {**hold, "Coordinate": "y", "Value": uy}},
                solver={"QuasiStatic": {"Load Steps": 1, "Relative Tolerance": 1e-9}},
                output={"Output Variables": ["Displacement"]})
            deck.update(blocks_of(deck, [{"Young's Modulus": E, "Poisson's Ratio": nu, "Density": 7850.0}
                                         for nu in ratios]))
            exact = [eval(u, {"x": points[:, 0], "y": points[:, 1], "t": 1.0}) for u in (ux, uy)]
            error = self.solve(deck).field("Displacement")[:, :2] - np.column_stack(exact)
            # Over what a plate at the origin moves.
            scale = np.linalg.norm(np.column_stack(exact)[:len(plate)])
            for nu, part in zip(ratios, error.reshape(len(ratios), -1)):
                # Displacements are solved to 1e-9 of the reaction; rounding of coordinates adds 1e-17/1e-6.
                self.assertLess(np.linalg.norm(part) / scale, 1e-7, (nu, ux, uy))

    def test_linear_form_in_small_strain(self):
        self.assertLess(self.error_of("1e-4*x*t", "2e-5*x*t", 0.2, **{"Tangential Force": "Linear"}), 1e-7)

    def test_rigid_rotation_by_half_a_radian(self):
        ux, uy = "(cos(0.5*t)-1)*x - sin(0.5*t)*y", "sin(0.5*t)*x + (cos(0.5*t)-1)*y"
        for nu in (0.1, 0.29):
            self.assertLess(self.error_of(ux, uy, nu, steps=10), 1e-7)


class LinearPeridynamicSolid(SceneTest):
    """Material Elastic on a cube or a plate that is deformed as a whole. Silling et al., J. Elasticity 88 (2007) 151: the
    dilatation under a uniform expansion and its energy are exact in any neighbourhood, cut off or not."""

    bulk, shear, spacing, thickness = 130e9, 60e9, 1e-3, 4e-3

    def fields(self, *functions, **plane):
        """`plane`: flags of a plate."""
        dimension = len(functions)
        self.write_mesh(lattice([10e-3] * dimension, self.spacing),
                        self.spacing**dimension * (self.thickness if plane else 1.0))
        conditions = {"Whole Node Set": {"Expression": "x > -1"}}
        for axis, function in zip("xyz", functions):
            conditions[axis] = {"Type": "Prescribed Displacement", "Node Set": "Whole Node Set", "Coordinate": axis,
                                "Value": function}
        deck = plate_deck(3.015 * self.spacing, self.thickness, conditions=conditions,
                          solver={"Final Time": 1e-9, "Verlet": {"Fixed dt": 1e-9}},
                          output={"Output Variables": ["Dilatation", "Stored_Elastic_Energy_Density"]})
        deck["Materials"]["Steel"] = {"Material Model": "Elastic", "Density": 7850.0, "Bulk Modulus": self.bulk,
                                      "Shear Modulus": self.shear, **plane}
        if plane:
            deck["Materials"]["Steel"]["Thickness"] = self.thickness
        else:
            del deck["Discretization"]["Thickness"]
        result = self.solve(deck)
        return result.field("Dilatation").ravel(), result.field("Stored_Elastic_Energy_Density").ravel()

    def test_expansion(self):
        strain = 1e-4
        dilatation, energy = self.fields(*(f"{strain}*{axis}" for axis in "xyz"))
        self.assertLess(np.max(np.abs(dilatation / (3 * strain) - 1.0)), 1e-9)
        self.assertLess(np.max(np.abs(energy / (0.5 * self.bulk * (3 * strain) ** 2) - 1.0)), 1e-9)

    def test_shear(self):
        # Inside, where neighbourhoods are whole, the energy is the sum over the lattice: e = gamma x y/r, theta = 0.
        dilatation, energy = self.fields("1e-4*y", "1e-4*x", "0*x")
        offsets = np.array(np.meshgrid(*[np.arange(-3, 4)] * 3)).reshape(3, -1)
        r2 = np.sum(offsets**2, axis=0)
        x, y, r2 = offsets[0][(r2 > 0) & (r2 < 9.1)], offsets[1][(r2 > 0) & (r2 < 9.1)], r2[(r2 > 0) & (r2 < 9.1)]
        expected = 7.5 * self.shear / np.sum(r2) * np.sum((2e-4 * x * y) ** 2 / r2)
        centre = 5 * 100 + 5 * 10 + 5
        self.assertLess(abs(dilatation[centre]), 1e-7)
        self.assertLess(abs(energy[centre] / expected - 1.0), 1e-3)


    def test_plane_strain_and_stress(self):
        # Hooke's law with E and nu: (lambda + G)/2 (2 s)^2 in plane strain, E/(1 - nu) s^2 in plane stress.
        strain = 1e-4
        E = 9.0 * self.bulk * self.shear / (3.0 * self.bulk + self.shear)
        nu = E / (2.0 * self.shear) - 1.0
        lame = E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu))
        for flag, expected in (("Plane Strain", 2.0 * (lame + self.shear) * strain**2),
                               ("Plane Stress", E / (1.0 - nu) * strain**2)):
            dilatation, energy = self.fields(f"{strain}*x", f"{strain}*y", **{flag: True})
            self.assertLess(np.max(np.abs(dilatation / (2 * strain) - 1.0)), 1e-9)
            self.assertLess(np.max(np.abs(energy / expected - 1.0)), 1e-9, flag)
            # Shear by gamma/2 = 1e-4, G gamma^2/2 of a disc; of this lattice the sum over it, with theta = 0.
            dilatation, energy = self.fields("1e-4*y", "1e-4*x", **{flag: True})
            x, y = (axis.ravel() for axis in np.meshgrid(np.arange(-3, 4), np.arange(-3, 4)))
            r2 = x**2 + y**2
            x, y, r2 = x[(r2 > 0) & (r2 < 9.1)], y[(r2 > 0) & (r2 < 9.1)], r2[(r2 > 0) & (r2 < 9.1)]
            of_lattice = 4.0 * self.shear / np.sum(r2) * np.sum((2e-4 * x * y) ** 2 / r2)
            self.assertLess(abs(of_lattice / (0.5 * self.shear * 2e-4**2) - 1.0), 0.1)
            centre = 5 * 10 + 5
            self.assertLess(abs(dilatation[centre]), 1e-7)
            self.assertLess(abs(energy[centre] / of_lattice - 1.0), 1e-3, flag)


class BodyForce(SceneTest):
    def test_its_field_and_its_work(self):
        # The load grows from b to 2 b while the plate moves from rest to u: the trapezoid of its work is 3/2 b V sum(u).
        self.write_mesh(lattice([0.02, 0.01], 1e-3), 1e-6 * 4e-3)
        loaded, load = "x > 0.015", 1e9
        deck = plate_deck(
            3.015e-3, 4e-3, {"Young's Modulus": E, "Poisson's Ratio": 0.29, "Density": 7850.0},
            conditions={"Loaded Node Set": {"Expression": loaded}, "Held Node Set": {"Expression": "x < 0.004"},
                        "Load": {"Type": "Body Force", "Node Set": "Loaded Node Set", "Coordinate": "x",
                                 "Value": f"{load!r}*(1 + t)"},
                        "Hold x": {"Type": "Prescribed Displacement", "Node Set": "Held Node Set", "Coordinate": "x",
                                   "Value": 0.0},
                        "Hold y": {"Type": "Prescribed Displacement", "Node Set": "Held Node Set", "Coordinate": "y",
                                   "Value": 0.0}},
            output={"Output Variables": ["Displacement", "External_Force_Density", "Work"]},
            Compute_Class_Parameters={"Work": {"Compute Class": "External_Work", "Output Label": "Work"}})
        is_loaded = lattice([0.02, 0.01], 1e-3)[:, 0] > 0.015
        for solver in ({"QuasiStatic": {"Load Steps": 1}}, {"Adaptive Dynamic Relaxation": {"Load Steps": 1}}):
            deck["Solver"] = {"Final Time": 1.0, **solver}
            result = self.solve(deck)
            for step, value in ((0, load), (1, 2 * load)):
                expected = np.zeros((len(is_loaded), 3))
                expected[is_loaded, 0] = value
                np.testing.assert_array_equal(result.field("External_Force_Density", step), expected)
            u = result.field("Displacement", 1)[is_loaded, 0]
            self.assertGreater(u.min(), 0.0)
            work = result.history()["Work"]
            np.testing.assert_allclose(work, [0.0, 1.5 * load * 4e-9 * u.sum()], rtol=1e-12)


class WorkOfGrips(SceneTest):
    def test_that_are_displaced_from_the_start_is_the_energy_of_the_body(self):
        self.write_mesh(lattice([0.02, 0.01], 1e-3), 1e-6 * 4e-3)
        ends = "x < 0.004 || x > 0.016"
        for load, solver in (("1e-5*x", {"QuasiStatic": {"Load Steps": 2, "Kinematics": "Small Strain"}}),
                             ("1e-5*x*(1 + t)", {"QuasiStatic": {"Load Steps": 3, "Kinematics": "Small Strain"}})):
            deck = plate_deck(
                3.015e-3, 4e-3, {"Young's Modulus": E, "Poisson's Ratio": 1 / 3},
                conditions={"Ends Node Set": {"Expression": ends},
                            "X": {"Type": "Prescribed Displacement", "Node Set": "Ends Node Set", "Coordinate": "x",
                                  "Value": load},
                            "Y": {"Type": "Prescribed Displacement", "Node Set": "Ends Node Set", "Coordinate": "y",
                                  "Value": 0.0}},
                solver={"Final Time": 1.0, **solver}, output={"Output Variables": ["Work", "Energy"]},
                Compute_Class_Parameters={
                    "Work": {"Compute Class": "External_Work", "Node Set": "Ends Node Set", "Output Label": "Work"},
                    "Energy": {"Compute Class": "Strain_Energy", "Output Label": "Energy"}})
            history = self.solve(deck).history()
            self.assertGreater(history["Energy"][-1], 0.0)
            np.testing.assert_allclose(history["Work"][1:], history["Energy"][1:], rtol=1e-4)


class Moduli(SceneTest):
    """Energy of uniform strains at the centre of a plate: E and nu of the lattice."""

    def moduli(self, m, cases):
        """C11 and C12 of plates that lie apart in one run, one for each of the cases: (nu, volume correction, more)."""
        size, apart, strain = 13, 20.0, 1e-6
        plate = lattice([float(size)] * 2, 1.0)
        self.write_mesh(np.vstack([plate + [apart * k, 0.0, 0.0] for k in range(len(cases))]), 1.0,
                        block=1 + np.repeat(np.arange(len(cases)), len(plate)))
        hold = {"Type": "Prescribed Displacement", "Node Set": "All Node Set"}
        deck = plate_deck(
            float(m), 1.0, conditions={"All Node Set": {"Expression": "x > -1"},
                                       # Along x alone, then along y as well.
                                       "X": {**hold, "Coordinate": "x", "Value": f"{strain}*x*min(2*t, 1)"},
                                       "Y": {**hold, "Coordinate": "y", "Value": f"{strain}*y*max(2*t - 1, 0)"}},
            solver={"QuasiStatic": {"Load Steps": 2}}, output={"Output Variables": ["Stored_Elastic_Energy_Density"]})
        deck.update(blocks_of(deck, [{"Young's Modulus": E, "Poisson's Ratio": nu, "Volume Correction": rule, **more}
                                     for nu, rule, more in cases]))
        result = self.solve(deck)
        centre = size * (size // 2) + size // 2
        first, second = (result.field("Stored_Elastic_Energy_Density", step).reshape(len(cases), -1)[:, centre]
                         for step in (1, 2))
        c11 = 2.0 * first / strain**2
        return zip(c11, second / strain**2 - c11)

    def test_lattice_values(self):
        # reference: table of E_eff/E (bond-based plane stress) by volume rule and m, to three decimals
        for m, table in ((3, {"None": 1.064, "Ramp To Horizon": 0.866, "Ramp Beyond Horizon": 1.045}),
                         (3.015, {"None": 1.049, "Ramp To Horizon": 0.859, "Ramp Beyond Horizon": 1.043}),
                         (4, {"None": 0.986, "Ramp To Horizon": 0.875, "Ramp Beyond Horizon": 1.019})):
            found = self.moduli(m, [(1.0 / 3.0, rule, {}) for rule in table])
            for (rule, expected), (c11, c12) in zip(table.items(), found):
                self.assertAlmostEqual((c11 - c12**2 / c11) / E, expected, delta=1.5e-3, msg=f"m = {m}, {rule}")

    def test_every_poissons_ratio(self):
        ratios, rule = (0.0, 0.1, 0.2, 0.29, 0.4, 1.0 / 3.0), "Ramp Beyond Horizon"
        for m in (3, 3.015, 4):
            found = list(self.moduli(m, [(nu, rule, {}) for nu in ratios] +
                                     [(nu, rule, {"Lattice Rescaling": True}) for nu in ratios[:-1]]))
            for nu, (c11, c12) in zip(ratios, found):
                sum11, sum12 = lattice_moduli(m, nu, rule)
                # Geometric nonlinearity is of the order of the strain, 1e-6.
                self.assertAlmostEqual(c11 / sum11, 1.0, delta=1e-5, msg=f"nu = {nu}, m = {m}")
                self.assertAlmostEqual((c12 - sum12) / sum11, 0.0, delta=1e-5, msg=f"nu = {nu}, m = {m}")
            for nu, (c11, c12) in zip(ratios, found[len(ratios):]):
                self.assertAlmostEqual((c11 - c12**2 / c11) / E, 1.0, delta=1e-5, msg=f"E, nu = {nu}, m = {m}")
                self.assertAlmostEqual(c12 / c11, nu, delta=1e-5, msg=f"nu = {nu}, m = {m}")


class Strip(SceneTest):
    """Tension of a strip with free edges: the apparent modulus, by the force through it and the strain in its middle."""

    def apparent_modulus(self, m, width, rule, correction):
        length = 8 * width
        self.write_mesh(lattice([length, width], 1.0), 1.0)
        grip, pull = m + 1, 1e-5 * length
        hold = {"Type": "Prescribed Displacement", "Coordinate": "x"}
        deck = plate_deck(
            float(m), 1.0, {"Young's Modulus": E, "Poisson's Ratio": 1.0 / 3.0, "Volume Correction": rule,
                            "Surface Correction": correction},
            conditions={"Left Node Set": {"Expression": f"x < {grip}"},
                        "Right Node Set": {"Expression": f"x > {length - grip}"},
                        "Middle Node Set": {"Expression": f"x < {grip} && abs(y - {width / 2}) < 0.6"},
                        "L": {**hold, "Node Set": "Left Node Set", "Value": 0.0},
                        "R": {**hold, "Node Set": "Right Node Set", "Value": float(pull)},
                        "Y": {"Type": "Prescribed Displacement", "Coordinate": "y", "Node Set": "Middle Node Set",
                              "Value": 0.0}},
            solver={"QuasiStatic": {"Relative Tolerance": 1e-8}},
            Compute_Class_Parameters={"Force": {"Compute Class": "Reaction_Force", "Node Set": "Right Node Set",
                                                "Output Label": "Force"}},
            output={"Output Variables": ["Displacement", "Force"]})
        result = self.solve(deck)
        force = abs(result.history()["ForceX"][-1])
        ux = result.field("Displacement")[:, 0].reshape(width, length).mean(axis=0)
        middle, quarter = length // 2, width
        strain = (ux[middle + quarter] - ux[middle - quarter]) / (2 * quarter)
        return force / (width * strain * E)

    def test_apparent_modulus(self):
        # reference: strips of the widths 2 and 5 horizons, m = 3, uncorrected and with the volume method
        for horizons, rule, correction, expected in (
                (2, "None", "None", 0.964), (2, "None", "Volume Method", 1.242),
                (2, "Ramp Beyond Horizon", "None", 0.927), (2, "Ramp Beyond Horizon", "Volume Method", 1.189),
                (5, "Ramp Beyond Horizon", "None", 0.998), (5, "Ramp Beyond Horizon", "Volume Method", 1.103)):
            modulus = self.apparent_modulus(3, 3 * horizons, rule, correction)
            self.assertAlmostEqual(modulus, expected, delta=2e-3, msg=f"{horizons} horizons, {rule}, {correction}")

    def test_energy_method_is_nearest_to_the_material(self):
        errors = {c: abs(self.apparent_modulus(3, 15, "Ramp Beyond Horizon", c) - 1.0)
                  for c in ("Volume Method", "Energy Method")}
        self.assertLess(errors["Energy Method"], 0.5 * errors["Volume Method"])


class Cantilever(SceneTest):
    """A beam six horizons high on any lattice, both ends moved as in the exact solution for a load P at one of them
    (Timoshenko & Goodier, Theory of Elasticity, 3rd ed. 1970, article 21; with the shift of Augarde & Deeks, Finite Elem.
    Anal. Des. 44 (2008) 595): the force at the end against P."""

    horizon, length, nu = 3.0, 72.0, 1.0 / 3.0

    def stiffness(self, lattice, correction):
        # Whole rows: 18 of squares, 20 of triangles.
        H, L, nu = 20 * np.sqrt(np.sin(np.pi / 3)) if lattice == "triangles" else 18.0, self.length, self.nu
        collar = 2 * self.horizon
        points, volume = lattice_points((-collar, -H / 2), (L + collar, H / 2), lattice, self.horizon, 1.0)
        self.write_mesh(np.column_stack([points, 0 * points[:, 0]]), volume)
        scale = 1e-9  # P/(6 E I)
        hold = {"Type": "Prescribed Displacement"}
        ux = f"-{scale}*y*((6*{L} - 3*x)*x + (2 + {nu!r})*(y^2 - {H}^2/4))"
        uy = f"{scale}*(3*{nu!r}*y^2*({L} - x) + (4 + 5*{nu!r})*{H}^2*x/4 + (3*{L} - x)*x^2)"
        deck = plate_deck(
            self.horizon, 1.0, {"Young's Modulus": E, "Poisson's Ratio": nu, "Surface Correction": correction},
            conditions={"Left Node Set": {"Expression": "x < 0"}, "Right Node Set": {"Expression": f"x > {L}"},
                        **{f"{side} {axis}": {**hold, "Node Set": f"{side} Node Set", "Coordinate": axis, "Value": value}
                           for side in ("Left", "Right") for axis, value in (("x", ux), ("y", uy))}},
            solver={"QuasiStatic": {"Relative Tolerance": 1e-7}},
            Compute_Class_Parameters={"Pull": {"Compute Class": "Reaction_Force", "Node Set": "Right Node Set",
                                               "Output Label": "Pull"}},
            output={"Output Variables": ["Pull"]})
        load = scale * 6 * E * H**3 / 12
        return abs(self.solve(deck).history()["PullY"][-1]) / load

    def test_energy_method_bends_as_the_material(self):
        for lattice in ("square_3", "turned_20", "triangles"):
            stiffness = {c: self.stiffness(lattice, c) for c in ("None", "Volume Method", "Energy Method")}
            self.assertLess(abs(stiffness["Energy Method"] - 1), 0.02, (lattice, stiffness))
            self.assertLess(stiffness["None"], 0.96, (lattice, stiffness))


if __name__ == "__main__":
    unittest.main()
