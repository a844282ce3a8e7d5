"""Writes docs/reference.md: every key that people write, out of the schemas, whose `description` is what a key means; channels and units,
out of their tables in code; and the other formats.

usage: reference.py [--check]

--check compares with the file instead of writing it. What the program reads and writes is held against the schemas by
tests/docs/input_formats.test.py and output_formats.test.py.
"""
import json
import sys
import textwrap
from pathlib import Path

from code_tables import channels, units

HERE = Path(__file__).resolve().parent
TARGET = HERE / "reference.md"
HEAD = """# Reference: what files say

`docs/reference.py` writes this page out of the [schemas](schemas), which editors show at a key, and of tables in code. Keys in **bold** are required.
Units are SI and radians; joints, links, tables count from 1, readings of a run from 0. An [effect](effects.md) is written `id`, or `id(j)` at joint or
link j.
"""
# (schema, heading, what it is, words behind the headings of its tables; False: they have none)
FORMATS = [
    ("experiment", "experiment.toml", "Makes a folder an [experiment](experiment-format.md).", ""),
    ("arm-experiment", "experiment.toml of an arm", "Beside the keys above, for an [arm in space](arms.md).", False),
    ("motion-experiment", "experiment.toml of a joint in motion", "For [logs of a joint](motion.md).", " of logs"),
    ("torque-experiment", "experiment.toml of an arm with torques", "For [torques of an arm](motion.md).", " of torques"),
    ("user-effects", "Effects of your own", "The file of `--effects` ([how](user-effects.md)).", False),
]


class Schema:
    def __init__(self, name):
        text = (HERE / "schemas" / f"{name}.schema.json").read_text(encoding="utf-8")
        self.root = json.loads(text)
        self.definitions = self.root.get("$defs", {})
        self.uses = {one: text.count(f'"#/$defs/{one}"') for one in self.definitions}

    def resolved(self, node, whatever=False):
        """The node that a reference, a list or a choice stands for; a definition of several uses has an entry of its own, or none."""
        while True:
            if "$ref" in node:
                name = node["$ref"].rsplit("/", 1)[1]
                if self.uses[name] > 1 and not whatever:
                    return {}
                node = self.definitions[name]
            elif choices := node.get("oneOf", node.get("anyOf")) if "properties" not in node else None:
                node = choices[-1]
            elif node.get("type") == "array" and "items" in node and node["items"]:
                node = node["items"]
            elif "properties" not in node and isinstance(node.get("additionalProperties"), dict):
                node = node["additionalProperties"]
            else:
                return node

    def members(self, node, whatever=False):
        return self.resolved(node, whatever).get("properties", {})

    def words(self, node):
        """What a key means, and its values unless that names them."""
        said = node.get("description", "")
        values = [f'`"{value}"`' for value in [*node.get("enum", []), node.get("const")] if isinstance(value, str)]
        if all(value.strip('`"') in said for value in values):
            values = []
        return ", ".join(filter(None, [said, *values]))

    def keys(self, node, said, whatever=False):
        """The keys of a key's own table; none that its meaning names already, but for values to choose from."""
        inner = self.members(node, whatever)
        named = all(f"`{key}`" in said for key in inner)
        return {key: one for key, one in inner.items() if not named or any(isinstance(value, str) for value in one.get("enum", []))}


def entries(schema, members, required, depth=0):
    """A line for each key, and below it those of its own table; keys of one meaning share a line."""
    names = {}
    for key, node in members.items():
        words = schema.words(node)
        inner = "".join(entries(schema, schema.keys(node, words), (), depth=depth + 1))
        names.setdefault((words, inner), []).append(f"**`{key}`**" if key in required else f"`{key}`")
    for (words, inner), keys in names.items():
        yield textwrap.fill("- " + ", ".join(keys) + (f": {words}" if words else ""), 150, initial_indent="  " * depth,
                            subsequent_indent="  " * (depth + 1), break_long_words=False, break_on_hyphens=False) + "\n" + inner


def sentence(words):
    return words and f"{words[0].upper()}{words[1:]}{'' if words[-1] in '.?' else '.'}\n\n"


def section(name, heading, said, divided):
    """A format's keys."""
    schema = Schema(name)

    def listed(node, whatever=False):
        members = {key: one for key, one in schema.keys(node, node.get("description", ""), whatever).items() if node is not schema.root or key not in tables}
        return "".join(entries(schema, members, schema.resolved(node, whatever).get("required", [])))

    tables = [key for key, node in schema.members(schema.root).items() if isinstance(divided, str) and schema.members(node, whatever=True)]
    text = f"\n## {heading}\n\n{said} [schemas/{name}.schema.json](schemas/{name}.schema.json)\n\n" + listed(schema.root)
    for key in tables:
        node = schema.members(schema.root)[key]
        title = (f"[[{key}]]" if node.get("type") == "array" else f"[{key}]") + divided
        text += f"\n### {title}\n\n" + sentence(node.get("description", "")) + listed(node, whatever=True)
    for one in (schema.definitions.values() if isinstance(divided, str) else ()):
        if "title" in one:
            text += f"\n### {one['title']}\n\n{one['description']}\n\n" + listed(one)
    return text


def others():
    """Every schema without a section."""
    names = [path.name.split(".")[0] for path in sorted((HERE / "schemas").glob("*.schema.json"))]
    links = [f"[{name}](schemas/{name}.schema.json)" for name in names if name not in (one[0] for one in FORMATS)]
    return ("\n## Other formats\n\nTheir schemas have every key. Keys may be added; those there keep their meaning.\n\n"
            + textwrap.fill(", ".join(links), 150, break_long_words=False, break_on_hyphens=False) + "\n")


text = HEAD + "".join([*(section(*one) for one in FORMATS), *channels(), *units(), others()]).replace("\n\n\n", "\n\n")
if "--check" not in sys.argv:
    TARGET.write_text(text, encoding="utf-8")
elif TARGET.read_text(encoding="utf-8") != text:
    sys.exit(f"{TARGET}: not what the schemas say; docs/reference.py writes it")
