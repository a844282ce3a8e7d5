#!/usr/bin/env python3
"""Work among the processes that mpirun starts: on 1, 2 and 4 ranks the same bytes as in one process; a rank is
killed, and the same command, begun again, does what was not done.

Usage: ranks.test.py PLUMBLINE SOURCE_FOLDER [CLASS ...]

EveryVerb takes seconds. WholeWork does trials, fleets and the published reference values; TRIALS in the environment is
the number of trials (3)."""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PLUMBLINE, SOURCE = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
TRIALS = os.environ.get("TRIALS", "3")
os.environ["SOURCE_DATE_EPOCH"] = "0"  # pages of before and after midnight
# more ranks than processors, as root in a container, and nothing bound to a processor that another has
MPIRUN = ["mpirun", "--oversubscribe", "--allow-run-as-root", "--bind-to", "none"]
TRIAL = ["trial", "--trials", TRIALS, "--seed", "3", "--patience", "300", "--out", "kept", "--json", "a.json",
         "--markdown", "a.md"]


def contents(folder):
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def done_so_far(journal):
    return journal.read_bytes().count(b"\n") - 1 if journal.exists() else 0


class OnRanks(unittest.TestCase):
    def setUp(self):
        self.place = pathlib.Path(tempfile.mkdtemp(prefix="ranks-"))
        self.addCleanup(shutil.rmtree, self.place)

    def here(self, name):
        folder = self.place / name
        folder.mkdir()
        return folder

    def run_in(self, folder, words, ranks=None):
        command = ([*MPIRUN, "-n", str(ranks)] if ranks else []) + [PLUMBLINE, *words]
        return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=600, check=False)

    def same_bytes(self, words, prepare=lambda folder: None):
        """Of standard output but for the line of times, and of every file."""
        alone = None
        for ranks in (None, 1, 2, 4):
            folder = self.here(f"on-{ranks}")
            prepare(folder)
            done = self.run_in(folder, words, ranks)
            self.assertEqual(done.returncode, 0, done.stderr)
            out = [line for line in done.stdout.splitlines() if not line.startswith("Time of a diagnosis")]
            alone = alone or (out, contents(folder))
            self.assertEqual(alone, (out, contents(folder)), f"on {ranks} ranks")
        return alone

    def cut_off(self, folder, words, journal):
        """A rank is killed when something is done. Whether something was left to do."""
        with subprocess.Popen([*MPIRUN, "-n", "3", PLUMBLINE, *words], cwd=folder, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL) as mpirun:
            while done_so_far(folder / journal) < 1 and mpirun.poll() is None:
                time.sleep(0.01)
            for rank in ranks_of(mpirun.pid)[-1:]:
                os.kill(rank, signal.SIGKILL)
            status = mpirun.wait(60)
        left = done_so_far(folder / journal) >= 1
        if left:
            self.assertNotEqual(status, 0)
        return left

    def killed_and_begun_again(self, words, journal, prepare=lambda folder: None):
        """Returns the files that were not written again."""
        whole = self.here("whole")
        prepare(whole)
        self.assertEqual(self.run_in(whole, words).returncode, 0)
        for attempt in range(5):  # the last items may be done before the first is seen to be
            cut = self.here(f"cut-{attempt}")
            prepare(cut)
            if self.cut_off(cut, words, journal):
                break
        else:
            self.fail("all was done before a rank could be killed")
        kept = {name: (cut / name).stat().st_mtime_ns for name in contents(cut)}
        again = self.run_in(cut, words, 2)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(contents(cut), contents(whole))
        return [name for name, at in kept.items() if (cut / name).exists() and (cut / name).stat().st_mtime_ns == at]

    def fleet(self, folder, count=3):
        for number in range(count):
            shutil.copytree(SOURCE / "tests/experiments/joint_coupling", folder / f"arm-{number}")

    @staticmethod
    def diagnosed(count):
        return ["diagnose", *(f"arm-{number}" for number in range(count)), "--reports", "reports", "--json", "all.json"]

    FLEET = diagnosed(3)


