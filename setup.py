"""What pyproject.toml cannot say: the extension module and the program are targets of CMake."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
#: A build of CMake's that has the targets already is used as it is; otherwise one is made.
BUILD = pathlib.Path(os.environ.get("PLUMBLINE_BUILD", ROOT / "build-python"))


def configure() -> None:
    """Says so on a terminal: what follows takes minutes, and pip shows nothing of it."""
    print("plumbline: compiling the engine and the program, about ten minutes of processor", file=sys.stderr, flush=True)
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DPLUMBLINE_PYTHON=ON", "-DPLUMBLINE_TESTS=OFF", "-DPLUMBLINE_INSTALL=OFF",
               "-DPLUMBLINE_MPI=OFF", "-DCMAKE_UNITY_BUILD=ON", f"-DPython_EXECUTABLE={sys.executable}"]
    try:
        import pybind11
        options.append(f"-Dpybind11_DIR={pybind11.get_cmake_dir()}")
    except ImportError:
        pass  # then the system's
    # of another Python that the folder was configured for nothing may be left
    subprocess.run(["cmake", "-S", ROOT, "-B", BUILD, "-G", "Ninja", "-U", "Python_*", "-U", "_Python_*", "-U", "pybind11_*",
                    *options], check=True)


class CMakeTargets(build_ext):
    def build_extension(self, extension: Extension) -> None:
        if "PLUMBLINE_BUILD" not in os.environ or "PLUMBLINE_CONFIGURE" in os.environ:
            configure()
        subprocess.run(["cmake", "--build", BUILD, "--target", "python-plumbline", "plumbline"], check=True)
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        (target.parent / "bin").mkdir(parents=True, exist_ok=True)
        shutil.copy2(BUILD / "python" / "plumbline" / target.name, target)
        shutil.copy2(BUILD / "plumbline", target.parent / "bin" / "plumbline")


setup(
    version=re.search(r"project\(plumbline VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1],
    license="BSL-1.0",  # its SPDX name; setuptools before 77 takes no name from pyproject.toml, and later ones refuse a file
    ext_modules=[Extension("plumbline._engine", [])],
    cmdclass={"build_ext": CMakeTargets},
    options={"build": {"build_base": "build-python/wheel"}},
)
