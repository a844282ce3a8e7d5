"""The stand-alone checker refuses every tampered certificate.

usage: tampering.test.py CHECKER CERTIFICATES

Every leaf is changed. Left with the old digest, any change is refused. A forger recomputes the digest: then every
change that makes a statement false is refused by arithmetic. Names and provenance alone rest on the digest.
"""
import copy
import hashlib
import importlib.util
import json
import sys
from fractions import Fraction


def load(path):
    spec = importlib.util.spec_from_file_location("checker", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


checker = load(sys.argv[1])


def sealed(document):
    text = json.dumps({**document, "sha256": ""}, sort_keys=True, separators=(",", ":"))
    return {**document, "sha256": hashlib.sha256(text.encode()).hexdigest()}


def holds(document):
    try:
        checker.check(json.loads(json.dumps(document), parse_float=str))
        return True
    except (ValueError, TypeError, KeyError, IndexError):
        return False


def leaves(node, path=()):
    children = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else None
    if children is None:
        yield path
    else:
        for key, child in children:
            yield from leaves(child, path + (key,))


def at(document, path):
    for key in path:
        document = document[key]
    return document


def changed(document, path, value):
    result = copy.deepcopy(document)
    at(result, path[:-1])[path[-1]] = value
    return result


def lies(document, path):
    """Values for a leaf that each make the certificate false."""
    old, parent, key = at(document, path), at(document, path[:-1]), path[-1]
    yield from (None, [], {}, True, 0.5)
    if isinstance(old, int):
        yield from (old + 1000 if key == "digits" else old + 1, -old - 1, str(old))
        if key != "digits":
            yield old - 1
        return
    yield from ("", "x", "nan", "1/0", old + "0x")
    if key in ("format", "sha256"):
        return
    x = Fraction(old)
    if key in ("low", "high"):
        width = Fraction(parent["high"]) - Fraction(parent["low"])
        beyond = x + 2 * width if key == "low" else x - 2 * width
        yield from (str(beyond), str(-x))
        if "digits" in parent:  # farther out: true still, but not to so many digits
            yield str(x + (x - beyond) * 10**30)
    elif "q" in path:
        yield from (str(x + Fraction(3, 10 ** (parent_digits(document, path) - 1))), str(-x) if x else "0.1")
    elif path[-2] in ("lengths", "stiffness"):
        yield from (str(x + Fraction(1, 10**30)), str(-x) if x else "-1")
    else:  # coefficients of polynomials
        yield from (str(x + 1), str(x + Fraction(1, 10**30)))


def parent_digits(document, path):
    return at(document, path[:-2])["digits"]


def kinds(certificates):
    """Short certificates that between them hold everything that one can hold."""
    def first(wanted):
        return next(c for c in certificates if len(c["lengths"]) <= 6 and wanted(c))
    return [
        first(lambda c: "matrices" in c and "shape" in c["forces"][0] and len(c["lengths"]) == 4),
        first(lambda c: "ties" in c and "shape" in c["forces"][0]),
        first(lambda c: "ties" in c and len(c["ties"]) == 2),
        first(lambda c: "shape" in c["forces"][0] and c["chain"].startswith("geometric-0.1-10")),
    ]


def forgeries(document):
    """Sealed documents, each of which says something false or lacks something, and what was done to it."""
    for path in leaves(document):
        if path[-1] not in GUARDED_BY_DIGEST and path[0] != "provenance":
            for value in lies(document, path):
                yield changed(document, path, value), (*path, value)
    for path in {path[:i] for path in leaves(document) for i in range(len(path))}:
        node = at(document, path)
        if isinstance(node, dict):
            yield changed(document, path + ("unknown",), "1"), (*path, "unknown member")
            for member in set(node) - OPTIONAL:
                yield without(document, path, member), (*path, member, "missing")
        elif path[-1] not in ("certificates", "forces", "ties"):
            yield without(document, path, -1), (*path, "last missing")


GUARDED_BY_DIGEST = {"chain", "licence", "sha256"}
OPTIONAL = {"shape", "ties", "matrices", "sha256"}


def without(document, path, key):
    result = copy.deepcopy(document)
    del at(result, path)[key]
    return result


def main():
    with open(sys.argv[2], encoding="utf-8") as file:
        published = json.load(file)
    refused, accepted = 0, []
    for certificate in kinds(published["certificates"]):
        document = sealed({**published, "certificates": [certificate]})
        assert holds(document), "the untouched certificate holds"
        for path in leaves(document):
            old = at(document, path)
            if holds(changed(document, path, old + 1 if isinstance(old, int) else old + "0")):
                accepted.append(path)
        for forgery, what in forgeries(document):
            refused += 1
            if holds(sealed(forgery)):
                accepted.append(what)
    for what in accepted:
        print("accepted:", *what)
    print(f"{refused} forgeries, {len(accepted)} accepted")
    sys.exit(bool(accepted))


if __name__ == "__main__":
    main()
