#!/usr/bin/python3
"""Runs the decks of a Peridigm source tree in pdrun and compares the results with the tree's own reference files.

    tests/peridigm/examples.py TREE --pdrun build/pdrun [--peridigm EXE] [--only WORD] [--keep FOLDER] [--details]

Every deck in examples/, test/regression and test/verification whose materials pdrun has is run unchanged, in a copy of
its folder. References are the files NAME_gold.e (or .h) beside a deck, and with --peridigm what that program makes of
the same deck. Fields are compared value by value at each common time; an error is the largest difference over the
largest value of the reference in the whole run. Differences below what rounding makes of forces, K/horizon 1e-13, and
of strains count as none. A solver that iterates leaves what its tolerance allows: where an error is above 1e-8, the
tolerances of the tree's own test, the .comp file, decide, and the verdict says "within Peridigm's tolerances". Decks
that differ for a reason that is known say which (EXPLAINED below).
"""
import argparse
import csv
import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile

import h5py
import numpy as np
from scipy.spatial import cKDTree

from exodus import ExodusSeries, joined

MATERIALS = {"Elastic", "Elastic Bond Based", "Diffusion"}
# What rounding leaves after many steps.
AGREES = 1e-8
HALF_STEP = ("Peridigm's velocities of prescribed points carry half a step of their acceleration, "
             "dt/2 (F + b)/rho; ours are those prescribed")
# Differences whose cause has been found: deck -> (field: largest relative error, cause). An error beyond that, or in any
# other field, is not explained by it. That of wave_in_bar is dt/2 F/rho of the forces at its held end.
EXPLAINED = {
    "Body_Force_Explicit.xml": ({"Velocity": 3e-2}, HALF_STEP),
    "Compression_QS_Explicit_3x2x2.xml": ({"Velocity": 1e-4}, HALF_STEP),
    "Compression_QS_Explicit_MultiFreqOutput_3x2x2.xml": ({"Velocity": 1e-4}, HALF_STEP),
    "wave_in_bar.yaml": ({"Velocity": 0.26}, HALF_STEP),
    "CentrifugalLoad.xml": (
        dict.fromkeys(("Displacement", "Velocity", "Dilatation", "Force", "Force_Density"), 5e-8),
        "both stop at the deck's absolute tolerance; tighter ones bring them together"),
    "PrecrackedPlateTwoCracks/PrecrackedPlate.xml": (
        {"Displacement": 0.04, "Velocity": 0.04, "Dilatation": 0.3, "Force": 0.06, "Force_Density": 0.06,
         "Number_Of_Neighbors": 0.08},
        "bonds that meet the very edge of a crack: all are cut here, by rounding some of them in Peridigm, whose "
        "neighbourhoods are not symmetric there"),
}


def values_of(text, key):
    """Values of a key anywhere in a deck, in XML or YAML."""
    in_xml = re.findall(rf'name="{key}"[^>]*value="([^"]*)"', text)
    in_yaml = re.findall(rf'^\s*"?{key}"?:\s*"?([^"\n#]+?)"?\s*$', text, re.MULTILINE)
    return in_xml + in_yaml


def decks_of(tree):
    """Paths of all decks, but for the copies in the folders np1, np2, ... that the tests run in."""
    found = []
    for part in ("examples", "test/regression", "test/verification"):
        for folder, _, files in os.walk(os.path.join(tree, part)):
            if re.fullmatch(r"np\d+", os.path.basename(folder)):
                continue
            for name in files:
                path = os.path.join(folder, name)
                if name.endswith((".yaml", ".xml")) and values_of(open(path, errors="replace").read(),
                                                                  "Material Model"):
                    found.append(path)
    return sorted(found)


