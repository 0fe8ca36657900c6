"""pdrun as a program: what it prints, its exit codes, alone and on several processes."""

import os
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

PDRUN = os.path.abspath(os.environ["PDRUN"])

DECK = """\
Discretization:
  Type: Text File
  Input Mesh File: mesh.txt
  Thickness: 1.0e-3
Materials:
  Steel: {Material Model: PDHE, Density: 7850.0, Young's Modulus: 2.0e+11, Poisson's Ratio: 0.3,
          Plane Stress: true, Thickness: 1.0e-3}
Blocks:
  Plate: {Block Names: block_1, Material: Steel, Horizon: 3.1e-3}
Boundary Conditions:
  All Node Set: {Expression: "x > -1"}
  Push: {Type: Initial Velocity, Node Set: All Node Set, Coordinate: x, Value: "100*x"}
Solver:
  Final Time: 1.0e-6
  Verlet: {Safety Factor: 0.5}
Output:
  Output Filename: results
  Output Frequency: 1000
  Output Variables: [Displacement]
"""


def mesh():
    rows = [f"{1e-3 * i} {1e-3 * j} 0.0 1 1.0e-9" for j in range(5) for i in range(11)]
    return "\n".join(rows) + "\n"


class Pdrun(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.write("deck.yaml", DECK)
        self.write("mesh.txt", mesh())

    def tearDown(self):
        self.folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, text):
        with open(self.path(name), "w") as file:
            file.write(text)

    def run_pdrun(self, *arguments, ranks=1):
        launcher = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np", str(ranks)]
        command = (launcher if ranks > 1 else []) + [PDRUN, *arguments]
        return subprocess.run(command, cwd=self.folder.name, capture_output=True, text=True, timeout=120)

    def test_help_shows_sample_runs_and_exit_codes(self):
        done = self.run_pdrun("--help")
        self.assertEqual(done.returncode, 0)
        self.assertTrue(done.stdout.startswith("Peridynamic"), done.stdout[:200])
        for text in ("Sample runs:", "mpirun -np 4 pdrun plate.yaml", "--ranks N", "--set PATH=VALUE", "--restart FILE", "Exit codes:"):
            self.assertIn(text, done.stdout)

    def test_version(self):
        done = self.run_pdrun("--version")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout, r"^pdrun \d+\.\d+\.\d+\n$")

    def start(self, *arguments, **environment):
        return subprocess.Popen([PDRUN, *arguments], cwd=self.folder.name, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, env={**os.environ, **environment})

    def long_run(self):
        """On two ranks, at work."""
        run = self.start("--ranks", "2", "deck.yaml", "--quiet", "--set", "Solver/Final Time=1.0",
                         "--set", "Output/Output Frequency=1")
        deadline = time.monotonic() + 60
        while not os.path.exists(self.path("results.h5")) and run.poll() is None and time.monotonic() < deadline:
            time.sleep(0.01)
        self.assertIsNone(run.poll(), run.stderr.read() if run.poll() is not None else "")
        return run

    def ranks_in_folder(self):
        """Processes of pdrun that work in the folder."""
        found = []
        for pid in filter(str.isdigit, os.listdir("/proc")):
            try:
                if os.readlink(f"/proc/{pid}/cwd") == self.folder.name and os.path.basename(
                        os.readlink(f"/proc/{pid}/exe")) == "pdrun":
                    found.append(int(pid))
            except OSError:
                pass
        return found

    def assert_all_end(self):
        deadline = time.monotonic() + 30
        while self.ranks_in_folder() and time.monotonic() < deadline:
            time.sleep(0.05)
        self.assertEqual(self.ranks_in_folder(), [])

    def test_ranks_start_mpirun_with_all_options(self):
        done = self.run_pdrun("--ranks", "3", "deck.yaml", "--set", "Output/Output Filename=three")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("ranks 3\n", done.stdout)
        self.assertTrue(os.path.exists(self.path("three.report.json")))
        done = self.run_pdrun("deck.yaml", "--ranks=2", "--check")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "deck.yaml: no mistakes found\n", ""))

    def test_ranks_pass_exit_codes_on(self):
        self.write("deck.yaml", DECK.replace("Horizon: 3.1e-3", "Horizn: 3.1e-3"))
        done = self.run_pdrun("--ranks", "2", "deck.yaml")
        self.assertEqual(done.returncode, 2)
        self.assertIn("did you mean \"Horizon\"", done.stderr)
        self.assertNotIn("mpirun", done.stderr)

    def test_ranks_without_mpirun_say_so(self):
        run = self.start("--ranks", "2", "deck.yaml", PATH="/nowhere")
        _, errors = run.communicate(timeout=60)
        self.assertEqual(run.returncode, 2)
        self.assertIn("--ranks needs mpirun", errors)

    def test_ranks_where_they_make_no_sense(self):
        for arguments, message in ((("--ranks", "0", "deck.yaml"), "--ranks"), (("--ranks", "2", "--list"), "a deck"),
                                   (("--ranks", "2", "--study", "study.yaml"), "a deck")):
            done = self.run_pdrun(*arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertIn(message, done.stderr)
        done = self.run_pdrun("--ranks", "2", "deck.yaml", ranks=2)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.count("leave it out, or mpirun"), 1, done.stderr)

    def test_signals_end_all_ranks(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            run = self.long_run()
            run.send_signal(number)
            run.communicate(timeout=60)
            self.assertEqual(run.returncode, -number)
            self.assert_all_end()
            os.remove(self.path("results.h5"))

    def test_a_killed_launcher_takes_its_ranks_along(self):
        run = self.long_run()
        run.kill()
        run.wait(timeout=60)
        self.assert_all_end()

    def test_a_killed_rank_is_told(self):
        run = self.long_run()
        ranks = [pid for pid in self.ranks_in_folder() if pid != run.pid]
        self.assertEqual(len(ranks), 2)
        os.kill(ranks[1], signal.SIGKILL)
        _, errors = run.communicate(timeout=60)
        self.assertEqual(run.returncode, 128 + signal.SIGKILL)
        self.assertIn("a rank was ended by signal 9 (Killed)", errors)

    def test_one_process_starts_no_daemon_of_mpi(self):
        # Open MPI looks for its daemon, orted, in PATH.
        self.write("orted", "#!/bin/sh\ntouch started\n")
        os.chmod(self.path("orted"), 0o755)
        for arguments in (("--list",), ("--explain", "PDHE"), ("--version",), ("--check", "deck.yaml"), ("deck.yaml",)):
            run = self.start(*arguments, PATH=self.folder.name)
            run.communicate(timeout=60)
            self.assertEqual(run.returncode, 0, arguments)
        self.assertFalse(os.path.exists(self.path("started")))

    def test_runs_side_by_side_share_no_session_directory(self):
        # Of Open MPI: the run that ends first would remove it as the next one starts.
        run = self.start("deck.yaml", TMPDIR=self.path("is not there"))
        _, errors = run.communicate(timeout=60)
        self.assertEqual(run.returncode, 0, errors)

    def test_list_names_every_kind(self):
        done = self.run_pdrun("--list")
        self.assertEqual(done.returncode, 0)
        for text in ("Materials\n", "  PDHE ", "  Corrosion Dissolution ", "Damage models\n", "  Critical Stretch ",
                     "  Dissolution ", "Computes\n", "Solvers\n", "  Verlet ", "  Corrosion ", "Methods of the solver Diffusion\n", "Initial and boundary conditions\n", "Bond filters\n",
                     "Sections of a deck\n"):
            self.assertIn(text, done.stdout)

    def test_everything_listed_is_explained(self):
        listed = self.run_pdrun("--list").stdout
        names = [re.split(r"\s{2,}", line.strip())[0] for line in listed.splitlines() if line.startswith("  ")]
        self.assertGreater(len(names), 40)
        for name in ("PDHE", "Corrosion Dissolution", "Critical Stretch", "Dissolution", "Crack_Tip", "Verlet",
                     "Corrosion", "Euler", "Traction", "Disk", "Output"):
            self.assertIn(name, names)
            done = self.run_pdrun("--explain", name)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(done.stdout.startswith(name), done.stdout)
        explained = self.run_pdrun("--explain", "PDHE").stdout
        self.assertIn("Young's Modulus: a number > 0 Pa", explained)
        self.assertIn('Give at most one of "Plane Stress", "Plane Strain", "One Dimensional".', explained)
        self.assertIn("    reads Volume (m3): Volume of the point's cell.", explained)
        self.assertIn("    reads, where it is there, Bond_Damage: Of bonds: 1 where the bond is broken", explained)
        self.assertIn("    adds to Force_Density (N/m3): Internal force per volume.", explained)
        explained = self.run_pdrun("--explain", "Field_Mean").stdout
        self.assertIn("    reads <Variable> (unit of the deck): What it is taken of.", explained)
        self.assertIn("    writes Velocity (m/s): Velocity.", self.run_pdrun("--explain", "Verlet").stdout)

    def test_sections_below_solvers_are_explained(self):
        explained = self.run_pdrun("--explain", "When")
        self.assertEqual(explained.returncode, 0, explained.stderr)
        self.assertTrue(explained.stdout.startswith("When (a section)\n"), explained.stdout)
        self.assertIn("In Staggered/Solvers/*", explained.stdout)
        self.assertIn("Has Changed By: ", explained.stdout)
        self.assertIn("Stop When (a section)", self.run_pdrun("--explain", "Stop When").stdout)
        self.assertIn("# When", self.run_pdrun("--explain", "When", "--markdown").stdout)
        self.assertEqual(self.run_pdrun("--explain", "Whenever").returncode, 2)

    def test_the_whole_reference_is_pages_of_a_folder_or_text(self):
        done = self.run_pdrun("--explain", "--all", "--markdown", "reference")
        self.assertEqual(done.returncode, 0, done.stderr)
        pages = done.stdout.split()
        self.assertEqual(sorted(os.listdir(self.path("reference"))), sorted(page.split("/")[1] for page in pages))
        with open(self.path("reference/README.md")) as file:
            linked = re.findall(r"\]\((\w+\.md)\)", file.read())
        self.assertEqual(["reference/README.md"] + [f"reference/{page}" for page in linked], pages)
        self.assertEqual(self.run_pdrun("--explain", "--all", "--markdown", "reference").returncode, 0)
        self.write("README.md", "mine")
        done = self.run_pdrun("--explain", "--all", "--markdown", ".")
        self.assertEqual(done.returncode, 2)
        self.assertIn('README.md" is there already and is no page of a reference', done.stderr)
        everything = self.run_pdrun("--explain", "--all", "--markdown").stdout
        for page in linked:
            with open(self.path(f"reference/{page}")) as file:
                self.assertIn(file.read(), everything)
        # How numbers are written comes once, at the end.
        keys, numbers = self.run_pdrun("--explain", "PDHE").stdout.split("\nA number may be a product")
        whole = self.run_pdrun("--explain", "--all").stdout
        self.assertIn(keys, whole)
        self.assertTrue(whole.endswith(numbers))
        self.assertTrue(self.run_pdrun("--explain", "PDHE", "--markdown").stdout.startswith("# Materials\n\n## PDHE\n"))
        for arguments in (["--explain"], ["--explain", "PDHE", "--all"], ["--explain", "PDHE", "--markdown", "folder"],
                          ["--markdown"]):
            self.assertEqual(self.run_pdrun(*arguments).returncode, 2, arguments)

    def test_a_run_ends_well_and_writes_the_resolved_deck(self):
        done = self.run_pdrun("deck.yaml", "--set", "Solver/Verlet/Safety Factor=0.4")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("results.resolved.yaml")) as file:
            resolved = file.read()
        self.assertIn("Safety Factor: 0.4", resolved)
        self.assertIn("Influence Function: One", resolved)
        self.write("again.yaml", resolved)
        self.assertEqual(self.run_pdrun("--check", "again.yaml").returncode, 0)

    def test_quiet_prints_nothing(self):
        done = self.run_pdrun("deck.yaml", "--quiet")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_quiet_linear_solvers_print_nothing(self):
        rows = [f"{1e-3 * i} {1e-3 * j} 0.0 1 1.0e-9" for j in range(20) for i in range(40)]
        self.write("mesh.txt", "\n".join(rows) + "\n")
        deck = DECK.replace("Verlet: {Safety Factor: 0.5}", "QuasiStatic: {Linear Solver: CG}")
        self.write("deck.yaml", deck.replace(
            'Push: {Type: Initial Velocity, Node Set: All Node Set, Coordinate: x, Value: "100*x"}',
            'Side Node Set: {Expression: "x < 3.5e-3 || x > 35.5e-3"}\n'
            '  Pull: {Type: Prescribed Displacement, Node Set: Side Node Set, Coordinate: x, Value: "1e3*x*t"}'))
        for ranks in (1, 2):
            for preconditioner in ("Multigrid", "ILU", "Jacobi"):
                done = self.run_pdrun("deck.yaml", "--quiet", "--set",
                                      f"Solver/QuasiStatic/Preconditioner={preconditioner}", ranks=ranks)
                self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""), preconditioner)

    def test_check_runs_nothing(self):
        done = self.run_pdrun("--check", "deck.yaml")
        self.assertEqual((done.returncode, done.stdout), (0, "deck.yaml: no mistakes found\n"))
        self.assertFalse(os.path.exists(self.path("results.h5")))

    def test_mistakes_are_code_2_and_printed_once_on_any_number_of_ranks(self):
        self.write("deck.yaml", DECK.replace("Horizon: 3.1e-3", "Horizn: 3.1e-3").replace("Final Time", "Final Tim"))
        for ranks in (1, 2):
            done = self.run_pdrun("deck.yaml", ranks=ranks)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stderr.count('deck.yaml:9:50: unknown key "Horizn" in Blocks/Plate'), 1, done.stderr)
            self.assertEqual(done.stderr.count('deck.yaml:14:3: unknown key "Final Tim" in Solver'), 1, done.stderr)

    def test_a_bad_mesh_is_code_2_on_any_number_of_ranks(self):
        self.write("mesh.txt", mesh() + "0 0 1\n")
        for ranks in (1, 2):
            done = self.run_pdrun("deck.yaml", ranks=ranks)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stderr.count("mesh.txt:56: a point has 5 numbers"), 1, done.stderr)

    def test_a_run_that_cannot_go_on_is_code_3_on_any_number_of_ranks(self):
        self.write("deck.yaml", DECK.replace("Safety Factor: 0.5", "Fixed dt: 1.0e-6"))  # far above the critical step
        for ranks in (1, 2):
            start = time.monotonic()
            done = self.run_pdrun("deck.yaml", ranks=ranks)
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn("the run cannot go on: ", done.stderr)
            self.assertLess(time.monotonic() - start, 60)  # all ranks leave: none waits for another

    def run_until_its_folder_goes_away(self, ranks, output, take_away):
        """What the run says to it. `output`: its Output Filename."""
        self.write("deck.yaml", DECK.replace("Safety Factor: 0.5", "Fixed dt: 1.0e-8").replace("1.0e-6", "1.0")
                   .replace("Output Filename: results", f"Output Filename: {output}").replace("1000", "500"))
        launcher = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np", str(ranks)]
        process = subprocess.Popen([*(launcher if ranks > 1 else []), PDRUN, "deck.yaml", "--quiet"],
                                   cwd=self.folder.name, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        deadline = time.monotonic() + 60
        while not os.path.exists(self.path(f"{output}.steps/000500.h5")) and time.monotonic() < deadline:
            time.sleep(0.01)
        take_away()
        _, message = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 3, message)
        self.assertRegex(message, f'the run cannot go on: cannot .*"{output}')
        return message

    def test_a_run_whose_results_folder_goes_away_ends_with_a_message(self):
        for ranks in (1, 2):
            message = self.run_until_its_folder_goes_away(
                ranks, "out/results", lambda: os.rename(self.path("out"), self.path(f"moved{ranks}")))
            self.assertIn("its folder is not there (was it removed or renamed?)", message)

    def test_a_run_whose_working_folder_goes_away_ends_with_a_message(self):
        def remove():
            while os.path.exists(self.folder.name):  # again where the run has just made a file
                shutil.rmtree(self.folder.name, ignore_errors=True)

        for ranks in (1, 2):
            self.run_until_its_folder_goes_away(ranks, "results", remove)
            os.mkdir(self.folder.name)
            self.write("mesh.txt", mesh())

    def test_a_restart_from_nothing_is_refused(self):
        done = self.run_pdrun("deck.yaml", "--restart", "no_such_file.h5")
        self.assertIn(done.returncode, (2, 3))
        self.assertIn("no_such_file.h5", done.stderr)

    def test_decks_of_peridigm_are_read(self):
        inner = DECK.replace("  Thickness: 1.0e-3\n", "  Thickness: 1.0e-3\n", 1)
        self.write("peridigm.yaml", "Peridigm:\n" + "".join("  " + line + "\n" for line in inner.splitlines())
                   + "  Verbose: false\n")
        done = self.run_pdrun("--check", "peridigm.yaml")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('warning: peridigm.yaml:21:3: "Verbose" has no effect here', done.stderr)


if __name__ == "__main__":
    unittest.main()
