"""What the theorems need: without the hypothesis the proof breaks, and a counterexample, computed here in fractions, shows
that no other proof would do. README.md lists the same.

usage: hypotheses.test.py COQC COMPILED README     (COMPILED: the folder of the checked theories)

The theories are read from the folder of this script. A hypothesis is left out by weakening it to one that says nothing, so
that what breaks is the proof, not a name.
"""
import concurrent.futures
import pathlib
import subprocess
import sys
import tempfile
from fractions import Fraction

HERE = pathlib.Path(__file__).resolve().parent


# ---- the chain, from its definitions ----

def distances(L):
    return [sum(L[i:], Fraction(0)) for i in range(len(L))]


def moment(L):
    """M = -S1."""
    z = distances(L)
    return [[z[max(i, j)] for j in range(len(L))] for i in range(len(L))]


def pencil(L, k, F):
    """A F + B of (33)."""
    n, z, M = len(L), distances(L), moment(L)
    rows = [[(k[i] if i == j else 0) - F * M[i][j] for j in range(n)] + [z[i]] for i in range(n)]
    return rows + [z + [Fraction(0)]]


def reduced(rows):
    """Rank and determinant by elimination."""
    rows, rank, det = [list(map(Fraction, row)) for row in rows], 0, Fraction(1)
    for column in range(len(rows[0])):
        pivot = next((i for i in range(rank, len(rows)) if rows[i][column]), None)
        if pivot is None:
            det = Fraction(0)
            continue
        if pivot != rank:
            rows[rank], rows[pivot], det = rows[pivot], rows[rank], -det
        det *= rows[rank][column]
        for i in range(rank + 1, len(rows)):
            factor = rows[i][column] / rows[rank][column]
            rows[i] = [a - factor * b for a, b in zip(rows[i], rows[rank])]
        rank += 1
    return rank, det


def determinant(rows):
    return reduced(rows)[1]


def times(A, B):
    return [[sum(a * b for a, b in zip(row, column)) for column in zip(*B)] for row in A]


def forms(L, k, q):
    """q^T K q and q^T M q."""
    M = moment(L)
    return (sum(ki * qi * qi for ki, qi in zip(k, q)),
            sum(M[i][j] * q[i] * q[j] for i in range(len(q)) for j in range(len(q))))


def is_mode(L, k, F, q, Fy):
    """(29) and (30)."""
    z, M = distances(L), moment(L)
    rows = [k[i] * q[i] - F * sum(M[i][j] * q[j] for j in range(len(q))) + Fy * z[i] for i in range(len(q))]
    return any(q) and not any(rows) and sum(a * b for a, b in zip(z, q)) == 0


def recursion(z, k, F):
    """H_0 ... H_(n-1), with 1/0 = 0 as Coq has it."""
    H, G = [z[0] ** 2], Fraction(1)
    for j in range(len(z) - 1):
        both = z[j] * z[j + 1]
        G = k[j] * G - (F * (z[j] - z[j + 1]) / both * H[-1] if both else 0)
        H.append(k[j + 1] * H[-1] + z[j + 1] ** 2 * G)
    return H


def D(L, k, F):
    return determinant(pencil(L, k, Fraction(F)))


def numbers(*values):
    return [Fraction(value) for value in values]


# ---- one counterexample a hypothesis: what holds without it, and is false ----

def definite():
    return forms(numbers(1, -1), numbers(0, 0), numbers(0, 1))[1] == -1


def rank_of_A():
    return reduced(moment(numbers(1, 0)))[0] == 1


def passive_joints_and_det_B():
    negative = D(numbers(1, 1), numbers(-4, 1), 0) == 0  # no joint is passive
    return negative and D(numbers(1, -1), numbers(0, 1), 0) == 0  # one joint is passive


def energy_factor():
    L, k, q = numbers(1, -1), numbers(0, 0), numbers(1, 0)
    return is_mode(L, k, Fraction(1), q, Fraction(1)) and forms(L, k, q) == (0, 0)


def determinant_of_recursion():
    L, k = numbers(1, 1, -1, 1), numbers(1, 1, 1, 1)  # the distance of joint 2 is 0
    return distances(L)[2] == 0 and D(L, k, 1) != -recursion(distances(L), k, Fraction(1))[-1]


