#!/usr/bin/python3
"""Where results go, what of earlier ones and of others' files they replace, and who may write them."""
import csv
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import time
import unittest

import h5py
import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from scene import SceneTest, lattice, mpirun, pdrun_path, plate_deck  # noqa: E402

ENDINGS = {".csv", ".csv-metadata.json", ".h5", ".xdmf", ".steps", ".report.json", ".resolved.yaml", ".log",
           ".checkpoint.h5"}


class ResultsTest(SceneTest):
    def setUp(self):
        super().setUp()
        self.write_mesh(lattice([0.02, 0.01], 1e-3), 1e-9)

    def deck(self, steps=4, **output):
        """A plate into which something diffuses."""
        return plate_deck(
            3.1e-3, 1e-3, {"Diffusivity": 1e-9},
            conditions={"All Node Set": {"Expression": "x > -1"},
                        "Start": {"Type": "Initial Concentration", "Node Set": "All Node Set", "Value": "x"}},
            solver={"Final Time": 1.0 * steps, "Diffusion": {"Method": "Euler", "Load Steps": steps}},
            output={"Output Filename": "plate", "Output Variables": ["Concentration", "Mean"], "Checkpoint Frequency": 2,
                    **output},
            Compute_Class_Parameters={"Mean": {"Compute Class": "Field_Mean", "Variable": "Concentration",
                                               "Output Label": "Mean"}})

    def write(self, name, text=""):
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "w") as file:
            file.write(text)

    def content(self, folder="."):
        """All files below the folder, with what is in them."""
        found = {}
        for place, _, names in os.walk(self.path(folder)):
            for name in names:
                with open(os.path.join(place, name), "rb") as file:
                    found[os.path.relpath(os.path.join(place, name), self.path(folder))] = file.read()
        return found

    def refused(self, deck, code, *words, **options):
        before = self.content()
        result = self.run_deck(deck, **options)
        self.assertEqual(result.code, code, result.text)
        for word in words:
            self.assertIn(word, result.text)
        after = self.content()
        after["deck.yaml"] = before["deck.yaml"] = b""
        self.assertEqual(before, after, "a run that is refused has changed files")

    def endings(self, base="plate", folder="."):
        return {name[len(base):] for name in os.listdir(self.path(folder)) if name.startswith(base + ".")}


class Places(ResultsTest):
    def test_an_output_folder_holds_all_and_the_start_nothing(self):
        self.solve(self.deck(**{"Output Filename": "sub/plate"}), arguments=["--output-folder", "far/away"])
        self.assertEqual(self.endings(folder="far/away/sub"), ENDINGS)
        self.assertEqual(sorted(os.listdir(self.folder)), ["deck.yaml", "far", "mesh.txt"])
        with h5py.File(self.path("far/away/sub/plate.h5")) as file:
            self.assertEqual(len(file["steps"]), 5)

    def test_links_that_lead_out_are_refused(self):
        os.makedirs(self.path("run/inside"))
        for name in ("mesh.txt",):
            shutil.move(self.path(name), self.path("run/" + name))
        outer, self.folder = self.folder, self.path("run")
        os.mkdir(os.path.join(outer, "outside"))
        os.symlink("../outside", self.path("out"))
        os.symlink("inside", self.path("in"))
        for arguments in ([], ["--check"]):
            self.refused(self.deck(**{"Output Filename": "out/plate"}), 2, "deck.yaml:", "by a symbolic link",
                         "--output-folder", arguments=arguments)
        os.symlink("../outside", self.path("plate.steps"))
        self.refused(self.deck(), 2, "plate.steps", "by a symbolic link")
        os.unlink(self.path("plate.steps"))
        os.symlink("nothing", self.path("plate.steps"))
        done = self.run_deck(self.deck())
        self.assertEqual(done.code, 2)
        self.assertIn("is a symbolic link to nothing", done.text)
        os.unlink(self.path("plate.steps"))
        self.assertEqual(os.listdir(os.path.join(outer, "outside")), [])
        self.solve(self.deck(**{"Output Filename": "in/plate"}))
        self.assertEqual(self.endings(folder="inside"), ENDINGS)

    def test_links_in_the_place_of_files_are_refused(self):
        self.write("precious", "mine")
        for ending in (".log", ".csv", ".h5", ".report.json"):
            os.symlink("precious", self.path("plate" + ending))
            self.refused(self.deck(), 2, f'"plate{ending}" is a symbolic link')
            os.unlink(self.path("plate" + ending))
        # Under the name of a file that is not whole yet nothing of anybody else is kept.
        os.makedirs(self.path("plate.steps"))
        for name in ("plate.csv", "plate.steps/000001.h5", "plate.checkpoint.h5"):
            os.symlink(self.path("precious"), self.path(name + ".pdrun-unfinished"))
        self.solve(self.deck())
        self.assertEqual(self.content()["precious"], b"mine")

    def test_a_file_where_a_folder_is_needed_and_the_reverse(self):
        self.write("file")
        self.refused(self.deck(**{"Output Filename": "file/plate"}), 2, 'file" is a file where a folder is needed')
        os.mkdir(self.path("plate.csv"))
        os.mkdir(self.path("plate.log"))
        self.refused(self.deck(), 2, '"plate.csv" is in the way', '"plate.log" is in the way')
        self.refused(self.deck(), 2, '"plate.csv" is in the way', '"plate.log" is in the way', arguments=["--check"])

    @unittest.skipIf(os.geteuid() == 0, "root may write anywhere")
    def test_a_folder_that_cannot_be_written_to(self):
        os.mkdir(self.path("out"), 0o555)
        self.refused(self.deck(**{"Output Filename": "out/plate"}), 2, "nothing can be written to the folder")


