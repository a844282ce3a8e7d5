"""The proved checker refuses every forgery, and agrees with the one in Python on the whole tampering set.

usage: agreement.test.py PROVED_CHECKER PROOFS TAMPERING_TEST CERTIFICATES

Forgeries are sealed with a fresh digest first, as the forger would: the digest guards names, which no arithmetic can, and is
left to Python.
"""
import importlib.util
import json
import os
import subprocess
import sys
import tempfile


def load(path, arguments):
    sys.argv = [path, *arguments]
    sys.path.insert(0, os.path.dirname(path))
    spec = importlib.util.spec_from_file_location("tampering", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def judged(proved, lines):
    with tempfile.NamedTemporaryFile("w", suffix=".jsonl") as file:
        file.write("\n".join(lines) + "\n")
        file.flush()
        return subprocess.run([proved, "--each", file.name], capture_output=True, text=True, check=True).stdout.split()


def named(published):
    """What an older checker was made to accept."""
    head = {**published, "certificates": []}

    def entry(lengths, stiffness, forces):
        return json.dumps({**head, "certificates": [
            {"chain": "forged", "lengths": lengths, "stiffness": stiffness, "forces": forces}]})

    def force(mode, low, high, below, digits, shape=None):
        result = {"mode": mode, "low": low, "high": high, "digits": digits, "below_low": below[0], "below_high": below[1]}
        return {**result, "shape": shape} if shape else result

    below, above = ({"first": first, "last": last, "digits": 2, "q": q}
                    for first, last, q in ((1, 2, ["-0.67", "1", "0"]), (2, 3, ["0", "-0.50", "1"])))
    chain = (["1", "1", "1"], ["6", "0", "2.2"])
    wide = ("3.99", "4.41", (0, 2), 1)
    narrow = ("3.99999", "4.00001", (0, 1), 4)
    # L = (1, 1, 1), k = (6, 0, 2.2): F_1 = 4 bends joints 1 and 2, F_2 = 4.4 joints 2 and 3
    yield "refused", "swapped mode", entry(*chain, [force(1, *wide, above)])
    yield "refused", "swapped mode, narrow bounds", entry(*chain, [force(1, *narrow, above)])
    yield "holds", "the right mode", entry(*chain, [force(1, *narrow, below)])
    # L = (1, 1), k = (0, 1): q = (-1/2, 1)
    two = (["1", "1"], ["0", "1"])
    for verdict, q in (("holds", ["-0.50", "1"]), ("refused", ["1", "-2.0"]), ("refused", ["-0.5", "1", "0"])):
        yield verdict, f"q {q}", entry(*two, [force(1, "1.99999", "2.00001", (0, 1), 5,
                                              {"first": 1, "last": 2, "digits": 2, "q": q})])
    whole = entry(*two, [force(1, "1.99999", "2.00001", (0, 1), 5)])
    yield "holds", "as it was", whole
    yield "refused", "a member twice", whole.replace('"mode": 1', '"mode": 7, "mode": 1')
    yield "refused", "lengths twice", whole.replace('"lengths"', '"lengths": ["5", "5"], "lengths"')


def texts(tampering, published):
    """The rest of the tampering set, with what is right of each: misspelt documents, and pairs by hand."""
    def of_one(entry):
        return tampering.sealed({**published, "certificates": [entry]})

    for text, what in tampering.misspelt(of_one(tampering.kinds(published["certificates"])[-1])):
        yield "refused", what, text
    for name, true, false in tampering.by_hand():
        yield "holds", f"beside: {name}", json.dumps(of_one(true))
        yield "refused", name, json.dumps(of_one(false))


def main():
    proved, proofs, tampering_path, certificates = sys.argv[1:5]
    tampering = load(tampering_path, [proofs])
    python = tampering.Judge(tampering.checker)
    with open(certificates, encoding="utf-8") as file:
        published = json.load(file)
    wrong, count = [], 0
    for certificate in tampering.kinds(published["certificates"]):
        untouched = tampering.sealed({**published, "certificates": [certificate]})
        cases = [(untouched, "untouched")]
        cases += [(tampering.sealed(forgery), what) for forgery, what in tampering.forgeries(untouched)]
        verdicts = judged(proved, [json.dumps(document) for document, _ in cases])
        assert len(verdicts) == len(cases)
        for verdict, (document, what) in zip(verdicts, cases):
            count += 1
            if (verdict == "holds") != python.holds(document) or (verdict == "holds") != (what == "untouched"):
                wrong.append((verdict, what))
    cases = [*named(published), *texts(tampering, published)]
    verdicts = judged(proved, [text for *_, text in cases])
    assert len(verdicts) == len(cases)
    for verdict, (expected, what, _) in zip(verdicts, cases):
        count += 1
        if verdict != expected:
            wrong.append((verdict, what))
    for item in wrong:
        print(*item)
    print(f"{count} documents, {len(wrong)} judged wrongly or otherwise than in Python")
    sys.exit(bool(wrong))


main()
