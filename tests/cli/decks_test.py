#!/usr/bin/python3
"""Every deck of decks/ is one that `pdrun --check` finds good, with the mesh that its scene makes and the options of its
scene's first run of it. The run*.sh of each scene run in a copy in which programs that make meshes write down what they were
asked for, which is done when a deck is checked, and those that draw and measure do nothing."""
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PDRUN = os.path.abspath(os.environ["PDRUN"])

# Stands for a program that makes a mesh. The file is the argument of -o, or the last one, or what is converted to.
RECIPE = """#!/bin/bash
real='{real}'
file="${{!#}}" before=
for word in "$@"; do
  [[ "$before" != -o ]] || file="$word"
  before="$word"
done
[[ "$1" != convert ]] || file="$3"
{{ echo '#recipe'; printf '%q ' "$real" "$@"; }} > "$file"
"""

# Stands for pdrun: checks a deck where it is met for the first time, after its mesh has been made.
CHECK = """#!/bin/bash
make() { # the file, and what it is made of
  [[ -f "$1" && "$(head -c 7 "$1")" == '#recipe' ]] || return 0
  local line="$(tail -n 1 "$1")"
  local words; eval "words=($line)"
  rm "$1"
  for word in "${words[@]:1}"; do make "$word"; done
  "${words[@]}" > /dev/null || exit 1
}
deck= mesh= voids= options=()
for word in "$@"; do
  case "$word" in
    *.yaml) [[ -n "$deck" ]] || deck="$word" ;;
    --quiet | --study | --fit) ;;
    *) options+=("$word") ;;
  esac
  case "$word" in
    "Discretization/Input Mesh File="*) mesh="${word#*=}" ;;
    Discretization/Voids/*"/File Name="*) voids="${word#*=}" ;;
  esac
done
if [[ " $* " == *" --study "* || " $* " == *" --fit "* ]]; then
  deck="$(dirname "$deck")/$(sed -n 's/^Deck: *//p' "$deck")"
fi
known= log='@LOG@'
read -r -d '' known < "$log" || true # no program of its own: there are a thousand runs
[[ $'\\n'"$known"$'\\n' != *$'\\n'"$deck"$'\\n'* ]] || exit 0
echo "$deck" >> "$log"
[[ -n "$mesh" ]] || mesh="$(sed -n 's/.*Input Mesh File: *\\([^ ,}]*\\).*/\\1/p' "$deck" | tail -n 1)"
[[ -z "$mesh" || "$mesh" == /* ]] || mesh="$(dirname "$deck")/$mesh"
[[ -z "$mesh" ]] || make "$mesh"
[[ -z "$voids" ]] || make "$(dirname "$deck")/$voids"
timeout 100 '@PDRUN@' --check "$deck" "${options[@]}" > '@OUT@' 2>&1 || { echo "$deck"; cat '@OUT@'; } >> '@BAD@'
"""


class Decks(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="pd_decks_")
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        shutil.copytree(ROOT / "decks", self.root / "decks",
                        ignore=shutil.ignore_patterns("figures", "__pycache__", "*.txt", "*.msh"))
        shutil.copytree(ROOT / "meshes", self.root / "meshes", ignore=shutil.ignore_patterns("figures", "__pycache__"))
        (self.root / "bin").mkdir()
        self.log, self.bad = self.root / "log", self.root / "bad"
        self.log.touch()
        self.bad.touch()
        for name in ("meshes/pdmesh", "decks/fracture_energy/lattices.py", "decks/compact_tension/specimen.py"):
            self.write(self.root / name, RECIPE.format(real=self.put_aside(name)))
        self.write(self.root / "bin/gmsh", RECIPE.format(real=shutil.which("gmsh")))
        # Options of runs, which matter as long as a deck is not checked.
        for name, decks in (("decks/mixed_mode/cases.py", 2), ("decks/hole/exact.py", 1)):
            self.write(self.root / name, f"""#!/bin/bash
[[ "$(grep -c {Path(name).parent} '{self.log}')" == {decks} ]] || exec '{self.put_aside(name)}' "$@"
printf '0\\n0\\n'
""")
        for place in [self.root / "meshes/pdplot",
                      *(p for name in ("plot*", "stud*", "cost", "kernels", "lefm") for p in self.root.glob(f"decks/**/{name}.py"))]:
            self.write(place, "#!/bin/true\n")
        check = CHECK
        for word, value in (("LOG", self.log), ("BAD", self.bad), ("OUT", self.root / "out"), ("PDRUN", PDRUN)):
            check = check.replace(f"@{word}@", str(value))
        self.write(self.root / "bin/pdrun", check)
        self.write(self.root / "bin/mpirun", '#!/bin/bash\nwhile [[ "$1" != /* ]]; do shift; done\n"$@"\n')
        # A million points; a few do.
        pits = self.root / "decks/pitting/pits.py"
        self.write(pits, pits.read_text().replace("(128, 128, 64)", "(24, 24, 16)"))
        space = self.root / "decks/mg_pin/run_space.sh"
        self.write(space, space.read_text().replace("${1:-10e-6}", "${1:-25e-6}"))
        penny = self.root / "decks/crack_sif/penny.yaml"
        penny.write_text(penny.read_text().replace(": 34", ": 17"))

    @staticmethod
    def write(place, text):
        if place.exists():
            place.unlink()
        place.write_text(text)
        place.chmod(0o755)

    def put_aside(self, name):
        """The same program under another name beside it."""
        real = (self.root / name).with_name("real_" + Path(name).name)
        shutil.copy(self.root / name, real)
        return real

    def test_pass_the_check(self):
        environment = {**os.environ, "PDRUN": str(self.root / "bin/pdrun"), "RESULTS": str(self.root / "results"),
                       "PATH": f"{self.root / 'bin'}:{os.environ['PATH']}", "SPACING": "100e-6"}
        for script in sorted(self.root.glob("decks/**/run*.sh")):
            done = subprocess.run([script], env=environment, capture_output=True, text=True, timeout=200)
            self.assertEqual(done.returncode, 0, f"{script}\n{done.stdout}{done.stderr}")
        self.assertEqual(self.bad.read_text(), "")
        shipped = {str(deck) for deck in self.root.glob("decks/**/*.yaml") if "\nDiscretization:" in deck.read_text()}
        checked = {str(Path(line).resolve()) for line in self.log.read_text().splitlines()}
        self.assertEqual(checked, shipped)
        self.assertGreater(len(shipped), 25)


if __name__ == "__main__":
    if shutil.which("gmsh") is None:
        raise SystemExit("no gmsh: ./setup.sh test installs it")
    unittest.main()
