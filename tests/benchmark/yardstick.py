"""The bare loops of yardstick_benchmark, measured again and again between the parts of the benchmark."""
import json
import statistics
import subprocess

_LIST, _LATTICE = "yardstick_list_bond_updates_per_s", "yardstick_lattice_bond_updates_per_s"
UNITS = {_LIST: "1/s", _LATTICE: "1/s", "yardstick_triad_bytes_per_s": "B/s"}
REPETITIONS = 3


def program_rates(program, counter, filter_text=None, minimum_time=None, repetitions=1):
    """{name: [rates]} of a program of Google Benchmark. With repetitions its benchmarks come in random order."""
    command = [str(program), "--benchmark_format=json"]
    if filter_text:
        command.append(f"--benchmark_filter={filter_text}")
    if minimum_time:
        command.append(f"--benchmark_min_time={minimum_time}")
    if repetitions > 1:
        command += [f"--benchmark_repetitions={repetitions}", "--benchmark_enable_random_interleaving=true"]
    output = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    rates = {}
    for entry in json.loads(output)["benchmarks"]:
        if entry["run_type"] == "iteration":
            rates.setdefault(entry["name"], []).append(entry[counter])
    return rates


def fitting(name):
    """The yardstick of a rate in bond-updates/s: diffusion is held against the loop without a list, which it does as
    well, forces and tests for breakage against the list."""
    return _LATTICE if "diffusion" in name else _LIST


class Yardstick:
    """samples: {name: all rates so far}; now: {name: their median in the last measurement}."""

    def __init__(self, program, is_quick):
        self._program, self._is_quick = program, is_quick
        self.samples, self.now = {}, {}

    def measure(self):
        quick = 1 if self._is_quick else 0
        rates = program_rates(self._program, "rate", f"quick:{quick}$", "0.01" if quick else "0.2", REPETITIONS)
        for name, values in rates.items():
            name = name.split("/")[0]
            self.samples.setdefault(name, []).extend(values)
            self.now[name] = statistics.median(values)
