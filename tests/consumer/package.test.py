"""The Debian package as a user meets it: made, installed into an empty system, used, removed without a trace.

package.test.py BUILD_TREE
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BUILD = Path(sys.argv.pop(1)).resolve()


def output(*command, **options):
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options).stdout


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        place = Path(cls.folder.name)
        output("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", place / "packages")
        [cls.package] = (place / "packages").glob("*.deb")
        cls.system = place / "system"
        database = cls.system / "var/lib/dpkg"
        for folder in ("updates", "info", "triggers"):
            (database / folder).mkdir(parents=True)
        for file in ("status", "available"):
            (database / file).touch()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def files(self):
        return {file.relative_to(self.system) for file in self.system.rglob("*")
                if not file.is_dir() and "var/lib/dpkg" not in str(file) and "var/log" not in str(file)}

    def dpkg(self, *arguments):
        # What it depends on is installed in the system that runs this test, not in the empty one.
        output("dpkg", f"--root={self.system}", "--force-depends", "--force-not-root", *arguments)

    @unittest.skipUnless(os.geteuid() == 0, "dpkg installs for root alone")
    def test_installed_used_and_removed(self):
        self.dpkg("--install", self.package)
        program, share = self.system / "usr/bin/plumbline", self.system / "usr/share"
        version = output("dpkg-deb", "--field", self.package, "Version").strip()
        self.assertRegex(output(program, "--version"), rf"^plumbline {re.escape(version)}( \([0-9a-f]+(-dirty)?\))?\n$")
        self.assertIn("Critical force", output(program, "critical"))

        page = output("man", "--local-file", "--warnings=all", share / "man/man1/plumbline.1", env={**os.environ, "MANWIDTH": "120"})
        self.assertNotIn("warning", page.split("NAME")[0])
        verbs = re.findall(r"^  (\w+) ", output(program, "--help").split("Subcommands:")[1], re.M)
        self.assertGreater(len(verbs), 5)
        for verb in verbs:
            self.assertIn(f"plumbline {verb}", page)

        completed = output("bash", "-c", f'source "{share}/bash-completion/completions/plumbline"; '
                           'COMP_WORDS=(plumbline ""); COMP_CWORD=1; _plumbline; echo "${COMPREPLY[@]}"').split()
        self.assertLessEqual(set(verbs), set(completed))
        self.assertEqual("_plumbline\n", output("zsh", "-fc", f'fpath=("{share}/zsh/vendor-completions" $fpath); '
                                                'autoload -Uz compinit && compinit -D -u; print ${_comps[plumbline]}'))

        self.dpkg("--purge", "plumbline")
        self.assertEqual(set(), self.files())


if __name__ == "__main__":
    unittest.main()