class FilesOfOthers(ResultsTest):
    def test_are_neither_written_over_nor_removed(self):
        for ending in sorted(ENDINGS - {".steps"}):
            self.write("plate" + ending, "step, force\n")
        self.write("plate.steps/000006.h5", "mine")
        for arguments in ([], ["--check"]):
            self.refused(self.deck(), 2, 'plate.steps/000006.h5" is there already and was not written by pdrun',
                         *(f'"plate{ending}" is there already' for ending in ENDINGS - {".steps"}), arguments=arguments)

    def test_in_the_folder_of_steps_stay(self):
        self.solve(self.deck())
        others = {"plate.steps/123.h5": b"my numbers", "plate.steps/notes.unfinished": b"my notes",
                  "plate.steps/000009.txt": b"text"}
        for name, text in others.items():
            self.write(name, text.decode())
        self.solve(self.deck(2))
        content = self.content()
        self.assertEqual({name: content[name] for name in others}, others)
        steps = {name for name in content if name.startswith("plate.steps/")} - set(others)
        self.assertEqual(steps, {f"plate.steps/{name}.h5" for name in ("mesh", "000000", "000001", "000002")})


class EarlierResults(ResultsTest):
    def test_are_replaced_as_a_whole(self):
        self.solve(self.deck())
        self.assertEqual(self.endings(), ENDINGS)
        deck = self.deck(2, **{"Output Variables": ["Concentration"], "Checkpoint Frequency": -1})
        del deck["Compute Class Parameters"]
        self.solve(deck)
        self.assertEqual(self.endings(), ENDINGS - {".csv", ".csv-metadata.json", ".checkpoint.h5"})
        with h5py.File(self.path("plate.h5")) as file:
            self.assertEqual(len(file["steps"]), 3)
        self.solve({**deck, "Output": {**deck["Output"], "Output Frequency": -1}})
        self.assertEqual(self.endings(), {".report.json", ".resolved.yaml", ".log"})

    def test_stay_where_a_run_is_refused(self):
        self.solve(self.deck())
        self.refused(self.deck(**{"Output Variables": ["Concentraton"]}), 2, "Concentraton")
        self.refused(self.deck(), 3, "none.h5", arguments=["--restart", "none.h5"])
        self.write_mesh(lattice([0.02, 0.01], 1e-3), -1e-9)
        self.refused(self.deck(), 2, "mesh.txt:1")

    def test_go_on_after_a_restart_without_the_old_report(self):
        self.solve(self.deck())
        shutil.copy(self.path("plate.checkpoint.h5"), self.path("first.h5"))
        self.run_deck(self.deck(10), arguments=["--restart", "first.h5"])
        history = self.run_deck(self.deck(10), arguments=["--restart", "first.h5"]).history()
        np.testing.assert_array_equal(history["step"], np.arange(11))
        with open(self.path("plate.log")) as file:
            starts = [line for line in file if line.startswith("pdrun ")]
        self.assertEqual(len(starts), 3)
        self.assertRegex(starts[0], f"^pdrun on {socket.gethostname()}, process \\d+, since 20")


