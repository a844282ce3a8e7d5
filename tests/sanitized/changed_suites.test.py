"""changed_suites.py itself, on a stand-in for the project: what counts as changed, and what is said of what passes, fails, does
not build and takes too long.

usage: changed_suites.test.py
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

TOOL = pathlib.Path(__file__).with_name("changed_suites.py")

# suites of no code: what building them does, and what running them does
PROJECT = """cmake_minimum_required(VERSION 3.20)
project(stand-in NONE)
enable_testing()
add_subdirectory(tests)
"""
SUITES = """function(suite name builds runs)
  add_custom_target(test-${name} COMMAND ${builds})
  add_test(NAME ${name} COMMAND false)
  add_test(NAME quick-${name} CONFIGURATIONS quick COMMAND ${runs})
endfunction()
suite(page true true)
suite(core true false)
suite(diagnose false true)
suite(proofs true "sleep;60")
"""


class ChangedSuites(unittest.TestCase):
    def setUp(self):
        self.room = tempfile.TemporaryDirectory()
        self.addCleanup(self.room.cleanup)
        self.here = pathlib.Path(self.room.name)
        self.git("init", "-q")
        self.write("tests/sanitized/changed_suites.py", TOOL.read_text())
        self.write("CMakeLists.txt", PROJECT)
        self.write("tests/CMakeLists.txt", SUITES)
        self.write(".gitignore", "build/\n__pycache__/\n")

    def write(self, name, text):
        path = self.here / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def git(self, *words, **environment):
        subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", *words], cwd=self.here, check=True,
                       env=os.environ | environment)

    def commit(self, hour, *names):
        for name in names:
            self.write(name, f"{hour}\n")
        self.git("add", ".")
        self.git("commit", "-qm", "a change", GIT_COMMITTER_DATE=f"2020-01-01T{hour:02}:00:00Z")

    def listed(self):
        done = subprocess.run([sys.executable, "-B", self.here / "tests/sanitized/changed_suites.py", "build", "--list"],
                              capture_output=True, text=True, check=True)
        return re.search(r": ([^:]*)\n", done.stdout)[1]

    def run_tool(self, minutes):
        subprocess.run(["cmake", "-G", "Ninja", "-S", self.here, "-B", self.here / "build"], check=True, capture_output=True)
        done = subprocess.run([sys.executable, "-B", self.here / "tests/sanitized/changed_suites.py", self.here / "build",
                               "--minutes", str(minutes)], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def test_several_commits_are_one_change(self):
        self.commit(1, "core/a.hpp")
        self.commit(8, "support/page/a.cpp")
        self.commit(9, "tests/app/a.test.cpp")
        self.assertEqual(self.listed(), "page app")

    def test_of_a_folder_what_is_not_compiled_does_not_count(self):
        self.commit(1, "core/a.hpp")
        self.commit(8, "trial/RESULTS.md", "proofs/coq/a.v", "proofs/a.py", "docs/a.hpp", "tests/close_to.hpp")
        self.assertEqual(self.listed(), "nothing that a suite here compiles")

    def test_what_is_not_committed_yet_counts(self):
        self.commit(1, "core/a.hpp", "support/page/a.cpp")
        self.commit(8, "core/a.hpp")
        self.write("support/page/a.cpp", "another\n")
        self.assertEqual(self.listed(), "page core")

    def test_where_nothing_is_older_all_folders_count(self):
        self.commit(1, "core/a.hpp")
        self.assertEqual(self.listed(), "page campaign trial draft core exchange diagnose simulator app proofs verify")
        shutil.rmtree(self.here / ".git")
        self.assertEqual(self.listed(), "page campaign trial draft core exchange diagnose simulator app proofs verify")

    def test_nothing_to_do_passes(self):
        self.commit(1, "core/a.hpp")
        self.commit(8, "README.md")
        status, _ = self.run_tool(1)
        self.assertEqual(status, 0)

    def test_what_fails_and_what_does_not_build_fail_and_the_rest_is_run(self):
        self.commit(1, "README.md")
        self.commit(8, "core/a.hpp", "support/page/a.cpp")
        status, text = self.run_tool(1)
        self.assertEqual(status, 1, text)
        self.assertRegex(text, r"page: built in \d+ s, ran for \d+ s: passed\n")
        self.assertRegex(text, r"core: built in \d+ s, ran for \d+ s: FAILED\n")
        self.commit(9, "diagnose/a.cpp")
        self.assertRegex(self.run_tool(1)[1], r"diagnose: does not build, \d+ s: FAILED\n")

    def test_what_the_time_does_not_suffice_for_is_left_out(self):
        self.commit(1, "README.md")
        self.commit(8, "proofs/a.cpp", "verify/a.cpp")
        status, text = self.run_tool(0.05)
        self.assertEqual(status, 0, text)
        self.assertRegex(text, r"proofs: .* \d+ s: stopped\nleft out, for 0.05 minutes are over: proofs verify\n")


unittest.main()
