#!/usr/bin/python3
"""Measures pdrun: kernels and whole runs. Writes a list of {name, value, unit, machine}.

First and between its parts it measures bare loops of its own (yardstick.hpp), since the same code runs 1.7 times faster
on one machine than on another and a shared machine is not always the same. Rates have a ratio to the loop that fits
them, of the same minutes; what is measured several times is a median with lowest and highest. At the end it prints the
tables of README.md (speed_table.py), and writes them beside its results.

  benchmark.py BUILD_FOLDER            everything, some minutes on an idle machine; into BUILD_FOLDER/benchmark.json
  PERIDIGM_EXECUTABLE=... benchmark.py BUILD_FOLDER    the same, with that Peridigm on the block beside pdrun
  benchmark.py BUILD_FOLDER --whole-crevice    72 h of the crevice at steps of 5 s too, ten minutes more
  benchmark.py BUILD_FOLDER --fatigue-events    600 events of a plate of 90 k points that tires too, ten minutes more
  benchmark.py BUILD_FOLDER --quick    tiny bodies and few steps, to see that all of it runs: the figures mean nothing
"""
import argparse
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

sys.dont_write_bytecode = True
SOURCE = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(Path(__file__).resolve().parent), str(SOURCE / "decks" / "crevice")]

import block  # noqa: E402
import scenes  # noqa: E402
import time_steps  # noqa: E402
from speed_table import speed_tables  # noqa: E402
from yardstick import UNITS, Yardstick, fitting, program_rates  # noqa: E402

SCENE = SOURCE / "decks" / "hydrogen_plate"
PIN = SOURCE / "decks" / "mg_pin"


def machine():
    model = "unknown processor"
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            model = line.split(":", 1)[1].strip()
            break
    return f"{model}, {os.cpu_count()} cores"


def show(result):
    spread = f"  ({result['lowest']:.4g} to {result['highest']:.4g})" if "lowest" in result else ""
    ratio = f"  {result['ratio']:.3g} x {result['yardstick'].split('_')[1]}" if "ratio" in result else ""
    print(f"{result['name']:<58} {result['value']:>14.6g} {result['unit']}{ratio}{spread}", flush=True)


