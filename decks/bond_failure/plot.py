#!/usr/bin/python3
"""mean_damage.png: mean damage against the load step for the three runs; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import read_history  # noqa: E402

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
figure, axis = figures.plt.subplots(figsize=(6.4, 3.8), constrained_layout=True)
for name, label in (("intact", "no crack, no hydrogen"), ("cracked", "crack, hydrogen from the left side"),
                    ("lips", "crack, hydrogen on its lips")):
    history = read_history(folder / f"{name}.csv")
    axis.plot(history["step"], history["Mean_Damage"], label=label)
    print(f"{label}: mean damage at the end {history['Mean_Damage'][-1]:.4g}")
axis.set_xlabel("load step")
axis.set_ylabel("mean damage")
axis.grid(alpha=0.3)
axis.legend()
figure.savefig(folder / "mean_damage.png", dpi=110)
print(folder / "mean_damage.png")