def copy_of_folder(deck, into):
    """The deck's folder without results; its mesh, where a script beside it makes that."""
    source = os.path.dirname(deck)
    for name in os.listdir(source):
        path = os.path.join(source, name)
        if os.path.isfile(path) and "_gold." not in name:
            shutil.copy(path, into)
    for mesh in values_of(open(deck).read(), "Input Mesh File"):
        if not os.path.exists(os.path.join(into, mesh)):
            for script in glob.glob(os.path.join(into, "*_generate_mesh.py")):
                subprocess.run([sys.executable, os.path.basename(script)], cwd=into, capture_output=True, check=False)


def run(command, folder, timeout):
    """(exit code, output); 124 where the time is up."""
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=timeout, errors="replace")
    except subprocess.TimeoutExpired:
        return 124, f"not done after {timeout} s"
    return done.returncode, done.stdout + done.stderr


class Ours:
    """Results of pdrun: times of steps, fields, histories. `paths`: of one or several outputs, without extension."""

    def __init__(self, paths):
        self.steps, self.coordinates, self.history = [], None, {}
        for path in paths:
            if os.path.exists(path + ".h5"):
                with h5py.File(path + ".h5", "r") as file:
                    self.coordinates = np.array(file["mesh/coordinates"])
                    self.steps += [(float(file["steps"][key].attrs["time"]), path, key) for key in file["steps"]]
            if os.path.exists(path + ".csv"):
                with open(path + ".csv") as file:
                    rows = list(csv.DictReader(file))
                self.history = {key: np.array([float(row[key]) for row in rows]) for key in rows[0]}
        self.exists = bool(self.steps or self.history)

    @staticmethod
    def _nearest(times, time, scale):
        """Position of the time, or None."""
        if len(times) == 0:
            return None
        k = int(np.argmin(np.abs(np.asarray(times) - time)))
        return k if abs(times[k] - time) <= 1e-7 * scale else None

    def field(self, label, time, scale):
        k = self._nearest([step[0] for step in self.steps], time, scale)
        if k is None:
            return None
        _, path, key = self.steps[k]
        with h5py.File(path + ".h5", "r") as file:
            group = file["steps"][key]
            return np.array(group[label]) if label in group else None

    def has_time(self, time, scale):
        times = [step[0] for step in self.steps] if self.steps else self.history["time"]
        return self._nearest(times, time, scale) is not None

    def values(self, columns, time, scale):
        """Those columns of the history, or None."""
        k = self._nearest(self.history.get("time", []), time, scale)
        known = all(column in self.history for column in columns)
        return np.array([self.history[column][k] for column in columns]) if known and k is not None else None


class Tolerances:
    """A .comp file of the tree: what its own test allows a variable to differ by."""

    def __init__(self, path):
        self.of = {}
        section = None
        for line in open(path):
            words = line.split("#")[0].split()
            if not words:
                continue
            upper = " ".join(words).upper()
            if not line[0].isspace():
                header = re.match(r"(NODAL|ELEMENT|GLOBAL) VARIABLES", upper)
                section = self._parse(words[2:], None) if header else None
                if header and section is None:
                    section = ("absolute", 1e-9, 0.0)
            elif section and not words[0].startswith("!"):
                self.of[words[0]] = self._parse(words[1:], section)

    @staticmethod
    def _parse(words, default):
        kind, value, floor = default or ("relative", None, 0.0)
        for i, word in enumerate(words):
            if word.lower() in ("absolute", "relative"):
                kind = word.lower()
            elif word.lower() == "floor":
                floor = float(words[i + 1])
                break
            else:
                value = float(word)
        return None if value is None else (kind, value, floor)

    def allow(self, name, ours, theirs):
        """None where the tree does not compare the variable."""
        if name not in self.of:
            return None
        kind, value, floor = self.of[name]
        difference, size = np.abs(ours - theirs), np.maximum(np.abs(ours), np.abs(theirs))
        return bool(np.all((difference <= (value if kind == "absolute" else value * size)) | (size <= floor)))


