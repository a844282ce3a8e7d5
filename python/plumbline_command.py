"""The command `plumbline` of the package: the program that stands in it, without what Python would load before;
for `new` with what reads workbooks and recordings."""
import os
import pathlib
import sys


def main() -> None:
    if sys.argv[1:2] == ["new"]:
        from plumbline.converted_tables import is_converted, new
        if any(map(is_converted, sys.argv[2:])):
            raise SystemExit(new(sys.argv[2:]))
    program = str(pathlib.Path(__file__).parent / "plumbline" / "bin" / "plumbline")
    os.execv(program, [program, *sys.argv[1:]])
