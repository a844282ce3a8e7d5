"""Verdicts on answers, counted by kind of structure; failing inputs are kept with a line that says why."""
import collections
import os

COLUMNS = ["cases", "answered", "refused rightly", "refused wrongly", "unsettled", "false certified", "wrong uncertified", "hangs", "crashes",
           "raw texts"]
BAD = ["refused wrongly", "false certified", "wrong uncertified", "hangs", "crashes", "raw texts"]


class Tally:
    def __init__(self, folder=None):
        self.counts, self.folder, self.bad = collections.defaultdict(collections.Counter), folder, 0
        self.checked = collections.Counter()  # numbers that were held against the truth, by what they are

    def add(self, kind, number, text, verdicts):
        """`verdicts` are pairs of a column and a reason; each structure counts once a column."""
        self.counts[kind]["cases"] += 1
        for column in {c for c, _ in verdicts}:
            self.counts[kind][column] += 1
        bad = [(c, reason) for c, reason in verdicts if c in BAD]
        self.bad += bool(bad)
        for column, reason in bad:
            print(f"{kind} {number}: {column}: {reason}", flush=True)
        if bad and self.folder:
            os.makedirs(self.folder, exist_ok=True)
            with open(os.path.join(self.folder, f"{kind}-{number}.toml"), "w", encoding="utf-8") as file:
                file.write("".join(f"# {column}: {reason}\n" for column, reason in bad) + text)

    def table(self):
        rows = [["structures"] + COLUMNS]
        total = collections.Counter()
        for kind, counts in self.counts.items():
            rows.append([kind] + [str(counts[c]) for c in COLUMNS])
            total.update(counts)
        rows.append(["all"] + [str(total[c]) for c in COLUMNS])
        rows.insert(1, ["---"] + ["--:"] * len(COLUMNS))
        lines = ["| " + " | ".join(row) + " |" for row in rows]
        held = ", ".join(f"{count} {what}" for what, count in self.checked.items())
        return "\n".join(lines) + f"\n\nHeld against the truth: {held}."