class EveryVerb(OnRanks):
    CHAINS = ["verify", "--section", "2", "--chains", "300", "--json", "a.json", "--unfinished", "chains.jsonl"]

    def test_random_chains(self):
        _, files = self.same_bytes(self.CHAINS)
        self.assertEqual(list(files), ["a.json"])

    def test_random_chains_of_which_a_rank_is_killed(self):
        self.killed_and_begun_again(self.CHAINS, "chains.jsonl")

    def test_what_is_to_be_kept_needs_a_place(self):
        folder = self.here("nowhere")
        self.fleet(folder)
        for words, option in ((["trial", "--trials", "2"], "--out"), (self.FLEET[:-4], "--reports")):
            done = self.run_in(folder, words, 2)
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"plumbline: {option}: found none, expected a folder", done.stderr)

    def test_every_other_verb_is_done_once(self):
        folder = self.here("once")
        words = ["critical", str(SOURCE / "docs/examples/four-link.toml")]
        self.assertEqual(self.run_in(folder, words, 3).stdout, self.run_in(folder, words).stdout)
        self.assertEqual(self.run_in(folder, ["critical", "nowhere.toml"], 3).stderr.count("nowhere.toml: found"), 1)


class WholeWork(OnRanks):
    def test_a_trial(self):
        _, files = self.same_bytes(TRIAL)
        self.assertEqual(len([name for name in files if name.startswith("kept/reports/")]), int(TRIALS))
        self.assertNotIn("kept/unfinished.jsonl", files)

    def test_a_trial_of_which_a_rank_is_killed(self):
        untouched = self.killed_and_begun_again(TRIAL, "kept/unfinished.jsonl")
        self.assertTrue([name for name in untouched if name.startswith("kept/reports/")])

    def test_a_fleet(self):
        _, files = self.same_bytes(self.FLEET, self.fleet)
        self.assertEqual(len([name for name in files if name.startswith("reports/")]), 6)  # pages too

    def test_a_fleet_of_which_a_rank_is_killed(self):
        many = 8  # of which two ranks have most left when the first is seen to be done
        self.assertTrue(self.killed_and_begun_again(self.diagnosed(many), "reports/unfinished.jsonl",
                                                    lambda folder: self.fleet(folder, many)))

    REFERENCE = ["reference", "--compact", "--out", "."]

    def test_reference_values_of_which_a_rank_is_killed(self):
        """Of the whole set that is published."""
        folder = self.here("reference")
        self.cut_off(folder, self.REFERENCE, "unfinished.jsonl")
        done = self.run_in(folder, self.REFERENCE, 4)
        self.assertEqual(done.returncode, 0, done.stderr)
        for name, text in contents(folder).items():
            self.assertEqual(text, (SOURCE / "verify/reference/values" / name).read_bytes(), name)

    def test_an_experiment_that_has_changed_since_is_diagnosed_again(self):
        folder = self.here("changed")
        self.fleet(folder)
        self.assertEqual(self.run_in(folder, [*self.FLEET[:-2], "--json", "/dev/full"]).returncode, 2)
        self.assertFalse((folder / "reports/unfinished.jsonl").exists())  # refused before the work
        words = self.FLEET
        with subprocess.Popen([PLUMBLINE, *words], cwd=folder, stdout=subprocess.DEVNULL) as alone:
            while done_so_far(folder / "reports/unfinished.jsonl") < 1 and alone.poll() is None:
                time.sleep(0.01)
            alone.kill()
        report = next((folder / "reports").glob("*.json"))
        before = report.stat().st_mtime_ns
        settings = folder / report.stem / "experiment.toml"
        settings.write_text(settings.read_text() + "# a word\n")
        self.assertEqual(self.run_in(folder, words).returncode, 0)
        self.assertNotEqual(report.stat().st_mtime_ns, before)


def ranks_of(mpirun):
    """Its children; none once it has ended."""
    try:
        children = pathlib.Path(f"/proc/{mpirun}/task/{mpirun}/children").read_text().split()
    except FileNotFoundError:
        return []
    return [int(child) for child in children]


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
