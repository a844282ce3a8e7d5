"""Holds the quotes of a paper's folder to the paper's own text.

usage: quotes.test.py FOLDER [--update TEXT]

The text itself is not ours to publish. FOLDER/words.txt has what it takes to recognise its words: of every three that follow
each other the first six digits of their SHA-256. A quote passes where each three of its words that no formula parts follow
each other in the paper; where a formula leaves fewer, each two, or the word. --update writes the file from TEXT, the paper in
Markdown with formulas between dollar signs.
"""
import hashlib
import pathlib
import re
import sys
import tomllib

BREAK = "\0"
OF_FORMULAS = {"sin", "cos", "det", "rank", "arg", "min", "lim", "dx", "fl"}  # as words in quotes, set in the paper


def runs(text):
    """The words between formulas, in lower case, without hyphens and signs."""
    text = re.sub(r"\$\$.*?\$\$|\$[^$]*\$", BREAK, text, flags=re.S)
    text = re.sub(r"[*“”\"‘’'`()\[\],.:;!?>#|]|\\_", " ", text)
    run = []
    for token in re.split(r"(\s+|-|–|/)", text):
        word = token.strip().lower()
        if re.fullmatch(r"[a-z]{2,}|a", word) and word not in OF_FORMULAS:
            run.append(word)
        elif word and word not in "-–/":
            yield run
            run = []
    yield run


def digest(words):
    return hashlib.sha256(" ".join(words).encode()).hexdigest()[:6]


def pieces(run, length):
    return [run[i:i + length] for i in range(len(run) - length + 1)]


def known(text):
    found = set()
    for run in runs(text):
        for length in (1, 2, 3):
            found.update(digest(piece) for piece in pieces(run, length))
    return found


def quotes(folder):
    for path in sorted(folder.glob("*.toml")):
        content = tomllib.loads(path.read_text(encoding="utf-8"))
        for claim in content.get("claim", []):
            yield claim["id"], claim["quote"]
        for premise in content.get("premise", []):
            if "where" in premise:
                yield premise["id"], premise["quote"]


def main(folder, *update):
    words = folder / "words.txt"
    if update:
        text = pathlib.Path(update[1]).read_text(encoding="utf-8")
        digests = sorted(known(text))
        lines = [" ".join(digests[i:i + 17]) + "\n" for i in range(0, len(digests), 17)]
        words.write_text("".join(lines), encoding="utf-8")
    of_paper = set(words.read_text(encoding="utf-8").split())
    wrong, tried = [], 0
    for name, quote in quotes(folder):
        # what an ellipsis leaves out parts a quote as a formula does
        for run in runs(quote.replace("…", BREAK)):
            for piece in pieces(run, min(3, len(run))) if run else []:
                tried += 1
                if digest(piece) not in of_paper:
                    wrong.append(f"{name}: “{' '.join(piece)}” is not in the paper")
    # a word that is not the paper's is found
    if digest(["the", "manipulator", "quotes"]) in of_paper:
        wrong.append("words.txt: takes any words")
    for line in wrong:
        print(line)
    print(f"{tried} pieces of quotes, {len(wrong)} not in the paper")
    sys.exit(bool(wrong))


main(pathlib.Path(sys.argv[1]), *sys.argv[2:])