def both_ends_passive():
    return recursion(numbers(2, 1), numbers(0, 0), Fraction(0))[-1] == 0


def passive_inside():
    z, k = numbers(3, 2, 1), numbers(3, 0, 1)
    at = [recursion(z, k, Fraction(F))[-1] for F in (0, 1, 2, 3, 4)]
    return at[2] == 0 and len({value > 0 for value in at if value}) == 1  # a double root: no change of sign


def two_passive():
    return D(numbers(1, 1, 1), numbers(0, 0, 1), 0) == 0


def negative_stiffness():
    return D(numbers(1, 1), numbers(0, -1), -2) == 0


def negative_length():
    return D([Fraction(1), Fraction(-1, 2)], numbers(1, 1), -2) == 0


def equal_forces():
    L, k = numbers(1, 1, 1), numbers(3, 0, 1)
    values = {F: D(L, k, F) for F in range(5)}
    leading = (values[0] - 2 * values[1] + values[2]) / 2
    return leading != 0 and all(value == leading * (F - 2) ** 2 for F, value in values.items())


def rank_of_a_mechanism():
    L, k = numbers(1, 1, 1), numbers(0, 0, 1)
    return D(L, k, 0) == 0 and reduced(pencil(L, k, Fraction(0)))[0] < 4


def block_at_zero():
    L, k = numbers(1, 1), numbers(1, 1)
    M, B = moment(L), pencil(L, k, Fraction(0))
    A = [[-x for x in row] + [Fraction(0)] for row in M] + [numbers(0, 0, 0)]
    first, last = [[Fraction(x)] for x in (-1, 0, 0)], [[Fraction(x)] for x in (0, 0, 1)]
    return times(A, first) == times(B, last) and not any(x for row in times(A, last) for x in row)


def zero_on_the_way():
    z, k = numbers(2, 1), numbers(0, 0)
    return recursion(z, k, Fraction(0))[-1] == 0  # the weight of the square is 1/0


def at_the_lowest_force():
    L, k, q = numbers(1, 1), numbers(0, 1), numbers(1, -2)
    strain, shortening = forms(L, k, q)
    return is_mode(L, k, Fraction(2), q, Fraction(0)) and strain - 2 * shortening == 0


def off_the_axis():
    L, k, q = numbers(1, 1), numbers(0, 1), numbers(1, 0)  # turns about its passive base
    strain, shortening = forms(L, k, q)
    return strain - 1 * shortening < 0  # below the lowest force, 2


def softer():
    return D(numbers(1, 1), numbers(0, 1), 2) == 0 and D(numbers(1, 1), [Fraction(0), Fraction(1, 2)], 1) == 0


def negative_length_and_stiffer():
    L = [Fraction(1), Fraction(-1, 2)]
    return D(L, numbers(1, 1), -2) == 0 and D(L, numbers(1, 2), -3) == 0


def all_raised():
    L, k, raised = numbers(1, 1, 1), numbers(0, 1, 1), numbers(0, 4, 4)
    return D(L, k, 1) == D(L, k, 3) == 0 and D(L, raised, 4) == D(L, raised, 12) == 0


def elastic_base_cut():
    whole = recursion(numbers(3, 2, 1), numbers(8, 1, 100), Fraction(6))
    return all(value > 0 for value in whole) and D(numbers(1, 1), numbers(8, 1), 6) == 0  # none up to 6; 6 without link 3


def turns_as_a_whole():
    L, k, t = numbers(1, 1), numbers(0, 1), numbers(1, 1)
    return k[1] * (t[1] - t[0]) == 0 and sum(a * b for a, b in zip(L, t)) != 0  # in balance at F = 0, off the axis


def lateral_force():
    return is_mode(numbers(1, 1), numbers(1, 1), Fraction(5, 2), numbers(1, -2), Fraction(-1, 2))


def elastic_base_reversed():
    F = Fraction(13, 6)
    return D(numbers(1, 2), numbers(1, 1), F) == 0 and D(numbers(2, 1), numbers(0, 1), F) != 0


def equal_at_zero():
    n, U, V = 2, 2, 1  # at x = 1
    return n * V - U == 0 and D(numbers(1, 1), numbers(1, 1), 0) != 0


def no_angle():
    return D(numbers(1, 1), numbers(0, 1), 0) != 0  # the imaginary part of 1 is 0


