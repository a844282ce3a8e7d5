"""What the tampering tests share: the ways into a document, forgeries by machine, and the judge who counts.

Every leaf is changed. Left with the old digest, any change is refused. A forger recomputes the digest: then every change
that makes a statement false is refused by arithmetic. Names and provenance alone rest on the digest.
"""
import copy
import hashlib
import json
import sys

import check_certificates


def sealed(document):
    text = json.dumps({**document, "sha256": ""}, sort_keys=True, separators=(",", ":"))
    return {**document, "sha256": hashlib.sha256(text.encode()).hexdigest()}


def leaves(node, path=()):
    children = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else None
    if children is None:
        yield path
    else:
        for key, child in children:
            yield from leaves(child, path + (key,))


def inner(document):
    """The paths of all objects and lists."""
    return {path[:i] for path in leaves(document) for i in range(len(path))}


def at(document, path):
    for key in path:
        document = document[key]
    return document


def changed(document, path, value):
    result = copy.deepcopy(document)
    at(result, path[:-1])[path[-1]] = value
    return result


def without(document, path):
    result = copy.deepcopy(document)
    del at(result, path[:-1])[path[-1]]
    return result


GUARDED_BY_DIGEST = {"chain", "case", "structure", "licence", "sha256"}


def rests_on_digest(path):
    return path[-1] in GUARDED_BY_DIGEST or path[0] == "provenance"


def incomplete(document, optional=frozenset(), removable=frozenset()):
    """Documents with a member too much or too few, and what was done to them.
    `optional` members may be missing, and `removable` lists may be shorter."""
    for path in inner(document):
        node = at(document, path)
        if isinstance(node, dict):
            yield changed(document, path + ("unknown",), "1"), (*path, "unknown member")
            for member in set(node) - {"sha256", *optional}:
                yield without(document, path + (member,)), (*path, member, "missing")
        elif path[-1] not in {"certificates", *removable} and node:
            yield without(document, path + (-1,)), (*path, "last missing")


def misspelt(entry):
    """Texts of a sealed document of one entry, in each of which a reader may see something else than the checker: numbers
    that are no exact text, and members stated twice."""
    text = json.dumps(sealed(entry))
    first = next(path for path in leaves(entry) if "lengths" in path)
    exact = json.dumps(at(entry, first))
    assert f'"lengths": [{exact}' in text
    for written in (exact.strip('"'), "NaN", "Infinity", "1e0"):  # sealed as if it had been text, or as it is read
        for meant in (exact, json.dumps(written)):
            seal = json.dumps(sealed(changed(entry, first, json.loads(meant))))
            yield seal.replace(f'"lengths": [{meant}', f'"lengths": [{written}', 1), f"lengths[0] = {written}"
    for odd in ("\u0661", "\uff11", " 1", "1 ", "1\n", "+1", "1_0", "0x1", "1.", ".5", "1,5", "1e", "--1", "1/0", "1/-2", "inf", "1E0"):
        yield json.dumps(sealed(changed(entry, first, odd))), f"lengths[0] = {odd!r}"
    for member in ("lengths", "certificates", "sha256", "version"):
        yield text.replace(f'"{member}":', f'"{member}": 1, "{member}":', 1), f"{member} twice"
    yield text + " {}", "a second document behind"
    yield text[:-1], "no end"
    yield "[" * 100000, "nothing but brackets"


class Judge:
    """Hands documents to a checker, and counts what it judges wrongly."""

    def __init__(self, checker):
        self.checker, self.machine, self.hand, self.misjudged = checker, 0, 0, []

    def holds(self, document):
        try:
            text = document if isinstance(document, str) else json.dumps(document)
            self.checker.check(check_certificates.read(text))
            return True
        except check_certificates.REFUSALS:
            return False

    def true(self, document, what):
        """Untouched, a document holds; any change is refused while the digest is the old one."""
        if not self.holds(document):
            self.misjudged.append(("refused although true", what))
            return
        for path in leaves(document):
            old = at(document, path)
            if self.holds(changed(document, path, old + 1 if isinstance(old, int) else old + "0")):
                self.misjudged.append(path)

    def by_machine(self, forgeries):
        """Pairs of a document that is false, and what was done to it; the forger seals it anew."""
        for forgery, what in forgeries:
            self.machine += 1
            if self.holds(forgery if isinstance(forgery, str) else sealed(forgery)):
                self.misjudged.append(what)

    def by_hand(self, document, name):
        self.hand += 1
        if self.holds(document):
            self.misjudged.append(name)

    def end(self):
        for what in self.misjudged:
            print("misjudged:", *(what if isinstance(what, tuple) else (what,)))
        print(f"{self.machine} forgeries by machine and {self.hand} by hand, {len(self.misjudged)} misjudged")
        sys.exit(bool(self.misjudged))


def published(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)
