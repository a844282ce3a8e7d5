"""The files of a new row, as docs/contributing.md lists them, are those that name one which is there.

usage: rows.test.py
"""
import re

from documents import ROOT

PAGE = ROOT / "docs" / "contributing.md"
# A row that stands for its kind, as code outside of it has to name it.
SPECIMENS = {
    "channel of a chain": r"\bName::tilt\b",
    "cause outside": r"\bstep_departure\b",
    "kind of noise": r"\bnoisier_segments\b",
    "kind of load": r"\bLoad::Kind::force\b|\bkind == Kind::force\b",
    "effect": r'"pulley_friction"',
}


def naming(pattern):
    """The files of diagnose/ with it, but for the drafts, whose words are of columns."""
    files = [path for ending in ("cpp", "hpp") for path in sorted((ROOT / "diagnose").rglob(f"*.{ending}"))]
    return {str(path.relative_to(ROOT)) for path in files
            if "draft" not in path.parts and re.search(pattern, path.read_text(encoding="utf-8"))}


items = re.findall(r"^- (.+) \(as `\w+`\): ((?:.|\n  )+); also", PAGE.read_text(encoding="utf-8"), re.M)
listed = {kind: set(re.findall(r"`([^`]+)`", files)) for kind, files in items}
assert set(listed) == set(SPECIMENS), f"{PAGE.name}: found the rows {sorted(listed)}, expected {sorted(SPECIMENS)}"
for kind, pattern in SPECIMENS.items():
    found = naming(pattern)
    assert found == listed[kind], f"{kind}: found {sorted(found)} in code, {sorted(listed[kind])} in {PAGE.name}"