class Locks(ResultsTest):
    def long_run(self, ranks=1, seconds=1e5):
        """A run that goes on and has written its first steps."""
        command = self.prepare(self.deck(int(seconds), **{"Output Frequency": 1}), "long", ranks)
        process = subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.addCleanup(self.end, process)
        deadline = time.monotonic() + 60
        while not os.path.exists(self.path("plate.steps/000006.h5")) and time.monotonic() < deadline:
            self.assertIsNone(process.poll(), process.stdout)
            time.sleep(0.02)
        return process

    @staticmethod
    def end(process):
        if process.poll() is None:
            process.kill()
        process.communicate()

    def test_a_second_run_is_refused_by_the_owners_name(self):
        first = self.long_run()
        with open(self.path("plate.lock")) as file:
            owner = file.readline().strip()
        self.assertRegex(owner, f"^pdrun on {socket.gethostname()}, process {first.pid}, since 20")
        for ranks in (1, 2):
            result = self.run_deck(self.deck(), ranks=ranks)
            self.assertEqual(result.code, 3, result.text)
            self.assertEqual(result.text.count(f'another run writes the results "plate": {owner}'), 1, result.text)
        self.assertIsNone(first.poll(), "the first run goes on")
        result = self.run_deck(self.deck(**{"Output Filename": "other"}))
        self.assertEqual(result.code, 0, result.text)

    def test_a_kill_leaves_nothing_that_blocks_the_next_run(self):
        for ranks in (1, 2):
            process = self.long_run(ranks)
            if ranks == 1:
                process.kill()
            else:
                with open(self.path("plate.lock")) as file:
                    os.kill(int(file.read().split()[-1]), signal.SIGKILL)
            process.communicate(timeout=60)
            self.assertTrue(os.path.exists(self.path("plate.lock")))
            self.solve(self.deck())
            self.assertEqual(self.endings(), ENDINGS)

    def test_a_kill_while_earlier_results_are_replaced_leaves_no_mixture(self):
        earlier, later = self.deck(60, **{"Output Frequency": 1}), self.deck(50, **{"Output Frequency": 1})
        begin = time.monotonic()
        self.solve(earlier)
        duration = time.monotonic() - begin
        random = np.random.default_rng(1)
        for delay in duration * random.uniform(0.2, 1.0, 8):
            process = subprocess.Popen(self.prepare(later), cwd=self.folder)
            time.sleep(delay)
            process.kill()
            process.wait()
            if os.path.exists(self.path("plate.h5")):
                with h5py.File(self.path("plate.h5")) as file:
                    for step in file["steps"]:
                        self.assertEqual(file["steps"][step]["Concentration"].shape, (200,), f"after {delay} s")
            if os.path.exists(self.path("plate.report.json")):  # the earlier run's or that of a later one that was done
                self.assertIn(len(self.content("plate.steps")), (62, 52), "a report without its results")
            self.solve(earlier)
            self.assertEqual(self.endings(), ENDINGS)

    def test_of_pairs_one_runs_and_the_other_is_refused(self):
        for _ in range(3):
            command = self.prepare(self.deck(300))
            pair = [subprocess.Popen(command, cwd=self.folder, stderr=subprocess.PIPE, text=True) for _ in range(2)]
            errors = [process.communicate(timeout=60)[1] for process in pair]
            self.assertEqual(sorted(process.returncode for process in pair), [0, 3], errors)
            with h5py.File(self.path("plate.h5")) as file:
                for step in file["steps"]:
                    self.assertEqual(file["steps"][step]["Concentration"].shape, (200,))
            self.assertEqual(self.endings(), ENDINGS)

    def test_a_lock_of_another_host_holds_until_it_is_removed(self):
        self.write("plate.lock", "pdrun on elsewhere, process 7, since 2026-01-01 00:00:00\nelsewhere\nx\n7\n")
        self.refused(self.deck(), 3, "on elsewhere, process 7, since", 'left "plate.lock" behind; remove it')
        os.unlink(self.path("plate.lock"))
        self.solve(self.deck())

    def test_a_lock_of_this_host_before_it_was_started_anew_does_not_hold(self):
        host = socket.gethostname()
        self.write("plate.lock", f"pdrun on {host}, process 7, since 2026-01-01 00:00:00\n{host}\nx\n1\n")
        self.solve(self.deck())
        self.assertEqual(self.endings(), ENDINGS)

    def test_a_lock_file_of_others_is_left_alone(self):
        self.write("plate.lock", "do not touch\n")
        self.refused(self.deck(), 3, '"plate.lock" is in the way')


class FullDisks(ResultsTest):
    """A file system in memory, in a mount space of the run's own, is full after a few files."""

    def run_on_a_small_disk(self, deck, kilobytes, ranks):
        command = " ".join(self.prepare(deck, ranks=ranks, arguments=["--output-folder", "small"]))
        os.makedirs(self.path("small"), exist_ok=True)
        script = (f"mount -t tmpfs -o size={kilobytes}k none small || exit 77; {command}; code=$?; "
                  "rm -rf after; cp -r small after; exit $code")
        done = subprocess.run(["unshare", "-m", "bash", "-c", script], cwd=self.folder, capture_output=True, text=True,
                              timeout=100)
        if "unshare" in done.stderr or done.returncode == 77:
            self.skipTest("nothing can be mounted here: " + done.stderr)
        return done

    def test_end_the_run_with_a_message_and_leave_what_can_be_read(self):
        # On several ranks HDF5 would wait without end for the one that met the end of the disk.
        nRead = 0
        for ranks, kilobytes in ((1, 4), (1, 16), (1, 64), (1, 90), (1, 200), (2, 4), (2, 40), (2, 90), (2, 200)):
            with self.subTest(ranks=ranks, kilobytes=kilobytes):
                done = self.run_on_a_small_disk(self.deck(60, **{"Output Frequency": 1}), kilobytes, ranks)
                self.assertEqual(done.returncode, 3, done.stderr)
                self.assertRegex(done.stderr, 'the run cannot go on: .*small/plate')
                self.assertFalse(os.path.exists(self.path("after/plate.lock")))
                if os.path.exists(self.path("after/plate.h5")) and os.path.getsize(self.path("after/plate.h5")):
                    with h5py.File(self.path("after/plate.h5")) as file:
                        for step in file["steps"]:
                            self.assertEqual(file["steps"][step]["Concentration"].shape, (200,))
                            nRead += 1
                # What is left stands in nobody's way.
                self.solve(self.deck(), arguments=["--output-folder", "after"])
                self.assertEqual(self.endings(folder="after"), ENDINGS)
        self.assertGreater(nRead, 0)


