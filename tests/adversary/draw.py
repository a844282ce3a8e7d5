"""Random structures as chain files. Each is drawn from a seed and a number alone, so that one can be drawn again without the others."""
import random
from fractions import Fraction


def written(value):
    """As TOML."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{k} = {written(v)}" for k, v in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(written, value)) + "]"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str) and value.startswith("="):
        return value[1:]  # a number, kept as it was drawn
    return f'"{value}"' if isinstance(value, str) else str(value)


def toml(table):
    return "".join(f"{key} = {written(value)}\n" for key, value in table.items())


class Draw:
    def __init__(self, seed, number):
        self.random = random.Random(f"{seed}/{number}")
        self.powers = self.random.choice([0.3, 0.3, 1, 3, 6, 12])
        self.figures = self.random.choice([1, 2, 4, 7])

    def chance(self, probability):
        return self.random.random() < probability

    def positive(self, powers=None):
        """A decimal; the largest of several over the smallest is 10^powers at most."""
        powers = self.powers if powers is None else powers
        value = 10 ** self.random.uniform(-powers / 2, powers / 2)
        return f"={value:.{self.figures - 1}e}" if powers > 2 else f"={value:.{self.figures}g}"

    def negative(self, powers=None):
        return "=-" + self.positive(powers)[1:]

    def several(self, count, zero=0.0):
        return ["=0" if self.chance(zero) else self.positive() for _ in range(count)]

    # ends and supports

    def held(self, free=0.4, held=0.4):
        chance = self.random.random()
        return "free" if chance < free else "held" if chance < free + held else self.positive()

    def ends(self, table, tables=0.4):
        """Ends in words, or as tables; one is held along but in one case of thirty."""
        words = self.random.choice(["", "pinned", "sprung", "clamped"])
        if words in ("pinned", "clamped"):
            table["stiffness"][0] = "=0"
        if words == "sprung" and table["stiffness"][0] == "=0":
            table["stiffness"][0] = "=1"
        if words:
            table["base"] = words
        words = self.random.choice(["", "guided", "free", "free", "clamped"])
        if words:
            table["end_point"] = words
        if self.chance(tables):
            self.table_of_base(table)
        if self.chance(tables):
            self.table_of_end(table)

    def table_of_base(self, table):
        base = {"along": "held" if self.chance(0.8) else self.positive()}
        if self.chance(0.5):
            base["across"] = self.held(0.15, 0.5)
        if self.chance(0.4):
            base["turn"], table["stiffness"][0] = "held", "=0"
        table["base"] = base
        if self.chance(0.3):  # the other end is held along
            base["along"] = "free"
            table["end_point"] = {"along": "held" if self.chance(0.7) else self.positive(), "across": self.held(), "turn": self.held(0.6, 0.2)}
        if self.chance(0.03):
            base["along"] = "free"

    def table_of_end(self, table):
        already = table["end_point"]["along"] if isinstance(table.get("end_point"), dict) else "free"
        table["end_point"] = {"along": already, "across": self.held(), "turn": self.held(0.6, 0.2)}

    def supports(self, table, links):
        joints = self.random.sample(range(2, links + 1), min(links - 1, self.random.choice([0, 0, 0, 1, 1, 2])))
        if joints:
            table["supports"] = [{"at": at, "across": "held" if self.chance(0.3) else self.positive()} for at in sorted(joints)]
        if self.chance(0.2):
            table["foundation"] = self.positive()

    # loads

    def along(self, space=False):
        push = self.negative() if self.chance(0.85) else self.positive()
        return [push] + ["=0"] * (2 if space else 1)

    def dead_loads(self, table, links, space=False, most=3):
        loads = []
        for _ in range(self.random.randint(1, most)):
            kind = self.random.choice(["end", "joint", "weight"])
            if kind == "weight":
                load = {"weight": self.along(space) if space else self.several(links, 0.2) if self.chance(0.7) else self.positive()}
                if self.chance(0.3) and not space:
                    load["direction"] = ["=1" if self.chance(0.5) else "=-1", "=0"]
            else:
                load = {"force": self.along(space)}
                if kind == "joint" and links > 1:
                    load["at"] = self.random.randint(2, links)
            if self.chance(0.15):
                load["fixed"] = True
            loads.append(load)
        if self.chance(0.8) or len(loads) > 1:
            table["loads"] = loads

    # structures

    def links(self, most):
        return self.random.randint(2, most) if self.chance(0.95) else 1

    def plane(self, most=8, zero=0.1):
        links = self.links(most)
        table = {"lengths": self.several(links), "stiffness": self.several(links, zero)}
        self.ends(table)
        self.supports(table, links)
        return table, links

    def dead(self):
        table, links = self.plane()
        self.dead_loads(table, links)
        return table

    def follower(self):
        self.powers = min(self.powers, 6)
        table, links = self.plane(self.random.choice([2, 3, 3, 4, 5]) if self.chance(0.96) else 8, 0.05)
        if self.chance(0.5):
            table["end_point"] = "free"
        load = {"follower": self.positive()}
        if links > 1 and self.chance(0.3):
            load["at"] = self.random.randint(2, links)
        loads = [load]
        if self.chance(0.3):
            self.dead_loads(table, links, most=1)
            loads += table.get("loads", [])
        table["loads"] = loads
        if self.chance(0.7):
            moves = isinstance(table.get("base"), dict) and table["base"].get("across", "held") != "held"
            table["masses"] = self.several(links + moves)
        return table

    def touching(self):
        """Two links of length 1 with a follower p and a dead force -d at the end, at which a frequency touches zero or two frequencies
        meet and part again; or nearly so, where the figures of p or of a mass are cut short."""
        k1, k2 = self.random.choice([1, 2, 4, 5, 8]), self.random.choice([1, 2, 4, 5, 8])
        d = self.random.randint(1, 5)
        masses = [self.random.randint(1, 9), self.random.randint(1, 9)]
        # det(K - F A) = k1 k2 - F d (k1 + 2 k2) + F^2 d (d + p), a square for this p
        p = Fraction(d * (k1 + 2 * k2) ** 2, 4 * k1 * k2) - d
        if self.chance(0.5):
            p += self.random.choice([0, 0, 1, -1]) * Fraction(1, 10 ** self.random.randint(4, 12))
        else:
            found = None
            while found is None:
                d, p = self.random.randint(-6, 5), Fraction(self.random.randint(1, 9))
                found = meeting_mass(k1, k2, d, p, masses[1])
            masses[0] = found
        decimals = self.random.randint(12, 20)
        return {"lengths": [1, 1], "stiffness": [k1, k2], "end_point": "free",
                "masses": [f"={decimal(m, decimals)}" for m in masses],
                "loads": [{"follower": f"={decimal(p, decimals)}"}, {"force": [-d, 0]}]}

    # in space

    def axes(self):
        """Of one joint: mostly across the chain, now and then oblique to it, along it, or twice the same."""
        count = self.random.choice([1, 1, 2, 2, 2, 3])
        across = [[0, 0, 1], [0, 1, 0], [0, 1, 1], [0, 2, -1]]
        oblique = [[1, 0, 1], [1, 1, 1], [-1, 2, 0], [1, 0, 0]]
        pool = across + (oblique if self.chance(0.4) else [])
        return [[f"={c}" for c in self.random.choice(pool)] for _ in range(count)]

    def space(self, most=6):
        links = self.links(most)
        joints = []
        for _ in range(links):
            axes = self.axes()
            joints.append({"axes": axes, "stiffness": self.several(len(axes), 0.08)})
        table = {"lengths": self.several(links), "joints": joints}
        words = self.random.choice(["", "jointed", "clamped", "bearing"])
        if words:
            table["base"] = {"turn": "held"} if words == "clamped" and self.chance(0.2) else words
        if words in ("clamped", "bearing"):
            joints[0]["stiffness"] = ["=0"] * len(joints[0]["axes"])
        words = self.random.choice(["", "guided", "free", "free", "clamped"])
        if words:
            table["end_point"] = {"across": "free"} if words == "free" and self.chance(0.2) else words
        return table, links

    def space_dead(self):
        table, links = self.space(self.random.choice([4, 6, 8]))
        self.supports(table, links)
        self.dead_loads(table, links, space=True)
        return table

    def torque(self):
        self.powers = min(self.powers, 3)
        table, _ = self.space()
        for joint in table["joints"]:
            joint["axes"] = [["=0"] + axis[1:] if axis[1:] != ["=0", "=0"] else ["=0", "=0", "=1"] for axis in joint["axes"]]
        table["loads"] = [{"torque": self.random.choice(["semitangential", "axial", "tangential"])}]
        return table

    # statements that contradict themselves or the documents

    def ill(self):
        """A structure with one thing in it that no document has."""
        space = self.chance(0.3)
        table = self.space_dead() if space else self.dead()
        table.setdefault("loads", [{"force": ["=-1"] + ["=0"] * (2 if space else 1)}])
        load, links = self.random.choice(table["loads"]), len(table["lengths"])
        key, value = self.random.choice([
            ("lengths", ["=1"] * (links + 1)), ("lengths", ["=-1"] * links), ("lengths", "long"), ("foundation", ["=1"]), ("foundation", True),
            ("base", 3), ("base", "loose"), ("base", {"along": "held", "acros": 1}), ("base", {"across": True}), ("end_point", []),
            ("end_point", {"turn": "fixed"}), ("ends", {"base": {"along": "held"}, "end_point": {"along": "held"}}), ("loads", {"force": [-1, 0]}), ("loads", [{}]), ("loads", []),
            ("supports", [{"at": 1, "across": 1}]), ("supports", [{"at": links + 1, "across": "held"}]), ("supports", [{"at": 2.5, "across": 1}]),
            ("supports", [{"at": 2, "across": 1}] * 2), ("supports", [{"at": 2}]), ("supports", [{"at": 2, "across": True}]),
            ("supports", {"at": 2, "across": 1}), ("masses", ["=1"] * (links + 2)), ("masses", "heavy"), ("weight", 1),
            ("stiffness" if not space else "rest", ["=1"] * (links + 1)), ("joints", [{"axes": [[0, 0, 1]], "stiffness": [1]}] * (links + 1)),
            ("fixed", "true"), ("fixed", 1), ("at", 0), ("at", links + 1), ("at", "2"), ("colour", 1), ("moment", 1), ("follower", "one")])
        if key in ("fixed", "at", "colour", "moment", "follower"):
            load[key] = value
        else:
            table.update(value if key == "ends" else {key: value})
        return table

    # bent

    def bent(self, links, zero=0.1):
        """In the plane, of like sizes; loads along and across, and moments."""
        self.powers = min(self.powers, 1)
        table = {"lengths": self.several(links), "stiffness": self.several(links, zero)}
        self.ends(table, tables=0.25)
        self.supports(table, links)
        loads = []
        for _ in range(self.random.randint(1, 2)):
            if self.chance(0.2):
                loads.append({"moment": self.positive()})
            elif self.chance(0.25):
                loads.append({"weight": self.several(links), "direction": self.random.choice([["=0", "=-1"], ["=0.6", "=-0.8"], ["=-1", "=0"]])})
            else:
                load = {"force": [self.negative(), "=0" if self.chance(0.5) else self.positive()]}
                if links > 1 and self.chance(0.3):
                    load["at"] = self.random.randint(2, links)
                loads.append(load)
            if self.chance(0.1):
                loads[-1]["fixed"] = True
        table["loads"] = loads
        return table

    def census(self):
        return self.bent(self.random.choice([1, 2, 2, 2, 3, 3]))

    def path(self):
        return self.bent(self.random.randint(1, 6)) if self.chance(0.5) else self.dead()

    def path_in_space(self):
        self.powers = min(self.powers, 1)
        return self.space_dead()


def decimal(value, places):
    """A number with so many decimals."""
    whole = round(Fraction(value) * 10 ** places)
    return f"{'-' if whole < 0 else ''}{abs(whole) // 10 ** places}.{abs(whole) % 10 ** places:0{places}d}"


def meeting_mass(k1, k2, d, p, m2):
    """The mass m1 with which the two frequencies meet at one factor alone: there the discriminant of det(K - F A - x M), a quadratic in
    F, has a double root. None where bisection finds none."""
    def doubled(m1):
        c0, c1 = m2 * (k1 + 4 * k2) + m1 * k2, 2 * m2 * (d + p) + m1 * d
        a, b, c = c1 ** 2 - 4 * m1 * m2 * d * (d + p), -2 * c0 * c1 + 4 * m1 * m2 * d * (k1 + 2 * k2), c0 ** 2 - 4 * m1 * m2 * k1 * k2
        return b * b - 4 * a * c
    grid = [Fraction(i, 7) for i in range(1, 150)]
    for low, high in zip(grid, grid[1:]):
        if (doubled(low) > 0) != (doubled(high) > 0):
            for _ in range(90):
                middle = (low + high) / 2
                low, high = (middle, high) if (doubled(middle) > 0) == (doubled(low) > 0) else (low, middle)
            return low
    return None
