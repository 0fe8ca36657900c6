"""Decks of dissolving bodies, and what must hold in every one of their runs."""
import re

import numpy as np
from scene import SceneTest, lattice

FARADAY = 96485.33212
SPACING, HORIZON = 1e-6, 4e-6
# SS304 and Cu of PeriFast/Corrosion (Wang, Jafarzadeh & Bobaru 2023).
STEEL = {"Diffusivity": 860e-12, "Solid Concentration": 142900.0, "Saturation Concentration": 4600.0,
         "Charge Number": 2.19, "Current Density": "5.1e3"}
COPPER = {"Diffusivity": 1297e-12, "Solid Concentration": 141000.0, "Saturation Concentration": 5000.0,
          "Charge Number": 2.0, "Current Density": "1450.0"}
HALF_A_FILM = {"All Node Set": {"Expression": "x < 1"},
               "Film": {"Type": "Film Coverage", "Node Set": "All Node Set", "Value": 0.5}}
SHAPES = {1: {"One Dimensional": True}, 2: {"Plane Strain": True}, 3: {}}


def front_speed(metal, current=None):
    current = float(metal["Current Density"]) if current is None else current
    return current / (metal["Charge Number"] * FARADAY * metal["Solid Concentration"])


def corrosion_deck(dimension, metal, solid, held, time, steps, name="result", **solver):
    """`solid`, `held`: expressions of the metal and of where C = 0 stays; no `held`: a closed body."""
    discretization = {"Type": "Text File", "Input Mesh File": "mesh.txt"}
    if dimension == 1:
        discretization["Cross Section Area"] = 1.0
    elif dimension == 2:
        discretization["Thickness"] = 1.0
    conditions = {"Metal Node Set": {"Expression": solid},
                  "Metal": {"Type": "Initial Concentration", "Node Set": "Metal Node Set",
                            "Value": metal["Solid Concentration"]}}
    if held:
        conditions["Sea Node Set"] = {"Expression": held}
        conditions["Sea"] = {"Type": "Prescribed Concentration", "Node Set": "Sea Node Set", "Value": 0.0}
    return {
        "Discretization": discretization,
        "Materials": {"Metal": {"Material Model": "Corrosion Dissolution", **SHAPES[dimension], **metal}},
        "Damage Models": {"Phases": {"Damage Model": "Dissolution"}},
        "Blocks": {"Body": {"Block Names": "block_1", "Material": "Metal", "Damage Model": "Phases",
                            "Horizon": HORIZON}},
        "Boundary Conditions": conditions,
        "Solver": {"Final Time": float(time), "Corrosion": {"Load Steps": steps, **solver}},
        "Compute Class Parameters": {"Dissolved": {"Compute Class": "Field_Integral", "Node Set": "Metal Node Set",
                                                   "Variable": "Damage", "Output Label": "Dissolved"}},
        "Output": {"Output Filename": name, "Output Frequency": 1,
                   "Output Variables": ["Concentration", "Damage", "Salt_Coverage", "Dissolved"]}}


class CorrosionTest(SceneTest):
    overshoot = 1e-8  # of electrolyte beyond saturation

    def make_lattice(self, lengths, origin=None):
        self.x = lattice(lengths, SPACING, origin)
        self.volume = SPACING ** len(lengths) if len(lengths) > 1 else SPACING
        self.write_mesh(self.x, self.volume)

    def corrode(self, dimension, metal, *args, **solver):
        result = self.solve(corrosion_deck(dimension, metal, *args, **solver))
        self.check(result, metal)
        return result

    def check(self, result, metal):
        """Metal is conserved; liquid holds between nothing and saturation, solid more; liquid never turns solid."""
        match = re.search(r"the balance is off by (\S+) of it", " ".join(result.report["solver"]))
        self.assertLess(float(match.group(1)), 1e-10)
        saturation, was_liquid = metal["Saturation Concentration"], None
        for step in result.steps():
            c, liquid = result.field("Concentration", step), result.field("Damage", step) >= 1.0
            salt = result.field("Salt_Coverage", step)
            self.assertTrue(np.all(np.isfinite(c)))
            self.assertGreaterEqual(np.min(c), -1e-8 * saturation, f"step {step}")
            self.assertLessEqual(np.max(c[liquid]), (1.0 + self.overshoot) * saturation, f"step {step}")
            self.assertGreaterEqual(np.min(c[~liquid], initial=saturation), saturation, f"step {step}")
            self.assertLessEqual(np.max(c), (1.0 + 1e-12) * metal["Solid Concentration"], f"step {step}")
            self.assertTrue(np.all((salt >= 0.0) & (salt <= 1.0)))
            if was_liquid is not None:
                self.assertTrue(np.all(liquid[was_liquid]), f"step {step}")
            was_liquid = liquid

    def amount(self, result, step=None):
        """Metal in the body, mol."""
        return np.sum(result.field("Concentration", step)) * self.volume
