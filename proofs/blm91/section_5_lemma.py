# SPDX-License-Identifier: MIT
"""Section V, Lemma 5.1: which periods occur for kappa > 1, a lemma on coprime fractions.

Wanted is, for an integer p, a fraction q/p in lowest terms with 1/4 <= q/p <
1/2. There is one for every p >= 3 except 6, and it can be written down:

    p = 2j + 1: q = j           p - 2q = 1
    p = 4j:     q = 2j - 1      (2j - 1)q - (j - 1)p = 1
    p = 8j + 2: q = 4j - 1      j(p - 2q) - q = 1
    p = 8j + 6: q = 4j + 1      q - j(p - 2q) = 1

with p - 2q > 0, and 4q - p = 2j - 1, 4j - 4, 8j - 6, 8j - 2 in turn, so that
j >= 1 is enough; left over are p = 1, 2, 6, where nothing works.

The paper argues with a prime p' between [p/4] and 2[p/4] (Bertrand), and with p'
+- 1 when p' divides p. Its inequality (5.9) is printed with 1/4 where pi/4 is meant, and the lemma cites (5.6) for it.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import evaluation, example, identity, instances, steps
from exactkf.language import *
from proofs.blm91.notation import GCD, gcd

p, q, d, j, k, r, s, x, pi, kappa, A, v, alpha1 = symbols("p q d j k r s x pi kappa A v alpha1")
coprime_, divides, prime, good, bad, inside, lo, hi, last, down = symbols("coprime divides prime good bad inside lo hi last down")

#: d divides x; q and p have no common divisor but 1; x is prime
DIVIDES = function(divides, [d, x], when(d >= x, d == x, divides(d, x - d)))
COPRIME = (DIVIDES, function(coprime_, [p, q], forall(d, 2, q, ~(divides(d, q) & divides(d, p)))))
PRIME = (DIVIDES, function(prime, [x], (x > 1) & forall(d, 2, x - 1, ~divides(d, x))))
PI = {pi: scalar()}
PI_BOUNDS = [standing("pi", (pi > rational("3.141592")) & (pi < rational("3.141593")))]
PRINTED = (rational("1/4") <= q / p * pi) & (q / p * pi < pi / 2)  # (5.9) as printed
MEANT = (p <= 4 * q) & (2 * q < p)  # 1/4 <= q/p < 1/2

# ---------------------------------------------------------------------- the lemma
ESCAPE = (let(A, rows([[2 / kappa, -1], [1, 0]])), let(v, inv(A) * rows([[0], [1]])), let(alpha1, 2 / kappa))
p1, q1, p2, q2, p3, q3, p4, q4 = symbols("p1 q1 p2 q2 p3 q3 p4 q4")
FAMILIES = (let(p1, 2 * j + 1), let(q1, j), let(p2, 4 * j), let(q2, 2 * j - 1), let(p3, 8 * j + 2), let(q3, 4 * j - 1), let(p4, 8 * j + 6), let(q4, 4 * j + 1))
WITNESS = ((p1 - 2 * q1 == 1) & ((2 * j - 1) * q2 - (j - 1) * p2 == 1) & (j * (p3 - 2 * q3) - q3 == 1) & (q4 - j * (p4 - 2 * q4) == 1)
           & (p2 - 2 * q2 == 2) & (p3 - 2 * q3 == 4) & (p4 - 2 * q4 == 4)
           & (4 * q1 - p1 == 2 * (j - 1) + 1) & (4 * q2 - p2 == 4 * (j - 1)) & (4 * q3 - p3 == 8 * (j - 1) + 2) & (4 * q4 - p4 == 8 * (j - 1) + 6))
NOTE_WITNESS = ("The correction is proved for every p by the explicit q of the module's text: Bezout identities make q coprime to p, and 4q - p >= 0, p - 2q > 0 are "
                "written as equations with j - 1 >= 0.")
claim("BLM91-L5.1.1", "a coprime q exists for p >= 3 other than 6, with (5.6) for q",
      exists(q, 1, p - 1, coprime_(p, q) & (alpha1 == v[1, 1])), over={p: integer(3, 40), kappa: scalar()}, where=[*COPRIME, *ESCAPE],
      given=[standing("p not 6", p != 6), standing("kappa > 1", kappa > 1)],
      by=[example(p=3, kappa=3), instances()],
      repair=repair("cross-reference", "(5.6) is a formula for escaping points and says nothing about q; meant is the double inequality of (5.9), and there pi/4 <= q pi/p < pi/2",
                    WITNESS, over={j: scalar()}, where=FAMILIES, by=[identity(), instances()]),
      note="As printed q is to satisfy (5.6), that is alpha^(i) = v_1^(i) for the point escaping at step i; taken at i = 1, where alpha^(1) = 2/kappa "
           "is the pole of (5.1), and kappa = 3, which has arctan sqrt(kappa^2 - 1) outside Q pi. " + NOTE_WITNESS)
NONE = forall(p, 1, 6, iff(exists(q, 1, p - 1, coprime_(p, q) & MEANT), (p == 3) | (p == 4) | (p == 5)))
claim("BLM91-L5.1.2", "no such q for p = 1, 2, 6",
      ~exists(q, 1, p - 1, coprime_(p, q) & PRINTED), over={p: integer(1, 6), **PI}, where=[*COPRIME],
      given=[given("exceptional p", (p == 1) | (p == 2) | (p == 6)), *PI_BOUNDS],
      by=[example(p=6, pi="3.1415926"), instances(using={x: positive()}, made_by={pi: rational("3.141592") + rational("1/1000000") / (1 + x)})],
      repair=repair("factor", "(5.9) has lost a factor pi on its left: with 1/4 <= q pi/p the number q = 1 serves for p = 6; with 1/4 <= q/p, that is pi/4 <= q pi/p, there is none",
                    NONE, where=[*COPRIME], by=[evaluation()]),
      note="Such q is read as: coprime to p, 1 <= q < p, with (5.9) as printed; pi enters by rational bounds. The lemma itself refers to (5.6).")
count = sym("count")
COUNT = function(count, [p], sum_of(q, 1, p - 1, when((p <= 4 * q) & (2 * q < p), when(gcd(p, q) == 1, 1, 0), 0)))
claim("BLM91-L5.1", "coprime fractions, both parts",
      iff(exists(q, 1, p - 1, coprime_(p, q) & PRINTED), ~((p == 1) | (p == 2) | (p == 6))), over={p: integer(1, 40), **PI}, where=[*COPRIME], given=PI_BOUNDS,
      by=[example(p=6, pi="3.1415926"), instances(using={x: positive()}, made_by={pi: rational("3.141592") + rational("1/1000000") / (1 + x)})],
      repair=repair("factor", "the lower bound of (5.9) is pi/4, not 1/4, and (5.9) is meant where (5.6) is cited",
                    WITNESS & (count(1) == 0) & (count(2) == 0) & (count(6) == 0), over={j: scalar()}, where=[*FAMILIES, GCD, COUNT], by=[identity(), instances()]),
      note="With (5.9) as printed in place of (5.6). The correction holds for every p: p = 2j + 1, 4j, 8j + 2, 8j + 6, j >= 1, are all p >= 3 but 6, the first four equations of the module's text make q coprime to p, the "
           "others give 0 < p - 2q and 0 <= 4q - p; count(p) is the number of q that serve.")

# ---------------------------------------------------------------------- the paper's proof, p = 4r + s
BETWEEN = (let(lo, r + 1), let(hi, 2 * r - 1), function(inside, [x], (r < x) & (x < 2 * r)))
claim("BLM91-E5.11", "q between [p/4] and 2[p/4] serves",
      forall(q, lo, hi, (rational("1/4") < q / p) & (q / p < rational("1/2"))), over={r: integer(1, 100), s: integer(0, 3)},
      where=[let(p, 4 * r + s), *BETWEEN],
      by=[steps(facts=["an integer above r is at least r + 1"], prose="4q >= 4r + 4 > p and 2q <= 4r - 2 < p"), instances(80), example(r=3, s=3), example(r=2, s=3)],
      note="Shown is 1/4 < q/p < 1/2, that is (5.9) with pi/4 for its printed lower bound 1/4, which is the stronger inequality; also for p < 10.")
claim("BLM91-S92", "a prime between [p/4] and 2[p/4]", (r < last) & prime(last), over={r: integer(2, 40)},
      where=[*PRIME, function(down, [x], when(prime(x), x, down(x - 1))), let(last, down(2 * r - 1))],
      by=[steps(facts=["Bertrand's postulate: there is a prime between r and 2r for every r > 1"], prose="r = [p/4] >= 2 for p >= 10"),
          instances(60), example(r=2), example(r=3)], note="The largest prime below 2r is larger than r.")
claim("BLM91-S93", "p = 4r: the prime does not divide p", forall(q, lo, hi, prime(q) >> ~divides(q, p)), over={r: integer(3, 25)},
      where=[let(p, 4 * r), *PRIME, *BETWEEN],
      by=[steps(facts=["a prime that divides a product divides a factor"], prose="it would divide 4 or r, and it is larger than r >= 3"), instances(60), example(r=3)], note="p >= 10 makes r >= 3.")
claim("BLM91-S94", "p = 4r + 2: the prime does not divide p", forall(q, lo, hi, prime(q) >> ~divides(q, p)), over={r: integer(2, 25)},
      where=[let(p, 4 * r + 2), *PRIME, *BETWEEN],
      by=[steps(facts=["a prime that divides a product divides a factor"], prose="it would divide 2r + 1, being larger than 2, with a quotient strictly between "
                "1 and 2, as r < q < 2r"), instances(60), example(r=4)])
BAD = function(bad, [q], prime(q) & divides(q, p))
claim("BLM91-S95", "p = 4r + 1: a neighbour of the prime serves", forall(q, lo, hi, bad(q) >> good(q)), over={r: integer(3, 25)},
      where=[let(p, 4 * r + 1), *PRIME, *COPRIME, *BETWEEN, BAD,
             function(good, [q], (p == 3 * q) & inside(q + 1) & inside(q - 1) & (coprime_(p, q + 1) | coprime_(p, q - 1)))],
      by=[steps(facts=["of three consecutive integers one is divisible by 3"],
                prose="(4r + 1)/q lies between 2 and 4, so p = 3q; then q - r and 2r - q are (r + 1)/3 and (2r - 1)/3, more than 1 for r >= 3; q is not 3, so not "
                      "both neighbours are multiples of 3, and q divides neither"),
          instances(60), example(r=5), example(r=8), example(r=14)],
      note="bad(q): q is prime and divides p; good(q): p = 3q, both q + 1 and q - 1 satisfy (5.11), one of them is coprime to p.")
ONE = (inside(q + 1) & coprime_(p, q + 1)) | (inside(q - 1) & coprime_(p, q - 1))
claim("BLM91-S96", "p = 4r + 3: a neighbour of the prime serves", forall(q, lo, hi, bad(q) >> good(q)), over={r: integer(2, 25)},
      where=[let(p, 4 * r + 3), *PRIME, *COPRIME, *BETWEEN, BAD, function(good, [q], (p == 3 * q) & inside(q + 1) & inside(q - 1) & ONE)],
      by=[example(r=3), instances(60)],
      repair=repair("boundary case", "for p = 15, where r = 3 and 5 is the only prime between, p' + 1 = 6 is not less than 2[p/4] = 6; q = p' - 1 = 4 serves there, so the lemma stands",
                    forall(q, lo, hi, bad(q) >> good(q)), over={r: integer(2, 25)},
                    where=[let(p, 4 * r + 3), *PRIME, *COPRIME, *BETWEEN, BAD,
                           function(good, [q], (p == 3 * q) & iff(inside(q + 1), p != 15) & inside(q - 1) & ONE)],
                    by=[instances(60), example(r=3), example(r=9), example(r=12)]),
      note="good(q): p = 3q, both q + 1 and q - 1 satisfy (5.11), one that does is coprime to p.")