class Comparison:
    """Errors of one run against one reference. `noise`: differences of fields that are rounding."""

    def __init__(self, noise):
        self.noise = noise
        self.errors, self.sizes, self.differences = {}, {}, {}
        self.broken_tolerances, self.unchecked, self.missing_fields, self.missing_times = set(), set(), set(), 0

    def add(self, label, ours, theirs, allowed):
        difference = float(np.max(np.abs(ours - theirs), initial=0.0))
        if difference <= self.noise.get(label, 0.0):
            difference = 0.0
        self.differences[label] = max(self.differences.get(label, 0.0), difference)
        self.sizes[label] = max(self.sizes.get(label, 0.0), float(np.max(np.abs(theirs), initial=0)))
        if allowed is None:
            self.unchecked.add(label)
        elif not allowed:
            self.broken_tolerances.add(label)

    def relative(self, label):
        difference, size = self.differences[label], self.sizes[label]
        return 0.0 if difference == 0.0 else difference / size if size > 0.0 else np.inf

    def verdict(self, deck):
        if not self.differences:
            return "nothing to compare"
        large = [label for label in self.differences if self.relative(label) > AGREES]
        fields, cause = next((EXPLAINED[name] for name in EXPLAINED if deck.endswith(name)), ({}, ""))
        is_explained = all(self.relative(label) <= fields.get(label, 0.0) for label in large)
        notes = []
        if self.missing_times:
            notes.append(f"{self.missing_times} times missing")
        if not large:
            notes.insert(0, "agrees")
        elif all(label not in self.broken_tolerances and label not in self.unchecked for label in large):
            notes.insert(0, "within Peridigm's tolerances")
        elif is_explained:
            notes.insert(0, f"explained: {cause}")
        else:
            notes.insert(0, "DIFFERS")
        return ", ".join(notes)


def vector_labels(names):
    """Names of variables with their components joined: DisplacementX, ... -> Displacement."""
    labels = set()
    for name in names:
        base = next((name[:-n] for n in (2, 1) if len(name) > n and re.fullmatch(f"[XYZ]{{{n}}}", name[-n:]) and
                     name[:-n] + ("XX" if n == 2 else "X") in names), name)
        labels.add(base)
    return sorted(labels)


def component_names(label, width):
    return [label] if width == 1 else [label + a for a in "XYZ"] if width == 3 else [
        label + a + b for a in "XYZ" for b in "XYZ"]


def noise_of(text):
    """What rounding may make of fields of this deck."""
    def largest(*keys):
        return max((float(v) for key in keys for v in values_of(text, key) if re.fullmatch(r"[-+.\deE]+", v)), default=0)
    horizons = [float(v) for v in values_of(text, "Horizon") if re.fullmatch(r"[-+.\deE]+", v)]
    force = 1e-13 * largest("Bulk Modulus", "Young's Modulus") / min(horizons, default=1.0)
    reach = min(horizons, default=1.0)
    return {"Force_Density": force, "Force": force * reach ** 3, "Dilatation": 1e-14, "Displacement": 1e-15 * reach}


class OtherPoints(ValueError):
    """The reference is of something else."""


def compare(ours, reference, tolerances, noise):
    result = Comparison(noise)
    scale = max(abs(reference.times[-1]), abs(reference.times[0]), 1e-300)
    order = None
    if ours.coordinates is not None and reference.fields:
        distance, order = cKDTree(ours.coordinates).query(reference.coordinates)
        extent = np.ptp(reference.coordinates, axis=0).max() or 1.0
        if distance.max() > 1e-6 * extent or len(set(order)) != len(order) or len(order) != len(ours.coordinates):
            raise OtherPoints(f"{len(ours.coordinates)} points here, {len(reference.coordinates)} there")
    # Where one solver follows another, Peridigm writes its first state again.
    steps = [k for k, t in enumerate(reference.times) if k == 0 or t > reference.times[k - 1]]
    result.missing_times = sum(not ours.has_time(reference.times[k], scale) for k in steps)
    for label in vector_labels(reference.fields):
        theirs_all = joined(reference.fields, label)
        if np.all(np.isnan(theirs_all)) or order is None:
            continue
        for k in steps:
            found = ours.field(label, reference.times[k], scale)
            if found is None:
                if ours.has_time(reference.times[k], scale):
                    result.missing_fields.add(label)
                continue
            found, theirs = found[order].reshape(len(order), -1), theirs_all[k].reshape(len(order), -1)
            exists = ~np.isnan(theirs)
            allowed = None
            if tolerances:
                answers = [tolerances.allow(name, found[exists[:, c], c], theirs[exists[:, c], c])
                           for c, name in enumerate(component_names(label, found.shape[1]))]
                allowed = None if None in answers else all(answers)
            result.add(label, found[exists], theirs[exists], allowed)
    for label in vector_labels(reference.globals):
        names = [label] if label in reference.globals else [label + axis for axis in "XYZ"]
        for k in steps:
            here = ours.values(names, reference.times[k], scale)
            if here is None:
                result.missing_fields.add(label)
                continue
            there = np.array([reference.globals[name][k] for name in names])
            answers = [tolerances.allow(*row) if tolerances else None for row in zip(names, here, there)]
            result.add(label, here, there, None if None in answers else all(answers))
    return result


