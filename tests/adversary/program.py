"""One run of the program on one structure, and what can be seen of its answer without knowing the truth."""
import json
import os
import re
import signal
import subprocess
import tempfile
from dataclasses import dataclass

# words of libraries and of the language, which no message may hold
RAW = re.compile(r"boost|std::|Eigen|terminate|what\(\)|Error in function|[Dd]ivision by zero|[Aa]ssert|basic_string|vector::|bad_alloc|toml::"
                 r"|\bnan\b|mpfr|gmp|segmentation|stack smashing", re.IGNORECASE)


@dataclass
class Answer:
    status: int
    out: str
    complaint: str
    hangs: bool

    @property
    def refused(self):
        return self.status != 0

    @property
    def crashed(self):
        return self.status < 0 or self.status > 100

    @property
    def raw(self):
        """Of a refusal, a reason why its words are not one clear line; else empty."""
        lines = [line for line in self.complaint.splitlines() if line.strip()]
        if self.refused and not lines:
            return "refused without a word"
        found = RAW.search(self.complaint)
        if found:
            return f"a library's word: {found.group()}"
        return f"{len(lines)} lines" if self.refused and len(lines) > 1 else ""

    def json(self):
        return json.loads(self.out)


class Program:
    def __init__(self, path, seconds):
        self.path, self.seconds = os.path.abspath(path), seconds
        self.folder = tempfile.TemporaryDirectory()

    def __call__(self, verb, text, *options, seconds=None):
        path = os.path.join(self.folder.name, "structure.toml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        run = subprocess.Popen([self.path, verb, path, *options], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True, preexec_fn=lambda: limited(seconds or self.seconds))
        out, complaint = run.communicate()
        return Answer(run.returncode, out, complaint, run.returncode == -signal.SIGXCPU)


def limited(seconds):
    """Processor time, which does not depend on what else the machine does."""
    import resource
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
