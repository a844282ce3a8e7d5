"""answers.py itself, on a stand-in for Plumbline: equal answers pass, a planted difference is found, errors are one line.

usage: answers.test.py
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

TOOL = pathlib.Path(__file__).with_name("answers.py")

STAND_IN = """#!/bin/sh
echo "you asked for $*; 0.25 of 3"
echo "1.0000000000,q1" >table.csv
echo '{"list": [1.5, 2e-12], "count": 2}' >result.json
exit 1
"""


def run(*arguments):
    return subprocess.run([sys.executable, str(TOOL), *map(str, arguments)], capture_output=True, text=True, check=False)


class Answers(unittest.TestCase):
    def setUp(self):
        self.room = tempfile.TemporaryDirectory()
        self.addCleanup(self.room.cleanup)
        self.here = pathlib.Path(self.room.name)
        self.program = self.here / "plumbline"
        self.program.write_text(STAND_IN)
        self.program.chmod(0o755)

    def written(self, name):
        done = run("write", self.program, self.here / name, "--only", "verify/*")
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.here / name

    def planted(self, file, old, new):
        """A copy of the answers, one of them altered."""
        one, other = self.written("one"), self.here / "other"
        shutil.copytree(one, other)
        path = other / "verify/json" / file
        text = path.read_text()
        self.assertIn(old, text)
        path.write_text(text.replace(old, new))
        return one, other

    def test_one_program_twice(self):
        done = run("compare", self.written("one"), self.written("two"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("0 different", done.stdout)

    def test_what_is_kept(self):
        kept = self.written("one") / "verify/claim"
        self.assertEqual((kept / "stdout").read_text(), "you asked for verify --claim z-no-exact-solution; 0.25 of 3\n")
        self.assertEqual((kept / "status").read_text(), "1\n")
        self.assertEqual((kept / "files/table.csv").read_text(), "1.0000000000,q1\n")

    def check_found(self, file, old, new, *words):
        one, other = self.planted(file, old, new)
        for tolerance in ([], ["--tolerance", "1e-9"]):
            done = run("compare", one, other, *tolerance)
            self.assertEqual(done.returncode, 1)
            self.assertTrue(done.stdout.startswith(f"verify/json: {file}"), done.stdout)
            for word in words:
                self.assertIn(word, done.stdout)

    def test_a_word(self):
        self.check_found("stdout", "asked", "begged", "asked", "begged")

    def test_a_count(self):
        self.check_found("stdout", "of 3", "of 4")

    def test_a_name_with_a_number(self):
        self.check_found("files/table.csv", "q1", "q2")

    def test_the_status(self):
        self.check_found("status", "1", "2")

    def test_a_number(self):
        self.check_found("files/result.json", "1.5", "1.50000001", "1.50000001")

    def test_a_count_in_json(self):
        self.check_found("files/result.json", '"count": 2', '"count": 3', "count")

    def test_a_missing_file(self):
        one, other = self.planted("files/result.json", "", "")
        (other / "verify/json/files/result.json").unlink()
        self.assertEqual(run("compare", one, other, "--tolerance", "0.1").returncode, 1)

    def test_a_missing_case(self):
        one, other = self.planted("status", "1", "1")
        shutil.rmtree(other / "verify/json")
        self.assertEqual(run("compare", one, other).returncode, 1)

    def check_within(self, file, old, new):
        one, other = self.planted(file, old, new)
        self.assertEqual(run("compare", one, other).returncode, 1)
        done = run("compare", one, other, "--tolerance", "1e-9")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("1 within 1e-09", done.stdout)

    def test_a_number_beside_larger_ones_of_its_array(self):
        self.check_within("files/result.json", "2e-12", "3e-12")

    def test_the_last_digit_in_print(self):
        self.check_within("stdout", "0.25", "0.26")

    def test_a_number_in_a_table(self):
        self.check_within("files/table.csv", "1.0000000000", "1.0000000005")

    def test_other_questions_are_said_first(self):
        one, other = self.planted("command", "verify", "criticise")
        self.assertIn("verify/json: command:", run("compare", one, other, "--tolerance", "0.5").stdout)

    def test_bad_input(self):
        full = self.written("one")
        for arguments in (
            ("write", self.here / "nowhere", self.here / "new"),
            ("write", self.program, full),
            ("compare", full, self.here / "nowhere"),
            ("compare", full, self.room.name + "/plumbline"),
        ):
            done = run(*arguments)
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), done.stderr)

    def test_a_path_of_the_machine_is_refused(self):
        self.program.write_text("#!/bin/sh\npwd\n")
        done = run("write", self.program, self.here / "new", "--only", "verify/text")
        self.assertEqual(done.returncode, 2)
        self.assertIn("a path of this machine", done.stderr)


unittest.main()
