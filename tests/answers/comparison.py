"""Whether two answers are alike: to the last byte, or up to a tolerance of their numbers.

With a tolerance T two numbers are alike when they differ by at most T times their scale. The scale is

- in JSON the largest magnitude among all numbers at the same place in both documents, whatever the positions in lists
  (so of an array, or of a key across a list of objects);
- in CSV the largest magnitude of the column;
- in any other text (tables, SVG, HTML, strings in JSON) the larger of the two numbers.

A number in text or CSV may also differ by one unit of its last written digit, because it is rounded for print: but only where it
has a decimal point or an exponent. Integers are counts and names: they must be the same, as must everything that is no number.
"""

import csv
import decimal
import io
import json
import re

# not a part of a word such as q1 or dev-001
NUMBER = re.compile(r"(?<![\w.])(?<![\w.][-+])[-+\u2212]?(?:\d+\.\d*|\.\d+|\d+(?=[eE]))(?:[eE][-+]?\d+)?(?![\w.])")

COMMIT = re.compile(rb"(plumbline \d+\.\d+\.\d+) \([0-9a-f]{7,}(?:-dirty)?\)")


def value(text):
    return float(text.replace("\u2212", "-"))


def last_unit(text):
    """What one step of the last written digit is worth."""
    exponent = decimal.Decimal(text.replace("\u2212", "-")).as_tuple().exponent
    return 10.0**exponent if exponent > -300 else 0.0


def alike_in_print(one, other, tolerance, scale):
    a, b = value(one), value(other)
    rounding = max(last_unit(one), last_unit(other)) * (1 + 1e-9)  # the step itself is computed in binary
    return abs(a - b) <= max(tolerance * scale, rounding)


def text_difference(one, other, tolerance, scale=0.0):
    """None, or what differs first between two texts of one line."""
    if one == other:
        return None
    if NUMBER.sub("#", one) != NUMBER.sub("#", other):
        return f"'{excerpt(one, other)}' became '{excerpt(other, one)}'"
    for a, b in zip(NUMBER.findall(one), NUMBER.findall(other)):
        if not alike_in_print(a, b, tolerance, max(scale, abs(value(a)), abs(value(b)))):
            return f"{a} became {b}"
    return None


def excerpt(text, other, around=40):
    """The part of a text where it begins to differ from another."""
    at = next((i for i, (a, b) in enumerate(zip(text, other)) if a != b), min(len(text), len(other)))
    return ("..." if at > around else "") + text[max(0, at - around) : at + around]


def lines_difference(one, other, tolerance):
    a, b = one.splitlines(), other.splitlines()
    for number, (left, right) in enumerate(zip(a, b), 1):
        found = text_difference(left, right, tolerance)
        if found:
            return f"line {number}: {found}"
    return None if len(a) == len(b) else f"{len(a)} lines became {len(b)}"


def csv_difference(one, other, tolerance):
    tables = [list(csv.reader(io.StringIO(text))) for text in (one, other)]
    if [len(row) for row in tables[0]] != [len(row) for row in tables[1]]:
        return "rows or fields are more or fewer"
    scale = {}
    for row in tables[0] + tables[1]:
        for column, field in enumerate(row):
            if NUMBER.fullmatch(field):
                scale[column] = max(scale.get(column, 0.0), abs(value(field)))
    for number, (left, right) in enumerate(zip(*tables), 1):
        for column, (a, b) in enumerate(zip(left, right)):
            found = text_difference(a, b, tolerance, scale.get(column, 0.0) if NUMBER.fullmatch(a) else 0.0)
            if found:
                return f"row {number}, column {column + 1}: {found}"
    return None


def leaves(document, path=""):
    """Every leaf of a JSON document with its path; the shape of the document is in the paths."""
    if isinstance(document, dict):
        yield path, "{" + ",".join(document) + "}"
        for key, part in document.items():
            yield from leaves(part, f"{path}.{key}")
    elif isinstance(document, list):
        yield path, f"[{len(document)}]"
        for i, part in enumerate(document):
            yield from leaves(part, f"{path}[{i}]")
    else:
        yield path, document


def json_difference(one, other, tolerance):
    documents = [list(leaves(json.loads(text))) for text in (one, other)]
    place = re.compile(r"\[\d+\]")
    scale = {}
    for path, leaf in documents[0] + documents[1]:
        if isinstance(leaf, float):
            key = place.sub("[]", path)
            scale[key] = max(scale.get(key, 0.0), abs(leaf))
    for (path, a), (other_path, b) in zip(*documents):
        at = path.lstrip(".") or "the document"
        if path != other_path or type(a) is not type(b):
            return f"{at}: {a!r} became {b!r}"
        if isinstance(a, float):
            if not (a == b or abs(a - b) <= tolerance * scale[place.sub("[]", path)]):
                return f"{at}: {a!r} became {b!r}"
        elif isinstance(a, str):
            found = text_difference(a, b, tolerance)
            if found:
                return f"{at}: {found}"
        elif a != b:
            return f"{at}: {a!r} became {b!r}"
    return None


def bytes_difference(one, other):
    try:
        a, b = one.decode().splitlines(), other.decode().splitlines()
    except UnicodeDecodeError:
        return f"{len(one)} and {len(other)} bytes, no text"
    for number, (left, right) in enumerate(zip(a, b), 1):
        if left != right:
            return f"line {number}: '{excerpt(left, right)}' became '{excerpt(right, left)}'"
    return f"{len(a)} lines became {len(b)}" if len(a) != len(b) else "ends of lines"


def is_csv(text):
    rows = text.splitlines()
    return len(rows) > 1 and rows[0].count(",") > 0 and " " not in rows[0]


def difference(name, one, other, tolerance):
    """None, or what differs first between two files of one name; not the commit that they were written by."""
    one, other = (COMMIT.sub(rb"\1", text) for text in (one, other))
    if one == other:
        return None
    exact = bytes_difference(one, other)
    if not tolerance or name in ("command", "status"):
        return exact
    try:
        a, b = one.decode(), other.decode()
    except UnicodeDecodeError:
        return exact
    if a[:1] in "[{":
        try:
            return json_difference(a, b, tolerance)
        except json.JSONDecodeError:
            return exact
    return csv_difference(a, b, tolerance) if is_csv(a) and is_csv(b) else lines_difference(a, b, tolerance)


def first_difference(one, other, tolerance):
    """None, or the first file that differs between two answers, and how. Other questions differ before their answers."""
    for name in sorted(one.keys() | other.keys(), key=lambda n: (n != "command", n != "status", n)):
        if name not in one or name not in other:
            return f"{name}: {'no longer written' if name in one else 'newly written'}"
        found = difference(name, one[name], other[name], tolerance)
        if found:
            return f"{name}: {found}"
    return None
