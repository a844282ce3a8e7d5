"""The one thing that pyproject.toml cannot say: the extension module is the CMake target python-plumbline."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
#: A build of CMake's that has the target already is used as it is; otherwise one is made.
BUILD = pathlib.Path(os.environ.get("PLUMBLINE_BUILD", ROOT / "build-python"))


class CMakeTarget(build_ext):
    def build_extension(self, extension: Extension) -> None:
        if "PLUMBLINE_BUILD" not in os.environ:
            subprocess.run(["cmake", "-S", ROOT, "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                            "-DPLUMBLINE_PYTHON=ON", "-DPLUMBLINE_TESTS=OFF", "-DPLUMBLINE_INSTALL=OFF",
                            f"-DPython_EXECUTABLE={sys.executable}"], check=True)
        subprocess.run(["cmake", "--build", BUILD, "--target", "python-plumbline"], check=True)
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(BUILD / "python" / "plumbline" / target.name, target)


setup(
    version=re.search(r"project\(plumbline VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1],
    ext_modules=[Extension("plumbline._engine", [])],
    cmdclass={"build_ext": CMakeTarget},
    options={"build": {"build_base": "build-python/wheel"}},
)
