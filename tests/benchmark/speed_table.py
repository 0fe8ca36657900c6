"""The speed tables of README.md, ready to be pasted, from the results of the benchmark.

  speed_table.py BUILD_FOLDER/benchmark.json
"""
import json
import sys
from pathlib import Path


class Figures:
    """Results by name, as text."""

    def __init__(self, results):
        self._results = {result["name"]: result for result in results}

    def number(self, name):
        return self._results[name]["value"]

    def rate(self, name):
        """Two digits, as in 7.6e9; "(6.1e9 to 7.7e9)" where repetitions lie further apart than a tenth."""
        result = self._results[name]
        low, high = result.get("lowest", result["value"]), result.get("highest", result["value"])
        spread = f" ({_short(low)} to {_short(high)})" if high > 1.1 * low else ""
        return _short(result["value"]) + spread

    def ratio(self, name):
        result = self._results[name]
        return f"{result['ratio']:.2g}" if "ratio" in result else "–"

    def phases(self, prefix):
        """The longest four phases of a run: "diffusion 5.9, force 5.6"."""
        found = [(result["value"], name[len(prefix):]) for name, result in self._results.items()
                 if name.startswith(prefix)]
        return ", ".join(f"{name} {seconds:.1f}" for seconds, name in sorted(found, reverse=True)[:4])

    def has(self, name):
        return name in self._results


def _short(value):
    """7.6e9, 9.1e-7"""
    digits, exponent = f"{value:.1e}".split("e")
    return f"{digits}e{int(exponent)}"


def _rows(f):
    """What is measured: (names of the results it needs, text, measured, ratio, aim)."""
    diffusion = ["diffusion_bond_updates_per_s", "diffusion_bond_updates_per_s_3d",
                 "kernel_diffusion_2d_small_jittered_nu29", "kernel_diffusion_3d_large_jittered_nu20"]
    breaking = ["mechanics_breaking_bond_updates_per_s_2d", "mechanics_breaking_bond_updates_per_s_3d"]
    force = ["kernel_force_2d_small_lattice_nu29", "kernel_force_3d_small_lattice_nu20",
             "kernel_force_2d_small_jittered_nu29", "kernel_force_3d_small_jittered_nu20"]
    bond_based = ["kernel_force_3d_small_lattice_nu25"]
    four = "{} in 2D, {} in 3D (jittered lattice: {}, {})"
    two = "{} in 2D, {} in 3D"

    def rates(names, text):
        return lambda: (text.format(*map(f.rate, names)), text.format(*map(f.ratio, names)))

    def plain(text):
        return lambda: (text(), "")

    yield (["yardstick_list_bond_updates_per_s"], "yardstick: bond-based force over a plain list, 3D, bond-updates/s",
           lambda: (f.rate("yardstick_list_bond_updates_per_s"), "1"), "")
    yield (["yardstick_lattice_bond_updates_per_s"], "yardstick: the same force on a lattice without a list",
           lambda: (f.rate("yardstick_lattice_bond_updates_per_s"), "1"), "")
    yield (["yardstick_triad_bytes_per_s"], "yardstick: STREAM triad, bytes/s",
           lambda: (f.rate("yardstick_triad_bytes_per_s"), ""), "")
    yield (["hydrogen_plate_converged_s"], "hydrogen plate, 10952 points, 3000 load steps, each to equilibrium",
           plain(lambda: f"{f.number('hydrogen_plate_converged_s'):.1f} s"), "10 s")
    yield (["hydrogen_plate_seed_case_s"],
           "the same by 20 Euler steps and one relaxation a load step, 591 k bonds",
           plain(lambda: f"{f.number('hydrogen_plate_seed_case_s'):.1f} s: {f.phases('hydrogen_plate_phase_s ')}"),
           "30 s (its model, a thesis code: 910.6 s)")
    for method, text in (("rkc", "the same hydrogen field by RKC, tolerance 1e-4, hydrogen time against Euler's"),
                         ("rkl", "by RKL")):
        yield ([f"hydrogen_plate_{method}_hydrogen_ratio", "hydrogen_plate_euler_error"], text,
               plain(lambda m=method: f"{f.number(f'hydrogen_plate_{m}_hydrogen_ratio'):.2f}, error "
                     f"{_short(f.number(f'hydrogen_plate_{m}_error'))} "
                     f"(Euler's {_short(f.number('hydrogen_plate_euler_error'))})"),
               "0.33")
    yield diffusion, "diffusion kernel, bond-updates/s", rates(diffusion, four), "1e9"
    yield (breaking, "whole Verlet runs of moving, breaking two-parameter bodies, bond-updates/s", rates(breaking, two),
           "2.5e8")
    yield force, "two-parameter force alone, bond-updates/s", rates(force, four), ""
    yield bond_based, "bond-based force alone (k_t = 0), 3D", rates(bond_based, "{}"), ""
    flow = [f"flow_{part}_bond_updates_per_s{case}" for case in ("", "_3d", "_jittered") for part in ("kernel", "step")]
    yield (flow, "explicit flow, right side (whole Runge-Kutta steps), bond-updates/s",
           rates(flow, "{} ({}) in 2D, {} ({}) in 3D, {} ({}) in 2D jittered"), "5e8")
    yield (["bytes_per_bond"], "bytes a directed bond (lists and fields; constants of uniform lattices are shared)",
           plain(lambda: f"{f.number('bytes_per_bond'):.1f}"), "40")
    yield (["speedup_2_ranks_mechanics", "speedup_2_ranks_diffusion"], "two ranks, 100 k points",
           plain(lambda: f"mechanics {f.number('speedup_2_ranks_mechanics'):.2f} ×, diffusion "
                 f"{f.number('speedup_2_ranks_diffusion'):.2f} ×"), "1.7 ×")
    for size, aims in (("11k", ("", "0.015 s, 0.04 s")), ("90k", ("1 s, 1.5 s", "0.12 s, 0.4 s"))):
        for case, aim, text in (("cold", aims[0], "from nothing"), ("warm", aims[1], "after bonds broke")):
            names = [f"statics_{mesh}_{size}_{case}_s" for mesh in ("lattice", "jittered")]
            yield (names, f"equilibrium of a plate of {size[:-1]} k points, horizon 4 spacings, to 1e-5, {text}",
                   plain(lambda names=names: f"{f.number(names[0]):.3f} s (jittered lattice: {f.number(names[1]):.3f} s)"),
                   aim)
    names = [f"fatigue_{mesh}_90k_600_events_s" for mesh in ("lattice", "jittered")]
    yield (names, "fatigue of the plate of 90 k points, 600 events (`--fatigue-events`)",
           plain(lambda names=names: f"{f.number(names[0]):.0f} s (jittered lattice: {f.number(names[1]):.0f} s)"),
           "75 s, 240 s")
    yield (["crevice_adaptive_s"], "crevice, 216 k points, 72 h of dissolution (`decks/crevice`), adaptive steps",
           plain(lambda: f"{f.number('crevice_adaptive_s'):.0f} s"), "45 s")
    yield (["crevice_fixed_step_s"], "the same by 51840 steps of 5 s",
           plain(lambda: f"{f.number('crevice_fixed_step_s'):.0f} s"), "600 s")
    yield (["mg_pin_s", "steady_flow_first_s", "steady_flow_again_s"],
           "magnesium wire in a flow, 26 166 points, 9 h of dissolution (`decks/mg_pin`)",
           plain(lambda: f"{f.number('mg_pin_s'):.0f} s; first flow {f.number('steady_flow_first_s'):.1f} s, later ones "
                 f"{f.number('steady_flow_again_s'):.1f} s"), "120 s; 25 s, 2 s")
    yield (["million_points_setup_s"], "a million points in 3D, 171 M bonds, set up",
           plain(lambda: f"{f.number('million_points_setup_s'):.1f} s; {f.number('million_points_gib'):.2f} GiB"),
           "20 s, 4 GiB")


