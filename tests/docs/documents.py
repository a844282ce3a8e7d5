"""The Markdown documents as the tests read them: fenced blocks, tables, headings."""
import re
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCHEMAS = ROOT / "docs" / "schemas"


def documents():
    return [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")), ROOT / "verify" / "papers" / "README.md"]


def texts():
    """Every Markdown file of the repository."""
    return [path for path in sorted(ROOT.rglob("*.md")) if not path.relative_to(ROOT).parts[0].startswith(("build", "."))]


@dataclass
class Block:
    """A fenced block: ```language name=value."""
    path: Path
    line: int  # of its first line, from 1
    language: str
    attributes: dict
    text: str

    @property
    def place(self):
        return f"{self.path.relative_to(ROOT)}:{self.line}"


def blocks(path):
    found, lines = [], path.read_text(encoding="utf-8").splitlines()
    start = None
    for number, line in enumerate(lines, 1):
        if not line.startswith("```"):
            continue
        if start is None:
            start, info = number, line[3:].split()
        else:
            attributes = dict(item.split("=", 1) for item in info[1:])
            text = "".join(part + "\n" for part in lines[start:number - 1])
            found.append(Block(path, start + 1, info[0] if info else "", attributes, text))
            start = None
    assert start is None, f"{path}: the block of line {start} has no end"
    return found


def anchors(path):
    """The addresses of the headings of a page, as GitHub names them."""
    text = re.sub(r"^```.*?^```", "", path.read_text(encoding="utf-8"), flags=re.M | re.S)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-") for heading in re.findall(r"^#+ (.*)$", text, re.M)}


def tables(path):
    """By heading (backquotes and section marks dropped): the tables under it, each a list of rows of cells."""
    result, heading, rows = {}, "", None
    text = re.sub(r"^```.*?^```", "", path.read_text(encoding="utf-8"), flags=re.M | re.S)
    for line in text.splitlines():
        if match := re.match(r"#+ (.*)", line):
            heading = match[1].replace("`", "")
        if line.startswith("|"):
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            if rows is None:
                rows = []
                result.setdefault(heading, []).append(rows)
            if not set("".join(cells)) <= set("-:"):
                rows.append(cells)
        else:
            rows = None
    return result

