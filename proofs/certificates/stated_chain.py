"""A straight chain as its chain file states it, assembled anew with fractions: lengths and springs, ends, supports, bed,
weights, loads and masses. What the keys mean stands in structure-certificate-format.md."""
import re
from fractions import Fraction

from check_certificates import fields, number, require

def read_node(entry, links):
    """The node of `at`: the end point, or joint 2 ... n by its number."""
    if entry.get("at", "end_point") == "end_point": return links
    joint = number(entry["at"])
    require(joint.denominator == 1 and 2 <= joint <= links, "at")
    return int(joint) - 1

class Motion:
    """One motion of one place: free, held, or against a spring."""
    def __init__(self, text):
        self.held = text == "held"
        self.spring = Fraction(0) if text in ("held", "free") else number(text)
        require(self.spring >= 0, "a negative spring")

    def add(self, spring):
        self.spring += 0 if self.held else spring

class End:
    """An end, by a word or by its three motions."""
    WORDS = {"guided": ("free", "held", "free"), "free": ("free", "free", "free"), "clamped": ("free", "held", "held")}

    def __init__(self, said, words, otherwise):
        if isinstance(said, str):
            motions = words[said]
        else:
            fields(said, "", "along across turn")
            motions = [said.get(name, default) for name, default in zip(("along", "across", "turn"), otherwise)]
        self.along, self.across, self.turn = map(Motion, motions)

    def holds_along(self):
        return self.along.held or self.along.spring > 0

def behind_half_bar(turn, half):
    return half if turn.held else turn.spring * half / (turn.spring + half)

def numbers(entry, count):
    require(isinstance(entry, list) and len(entry) == count, "a list of another length")
    return [number(x) for x in entry]

def is_fixed(load):
    require(load.get("fixed", 0) in (0, 1), "fixed")
    return load.get("fixed", 0) == 1

def read_supports(entry, links):
    """The motions across of nodes 1 ... n - 1."""
    across = [Motion("free") for _ in range(links - 1)]
    places = [read_node(support, links) for support in entry.get("supports", [])]
    require(len(set(places)) == len(places) and links not in places, "two supports at one joint, or one at the end point")
    for node, support in zip(places, entry.get("supports", [])):
        fields(support, "at across")
        across[node - 1] = Motion(support["across"])
    return across

def lay_bed(entry, lengths, across):
    """A bed of so much force per deflection and length: each link's share on its two ends."""
    bed = number(entry.get("foundation", "0"))
    require(bed >= 0, "foundation")
    for link, length in enumerate(lengths):
        for node in (link, link + 1): across[node].add(bed * length / 2)

