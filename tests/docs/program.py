"""Runs plumbline for a test, whose first argument it is."""
import subprocess
import sys
from pathlib import Path

PLUMBLINE = Path(sys.argv[1]).resolve()


def plumbline(*arguments, folder):
    return subprocess.run([PLUMBLINE, *arguments], cwd=folder, text=True, capture_output=True, check=False)


def complaint(*arguments, folder):
    """The error of a command that must refuse its input."""
    done = plumbline(*arguments, folder=folder)
    assert done.returncode == 2 and not done.stdout, f"{arguments}: exit status {done.returncode}\n{done.stdout}"
    assert done.stderr.count("\n") == 1, done.stderr
    return done.stderr
