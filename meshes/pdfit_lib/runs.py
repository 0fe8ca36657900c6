"""Runs of a fit: each set of values once, some side by side."""
import hashlib
import json
import os
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from pdplot_lib.results import PlotError, read_history

# What a run leaves beside its history and report, which are all that a fit needs.
_REST = (".xdmf", ".h5", ".checkpoint.h5", ".resolved.yaml", ".log")


class Runs:
    """Histories by values. Those of earlier fits of the same deck, files and pdrun are taken as they are."""

    def __init__(self, problem):
        self.problem = problem
        self.count = self.reused = 0
        self.failures = {}  # key: why
        self._histories = {}
        cores = len(os.sched_getaffinity(0))
        self.pool = ThreadPoolExecutor(problem.processes or cores)

    def histories(self, sets):
        """For each set of values {number of run: {column: rows}}; nothing where a run could not go on."""
        keys = [[self._key(run, values) for run in range(len(self.problem.runs))] for values in sets]
        asked = {}
        for values, those in zip(sets, keys):
            for run, key in enumerate(those):
                if key not in self._histories and key not in asked:
                    asked[key] = self.pool.submit(self._run, key, run, values)
        for key, future in asked.items():
            self._histories[key] = future.result()
        return [None if any(self._histories[key] is None for key in those)
                else {run: self._histories[key] for run, key in enumerate(those)} for those in keys]

    @property
    def n_known(self):
        """Runs that were needed so far."""
        return len(self._histories)

    def why(self, values):
        """What the first run said that failed with these values."""
        keys = (self._key(run, values) for run in range(len(self.problem.runs)))
        return next((self.failures[key] for key in keys if key in self.failures), "")

    def name(self, run, values):
        """That of its files."""
        return f"{self.problem.name}.fit/{self._key(run, values)}"

    def _key(self, run, values):
        text = "\n".join([self.problem.runs[run]["deck"], *self.problem.overrides(run, values)])
        return self.problem.runs[run]["origin"] + "_" + hashlib.sha256(text.encode()).hexdigest()[:16]

    def _run(self, key, run, values):
        base = Path(f"{self.problem.base}.fit") / key
        history = self._finished(base)
        if history is not None:
            self.reused += 1
            return history
        command = [self.problem.program, self.problem.runs[run]["deck"], "--quiet"]
        if self.problem.folder:
            command += ["--output-folder", self.problem.folder]
        for text in (*self.problem.overrides(run, values), f'Output/Output Filename="{self.name(run, values)}"',
                     "Output/Output Frequency=-1", "Output/Checkpoint Frequency=-1"):
            command += ["--set", text]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        self.count += 1
        for ending in _REST:
            base.with_name(base.name + ending).unlink(missing_ok=True)
        shutil.rmtree(base.with_name(base.name + ".steps"), ignore_errors=True)
        history = self._finished(base) if done.returncode == 0 else None
        if history is None:
            lines = done.stderr.strip().splitlines() or [f"ended with code {done.returncode}"]
            self.failures[key] = lines[0]
            print(f"a run failed with {self.problem.text(values)}:\n  " + "\n  ".join(lines[:5]),
                  file=sys.stderr, flush=True)
        return history

    @staticmethod
    def _finished(base):
        """The history of a run that came to its end, as its report says."""
        try:
            json.loads(base.with_name(base.name + ".report.json").read_text(encoding="utf-8"))
            return read_history(base.with_name(base.name + ".csv"))
        except (OSError, ValueError, PlotError, IndexError):
            return None