class PlaneChain:
    """Deflections across at the free nodes are the unknowns; those of a clamped link are one."""
    BASE = {"pinned": ("held", "held", "free"), "sprung": ("held", "held", "free"), "clamped": ("held", "held", "held")}

    def __init__(self, entry):
        fields(entry, "", "lengths stiffness rest base end_point supports foundation loads masses beam")
        if "beam" in entry: self.read_beam(entry)
        else: self.read_links(entry)
        n = self.n = len(self.L)
        require(n == len(self.k) > 0 and min(self.L) > 0 <= min(self.k), "no such chain")
        require(self.base.turn.spring == 0 and not (self.base.turn.held and self.k[0]), "the spring of joint 1")
        self.across = [self.base.across] + read_supports(entry, n) + [self.end.across]
        lay_bed(entry, self.L, self.across)
        self.axial, self.followers = [[Fraction(0)] * (n + 1), [Fraction(0)] * (n + 1)], []
        for load in entry.get("loads", [{"force": ["-1", "0"]}]): self.read_load(load)
        self.read_masses(entry.get("masses"))
        self.compress()
        self.number_unknowns()

    def read_links(self, entry):
        self.L, self.k = [number(x) for x in entry["lengths"]], [number(x) for x in entry["stiffness"]]
        require(not any(number(x) for x in entry.get("rest", [])) and len(entry.get("rest", self.L)) == len(self.L), "a bent chain")
        self.base = End(entry.get("base", {}), self.BASE, ("held", "held", "free"))
        self.end = End(entry.get("end_point", {}), End.WORDS, ("free", "held", "free"))
        word = entry.get("base")
        require(not (word == "pinned" and self.k[0]) and not (word == "sprung" and not self.k[0]), "the word for the base")

    def read_beam(self, entry):
        """Bars of equal length l: k = E I / l at a joint; between a bar's middle and the rod's end there is half a bar, 2 E I / l,
        in series with what holds that end against turning."""
        require(not {"lengths", "stiffness", "rest"} & set(entry), "a beam and lists")
        beam = entry["beam"]
        fields(beam, "length links", "E I EI")
        require(("EI" in beam) != ("E" in beam and "I" in beam) and len(beam) == (3 if "EI" in beam else 4), "beam")
        EI = number(beam["EI"]) if "EI" in beam else number(beam["E"]) * number(beam["I"])
        links, length = number(beam["links"]), number(beam["length"])
        require(links.denominator == 1 and 0 < links <= 10**6 and EI > 0 < length, "beam")
        self.L = [length / links] * int(links)
        k = EI / self.L[0]
        pinned = ("held", "held", "free")
        self.base = End(entry.get("base", "pinned"), {"pinned": pinned, "clamped": ("held", "held", "held")}, pinned)
        self.end = End(entry.get("end_point", "pinned"), {**End.WORDS, "pinned": End.WORDS["guided"]}, End.WORDS["guided"])
        self.k = [behind_half_bar(self.base.turn, 2 * k)] + [k] * (len(self.L) - 1)
        self.base.turn, turn = Motion("free"), Motion("free")
        turn.add(behind_half_bar(self.end.turn, 2 * k))
        self.end.turn = turn

    def read_load(self, load):
        fields(load, "", "at force follower weight direction fixed")
        require(len({"force", "follower", "weight"} & set(load)) == 1 and ("direction" not in load or "weight" in load), "load")
        axial, node = self.axial[0 if is_fixed(load) else 1], read_node(load, self.n)
        if "force" in load:
            x, y = numbers(load["force"], 2)
            require(not y, "a force across the chain")
            axial[node] += x
        elif "follower" in load:
            axial[node] -= number(load["follower"])
            self.followers.append((node, number(load["follower"]), is_fixed(load)))
        else:
            require("at" not in load, "a weight at a joint")
            x, y = numbers(load.get("direction", ["-1", "0"]), 2)
            require(not y and x in (1, -1), "a weight across the chain")
            said = load["weight"]
            for link, weight in enumerate(numbers(said, self.n) if isinstance(said, list) else [number(said)] * self.n):
                axial[link] += x * weight / 2
                axial[link + 1] += x * weight / 2

    def read_masses(self, said):
        """At all nodes, or at the far ends of the links; else each link's length, half of it at either end."""
        if said is None:
            self.masses = [(a + b) / 2 for a, b in zip([0] + self.L, self.L + [0])]
        else:
            self.masses = [Fraction(0)] * (self.n + 1 - len(said)) + [number(x) for x in said]
        require(len(self.masses) == self.n + 1 and len(said or self.L) >= self.n and min(self.masses) >= 0, "masses")

    def compress(self):
        """What the end that is held along the chain has to carry passes through the links before it."""
        from_base = self.base.holds_along()
        require(from_base != self.end.holds_along(), "held along at one end")
        self.N = [[-sum(f[link + 1:]) if from_base else sum(f[:link + 1]) for link in range(self.n)] for f in self.axial]

    def number_unknowns(self):
        leader = list(range(self.n + 1))
        if self.base.turn.held: leader[1] = leader[0]
        if self.end.turn.held: leader[self.n] = leader[self.n - 1]
        held = {leader[i] for i, motion in enumerate(self.across) if motion.held}
        free = [i for i in sorted(set(leader)) if i not in held]
        self.size, self.unknown = len(free), [free.index(i) if i in free else None for i in leader]

    def matrix(self, springs, factor):
        """Of springs (as they are, times `springs`) and loads: fixed ones times `springs`, the others times `factor`."""
        rows = [{} for _ in range(self.size)]
        def add(terms, times):
            for i, a in terms:
                for j, b in terms:
                    if times and i is not None and j is not None: rows[i][j] = rows[i].get(j, 0) + times * a * b
        def slope(link, times=1):
            return [(self.unknown[link], -times / self.L[link]), (self.unknown[link + 1], times / self.L[link])]
        for i in range(self.n):
            if i: add(slope(i) + slope(i - 1, -1), springs * self.k[i])
            elif not self.base.turn.held: add(slope(0), springs * self.k[0])
            add(slope(i), -self.L[i] * (springs * self.N[0][i] + factor * self.N[1][i]))
        add(slope(self.n - 1), springs * self.end.turn.spring)
        for i, motion in enumerate(self.across): add([(self.unknown[i], 1)], springs * motion.spring)
        return rows

    def motion(self, factor):
        """The matrix K - factor A, which a load that follows its link makes unsymmetric, and the masses of its unknowns."""
        rows, mass = self.matrix(1, factor), [Fraction(0)] * self.size
        for node, push, fixed in self.followers:
            at, before = self.unknown[node], self.unknown[node - 1]
            if at is None: continue
            across = push / self.L[node - 1] * (1 if fixed else factor)
            rows[at][at] = rows[at].get(at, 0) + across
            if before is not None: rows[at][before] = rows[at].get(before, 0) - across
        for node, m in enumerate(self.masses):
            if self.unknown[node] is not None: mass[self.unknown[node]] += m
        require(min(mass) > 0, "a place without a mass")
        return [[row.get(j, Fraction(0)) for j in range(self.size)] for row in rows], mass

