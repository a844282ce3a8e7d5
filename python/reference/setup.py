"""The data of this package are the files in the folder verify/reference/values/ of the project, as they are."""
import json
import pathlib
import shutil

from setuptools import setup
from setuptools.command.build_py import build_py

VALUES = pathlib.Path(__file__).resolve().parents[2] / "verify/reference/values"


class WithValues(build_py):
    def run(self) -> None:
        super().run()
        for file in VALUES.iterdir():
            shutil.copy2(file, pathlib.Path(self.build_lib, "plumbline_reference", file.name))


setup(
    version=json.loads((VALUES / "datapackage.json").read_text())["provenance"]["program"].split()[1],
    cmdclass={"build_py": WithValues},
    options={"build": {"build_base": "../../build-python/reference"}},
)
