"""The command `plumbline` of the package: the program that stands in it, without what Python would load before."""
import os
import pathlib
import sys


def main() -> None:
    program = str(pathlib.Path(__file__).parent / "plumbline" / "bin" / "plumbline")
    os.execv(program, [program, *sys.argv[1:]])
