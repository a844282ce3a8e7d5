"""Whether everything that the site links to is there.

usage: links.py HTML

Every address inside the site in an attribute href or src, with its anchor; none that leads out of it. Exit status 1 and a line for each
that leads nowhere.
"""
import sys
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

SITE = Path(sys.argv[1]).resolve()
# What it links to above a class whose nested classes are all private.
DOXYGENS_OWN = ("nested-classes",)


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.addresses, self.anchors = [], set()
        self.feed(path.read_text(encoding="utf-8", errors="replace"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src") and value:
                self.addresses.append(value)
            if name in ("id", "name") and value:
                self.anchors.add(value)


@cache
def read(path):
    return Page(path)


def faults(path):
    for address in read(path).addresses:
        parts = urlsplit(address)
        if parts.scheme:
            continue
        target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
        if not target.is_relative_to(SITE) or not target.exists():
            yield f"{path.relative_to(SITE)}: {address} is not there"
        elif parts.fragment not in ("", *DOXYGENS_OWN) and target.suffix == ".html" and unquote(parts.fragment) not in read(target).anchors:
            yield f"{path.relative_to(SITE)}: {address} has no such anchor"


pages = sorted(SITE.glob("*.html"))
found = sorted({fault for page in pages for fault in faults(page)})
print("\n".join(found) or f"{len(pages)} pages, {sum(len(read(page).addresses) for page in pages)} links, all there")
sys.exit(1 if found else 0)
