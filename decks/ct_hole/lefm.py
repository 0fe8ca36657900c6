#!/usr/bin/python3
"""Where linear elastic fracture mechanics leads the crack of this scene, by the finite elements of
../three_hole_ct/lefm.py; lefm.py X Y FILE writes x, y of the path in mm, for a hole at X, Y (mm).

Both specimens are those of ASTM E647, so that this one is that one made smaller; a path knows neither size nor load.
"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "three_hole_ct"))

import lefm  # noqa: E402
import numpy as np  # noqa: E402

SCALE = 29.5 / lefm.WIDTH
x, y = float(sys.argv[1]) / SCALE, float(sys.argv[2]) / SCALE
cut, hole = [(-lefm.FRONT, 0.0), (7.5 / SCALE, 0.0)], (x, y, 3.5 / SCALE)
path, _ = lefm.grow(cut, [hole], 1000.0, 0.75, lambda tip: tip[0] > x + 4.0)
np.savetxt(sys.argv[3], path * SCALE, fmt="%.4f", delimiter=",", header="x,y", comments="")
