"""Lays out what Doxygen makes the site of: every Markdown file of the repository, with links as Doxygen has them, and beside the
pages the files that they link to.

usage: pages.py FOLDER

FOLDER/pages gets the Markdown, FOLDER/html the files.
"""
import html
import re
import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PLACE = Path(sys.argv[1]).resolve()
FENCED = re.compile(r"^```.*?^```\n", re.M | re.S)
CODE = re.compile(r"(`+)(.+?)\1(?!`)", re.S)
LINK = re.compile(r"(?<!!)\[((?:[^\]\[]|<code>.*?</code>)*)\]\(([^)\s]+)\)")


def is_built(path):
    return path.relative_to(ROOT).parts[0].startswith(("build", "."))


PAGES = [path for path in sorted(ROOT.rglob("*.md")) if not is_built(path)]


def label(path, heading=""):
    """Of a page, or of a heading on it as GitHub names it."""
    page = re.sub(r"\W", "-", path.relative_to(ROOT).with_suffix("").as_posix())
    slug = re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-")
    return f"{page}--{slug}" if slug else page


def outside_fences(text, change):
    """The text, changed but for its fenced blocks, which lose what only the tests read."""
    parts, at = "", 0
    for block in FENCED.finditer(text):
        parts += change(text[at:block.start()]) + re.sub(r"^```(\w*).*", r"```\1", block[0])
        at = block.end()
    return parts + change(text[at:])


def code(match):
    """A span of code as Doxygen leaves it alone: in backquotes it looks for quotes of its own."""
    text = html.escape(match[2], quote=False)
    for sign in "\\@[]*_~|-":
        text = text.replace(sign, f"&#{ord(sign)};")
    return f"<code>{text}</code>"


bare_dashes = "\\--"  # else Doxygen makes one long dash of them


def headings(path):
    text = FENCED.sub("", path.read_text(encoding="utf-8"))
    return {label(path, heading) for heading in re.findall(r"^#+ (.*)$", text, re.M)}


def copied(target):
    """The address of a file that is no page: beside the pages, under its own name."""
    place = PLACE / "html" / "files" / target.relative_to(ROOT)
    place.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(target, place)
    return place.relative_to(PLACE / "html").as_posix()


def linked(path, words, target):
    """A link as Doxygen has it, on one line, for it loses what follows one that is broken; of a folder, which no site shows, the words."""
    words = re.sub(r"\s+", " ", words)
    name, _, anchor = target.partition("#")
    if "://" in name:
        return f'<a href="{target}">{words}</a>'
    file = (path.parent / name).resolve() if name else path
    if not file.exists():
        sys.exit(f"{path.relative_to(ROOT)}: a link to {name}, which is not there")
    if file in PAGES:
        return f"[{words}](@ref {label(file, anchor) if label(file, anchor) in headings(file) else label(file)})"
    return words if file.is_dir() else f'<a href="{copied(file)}">{words}</a>'


def page(path):
    depth = 0

    def heading(match):
        """With a name, and one deeper than the last at most, as Doxygen wants it."""
        nonlocal depth
        name = label(path, match[2]) if depth else label(path)
        depth = min(len(match[1]), depth + 1)
        return f"{'#' * depth} {match[2].replace('`', '').replace('--', bare_dashes)} {{#{name}}}"

    def change(text):
        text = re.sub(r"^(#+) (.*)$", heading, text, flags=re.M)
        text = CODE.sub(code, text)
        text = re.sub(r"\[@(\w+)\]", r"[\\@\1]", text)  # a citation is no command of Doxygen's
        text = re.sub(r"!\[([^\]]*)\]\(([^)]+)\)", lambda m: f'<img src="{copied((path.parent / m[2]).resolve())}" alt="{m[1]}"/>', text)
        return LINK.sub(lambda match: linked(path, match[1], match[2]), text)

    return outside_fences(path.read_text(encoding="utf-8"), change)


shutil.rmtree(PLACE / "html", ignore_errors=True)
shutil.rmtree(PLACE / "pages", ignore_errors=True)
(PLACE / "pages").mkdir(parents=True)
for one in PAGES:
    (PLACE / "pages" / f"{label(one)}.md").write_text(page(one), encoding="utf-8")