def one_change():
    L, k, q = numbers(1, 1, 1), numbers(6, 0, 3), [Fraction(0), Fraction(1, 2), Fraction(-1)]
    return D(L, k, 4) == 0 and is_mode(L, k, Fraction(6), q, Fraction(0))  # the second mode


# theorem, hypothesis as README.md words it, theory, what stands there, what is put in its place, counterexample
LINKS = "links : chain_of_links n L k"
ONE = "one : at_most_one_passive n k"
NO_ONE = "one : forall i j : nat, i = j -> i = j"
CASES = [
    ("definite.M_definite", "lengths positive", "definite",
     "Theorem M_definite q : (forall i, (i < n)%N -> 0 < L i) ->", "Theorem M_definite q : True ->", definite),
    ("definite.rank_A", "lengths not zero", "definite",
     "Theorem rank_A : (forall i, (i < n)%N -> L i != 0) ->", "Theorem rank_A : True ->", rank_of_A),
    ("definite.det_B_zero", "L > 0, k ≥ 0", "definite",
     "Theorem det_B_zero : (forall i, (i < n)%N -> 0 < L i) -> (forall i, (i < n)%N -> 0 <= k i) ->",
     "Theorem det_B_zero : True -> True ->", passive_joints_and_det_B),
    ("definite.energy_factor", "lengths positive", "definite",
     "Theorem energy_factor F q Fy : (forall i, (i < n)%N -> 0 < L i) ->", "Theorem energy_factor F q Fy : True ->",
     energy_factor),
    ("determinant.recursion_det", "zᵢ not zero", "determinant",
     "Theorem recursion_det m z k F : (forall i, (i <= m)%N -> z i != 0) ->", "Theorem recursion_det m z k F : True ->",
     determinant_of_recursion),
    ("recursion.string_theorem", "not both ends passive", "recursion",
     "0 <= k 0%N -> 0 <= k m.+1 -> 0 < k 0%N \\/ 0 < k m.+1 ->", "0 <= k 0%N -> 0 <= k m.+1 -> True ->", both_ends_passive),
    ("recursion.string_theorem", "inner k > 0", "recursion",
     "Theorem string_theorem m z k : distances m.+1 z -> (forall i, (0 < i <= m)%N -> 0 < k i) ->",
     "Theorem string_theorem m z k : distances m.+1 z -> True ->", passive_inside),
    ("forces.critical_forces", "one passive joint at most", "forces", ONE, NO_ONE, two_passive),
    ("forces.critical_forces", "k ≥ 0", "forces", LINKS,
     "links : (forall i, (i < n)%N -> 0 < L i) /\\ (forall i, (i < n)%N -> 0 <= k i ^+ 2)", negative_stiffness),
    ("forces.critical_forces", "L > 0", "forces", LINKS,
     "links : (forall i, (i < n)%N -> 0 <= L i ^+ 2) /\\ (forall i, (i < n)%N -> 0 <= k i)", negative_length),
    ("forces.simple_forces", "no interior passive joint", "forces",
     "Theorem simple_forces fs : no_interior_passive n k ->", "Theorem simple_forces fs : True ->", equal_forces),
    ("eigenvalues.rank_B", "one passive joint at most", "eigenvalues", ONE, NO_ONE, rank_of_a_mechanism),
    ("eigenvalues.semisimple", "the eigenvalue is not zero", "eigenvalues",
     "Theorem semisimple a (v : 'cV[R]_(n + 1)) : a != 0 ->", "Theorem semisimple a (v : 'cV[R]_(n + 1)) : True ->",
     block_at_zero),
    ("stability.energy_squares", "no H_i zero", "stability",
     "(j <= m)%N -> (forall i, (i <= j)%N -> (H z k i).[F] != 0) ->\n", "(j <= m)%N -> True ->\n", zero_on_the_way),
    ("stability.stable_below", "below all critical forces", "stability",
     "Theorem stable_below fs F q : roots_of (D n L k) fs -> all (fun f => F < f) fs ->",
     "Theorem stable_below fs F q : roots_of (D n L k) fs -> all (fun f => F <= f) fs ->", at_the_lowest_force),
    ("stability.stable_below", "the end on the axis", "stability",
     "q != 0 -> (S0 n L)^T *m q = 0 -> 0 < second_variation F q.", "q != 0 -> True -> 0 < second_variation F q.",
     off_the_axis),
    ("monotone.forces_monotone", "no stiffness falls", "monotone",
     "Hypothesis stiffer : forall i, (i < n)%N -> k i <= k' i.", "Hypothesis stiffer : forall i, (i < n)%N -> k i <= k i.", softer),
    ("monotone.forces_monotone", "L > 0", "monotone",
     "(links : chain_of_links n L k)", "(links : forall i, (i < n)%N -> 0 <= k i)", negative_length_and_stiffer),
    ("interlacing.raised_interlaced", "the others stay", "interlacing",
     "j != i -> k' j = k j)", "j != i -> k j <= k' j)", all_raised),
    ("interlacing.cut_passive_base", "the base passive", "interlacing",
     "Theorem cut_passive_base fs cs m : k 0%N = 0 ->", "Theorem cut_passive_base fs cs m : True ->", elastic_base_cut),
    ("orientations.free_row", "F not zero", "orientations", "k 0%N = 0 -> F != 0 ->", "k 0%N = 0 -> True ->", turns_as_a_whole),
    ("orientations.free_row", "the base passive", "orientations", "k 0%N = 0 -> F != 0 ->", "True -> F != 0 ->", lateral_force),
    ("reversal.mode_backwards", "the base passive", "reversal", "(base : k 0%N = 0).\n\nTheorem mode_backwards",
     "(base : k 0%N = k 0%N).\n\nTheorem mode_backwards", elastic_base_reversed),
    ("equal_links.critical_equal", "F not zero", "equal_links", "(F0 : F != 0)", "(F0 : F == F)", equal_at_zero),
    ("equal_links.equal_on_passive_base", "s not zero", "equal_links", "(s0 : s != 0)", "(s0 : s == s)", no_angle),
    ("nodes.nodes", "no interior passive joint", "nodes",
     "Theorem nodes fs m (f : nat -> R) Fy : no_interior_passive n k ->", "Theorem nodes fs m (f : nat -> R) Fy : True ->", one_change),
]


