"""No sentence of a report's page has a hole: a template whose value is empty leaves punctuation behind.

usage: sentences.test.py PLUMBLINE
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from documents import ROOT

HOLES = [r": ;", r"(?<!\d) \.(?=[\s<]|$)", r" ;", r": \.", r"\( *\)", r", ,", r"<tbody>\s*</tbody>", r"\{\{"]
FOLDERS = ("experiment", "joint-loop", "servo-arm", "cogging", "arm")


def holes(page):
    body = re.sub(r"<(style|svg|script)\b.*?</\1>", "", page, flags=re.S)
    words = re.sub(r"<(?!/?tbody)[^>]*>", "", body)
    return [words[max(0, at.start() - 60) : at.end() + 20] for hole in HOLES for at in re.finditer(hole, words)]


def main(program):
    assert holes("<p>Excluded: ; with them</p>") and holes("<p>It looks like .</p>"), "holes are not found"
    wrong = []
    with tempfile.TemporaryDirectory() as place:
        for name in FOLDERS:
            page = Path(place) / f"{name}.html"
            subprocess.run([program, "diagnose", ROOT / "docs/examples" / name, "--html", page], check=True, stdout=subprocess.DEVNULL)
            text = page.read_text(encoding="utf-8")
            wrong += [f"{name}: {hole!r}" for hole in holes(text)]
            if str(ROOT) in text:
                wrong.append(f"{name}: names the folder {ROOT}")
    sys.exit("\n".join(wrong) or 0)


if __name__ == "__main__":
    main(sys.argv[1])
