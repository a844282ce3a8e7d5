"""Faults as a careful developer might make them, from the text alone: operators, constants, arguments, statements."""
import re

from fault import Fault

INSTEAD = {"<": ["<=", ">"], "<=": ["<"], ">": [">=", "<"], ">=": [">"], "==": ["!="], "!=": ["=="], "&&": ["||"],
           "||": ["&&"], "+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"], "%": ["*"], "and": ["or"], "or": ["and"]}
# what counts: among real numbers a comparison that takes equality too is the same
COUNTED = re.compile(r"(?:(?<![\w.])\d+|size\(\)|\b(?:\w*_)?(?:size|count|n|rows|cols|end)_?(?:\(\))?)$")
# what assigns, or calls for the sake of what it does
EFFECT = re.compile(r"(?:\+\+|--|\*)?[\w:.>\[\]()*+-]+(?: (?:[-+*/%|&^]|<<|>>)?= |\(|;)")
# what is the same of its arguments in any order
ANY_ORDER = ("max", "min", "minmax", "larger", "smaller", "swap", "hypot", "hull", "intersection")
NO_EFFECT = ("return", "using", "static_assert", "break", "continue", "throw", "namespace", "public", "private", "case",
             "default", "friend", "typename", "template", "goto")


def operators(source):
    for i, token in enumerate(source.tokens):
        if source.binary(i) is None:
            continue
        (begin, middle), (after, end) = source.operands(i)
        if '"' in source.text[middle - 1:after + 1]:
            continue  # texts are joined by +
        counted = any(COUNTED.search(source.text[b:e].strip()) for b, e in ((begin, middle), (after, end)))
        for other in INSTEAD.get(token.text, []):
            if not counted and {token.text, other} in ({"<", "<="}, {">", ">="}):
                continue
            text = source.text[begin:token.begin] + other + source.text[token.end:end]
            yield Fault.at(source, begin, end, text, f"`{token.text}` is `{other}`", token.begin)


def constants(source):
    for token in source.tokens:
        if token.kind == "name" and token.text in ("true", "false", "True", "False"):
            other = {"true": "false", "false": "true", "True": "False", "False": "True"}[token.text]
            yield Fault.at(source, token.begin, token.end, other, f"`{token.text}` is `{other}`")
        # what is written with an exponent is a tolerance or a unit: not taken
        if token.kind == "number" and re.fullmatch(r"\d+|\d*\.\d*", token.text):
            value = float(token.text)
            few = token.text.isdigit() and value < 10
            other = str(int(value) + 1) if few else str(2 * int(value)) if token.text.isdigit() \
                else repr(2 * value) if value else "1.0"
            yield Fault.at(source, token.begin, token.end, other, f"`{token.text}` is `{other}`")


def negations(source):
    for i, token in enumerate(source.tokens):
        if token.text == "!" and source[i + 1] not in ("=", ""):
            end = i + 1
            while source[end + 1] in ("(", "[", ".", "->", "::") or source[end] in (".", "->", "::", "(", "["):
                end = source.partner.get(end, end + 1) if source[end] in "([" else end + 1
            text = source.text[source.tokens[i + 1].begin:source.tokens[end].end]
            # a bool like the right text: beside an optional that would become one, which is true
            after = text if source.python else f"static_cast<bool>({text})"
            yield Fault.at(source, token.begin, source.tokens[end].end, after, "`!` is forgotten")


def conditions(source):
    """A guard that never stops anything."""
    for i, token in enumerate(source.tokens):
        if token.text == "if" and source[i + 1] == "(" and i + 1 in source.partner and source[i - 1] != "else":
            begin = source.partner[i + 1] + 1
            end = source.statement(begin) if source[begin] in ("return", "continue", "break", "throw") else None
            if end is not None and source[end + 1] != "else":
                yield Fault.at(source, token.begin, source.tokens[end].end, ";", "a guard is forgotten")


def statements(source):
    for i in range(1, len(source.tokens)):
        if source.python or source[i - 1] not in (";", "{", "}") and not (source[i - 1] == ")" and is_head(source, i - 1)):
            continue
        end = source.statement(i)
        if end is None or end == i or source[i] in NO_EFFECT or not inside_function(source, i):
            continue
        text = source.text[source.tokens[i].begin:source.tokens[end].end]
        if EFFECT.match(text):
            yield Fault.at(source, source.tokens[i].begin, source.tokens[end].end, ";", "a statement is forgotten")


def is_head(source, i):
    return i in source.partner and source[source.partner[i] - 1] in ("if", "for", "while")


def inside_function(source, i):
    """Whether the innermost braces around token i are those of a body: they follow a closing parenthesis or a word."""
    j = i - 1
    while j >= 0 and source[j] != "{":
        j = source.partner.get(j, j) - 1 if source[j] in (")", "]", "}") else j - 1
    return j > 0 and (source[j - 1] in (")", "else", "do", "const", "noexcept", "override", "try", "mutable", "]", ";", "{", "}")
                      or source[j - 1] == ">" or source[j - 2] == "->")


def arguments(source):
    for i, token in enumerate(source.tokens):
        if token.text != "(" or i not in source.partner or source.tokens[i - 1].kind != "name":
            continue
        if source[i - 1] in ("if", "for", "while", "switch", "and", "or", "not", "in", "return", *ANY_ORDER) \
                or source[i - 2] == "def":
            continue
        commas, j = [], i + 1
        while j < source.partner[i]:
            if source[j] == ",":
                commas.append(j)
            j = source.partner.get(j, j) + 1 if source[j] in "([{" else j + 1
        ends = [i, *commas, source.partner[i]]
        parts = [source.text[source.tokens[a + 1].begin:source.tokens[b - 1].end] for a, b in zip(ends, ends[1:])]
        # declarations have two words in a part; a template's comma makes a part without balance
        if len(parts) not in (2, 3) or any(re.search(r"\w[&*]* \w|<[^>]*$|[\[{;]", part) for part in parts):
            continue
        first, last = parts[0], parts[1]
        begin = source.tokens[i + 1].begin
        end = source.tokens[ends[2] - 1].end
        if first != last and not source.python or first != last and "=" not in first + last:
            start = name_begin(source, i - 1)
            whole = source.tokens[source.partner[i]].end
            text = source.text[start:begin] + last + ", " + first + source.text[end:whole]
            yield Fault.at(source, start, whole, text, f"`{first}` and `{last}` change places", begin)


def name_begin(source, i):
    """Where the called name that ends at token i begins: with its object and its namespaces."""
    while True:
        if source[i - 1] in ("::", ".", "->") and (source.tokens[i - 2].kind == "name" or source[i - 2] in (")", "]")):
            i = source.partner.get(i - 2, i - 2)
            if source[i] in ("(", "[") and source.tokens[i - 1].kind == "name":
                i -= 1
        else:
            return source.tokens[i].begin


def all_faults(source):
    """Every fault that this file can be given, once."""
    seen = set()
    for kind in (operators, constants, negations, conditions, statements, arguments):
        for fault in kind(source):
            if fault is not None and fault.key not in seen:
                seen.add(fault.key)
                yield fault
