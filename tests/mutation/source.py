"""A source file of C++ or Python as tokens: enough of the language to say where an operand begins and ends, in code that
is formatted as ours is (a binary operator stands between blanks, a bracket of a template does not)."""
import bisect
import re
from dataclasses import dataclass

TOKEN = re.compile(r"""
    (?P<blank>\s+|//[^\n]*|/\*.*?\*/|^[ ]*\#(?:[^\n]|(?<=\\)\n)*)
  | (?P<string>(?:u8|L)?R"(?P<mark>[^(]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*')
  | (?P<number>(?:\d|\.\d)(?:[eEpP][+-]|[\w.]|'\d)*)
  | (?P<name>[A-Za-z_]\w*)
  | (?P<sign><=>|<<=|>>=|->\*?|\+\+|--|::|&&|\|\||[-+*/%&|^<>=!]=|<<|>>|.)
""", re.X | re.S | re.M)
PYTHON = re.compile(TOKEN.pattern.replace(r"^[ ]*\#(?:[^\n]|(?<=\\)\n)*", r"\#[^\n]*")
                    .replace('(?:u8|L)?R"(?P<mark>[^(]*)\\(.*?\\)(?P=mark)"', '[fr]?\"\"\".*?\"\"\"').replace("//[^\\n]*|", ""),
                    re.X | re.S | re.M)
CLOSING = {")": "(", "]": "[", "}": "{"}
PRECEDENCE = {"||": 1, "&&": 2, "==": 6, "!=": 6, "<": 7, "<=": 7, ">": 7, ">=": 7, "<<": 9, ">>": 9, "+": 10, "-": 10,
              "*": 11, "/": 11, "%": 11, "and": 2, "or": 1, "^": 4}
ENDS = {",", ";", "?", ":", "=", "+=", "-=", "*=", "/=", "%=", "|=", "&=", "^=", "<<=", ">>=", "return", "throw", "case", "else",
        "do", "{", "(", "[", "if", "while", "for", "not", "in", "lambda", "assert", "elif", "yield"}


@dataclass
class Token:
    kind: str
    text: str
    begin: int
    end: int


class Source:
    def __init__(self, path, text):
        self.path, self.text, self.python = path, text, path.endswith(".py")
        pattern = PYTHON if self.python else TOKEN
        self.tokens = [Token(match.lastgroup if match.lastgroup != "mark" else "string", match[0], match.start(), match.end())
                       for match in pattern.finditer(text) if match.lastgroup != "blank"]
        self.pair()
        if self.python:
            self.end_lines()
            self.pair()
        self.lines = [0] + [m.end() for m in re.finditer("\n", text)]

    def pair(self):
        """Which bracket belongs to which."""
        self.partner, open_ = {}, []
        for i, token in enumerate(self.tokens):
            if token.kind != "sign":
                continue
            if token.text in "([{":
                open_.append(i)
            elif token.text in CLOSING and open_:
                j = open_.pop()
                self.partner[i], self.partner[j] = j, i

    def end_lines(self):
        """A semicolon without extent at the end of every line of Python that is not inside brackets."""
        ended, depth = [], 0
        for token, after in zip(self.tokens, [*self.tokens[1:], None]):
            ended.append(token)
            depth += (token.text in ("(", "[", "{")) - (token.text in CLOSING)
            if depth == 0 and (after is None or "\n" in self.text[token.end:after.begin]):
                ended.append(Token("sign", ";", token.end, token.end))
        self.tokens = ended

    def line(self, place):
        return bisect.bisect_right(self.lines, place)

    def text_of(self, line):
        begin = self.lines[line - 1]
        return self.text[begin:self.text.find("\n", begin)].strip()

    def __getitem__(self, i):
        return self.tokens[i].text if 0 <= i < len(self.tokens) else ""

    def binary(self, i):
        """The precedence of the operator between two operands that token i is, or None."""
        token = self.tokens[i]
        if token.text not in PRECEDENCE or token.kind == "string" or not 0 < i < len(self.tokens) - 1:
            return None
        before, after = self.text[token.begin - 1], self.text[token.end]
        return PRECEDENCE[token.text] if before.isspace() and after.isspace() and self[i - 1] != "operator" else None

    def operands(self, i):
        """Where the two operands of the binary operator i begin and end, as places in the text."""
        precedence = self.binary(i)
        left = i - 1
        while left >= 0:
            text = self[left]
            if text in CLOSING and self.tokens[left].kind == "sign":
                if text == "}" and self[left + 1] not in (".", "->"):
                    break
                left = self.partner.get(left, -1)
            elif text in ENDS or self.loose(left, precedence, strict=True):
                break
            left -= 1
        right = i + 1
        while right < len(self.tokens):
            text = self[right]
            if text in ("(", "[", "{") and right in self.partner:
                if self.python and text == "{" or text != "{" or self.tokens[right - 1].kind == "name" or self[right - 1] == ")":
                    right = self.partner[right]
                else:
                    break
            elif text in CLOSING or text in ENDS or self.loose(right, precedence, strict=False):
                break
            right += 1
        return (self.tokens[left + 1].begin, self.tokens[i - 1].end), (self.tokens[i + 1].begin, self.tokens[right - 1].end)

    def loose(self, i, precedence, strict):
        """Whether operator i binds less than one of this precedence does, or as much where that ends an operand too."""
        other = self.binary(i)
        return other is not None and (other < precedence if strict else other <= precedence)

    def statement(self, i):
        """Where the statement ends that begins at token i: the index of its semicolon, or None."""
        while i < len(self.tokens) and self[i] != ";":
            if self[i] in CLOSING:
                return None
            i = self.partner.get(i, i) + 1
        return i if i < len(self.tokens) else None