def references_of(deck, names):
    """(names of outputs, file) for the gold files beside the deck."""
    folder, stem = os.path.dirname(deck), os.path.splitext(os.path.basename(deck))[0]
    found = [([name], path) for name in dict.fromkeys(names) for end in ("e", "h")
             for path in [os.path.join(folder, f"{name}_gold.{end}")] if os.path.exists(path)]
    # One reference may stand for all outputs together.
    whole = os.path.join(folder, f"{stem}_gold.e")
    return found or ([(list(dict.fromkeys(names)), whole)] if os.path.exists(whole) else [])


def tolerances_for(deck, name):
    folder = os.path.dirname(deck)
    stem = os.path.splitext(os.path.basename(deck))[0]
    for candidate in (name, stem):
        path = os.path.join(folder, candidate + ".comp")
        if os.path.exists(path):
            return Tolerances(path)
    found = glob.glob(os.path.join(folder, "*.comp"))
    return Tolerances(found[0]) if len(found) == 1 else None


def reason_of(output, deck):
    """The mistakes that pdrun found, in short."""
    lines = [line.replace(deck, "deck") for line in output.splitlines() if line.strip()]
    mistakes = [line for line in lines if not line.startswith("warning:") and "step " not in line[:5]]
    mistakes = mistakes or lines
    first = re.sub(r"^\S*?:(\d+):", r"line \1:", mistakes[0]) if mistakes else "no output"
    return first[:110] + (f" (and {len(mistakes) - 1} more)" if len(mistakes) > 1 else "")


class Table:
    def __init__(self, details):
        self.details, self.counts, self.fields_compared = details, {}, 0

    def row(self, deck, against, fields, error, verdict):
        kind = re.split(r"[,:;(]", verdict)[0].strip()
        self.counts[kind] = self.counts.get(kind, 0) + 1
        print(f"{deck:58.58} | {against:8} | {fields:>6} | {error:>8} | {verdict}", flush=True)

    def comparison(self, deck, text, against, result):
        self.fields_compared += len(result.differences)
        worst = max(result.differences, key=result.relative, default=None)
        error = "" if worst is None else f"{result.relative(worst):.1e}"
        # References may be older than the deck, with fields that it does not ask for.
        missing = sorted(label for label in result.missing_fields if label in text)
        verdict = result.verdict(deck) + (f" ({worst})" if worst and result.relative(worst) > AGREES else "")
        if missing:
            verdict += "; not here: " + " ".join(missing)
        self.row(deck, against, len(result.differences), error, verdict)
        if self.details:
            for label in sorted(result.differences):
                print(f"      {label:34} largest {result.sizes[label]:.6e}  difference {result.differences[label]:.2e}"
                      f"  relative {result.relative(label):.1e}"
                      f"{'  beyond .comp' if label in result.broken_tolerances else ''}")


