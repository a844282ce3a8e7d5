"""What Coq has checked: asks it for the assumptions of every theorem in the theories named, and writes them.

usage: check.py COQC FOLDER THEORY...     in FOLDER the theories lie compiled; what is written there:

    assumptions.v    the question, of all theorems together
    assumptions.txt  a line a theorem: its name, and Coq's word that it rests on no axiom
    checked.inc      the names and the version of Coq as C++, for `plumbline verify`

A theorem that rests on an axiom is an error, and nothing is written.
"""
import pathlib
import re
import subprocess
import sys

THEOREM = re.compile(r"^Theorem (\w+)", re.MULTILINE)
NO_AXIOM = "Closed under the global context"


def theorems(folder, theories):
    return [f"{theory}.{name}" for theory in theories
            for name in THEOREM.findall((folder / f"{theory}.v").read_text(encoding="utf-8"))]


def rests_on(coqc, folder, theories, names):
    """What these theorems rest on together, in Coq's words: one question for all takes a tenth of the time of one each."""
    together = ", ".join(f"@{name}" for name in names)
    (folder / "assumptions.v").write_text(
        f"Require {' '.join(theories)}.\nDefinition together := ({together}).\nPrint Assumptions together.\n", encoding="utf-8")
    said = subprocess.run([coqc, "-q", "-w", "none", "assumptions.v"], cwd=folder, capture_output=True, text=True)
    if said.returncode:
        sys.exit(said.stderr)
    return " ".join(said.stdout.split())


def main(coqc, folder, theories):
    names = theorems(folder, theories)
    axioms = rests_on(coqc, folder, theories, names)
    if axioms != NO_AXIOM:
        guilty = [name for name in names if rests_on(coqc, folder, theories, [name]) != NO_AXIOM]
        sys.exit(f"check: {', '.join(guilty)} rests on {axioms}, expected no axiom")
    version = subprocess.run([coqc, "-print-version"], capture_output=True, text=True, check=True).stdout.split()[0]
    (folder / "assumptions.txt").write_text("".join(f"{name}: {NO_AXIOM}\n" for name in names), encoding="utf-8")
    (folder / "checked.inc").write_text(
        f'constexpr std::string_view version = "{version}";\n'
        f"constexpr std::array<std::string_view, {len(names)}> theorems{{\n"
        + "".join(f'    "{name}",\n' for name in sorted(names)) + "};\n", encoding="utf-8")


main(sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:])
