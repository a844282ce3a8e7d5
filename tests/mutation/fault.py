"""A fault to plant: in this file, here, this text for that."""
import os
import tomllib
from dataclasses import dataclass


class Moved(Exception):
    """A listed fault whose text no longer stands where it was planted."""


@dataclass
class Fault:
    path: str
    begin: int
    end: int
    before: str
    after: str
    what: str
    line: int
    listed: str = ""  # its name in the list
    argued: str = ""  # why no test can or need tell it from right code

    @property
    def key(self):
        """The same for the same change, however much of the text around it is told with it."""
        head = len(os.path.commonprefix([self.before, self.after]))
        tail = len(os.path.commonprefix([self.before[head:][::-1], self.after[head:][::-1]]))
        return f"{self.path}:{self.begin + head}:{self.end - tail}:{self.after[head:len(self.after) - tail]}"

    @property
    def statement(self):
        """Whether whole statements are exchanged, not an expression."""
        return self.before.rstrip().endswith((";", "}"))

    @staticmethod
    def at(source, begin, end, after, what, place=None):
        before = source.text[begin:end]
        return Fault(source.path, begin, end, before, after, what, source.line(begin if place is None else place))


def listed(path, sources, wanted):
    """The faults of the list at `path` in the files that are wanted; sources gives a Source for a file's name. Raises Moved for
    the first whose text does not stand in its file, or stands there twice."""
    for entry in tomllib.loads(path.read_text())["fault"]:
        if not wanted(entry["file"]):
            continue
        source = sources(entry["file"])
        count = source.text.count(entry["before"])
        if count != 1:
            raise Moved(f"{path}: {entry['id']}: found {count} times in {entry['file']}: {entry['before']!r}, expected once")
        begin = source.text.index(entry["before"])
        end = begin + len(entry["before"])
        fault = Fault.at(source, begin, end, entry["after"], entry["what"])
        fault.listed, fault.argued = entry["id"], entry.get("argued", "")
        yield fault
