"""Faults in the stand-alone checkers, which are Python: each in its own copy of their folder, against what tampers."""
import shutil
import subprocess
import sys
import tempfile
import pathlib

from workplace import ROOT

PUBLISHED = ROOT / "verify/reference/values"
KINDS = (("check_certificates.py", "tampering.test.py", "certificates.json"),
         ("check_equilibria.py", "tampering_equilibria.test.py", "equilibria-certificates.json"),
         ("check_paths.py", "tampering_paths.test.py", "path-certificates.json"))


def try_checker(fault, folder):
    """What catches it: the true certificates refused, or a false one let through."""
    with tempfile.TemporaryDirectory(dir=folder) as copy:
        proofs = pathlib.Path(copy)
        for path in (ROOT / "proofs/certificates").glob("*.py"):
            shutil.copy(path, proofs)
        name = pathlib.Path(fault.path).name
        text = (ROOT / fault.path).read_text()
        (proofs / name).write_text(text[:fault.begin] + fault.after + text[fault.end:])
        kinds = [kind for kind in KINDS if kind[0] == name] or KINDS
        for checker, tampering, published in kinds:
            for words in ([proofs / checker, PUBLISHED / published],
                          [ROOT / "tests/proofs/certificates" / tampering, proofs, PUBLISHED / published]):
                try:
                    done = subprocess.run([sys.executable, "-B", *map(str, words)], capture_output=True, timeout=300)
                except subprocess.TimeoutExpired:
                    return f"{words[0].name} (does not end)"
                if done.returncode != 0:
                    return words[0].name
    return ""
