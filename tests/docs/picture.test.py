"""The picture of the README: a chart of the bundled bench's report, by itself.

usage: picture.test.py PLUMBLINE [--update]

The committed picture is held against the one that the program draws now: the same elements, and every coordinate within
half a unit of the chart's 360, which is less than a dot's radius. --update writes it anew.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from documents import ROOT

PICTURE = ROOT / "docs" / "diagnosis.svg"
CHART = "Fy in run z-press"
STYLE = """<style>
text { font: 12px system-ui, "DejaVu Sans", sans-serif; fill: #111; } .end { text-anchor: end; } .middle { text-anchor: middle; }
path { fill: none; stroke-linecap: round; stroke-linejoin: round; stroke-width: .8; stroke: #555; } .grid { stroke: #e6e6e6; } .zero { stroke: #999; }
.nominal { stroke: #c45200; stroke-width: 1.2; } .corrected { stroke: #0072b2; stroke-width: 2; } .measured { stroke: #000; stroke-width: 3.2; }
</style>
<rect width="360" height="240" fill="#fff"/>
"""
NUMBER = re.compile(r"\d+\.\d+|\d+")


def drawn(program):
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / "page.html"
        subprocess.run([program, "diagnose", ROOT / "docs/examples/experiment", "--html", page], check=True, stdout=subprocess.DEVNULL)
        charts = re.findall(r"<svg.*?</svg>", page.read_text(encoding="utf-8"), re.S)
    [chart] = [chart for chart in charts if f">{CHART}<" in chart]
    shown = [line for line in chart.splitlines() if 'class="value"' not in line]
    head, *rest = shown
    return "\n".join([head.replace("<svg", '<svg xmlns="http://www.w3.org/2000/svg"'), *rest[:2], STYLE.rstrip(), *rest[2:]]) + "\n"


def differences(committed, anew):
    if NUMBER.sub("#", committed) != NUMBER.sub("#", anew):
        yield f"{PICTURE.name}: found other elements than the program draws"
        return
    for old, new in zip(NUMBER.findall(committed), NUMBER.findall(anew)):
        if abs(float(old) - float(new)) > 0.5:
            yield f"{PICTURE.name}: found {old}, the program draws {new}"


def main():
    anew = drawn(sys.argv[1])
    if "--update" in sys.argv:
        PICTURE.write_text(anew, encoding="utf-8")
        return 0
    faults = list(differences(PICTURE.read_text(encoding="utf-8"), anew))
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