class SpaceChain:
    """Turns about the axes that bend the chain are the unknowns: a sum of squares of linear forms in them."""
    BASE = {"jointed": ("held", "held", "free"), "bearing": ("held", "held", "free"), "clamped": ("held", "held", "held")}

    def __init__(self, entry):
        fields(entry, "lengths joints", "base end_point supports foundation loads")
        L = self.L = [number(x) for x in entry["lengths"]]
        n = len(L)
        require(n == len(entry["joints"]) > 0 and min(L) > 0, "no such chain")
        base = End(entry.get("base", {}), self.BASE, ("held", "held", "free"))
        end = End(entry.get("end_point", {}), End.WORDS, ("free", "held", "free"))
        require(base.along.held and base.across.held and not base.turn.spring, "a base that moves")
        require(not end.holds_along() and not end.turn.spring, "the end point")
        axes = self.read_axes(entry["joints"], base.turn.held, entry.get("base") == "bearing")
        across = [Motion("held")] + read_supports(entry, n) + [end.across]
        lay_bed(entry, L, across)
        slopes = [[[lean[d] * (joint <= i) for joint, _, lean in axes] for d in (0, 1)] for i in range(n)]
        places = [[[sum(L[j] * slopes[j][d][a] for j in range(i + 1)) for a in range(len(axes))] for d in (0, 1)] for i in range(n)]
        held = [w for i in range(n) if across[i + 1].held for w in places[i]]
        basis = kernel(held + (slopes[-1] if end.turn.held else []), len(axes))
        N = self.read_compression(entry, n)
        squares = [(k, 0, [Fraction(a == b) for b in range(len(axes))]) for a, (_, k, _) in enumerate(axes)]
        for i in range(n):
            squares += [(across[i + 1].spring, 0, w) for w in places[i]]
            squares += [(-L[i] * N[0][i], -L[i] * N[1][i], t) for t in slopes[i]]
        self.size = len(basis)
        self.squares = [(c, d, [sum(x * y for x, y in zip(form, b)) for b in basis]) for c, d, form in squares if c or d]

    @staticmethod
    def read_axes(joints, clamped, bearing):
        """Of each that bends: its joint, the spring of its unit vector, and how what lies beyond leans in y and z."""
        axes = []
        for i, joint in enumerate(joints):
            fields(joint, "axes stiffness", "rest")
            count = len(joint["axes"])
            springs, rest = numbers(joint["stiffness"], count), numbers(joint.get("rest", ["0"] * count), count)
            require(1 <= count <= 3 and min(springs) >= 0 and not any(rest), "axes")
            require(i or not (clamped or bearing) or not any(springs), "springs at joint 1 of a clamp or a bearing")
            for axis, k in zip(joint["axes"], springs):
                a = numbers(axis, 3)
                require(any(a), "an axis without a direction")
                if (a[1] or a[2]) and not (i == 0 and clamped): axes.append((i, k * sum(x * x for x in a), (a[2], -a[1])))
        return axes

    @staticmethod
    def read_compression(entry, n):
        axial = [[Fraction(0)] * (n + 1), [Fraction(0)] * (n + 1)]
        for load in entry.get("loads", [{"force": ["-1", "0", "0"]}]):
            fields(load, "", "at force weight fixed")
            require(len({"force", "weight"} & set(load)) == 1 and not ("at" in load and "weight" in load), "load")
            x, y, z = numbers(load["force"] if "force" in load else load["weight"], 3)
            require(not y and not z, "a force across the chain")
            to = axial[0 if is_fixed(load) else 1]
            if "force" in load: to[read_node(load, n)] += x
            else:
                for link in range(n): to[link], to[link + 1] = to[link] + x / 2, to[link + 1] + x / 2
        return [[-sum(f[link + 1:]) for link in range(n)] for f in axial]

    def matrix(self, springs, factor):
        """As that of a chain in the plane."""
        return [{j: sum((springs * c + factor * d) * form[i] * form[j] for c, d, form in self.squares) for j in range(self.size)}
                for i in range(self.size)]

