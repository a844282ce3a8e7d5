"""A copy of the project with all faults of a folder in it, built once; the folder's suite, and which of its cases come by
which fault."""
import os
import pathlib
import subprocess
import sys
import time

from planting import culprits, rendered

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("core", "proofs", "diagnose")


def write(path, text):
    """Leaves a file alone that is so already: what depends on it is not built again."""
    if not path.is_file() or path.read_bytes() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text)


class Workplace:
    def __init__(self, folder, suite, jobs, unity):
        self.folder, self.suite, self.jobs, self.unity = folder, suite, jobs, unity
        self.build = folder / "build"  # where a clone has it, so that a compiler cache knows what is as there
        folder.mkdir(parents=True, exist_ok=True)
        self.unplanted = {}  # why a fault could not be planted, by its key

    def copied(self):
        """The files of the project, as they stand in its folder."""
        names = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True, capture_output=True,
                               text=True).stdout.split("\n")
        return [name for name in names if name and (ROOT / name).is_file()]

    def plant(self, faults):
        """Writes the copy with all these faults."""
        self.faults = faults
        self.number = {fault.key: i for i, fault in enumerate(faults)}
        self.owners = {}
        texts = {}
        for path in {fault.path for fault in faults}:
            there = [fault for fault in faults if fault.path == path and fault.key not in self.unplanted]
            text, self.owners[path], left_out = rendered(path, (ROOT / path).read_text(), there, lambda f: self.number[f.key])
            self.unplanted.update((fault.key, "overlaps another") for fault in left_out)
            texts[path] = text.encode()
        main = (ROOT / "tests/main.cpp").read_bytes()
        texts["tests/main.cpp"] = main + b'#include "mutation/planted.hpp"\n#include "mutation/recorder.hpp"\n'
        for name in self.copied():
            write(self.folder / name, texts.get(name) or (ROOT / name).read_bytes())

    def configure(self):
        if not (self.build / "build.ninja").is_file():
            subprocess.run(["cmake", "--preset", "test", f"-DCMAKE_UNITY_BUILD={'ON' if self.unity else 'OFF'}"], cwd=self.folder,
                           check=True, stdout=subprocess.DEVNULL)

    def make(self, faults):
        """Builds the suite with every fault that compiles; the others are unplanted. Ends the program where the right text
        does not compile."""
        while True:
            self.plant(faults)
            self.configure()
            done = subprocess.run(["ninja", "-C", str(self.build), "-k", "0", f"-j{self.jobs}", f"test-{self.suite}"], capture_output=True, text=True)
            if done.returncode == 0:
                return
            guilty = culprits(done.stdout, self.owners)
            guilty -= set(self.unplanted)
            print(f"{len(guilty)} faults do not compile", file=sys.stderr, flush=True)
            if not guilty:
                sys.exit("the copy does not compile:\n" + done.stdout[-3000:])
            self.unplanted.update((key, "does not compile") for key in guilty)

    def run(self, words, seconds, **environment):
        """(exit status, output) of the suite; the status is None where it does not end in time."""
        tests = self.build / "tests"
        try:
            done = subprocess.run([str(tests / f"test-{self.suite}"), "--no-intro", *words], cwd=tests, capture_output=True,
                                  timeout=seconds, env={**os.environ, "RC_PARAMS": "seed=1", **environment})
            return done.returncode, done.stdout.decode(errors="replace")
        except subprocess.TimeoutExpired:
            return None, ""

    def record(self):
        """Every test case as (seconds, name, faults that it comes by), the shortest first; as it was recorded if the suite is the same."""
        self.cases = []
        file, suite, begin = self.folder / "reached", self.build / f"tests/test-{self.suite}", time.time()
        if not file.is_file() or file.stat().st_mtime < suite.stat().st_mtime:
            whole = file.with_suffix(".part")
            status, output = self.run([], 3600, PLUMBLINE_REACHED=str(whole))
            if status != 0:
                sys.exit(f"the suite {self.suite} fails without a fault:\n{output[-3000:]}")
            whole.rename(file)
        always = set()
        for row in file.read_text().splitlines():
            name, seconds, reached = row.split("\t")
            if not name:
                always = set(map(int, reached.split()))
            else:
                self.cases.append((float(seconds), name, always | set(map(int, reached.split()))))
        print(f"{self.suite}: {time.time() - begin:.0f} s without a fault", file=sys.stderr, flush=True)
        self.cases.sort(key=lambda case: case[:2])