class Studies(ResultsTest):
    STUDY = """\
Deck: deck.yaml
Name: {name}
Histories: [Mean]
Series:
  - Label: "one, two"
    Sweep: {{Solver/Diffusion/Load Steps: {steps}}}
"""

    def study(self, name="steps", steps=(4, 5), arguments=()):
        self.prepare(self.deck())
        self.write("study.yaml", self.STUDY.format(name=name, steps=list(steps)))
        return subprocess.run([pdrun_path(), "--study", "study.yaml", "--quiet", *arguments], cwd=self.folder,
                              capture_output=True, text=True, timeout=120)

    def test_names_stay_below_the_folder(self):
        for name in ("../steps", "/tmp/steps", "a:b"):
            done = self.study(name)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("study.yaml:2:7: Name must", done.stderr)

    def test_results_go_to_the_output_folder_as_a_whole(self):
        done = self.study(steps=(4, 5, 6), arguments=["--output-folder", "out"])
        self.assertEqual(done.returncode, 0, done.stderr)
        self.write("out/steps.study/mine.csv", "mine")
        done = self.study(steps=(4, 5), arguments=["--output-folder", "out"])
        self.assertEqual(done.returncode, 0, done.stderr)
        names = os.listdir(self.path("out/steps.study"))
        self.assertEqual({name.split(".")[0] for name in names}, {"1_1", "1_2", "mine"})
        with open(self.path("out/steps.study.csv"), newline="") as file:
            self.assertEqual([row["label"] for row in csv.DictReader(file)], 2 * ["one, two"])
        self.assertTrue(os.path.exists(self.path("out/steps.histories.png")))
        self.assertEqual(sorted(os.listdir(self.folder)), ["deck.yaml", "mesh.txt", "out", "study.yaml"])

    def test_tables_and_pictures_of_others_stay(self):
        self.write("steps.study.csv", "a,b\n1,2\n")
        self.write("steps.histories.png", "picture")
        for arguments in ([], ["--check"]):
            done = self.study(arguments=arguments)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn('"steps.study.csv" is there already', done.stderr)
            self.assertIn('"steps.histories.png" is there already', done.stderr)
        self.assertEqual(self.content()["steps.study.csv"], b"a,b\n1,2\n")


class Names(ResultsTest):
    """Names that were chosen to break files arrive whole in each of them."""

    def test_in_csv_json_and_xml(self):
        import meshio
        name, label = "a & b <c> [1]", "M & <x> é;y"
        deck = self.deck(**{"Output Filename": name, "Output Variables": ["Ions & <more>", label]})
        deck["Materials"]["Steel"]["Diffusing Field"] = "Ions & <more>"
        deck["Solver"]["Diffusion"]["Field"] = "Ions & <more>"
        deck["Boundary Conditions"]["Start"].update({"Type": "Initial Value", "Field": "Ions & <more>"})
        deck["Compute Class Parameters"]["Mean"].update({"Variable": "Ions & <more>", "Output Label": label})
        self.solve(deck)
        base = self.path(name)
        with open(base + ".csv", encoding="utf-8", newline="") as file:
            self.assertEqual(next(csv.reader(file)), ["step", "time", label])
        table = np.genfromtxt(base + ".csv", delimiter=",", names=True, encoding="utf-8", deletechars="", replace_space=" ")
        self.assertEqual(table.dtype.names, ("step", "time", label))
        with open(base + ".csv-metadata.json") as file:
            self.assertEqual(json.load(file)["tableSchema"]["columns"][2]["name"], label)
        with meshio.xdmf.TimeSeriesReader(base + ".xdmf") as reader:
            reader.read_points_cells()
            self.assertIn("Ions & <more>", reader.read_data(0)[1])


if __name__ == "__main__":
    unittest.main()