def kernel(rows, columns):
    """A basis of what the rows map to zero."""
    pivots = []
    for column in range(columns):
        row = next((row for row in rows if row[column]), None)
        if row is None: continue
        pivot = [x / row[column] for x in row]
        eliminated = [[x - other[column] * y for x, y in zip(other, pivot)] for other in rows if other is not row]
        pivots = [(at, [x - other[column] * y for x, y in zip(other, pivot)]) for at, other in pivots] + [(column, pivot)]
        rows = eliminated
    basis, leading = [], {at for at, _ in pivots}
    for column in range(columns):
        if column in leading: continue
        vector = [Fraction(i == column) for i in range(columns)]
        for at, pivot in pivots: vector[at] = -pivot[column]
        basis.append(vector)
    return basis

def canonical(said):
    """Words and fractions in place of texts, so that two ways to write a number are one."""
    if isinstance(said, dict): return {key: canonical(value) for key, value in said.items()}
    if isinstance(said, list): return [canonical(value) for value in said]
    if not isinstance(said, str): return said
    text = said.replace("_", "").strip()
    if re.fullmatch(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d{1,6})?|-?\d+/0*[1-9]\d*", text, re.ASCII): return Fraction(text)
    return said

def read_chain_file(path):
    """What a chain file says, canonical, in the spelling of chain files; decimals that a text joins by ';' are one each."""
    import tomllib  # from Python 3.11 on; nothing else here asks for it
    with open(path, encoding="utf-8") as file: chain = tomllib.loads(file.read(), parse_float=str)
    def plain(said):
        if isinstance(said, dict): return {key: plain(value) for key, value in said.items()}
        if isinstance(said, list): return [part for item in said for part in (item.split(";") if isinstance(item, str) else [plain(item)])]
        return said if isinstance(said, str) else str(int(said)) if not isinstance(said, bool) else int(said)
    chain = plain(chain.get("nominal", chain))
    for here, there in (("lengths", "link_length"), ("stiffness", "joint_stiffness")):
        if there in chain: chain[here] = chain.pop(there)
    return canonical({key: value for key, value in chain.items() if key not in ("link_mass", "gravity")})

def assembled(entry):
    return SpaceChain(entry) if "joints" in entry else PlaneChain(entry)
