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
+- 1 when p' divides p. Its inequality (5.9) is printed with 1/4 where pi/4 is meant, and the lemma names (5.6) for it.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import evaluation, example, identity, instances, restated, steps
from exactkf.language import *

p, q, d, j, k, r, s, x = symbols("p q d j k r s x")
coprime_, divides, prime, good, bad, inside, lo, hi, last, down, serves = symbols("coprime divides prime good bad inside lo hi last down serves")

#: d divides x; q and p have no common divisor but 1; x is prime
DIVIDES = function(divides, [d, x], when(d >= x, d == x, divides(d, x - d)))
COPRIME = (DIVIDES, function(coprime_, [p, q], forall(d, 2, q, ~(divides(d, q) & divides(d, p)))))
PRIME = (DIVIDES, function(prime, [x], (x > 1) & forall(d, 2, x - 1, ~divides(d, x))))
MEANT = (p <= 4 * q) & (2 * q < p)  # 1/4 <= q/p < 1/2

# ---------------------------------------------------------------------- the lemma
p1, q1, p2, q2, p3, q3, p4, q4 = symbols("p1 q1 p2 q2 p3 q3 p4 q4")
FAMILIES = (let(p1, 2 * j + 1), let(q1, j), let(p2, 4 * j), let(q2, 2 * j - 1), let(p3, 8 * j + 2), let(q3, 4 * j - 1), let(p4, 8 * j + 6), let(q4, 4 * j + 1))
WITNESS = ((p1 - 2 * q1 == 1) & ((2 * j - 1) * q2 - (j - 1) * p2 == 1) & (j * (p3 - 2 * q3) - q3 == 1) & (q4 - j * (p4 - 2 * q4) == 1)
           & (p2 - 2 * q2 == 2) & (p3 - 2 * q3 == 4) & (p4 - 2 * q4 == 4)
           & (4 * q1 - p1 == 2 * (j - 1) + 1) & (4 * q2 - p2 == 4 * (j - 1)) & (4 * q3 - p3 == 8 * (j - 1) + 2) & (4 * q4 - p4 == 8 * (j - 1) + 6))
claim("BLM91-X.12", "a fraction with denominator p between 1/4 and 1/2, in lowest terms, for every p", WITNESS, over={j: scalar()}, where=FAMILIES,
      by=[identity(), restated("Bezout: numbers of which a combination with integer coefficients is 1 are coprime", "every p >= 3 other than 6 is 2j + 1, 4j, 8j + 2 or 8j + 6 for some j >= 1"), instances()],
      note="p = 2j + 1, 4j, 8j + 2, 8j + 6 with j >= 1 are all p >= 3 but 6. The first four equations make q coprime to p; the others give 0 < p - 2q and 4q - p >= 0. That these families exhaust p, and that such a combination makes numbers coprime, are the two facts named; variables over all integers are not in the language.")
#: is there such a q for p
SERVES = (*COPRIME, function(serves, [p], exists(q, 1, p - 1, coprime_(p, q) & MEANT)))
READ = "The lemma names (5.6), a formula for escaping points; the double inequality of the case kappa > 1 is (5.9), with its lower bound pi/4. (With the bound 1/4 in its print q = 1 would serve for p = 6 too: the misprint of E5.9, not counted twice.)"
BEZOUT = ["Bezout: numbers of which a combination with integer coefficients is 1 are coprime"]
LIMITS = (" For every p by X.12, whose identities are proved for every j; integer variables of a statement are bounded, so that the residue of p and Bezout stand as named facts in prose, and the formula itself is tried for p up to 60.")
ALL_P = "the four families of X.12 are all p >= 3 but 6, and their q serve"
claim("BLM91-L5.1.1", "a coprime q exists for p >= 3 other than 6", serves(p), over={p: integer(3, 60)}, where=SERVES, given=[given("p not 6", p != 6)],
      by=[steps("BLM91-X.12", facts=BEZOUT, prose=ALL_P), instances(57), example(p=6)], note=READ + LIMITS)
claim("BLM91-L5.1.2", "no such q for p = 1, 2, 6", ~serves(p), over={p: integer(1, 6)}, where=SERVES, given=[given("exceptional p", (p == 1) | (p == 2) | (p == 6))],
      by=[evaluation(), instances(), example(p=3)], note=READ)
claim("BLM91-L5.1", "coprime fractions, both parts", iff(serves(p), ~((p == 1) | (p == 2) | (p == 6))), over={p: integer(1, 60)}, where=SERVES,
      by=[steps("BLM91-X.12", "BLM91-L5.1.2", facts=BEZOUT, prose=ALL_P + "; for p = 1, 2, 6 no q does"), instances(60), example(p=1), example(p=2), example(p=6)], note=READ + LIMITS)

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
                    by=[steps(facts=["of three consecutive integers one is divisible by 3"],
                              prose="(4r + 3)/q lies between 2 and 6 and is odd, and 5q = 4r + 3 < 5r + 5 leaves no q above r; so p = 3q, r = 3s, q = 4s + 1; q - r = s + 1 and 2r - q = 2s - 1, more than 1 for s >= 2; "
                                    "q is not 3, so not both neighbours are multiples of 3, and q divides neither; s = 1 is p = 15"),
                        instances(60), example(r=3), example(r=9), example(r=12)]),
      note="good(q): p = 3q, both q + 1 and q - 1 satisfy (5.11), one that does is coprime to p.")
