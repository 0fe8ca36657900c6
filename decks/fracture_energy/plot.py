#!/usr/bin/python3
"""growth.png: energy and direction of growth on all lattices; paths.png: what the crack of the strip looks like on some; and
both as a table; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from growth import FIRST, HORIZON, Growth  # noqa: E402
from lattices import LATTICES  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.raster import Raster  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

MODELS = {"Stretch": ("Critical Stretch", "C3"), "Nodal": ("Nodal Energy", "C0")}
SHOWN = ("square_3", "turned_20", "jittered", "triangles")
FAR = 3.5  # horizons that a crack has to grow

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
bodies = [body for body in FIRST if (folder / f"{body}_square_3_Nodal.csv").exists()]
figure, axes = figures.plt.subplots(2, len(bodies), figsize=(3.6 * len(bodies), 5.0), squeeze=False, sharex=True,
                                    sharey="row", constrained_layout=True)
for column, body in zip(axes.T, bodies):
    for model, (title, color) in MODELS.items():
        energies, angles = [], []
        for lattice in LATTICES:
            if not (folder / f"{body}_{lattice}_{model}.csv").exists():
                energies.append(np.nan)
                angles.append(np.nan)
                continue
            run = Growth(folder, body, lattice, model)
            energies.append(run.needed(FAR))
            angles.append(run.angle)
            print(f"{body:6} {title:16} {lattice:10} half a horizon {run.needed(0.5):5.2f}, {FAR} horizons "
                  f"{energies[-1]:5.2f} G_c, {angles[-1]:5.1f} degrees")
        column[0].plot(energies, "o", color=color, label=title)
        column[1].plot(np.abs(angles), "o", color=color)
    column[0].axhspan(0.9, 1.1, color="0.85")
    column[1].axhspan(0.0, 5.0, color="0.85")
    column[0].set_title(body)
    column[1].set_xticks(range(len(LATTICES)), [name.replace("_", " ") for name in LATTICES], rotation=60)
axes[0, 0].set_ylabel("energy needed / fracture energy")
axes[1, 0].set_ylabel("angle to the old crack (degrees)")
axes[0, 0].legend()
figure.savefig(folder / "growth.png")

pictures, maps = figures.plt.subplots(len(MODELS), len(SHOWN), figsize=(11, 3.6), constrained_layout=True)
for row, (model, (title, color)) in zip(maps, MODELS.items()):
    for panel, lattice in zip(row, SHOWN):
        results = Results(folder / f"strip_{lattice}_{model}")
        window = np.array([FIRST["strip"] - 2 * HORIZON, -2 * HORIZON]), np.array([22e-3, 2 * HORIZON])
        raster = Raster(results.x[:, :2], results.spacing(), pixels=260, window=window)
        image = panel.imshow(raster.image(results.field("Damage", results.steps[-1])), origin="lower", cmap="inferno",
                             vmin=0, vmax=0.6, extent=[value * 1e3 for value in raster.extent])
        panel.set_title(f"{title}, {lattice.replace('_', ' ')}", fontsize=8)
        panel.set_xticks([])
        panel.set_yticks([])
pictures.colorbar(image, ax=maps, shrink=0.8).set_label("Damage")
pictures.savefig(folder / "paths.png")
print(folder / "growth.png", folder / "paths.png")