def check_deck(deck, arguments, table):
    name = os.path.relpath(deck, arguments.tree)
    text = open(deck, errors="replace").read()
    missing = set(values_of(text, "Material Model")) - MATERIALS
    if missing:
        return missing
    folder = tempfile.mkdtemp(prefix="pd_deck_", dir=arguments.keep)
    try:
        ours_in, theirs_in = os.path.join(folder, "pdrun"), os.path.join(folder, "peridigm")
        os.mkdir(ours_in)
        copy_of_folder(deck, ours_in)
        pdrun = [arguments.pdrun, os.path.basename(deck), "--peridigm-keys", arguments.keys]
        code, output = run(pdrun, ours_in, arguments.timeout)
        their_code = None
        if arguments.peridigm:
            os.mkdir(theirs_in)
            copy_of_folder(deck, theirs_in)
            # Of a deck that is refused here only the first seconds matter.
            their_code, _ = run([arguments.peridigm, os.path.basename(deck)], theirs_in,
                                arguments.timeout if code == 0 else 5.0)
        if code != 0:
            theirs = f"; Peridigm exits with {their_code} too" if their_code not in (None, 0, 124) else ""
            table.row(name, "-", "", "", f"exit {code}: {reason_of(output, os.path.basename(deck))}{theirs}")
            return set()
        outputs = values_of(text, "Output Filename")
        references = [(names, path, "gold") for names, path in references_of(deck, outputs)]
        if their_code == 0:
            references += [([output_name], path, "Peridigm") for output_name in dict.fromkeys(outputs)
                           for path in glob.glob(os.path.join(theirs_in, output_name + ".[eh]"))]
        if not references:
            table.row(name, "-", "", "", "runs: the tree has no results to compare with")
        for names, path, against in references:
            ours = Ours([os.path.join(ours_in, output_name) for output_name in names])
            if not ours.exists:
                table.row(name, against, "", "", f"DIFFERS: no results {' '.join(names)} here")
                continue
            try:
                table.comparison(name, text, against, compare(ours, ExodusSeries([path]),
                                                              tolerances_for(deck, names[0]), noise_of(text)))
            except OtherPoints as error:
                table.row(name, against, "", "", f"no comparison: the reference is of something else, {error}")
    finally:
        if not arguments.keep:
            shutil.rmtree(folder)
    return set()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tree", help="a Peridigm source tree")
    parser.add_argument("--pdrun", default=os.environ.get("PDRUN", "pdrun"), help="the pdrun to test")
    parser.add_argument("--peridigm", default=os.environ.get("PERIDIGM_EXECUTABLE"), help="a Peridigm to run beside it")
    parser.add_argument("--only", default="", help="decks whose path contains this")
    parser.add_argument("--keep", help="an existing folder in which the runs are kept")
    parser.add_argument("--timeout", type=float, default=600.0, help="seconds for one run (600)")
    parser.add_argument("--keys", default="strict", choices=["strict", "lenient"], help="pdrun's --peridigm-keys")
    parser.add_argument("--details", action="store_true", help="every field with its error")
    arguments = parser.parse_args()
    arguments.pdrun = os.path.abspath(arguments.pdrun) if os.sep in arguments.pdrun else arguments.pdrun
    decks = [deck for deck in decks_of(arguments.tree) if arguments.only in deck]
    if not decks:
        parser.error(f"no decks with {arguments.only!r} in {arguments.tree}")
    table, others = Table(arguments.details), {}
    print(f"{'deck':58} | {'against':8} | fields | {'error':8} | verdict")
    for deck in decks:
        for material in check_deck(deck, arguments, table):
            others[material] = others.get(material, 0) + 1
    print("\n" + "; ".join(f"{count} {verdict}" for verdict, count in sorted(table.counts.items())) +
          f"; {table.fields_compared} fields compared")
    if others:
        print("Decks with other materials, not run: " + ", ".join(f"{m} ({n})" for m, n in sorted(others.items())))
    return 1 if any(verdict.startswith("DIFFERS") for verdict in table.counts) else 0


if __name__ == "__main__":
    sys.exit(main())
