"""What Coq has checked: asks it for the assumptions of every theorem in the theories named, and writes them.

usage: check.py COQC FOLDER THEORY...     in FOLDER the theories lie compiled; what is written there:

    assumptions.v    the question
    assumptions.txt  a line a theorem: its name, and what it rests on, in Coq's words
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


def question(theories, names):
    lines = [f"Require {' '.join(theories)}."]
    for name in names:
        lines += [f'Goal True. idtac "theorem {name}". Abort.', f"Print Assumptions {name}."]
    return "\n".join(lines) + "\n"


def answers(text, names):
    """Pairs of a theorem and what it rests on."""
    parts = re.split(r"^theorem (\S+)\n", text, flags=re.MULTILINE)[1:]
    pairs = [(name, " ".join(rest.split())) for name, rest in zip(parts[::2], parts[1::2])]
    if [name for name, _ in pairs] != names:
        sys.exit("check: Coq answered about other theorems than it was asked about")
    return pairs


def main(coqc, folder, theories):
    names = theorems(folder, theories)
    (folder / "assumptions.v").write_text(question(theories, names), encoding="utf-8")
    said = subprocess.run([coqc, "-q", "-w", "none", "assumptions.v"], cwd=folder, capture_output=True, text=True)
    if said.returncode:
        sys.exit(said.stderr)
    pairs = answers(said.stdout, names)
    for name, rest in pairs:
        if rest != NO_AXIOM:
            sys.exit(f"check: {name} rests on {rest}, expected no axiom")
    version = subprocess.run([coqc, "-print-version"], capture_output=True, text=True, check=True).stdout.split()[0]
    (folder / "assumptions.txt").write_text("".join(f"{name}: {rest}\n" for name, rest in pairs), encoding="utf-8")
    (folder / "checked.inc").write_text(
        f'constexpr std::string_view version = "{version}";\n'
        f"constexpr std::array<std::string_view, {len(names)}> theorems{{\n"
        + "".join(f'    "{name}",\n' for name in sorted(names)) + "};\n", encoding="utf-8")


main(sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:])
