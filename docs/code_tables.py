"""The tables of the reference that stand in code: channels and symbols of units."""
import re
from pathlib import Path

CODE = Path(__file__).resolve().parents[1] / "diagnose" / "bench"
OWNERS = {"end": "", "joints": "", "chain": " of a chain", "arm": " of an arm in space"}
GREEK_MU = "μ"  # read as the micro sign, as which it looks


def rows_of(name, row, pattern):
    """The groups of a row's pattern, which fits every row of the table in a source file."""
    code = (CODE / name).read_text(encoding="utf-8")
    rows = re.findall(row + pattern, code)
    assert rows and len(rows) == code.count(re.sub(r"\\", "", row)), f"{name}: a row is not read: {row}"
    return rows


def channels():
    """A row for each sensor, with its channels."""
    header, code = ((CODE / name).read_text(encoding="utf-8") for name in ("channel.hpp", "channel.cpp"))
    sensors = re.findall(r"\w+", re.search(r"enum class Sensor \{(.*?)\}", header, re.S)[1])
    units_of = re.findall(r'"([^"]+)"', re.search(r"sensors> units\{(.*?)\}", code, re.S)[1])
    rows = rows_of("channel.hpp", r"ChannelKind\{Name::", r'\w+,\s+"([\w ]+)",\s+"(\w+)",\s+Sensor::(\w+),\s+Of::(\w+),\s+Index::(\w+)')
    yield "\n## Channels\n\nA channel is a column of readings; those of one sensor share the scale of their noise.\n\n| sensor | unit | channels |\n|---|---|---|\n"
    for sensor, unit in zip(sensors, units_of, strict=True):
        names = {}
        for label, noise, own, owner, index in rows:
            if own == sensor:
                shown = {"none": f"`{label}`", "joint": f"`{label}1` …",
                         "coordinate": f"`{'r' if label == 'r' else ''}x1` … (`noise.{noise}`)",
                         "sensor": ", ".join(f"`{one}1`" for one in label.split()) + f" … (`noise.{noise}`)"}[index]
                names.setdefault(OWNERS[owner], []).append(shown)
        yield f"| {sensor.replace('_', ' ')} | {unit} | {'; '.join(', '.join(one) + owner for owner, one in names.items())} |\n"


def units():
    """A row for each kind of quantity, with its symbols; a factor that is no power of ten stands beside its symbol."""
    rows = rows_of("unit.cpp", r'Symbol\{"', r'([^"]+)", "([^"]+)", (\w+)(, 180)?\}')
    yield ("\n## Symbols of units\n\nA unit is a product of symbols with powers, separated by blanks, `*` or `·`; symbols after a `/` divide: `\"N mm/rad\"`,\n"
           "`\"m/s^2\"`. A number is a factor: `\"0.0879 deg\"`, a count of an encoder. Decimals are exact.\n\n| of | symbols, factors to SI |\n|---|---|\n")
    for kind in dict.fromkeys(row[2] for row in rows):
        shown = [f"`{name}`" + ("" if turns or re.fullmatch(r"1(e.*)?", factor) else f" {factor}")
                 for name, factor, own, turns in rows if own == kind and GREEK_MU not in name]
        yield f"| {kind} | {', '.join(shown)} |\n"
    yield "\nFactors are those of the SI brochure (BIPM, 9th edition) and of NIST SP 811 (2008), appendix B.\n"