class Benchmark:
    def __init__(self, build, folder, is_quick, is_crevice_whole):
        self.build, self.folder, self.is_quick, self.is_crevice_whole = build, folder, is_quick, is_crevice_whole
        self.pdrun = str(build / "pdrun")
        self.machine = machine() + (", --quick: tiny bodies" if is_quick else "")
        self.yardstick = Yardstick(self._program("yardstick_benchmark"), is_quick)
        self._results = []

    @property
    def results(self):
        """Those of the bare loops first."""
        loops = [self._result(name, self.yardstick.samples[name], UNITS[name]) for name in self.yardstick.samples]
        return loops + self._results

    def _result(self, name, values, unit):
        result = {"name": name, "value": float(statistics.median(values)), "unit": unit, "machine": self.machine}
        if len(values) > 1:
            result.update(lowest=float(min(values)), highest=float(max(values)), samples=len(values))
        return result

    def add(self, name, value, unit):
        self._add(self._result(name, [value], unit), [value / self.yardstick.now[fitting(name)]])

    def _add(self, result, ratios):
        """With the median of `ratios`, where it is a rate."""
        if result["unit"] == "1/s":
            result.update(ratio=float(statistics.median(ratios)), yardstick=fitting(result["name"]))
        self._results.append(result)
        show(result)

    def measure_yardstick(self):
        """Shows this measurement alone; the results have all of them."""
        self.yardstick.measure()
        for name, rate in self.yardstick.now.items():
            show(self._result(name, [rate], UNITS[name]))

    def own_run(self, counts, content, jitter=0.0, **options):
        scenes.write_lattice(self.folder / "lattice.txt", counts, jitter)
        return scenes.run_own(self.pdrun, content, self.folder, **options)

    def kernels(self):
        """Rates of single evaluations, in rounds with the yardstick; the first five are those the project holds itself
        to."""
        rates, ratios = {}, {}
        for round_number in range(1 if self.is_quick else 3):
            if round_number > 0:
                self.measure_yardstick()
            for name, rate in self._kernel_rates().items():
                rates.setdefault(name, []).append(rate)
                ratios.setdefault(name, []).append(rate / self.yardstick.now[fitting(name)])
        aliases = {"diffusion_bond_updates_per_s": "diffusion_2d_small_lattice_nu29",
                   "diffusion_bond_updates_per_s_2d_large": "diffusion_2d_large_lattice_nu29",
                   "diffusion_bond_updates_per_s_3d": "diffusion_3d_large_lattice_nu20",
                   "mechanics_breaking_kernel_bond_updates_per_s_2d": "mechanicsBreaking_2d_small_lattice_nu29",
                   "mechanics_breaking_kernel_bond_updates_per_s_3d": "mechanicsBreaking_3d_small_lattice_nu20"}
        for alias, name in [*aliases.items(), *(("kernel_" + name, name) for name in rates)]:
            if name in rates:
                self._add(self._result(alias, rates[name], "1/s"), ratios[name])

    def _kernel_rates(self):
        options = {"filter_text": "large:0", "minimum_time": "0.01"} if self.is_quick else {"minimum_time": "0.2"}
        found = program_rates(self._program("kernels_benchmark"), "bond_updates_per_s", **options)
        rates = {}
        for text, (rate,) in found.items():
            kernel, *arguments = text.split("/")
            values = dict(argument.split(":") for argument in arguments)
            name = "_".join([kernel, "2d" if values["plane"] == "1" else "3d",
                             "large" if values["large"] == "1" else "small",
                             "lattice" if values["jitter"] == "0" else "jittered", "nu" + values["nu"]])
            rates[name] = rate
        return rates

    def _program(self, name):
        found = [path for path in self.build.rglob(name) if path.is_file() and os.access(path, os.X_OK)]
        if not found:
            raise RuntimeError(f"no {name} in {self.build}: build with the tests")
        return found[0]

    def hydrogen_plate(self):
        """The plate in equilibrium at all times; the seed's work, one relaxation a load step; and the same hydrogen by an
        error-controlled integrator."""
        folder = self._hydrogen_plate_decks()
        steps = 4 if self.is_quick else 3000
        size = {"Solver/Staggered/Load Steps": steps, "Solver/Final Time": repr(6160.0 * steps)}
        report, _ = self._hydrogen_run(folder / "hydrogen_plate.yaml", size)
        self.add("hydrogen_plate_converged_s", report["seconds"], "s")
        deck = folder / "one_relaxation.yaml"
        report, euler = self._hydrogen_run(deck, size)
        self.add("hydrogen_plate_seed_case_s", report["seconds"], "s")
        for phase in report["phases"]:
            self.add("hydrogen_plate_phase_s " + phase["name"], phase["seconds"], "s")
        self.add("hydrogen_plate_load_step_s", report["seconds"] / steps, "s")
        self.add("bytes_per_bond", report["bytes_per_bond"], "B")
        self.add("hydrogen_plate_peak_mib", report["peak_memory_bytes"] / 2**20, "MiB")

        _, reference = self._hydrogen_run(deck, {**size, **self._controlled("RKL", 1e-7)})
        self.add("hydrogen_plate_euler_error", self._difference(euler, reference), "1")
        for method in ("RKC", "RKL"):
            controlled, field = self._hydrogen_run(deck, {**size, **self._controlled(method, 1e-4)})
            name = f"hydrogen_plate_{method.lower()}"
            self.add(f"{name}_hydrogen_ratio", self._hydrogen_seconds(controlled) / self._hydrogen_seconds(report), "1")
            self.add(f"{name}_error", self._difference(field, reference), "1")

    def _hydrogen_plate_decks(self):
        """A folder with the scene's decks and a mesh of its own, so that one made elsewhere is not touched."""
        folder = self.folder / "hydrogen_plate"
        folder.mkdir()
        subprocess.run([str(SCENE / "make_mesh.sh"), str(folder)], check=True, capture_output=True)
        for deck in SCENE.glob("*.yaml"):
            shutil.copy(deck, folder)
        return folder

    @staticmethod
    def _controlled(method, tolerance):
        return {"Solver/Staggered/Diffusion": f"{{Method: {method}, Relative Tolerance: {tolerance:.1e}}}"}

    def _hydrogen_run(self, deck, overrides):
        """(report, concentration at the end)."""
        report = scenes.run(self.pdrun, deck, self.folder, overrides=overrides)
        with h5py.File(self.folder / "run.h5", "r") as file:
            last = sorted(file["steps"])[-1]
            return report, np.array(file["steps"][last]["Concentration"])

    @staticmethod
    def _hydrogen_seconds(report):
        return sum(phase["seconds"] for phase in report["phases"] if phase["name"].startswith(("flux", "diffusion")))

    @staticmethod
    def _difference(field, reference):
        return np.linalg.norm(field - reference) / np.linalg.norm(reference)

    def statics(self):
        """Equilibria of a plate from nothing, and after bonds broke at the tip of its crack."""
        for name, counts in (("11k", (104, 104, 1)), ("90k", (300, 300, 1))):
            counts = (40, 40, 1) if self.is_quick else counts
            for mesh, jitter in (("lattice", 0.0), ("jittered", 0.2)):
                cold, _ = self._equilibria(counts, jitter, 1e-6)
                whole, n_warm = self._equilibria(counts, jitter, scenes.crack_opening(counts))
                self.add(f"statics_{mesh}_{name}_cold_s", cold, "s")
                if n_warm > 0:
                    self.add(f"statics_{mesh}_{name}_warm_s", (whole - cold) / n_warm, "s")
                self.add(f"statics_{mesh}_{name}_warm_equilibria", n_warm, "1")

    def _equilibria(self, counts, jitter, opening):
        """(seconds for the equilibria of a load step, how many of them after bonds broke)."""
        report = self.own_run(counts, scenes.opened_plate(counts, opening), jitter=jitter)
        seconds = sum(phase["seconds"] for phase in report["phases"]
                      if phase["name"] in ("springs", "two-level set-up", "linear solve", "force of springs"))
        broken = [line for line in report["solver"] if "further equilibria" in line]
        return seconds, int(broken[0].split()[1]) if broken else 0

    def fatigue_events(self):
        """A plate of 90 k points that tires: seconds for 600 events, the coarse level and all, on one rank, and what two
        make of the first of them."""
        counts, n_events = ((40, 40, 1), 6) if self.is_quick else ((300, 300, 1), 600)
        for mesh, jitter in (("lattice", 0.0), ("jittered", 0.2)):
            seconds, found = self._events(counts, jitter, n_events, 1)
            self.add(f"fatigue_{mesh}_90k_600_events_s", seconds * n_events / found, "s")
            self.add(f"fatigue_{mesh}_90k_events", found, "1")
            times = [self._events(counts, jitter, n_events // 6, ranks)[0] for ranks in (1, 2)]
            self.add(f"speedup_2_ranks_fatigue_{mesh}", times[0] / times[1], "1")

    def _events(self, counts, jitter, n_events, ranks):
        """(seconds, events) of a run until so many events may have been: two bonds and more break in one of a lattice. All
        but the reading of the mesh counts: between the phases of an event ranks wait for each other, too."""
        n_bonds = n_events * (1 if jitter > 0.0 else 2)
        # Those that the notch cuts count, too: a run that may break none says how many they are.
        report = self.own_run(counts, scenes.tiring_plate(counts, 1), jitter=jitter)
        ended = next(line for line in report["solver"] if "Broken has reached" in line)
        n_bonds += int(float(ended.split("reached")[1].split()[0]))
        report = self.own_run(counts, scenes.tiring_plate(counts, n_bonds), jitter=jitter, ranks=ranks)
        words = next(line for line in report["solver"] if "bonds broke in" in line).split()
        once = sum(phase["seconds"] for phase in report["phases"] if phase["name"] in self.ONCE)
        return report["seconds"] - once, int(words[words.index("events,") - 1])

    def crevice(self):
        """The crevice by adaptive steps, and by those of its source: 5 s, for a tenth of its 72 h or for all of them."""
        folder = self.folder / "crevice"
        folder.mkdir()
        case = time_steps.SHORT if self.is_quick else time_steps.WHOLE
        time_steps.prepare(case, folder)

        def run(step=None, share=1.0):
            settings = case.settings()
            settings["Solver/Final Time"] *= share
            if step is not None:
                settings.update(time_steps.fixed(step))
            report = scenes.run(self.pdrun, "crevice.yaml", folder, overrides=settings)
            return report["seconds"], max(time_steps.depths(folder))

        seconds, adaptive = run()
        self.add("crevice_adaptive_s", seconds, "s")
        if not self.is_crevice_whole:
            self.add("crevice_fixed_step_first_tenth_s", run(5.0, 0.1)[0], "s")
            return
        seconds, fixed = run(5.0)
        self.add("crevice_fixed_step_s", seconds, "s")
        self.add("crevice_adaptive_depth_difference", abs(adaptive / fixed - 1.0), "1")

    def magnesium_pin(self):
        """The whole section of the magnesium wire in a flow: its first flow, those when metal has dissolved, all of it."""
        folder = self.folder / "mg_pin"
        folder.mkdir()
        shutil.copy(PIN / "mg_pin.yaml", folder)
        spacing = 10.625e-6 if self.is_quick else 5e-6
        scenes.write_pin(folder / "mg_pin.txt", spacing)
        whole = {"Discretization/Symmetry": "{}", "Solver/Staggered/Solvers/Flow/When/Has Changed By": 2.5e-10,
                 **{f"Blocks/{block}/Horizon": 3.015 * spacing for block in ("Channel", "Walls")},
                 "Materials/Fluid/Flux Horizon": 1.2 * spacing}
        short = {"Solver/Final Time": 60.0, "Solver/Staggered/Load Steps": 1}
        first, n_first = self._flows(scenes.run(self.pdrun, "mg_pin.yaml", folder, overrides={**whole, **short}))
        report = scenes.run(self.pdrun, "mg_pin.yaml", folder, overrides={**whole, **(short if self.is_quick else {})})
        every, n_flows = self._flows(report)
        self.add("steady_flow_first_s", first / n_first, "s")
        if n_flows > 1:
            self.add("steady_flow_again_s", (every - first / n_first) / (n_flows - 1), "s")
        self.add("mg_pin_s", report["seconds"], "s")

    @staticmethod
    def _flows(report):
        """(seconds for all flows, how many)"""
        seconds = sum(phase["seconds"] for phase in report["phases"] if "flow" in phase["name"])
        line = next(line for line in report["solver"] if "Steady Flow: " in line and "load steps" in line)
        return seconds, int(line.split("Steady Flow: ")[-1].split()[0])

    def mechanics(self):
        """Whole runs of bodies that move and break: bonds over the time of a force and of a test for breakage."""
        plane, solid = ((60, 30, 1), (12, 12, 12)) if self.is_quick else ((155, 77, 1), (46, 46, 46))
        for name, counts, steps in (("2d", plane, 1000), ("3d", solid, 200)):
            report = self.own_run(counts, scenes.breaking_body(counts, 20 if self.is_quick else steps))
            # Forces are evaluated more often than breakage, for the critical time step.
            seconds_an_update = sum(phase["seconds"] / phase["bond_updates"] for phase in report["phases"]
                                    if phase["name"] in ("force", "damage"))
            self.add(f"mechanics_breaking_bond_updates_per_s_{name}", 1.0 / seconds_an_update, "1/s")
            self.add(f"bytes_per_bond_breaking_{name}", report["bytes_per_bond"], "B")

    def flow(self):
        """Steps of an explicit flow. One bond-update is all that a directed bond of the horizon passes on in one
        evaluation of the rates, of which a step has four: its share of viscosity, and where it is short enough of
        convection, divergence and the pressure's gradient; the smoothing of the pressure and Tait's equation at its
        point are counted with it. `flow_step...` has the updates of the Runge-Kutta method in its time as well."""
        plane, solid = ((40, 40, 1), (16, 16, 16)) if self.is_quick else ((208, 208, 1), (34, 34, 34))
        for name, counts, jitter, steps in (("", plane, 0.0, 100), ("_jittered", plane, 0.2, 100),
                                            ("_3d", solid, 0.0, 20)):
            content = scenes.driven_cavity(counts, 2 if self.is_quick else steps)
            phases = {phase["name"]: phase for phase in self.own_run(counts, content, jitter=jitter)["phases"]}
            bonds = phases["flow kernel"]["bond_updates"]
            rates = phases["flow kernel"]["seconds"] + phases["flow rates"]["seconds"]
            whole = rates + phases["flow boundaries"]["seconds"] + phases["flow update"]["seconds"]
            self.add(f"flow_kernel_bond_updates_per_s{name}", bonds / rates, "1/s")
            self.add(f"flow_step_bond_updates_per_s{name}", bonds / whole, "1/s")

    def speedup(self):
        """Time of the same steps on 1 rank over that on 2."""
        counts = (60, 30, 1) if self.is_quick else (448, 224, 1)
        bodies = (("mechanics", scenes.breaking_body, 250), ("diffusion", scenes.diffusing_plate, 2000))
        for name, body, steps in bodies:
            content = body(counts, 10 if self.is_quick else steps)
            reports = [self.own_run(counts, content, ranks=ranks) for ranks in (1, 2)]
            work = [sum(phase["bond_updates"] for phase in report["phases"]) for report in reports]
            if work[0] != work[1]:
                raise RuntimeError(f"speedup of {name}: {work[0]} bond-updates on 1 rank, {work[1]} on 2")
            times = [self._stepping_seconds(report) for report in reports]
            self.add(f"speedup_2_ranks_{name}", times[0] / times[1], "1")

    def block(self):
        """The block that Peridigm can run too, whole Verlet steps."""
        folder = self.folder / "block"
        folder.mkdir()
        body = block.Block(folder, 12 if self.is_quick else 46)
        peridigm = block.peridigm_executable()
        programs = [self.pdrun] + ([peridigm] if peridigm else [])
        for name in block.CASES:
            rates = body.rates(programs, name, (1, 2), 1 if self.is_quick else 2)
            for program in programs:
                owner = "block" if program == self.pdrun else "peridigm_block"
                self.add(f"{owner}_{name}_bond_updates_per_s", rates[program, 1], "1/s")
                self.add(f"speedup_2_ranks_{owner}_{name}", rates[program, 2] / rates[program, 1], "1")
            if peridigm:
                self.add(f"block_{name}_difference_to_peridigm", body.difference(self.pdrun, peridigm, name), "1")

    ONCE = ("mesh and neighborhoods", "initialization", "output", "checkpoint")

    def _stepping_seconds(self, report):
        """All phases but those that come once: a program's start and the reading of a mesh take as long as many steps
        of diffusion, and no two runs take the same. Waits for the other rank are in the phase that exchanges ghosts."""
        return sum(phase["seconds"] for phase in report["phases"] if phase["name"] not in self.ONCE)

    def million_points(self):
        """A cube of a million points, from the mesh file to the end of one step."""
        n = 20 if self.is_quick else 100
        step = 1e-9
        # The critical step by a formula: that of the model itself takes two hundred evaluations of the force.
        content = scenes.deck(False, {"Verlet": {"Fixed dt": step, "Critical Step": "Bulk Modulus"}}, step, 3.015)
        report = self.own_run((n, n, n), content)
        setup = sum(phase["seconds"] for phase in report["phases"]
                    if phase["name"] in ("mesh and neighborhoods", "initialization"))
        self.add("million_points_setup_s", setup, "s")
        self.add("million_points_whole_run_s", report["seconds"], "s")
        self.add("million_points_gib", report["peak_memory_bytes"] / 2**30, "GiB")
        self.add("million_points_bonds", report["bonds"], "1")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="where pdrun and kernels_benchmark were built")
    parser.add_argument("--quick", action="store_true", help="tiny bodies; the figures mean nothing")
    parser.add_argument("--whole-crevice", action="store_true", help="crevice_fixed_step_s, ten minutes more")
    parser.add_argument("--fatigue-events", action="store_true", help="600 events of fatigue, ten minutes more")
    parser.add_argument("-o", "--output", type=Path, help="default: benchmark.json in the build folder")
    options = parser.parse_args()
    build = options.build.resolve()
    output = options.output or build / "benchmark.json"
    failures = 0
    with tempfile.TemporaryDirectory(prefix="pd_benchmark_") as folder:
        benchmark = Benchmark(build, Path(folder), options.quick, options.whole_crevice)
        parts = [benchmark.block, benchmark.hydrogen_plate, benchmark.statics, benchmark.crevice,
                 benchmark.magnesium_pin, benchmark.mechanics, benchmark.flow, benchmark.speedup,
                 benchmark.million_points, benchmark.kernels]
        if options.fatigue_events:
            parts.append(benchmark.fatigue_events)
        for part in parts:
            try:
                benchmark.measure_yardstick()
                part()
            except (RuntimeError, OSError, subprocess.CalledProcessError) as error:
                print(f"benchmark.py: {part.__name__}: {error}", file=sys.stderr)
                failures += 1
            output.write_text(json.dumps(benchmark.results, indent=2) + "\n")
    for result in benchmark.results[:len(benchmark.yardstick.samples)]:
        show(result)
    tables = speed_tables(benchmark.results)
    output.with_suffix(".md").write_text(tables)
    print(f"\n{tables}\n{output}\n{output.with_suffix('.md')}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