def _block_rows(f):
    cases = {"bond_based": "bond-based, breaking", "bond_based_unbroken": "bond-based, tested, nothing breaks",
             "bond_based_plain": "bond-based, no damage model", "elastic": "linear peridynamic solid",
             "elastic_breaking": "linear peridynamic solid, breaking"}
    for case, text in cases.items():
        cells = [text]
        for owner in ("block", "peridigm_block"):
            one, speedup = f"{owner}_{case}_bond_updates_per_s", f"speedup_2_ranks_{owner}_{case}"
            if not (f.has(one) and f.has(speedup)):
                cells += ["", "", ""]
                continue
            two = f"{_short(f.number(one) * f.number(speedup))}, {f.number(speedup):.2f} ×"
            cells += [f.rate(one), f.ratio(one), two]
        if any(cells[1:]):
            yield cells


def speed_tables(results):
    """Markdown. Rows whose results are not there, as in a run that was cut short, are left out."""
    f = Figures(results)
    lines = [f"{results[0]['machine']}.", "", "| What | Measured | Ratio to the yardstick | Aim |", "|---|---|---|---|"]
    for names, text, cells, aim in _rows(f):
        if all(map(f.has, names)):
            measured, ratio = cells()
            lines.append(f"| {text} | {measured} | {ratio} | {aim} |")
    lines += ["", "| Directed bond-updates/s | pdrun, 1 core | ratio | 2 cores | Peridigm, 1 core | ratio | 2 cores |",
              "|---|---|---|---|---|---|---|"]
    lines += ["| " + " | ".join(cells) + " |" for cells in _block_rows(f)]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    print(speed_tables(json.loads(Path(sys.argv[1]).read_text())), end="")