def proof_breaks(coqc, compiled, case):
    """Whether Coq refuses the theory without the hypothesis, in the proof and not for a slip in the statement."""
    theorem, _, theory, hypothesis, instead, _ = case
    text = (HERE / f"{theory}.v").read_text(encoding="utf-8")
    if text.count(hypothesis) < 1:
        return f"{theory}.v does not have: {hypothesis}"
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "weakened.v"
        file.write_text(text.replace(hypothesis, instead), encoding="utf-8")
        run = subprocess.run([coqc, "-q", "-w", "none", "-Q", compiled, "", file.name], cwd=folder, capture_output=True,
                             text=True, check=False)
    if run.returncode == 0:
        return f"{theorem}: proved without its hypothesis"
    line = int(run.stderr.split('", line ', 1)[1].split(",")[0])
    before = text.replace(hypothesis, instead).splitlines()[:line]
    proof = max((i for i, words in enumerate(before) if words.startswith("Proof.") or " Proof. " in words), default=0)
    ended = max((i for i, words in enumerate(before[:-1]) if words.endswith("Qed.")), default=0)
    return None if proof >= ended else f"{theorem}: refused outside of a proof: {run.stderr}"


def main():
    coqc, compiled, readme = sys.argv[1], str(pathlib.Path(sys.argv[2]).resolve()), sys.argv[3]
    table = pathlib.Path(readme).read_text(encoding="utf-8").split("## Why the hypotheses", 1)[1].split("\n## ", 1)[0]
    rows = {tuple(cell.strip() for cell in line.strip("|").split("|")[:2]) for line in table.splitlines() if line.startswith("| `")}
    stated = {(f"`{theorem}`", hypothesis) for theorem, hypothesis, *_ in CASES}
    wrong = [f"only in one of README.md and this test: {row}" for row in sorted(rows ^ stated)]
    wrong += [f"{case[0]}, {case[1]}: the counterexample is none" for case in CASES if not case[-1]()]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        wrong += filter(None, pool.map(lambda case: proof_breaks(coqc, compiled, case), CASES))
    for item in wrong:
        print(item)
    print(f"{len(CASES)} hypotheses left out, {len(wrong)} complaints")
    sys.exit(bool(wrong))


main()
