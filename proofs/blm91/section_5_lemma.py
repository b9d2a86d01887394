# SPDX-License-Identifier: MIT
"""Section V, Lemma 5.1: which periods occur for kappa > 1, a lemma on coprime fractions.

Wanted is, for an integer p, a fraction q/p in lowest terms with 1/4 <= q/p <
1/2. There is one for every p >= 3 except 6, and it can be written down:

    p = 2j + 1: q = j           p - 2q = 1
    p = 4j:     q = 2j - 1      (2j - 1)q - (j - 1)p = 1
    p = 8j + 2: q = 4j - 1      j(p - 2q) - q = 1
    p = 8j + 6: q = 4j + 1      q - j(p - 2q) = 1

with p - 2q > 0, and 4q - p = 2j - 1, 4j - 4, 8j - 6, 8j - 2 in turn, so that
j >= 1 is enough; left over are p = 1, 2, 6, where nothing works. That p and q
are coprime follows from the last column: with p = d b and q = d a for some d >= 2
it says that d divides 1. Every claim here but Bertrand's postulate is proved for
all integers at once: what is denied contradicts itself in each of finitely many cases.

The paper argues with a prime p' between [p/4] and 2[p/4] (Bertrand), and with p'
+- 1 when p' divides p. Its inequality (5.9) is printed with 1/4 where pi/4 is meant, and the lemma names (5.6) for it.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import arithmetic, at_index, by_cases, by_rests, example, instances, steps
from exactkf.language import *

p, q, d, d1, i, i1, i2, i3, i4, j, r, s, x, y = symbols("p q d d1 i i1 i2 i3 i4 j r s x y")
coprime_, divides, prime, good, bad, inside, lo, hi, last, down, serves = symbols("coprime divides prime good bad inside lo hi last down serves")

#: d divides x; x and y have no common divisor but 1; x is prime
DIVIDES = function(divides, [d, x], exists(i, 1, x, d * i == x))
COPRIME = (DIVIDES, function(coprime_, [x, y], forall(d, 2, y, ~(divides(d, y) & divides(d, x)))))
PRIME = (DIVIDES, function(prime, [x], (x > 1) & forall(d, 2, x - 1, ~divides(d, x))))
EXCEPTIONAL = (p == 1) | (p == 2) | (p == 6)

# ---------------------------------------------------------------------- the lemma
p1, q1, p2, q2, p3, q3, p4, q4 = symbols("p1 q1 p2 q2 p3 q3 p4 q4")
FAMILIES = (let(p1, 2 * j + 1), let(q1, j), let(p2, 4 * j), let(q2, 2 * j - 1), let(p3, 8 * j + 2), let(q3, 4 * j - 1), let(p4, 8 * j + 6), let(q4, 4 * j + 1))


def fits(p, q):
    """q is prime to p, and 1/4 <= q/p < 1/2."""
    return coprime_(p, q) & (p <= 4 * q) & (2 * q < p)


#: with q = d i and p = d i1, what d times is 1
BEZOUT = [i1 - 2 * i, 2 * i - i1, (2 * j - 1) * i - (j - 1) * i1, j * (i1 - 2 * i) - i, i - j * (i1 - 2 * i)]
claim("BLM91-X.12", "a fraction with denominator p between 1/4 and 1/2, in lowest terms, written down", fits(p1, q1) & fits(p2, q2) & fits(p3, q3) & fits(p4, q4),
      sizes=["j"], where=[*COPRIME, *FAMILIES], given=[given("positive", j >= 1)], by=[arithmetic(*(by_cases(z >= 1) for z in BEZOUT)), instances(j=range(1, 6)), example(j=0)],
      note="p = 2j + 1, 4j, 8j + 2, 8j + 6 with j >= 1 are all p >= 3 but 6.")
#: is there such a q for p
SERVES = (*COPRIME, function(serves, [x], exists(q, 1, x - 1, fits(x, q))))
READ = "The lemma names (5.6), a formula for escaping points; the double inequality of the case kappa > 1 is (5.9), with its lower bound pi/4. (With the bound 1/4 in its print q = 1 would serve for p = 6 too: the misprint of E5.9, not counted twice.)"
#: p = 8j, .., 8j + 7: q, and what a common divisor d times is 1
WRITTEN = [(4 * j - 1, (4 * j - 1) * i - (2 * j - 1) * i1), (4 * j, i1 - 2 * i), (4 * j - 1, j * (i1 - 2 * i) - i), (4 * j + 1, i1 - 2 * i),
           (4 * j + 1, (4 * j + 1) * i - 2 * j * i1), (4 * j + 2, i1 - 2 * i), (4 * j + 1, i - j * (i1 - 2 * i)), (4 * j + 3, i1 - 2 * i)]
FAMILY = [by_rests(p, 8, j, [[at_index(q, q_), by_cases(one >= 1)] for q_, one in WRITTEN])]
#: for p = 6 only q = 2 is left, which 2 divides
NONE = [by_cases(q >= 3), at_index(d, 2), at_index(i, 1), at_index(i, 3)]
claim("BLM91-L5.1.1", "a coprime q exists for p >= 3 other than 6", serves(p), sizes=["p"], where=SERVES, given=[given("p at least 3", p >= 3), given("p not 6", p != 6)],
      by=[arithmetic(*FAMILY), instances(p=(*range(3, 21), 30, 42)), example(p=6), example(p=2)], note=READ + " For every p, by the q written down in X.12.")
claim("BLM91-L5.1.2", "no such q for p = 1, 2, 6", ~serves(p), sizes=["p"], where=SERVES, given=[given("exceptional p", EXCEPTIONAL)],
      by=[arithmetic(*NONE), instances(p=(1, 2, 6)), example(p=3)], note=READ)
claim("BLM91-L5.1", "coprime fractions, both parts", iff(serves(p), ~EXCEPTIONAL), sizes=["p"], where=SERVES, given=[given("positive", p >= 1)],
      by=[arithmetic(by_cases(EXCEPTIONAL, NONE, FAMILY)), instances(p=(*range(1, 21), 30, 42)), example(p=0)], note=READ + " For every p >= 1.")

# ---------------------------------------------------------------------- the paper's proof, p = 4r + s
BETWEEN = (let(lo, r + 1), let(hi, 2 * r - 1), function(inside, [x], (r < x) & (x < 2 * r)))
claim("BLM91-E5.11", "q between [p/4] and 2[p/4] serves",
      forall(q, lo, hi, (p < 4 * q) & (2 * q < p)), sizes=["r"], over={s: integer(0, 3)}, where=[let(p, 4 * r + s), *BETWEEN],
      by=[arithmetic(), instances(40, r=range(1, 8)), example(r=3, s=3), example(r=2, s=3)],
      note="Shown is 1/4 < q/p < 1/2, that is (5.9) with pi/4 for its printed lower bound 1/4, which is the stronger inequality; for every p, also for p < 10.")
claim("BLM91-S92", "a prime between [p/4] and 2[p/4]", (r < last) & prime(last), over={r: integer(2, 40)},
      where=[*PRIME, function(down, [x], when(prime(x), x, down(x - 1))), let(last, down(2 * r - 1))],
      by=[steps(facts=["Bertrand's postulate: there is a prime between r and 2r for every r > 1"], prose="r = [p/4] >= 2 for p >= 10"),
          instances(60), example(r=2), example(r=3)], note="The largest prime below 2r is larger than r.")
#: p = q i; the quotient i is 3, and 2 divides q
QUOTIENT = [by_cases(i == 3), by_rests(q, 2, j), at_index(d, 2), at_index(i, j)]
claim("BLM91-S93", "p = 4r: the prime does not divide p", forall(q, lo, hi, prime(q) >> ~divides(q, p)), sizes=["r"], given=[standing("p at least 10", r >= 3)],
      where=[let(p, 4 * r), *PRIME, *BETWEEN], by=[arithmetic(*QUOTIENT), instances(r=range(3, 16)), example(r=3)],
      note="p >= 10 makes r >= 3. The quotient would be 3, and q a multiple of 4.")
claim("BLM91-S94", "p = 4r + 2: the prime does not divide p", forall(q, lo, hi, prime(q) >> ~divides(q, p)), sizes=["r"], given=[standing("p at least 10", r >= 2)],
      where=[let(p, 4 * r + 2), *PRIME, *BETWEEN], by=[arithmetic(*QUOTIENT), instances(r=range(2, 16)), example(r=4)],
      note="The quotient would be 3, and q an even number.")
BAD = function(bad, [q], prime(q) & divides(q, p))
#: p = q i = 3 q; d and d1, which divide p and q + 1 or q - 1, are 3
NEIGHBOURS = [by_cases(i == 3), by_rests(r, 3, j), by_cases(3 * i1 - i2 == 1), by_cases(d == 3), by_cases(i4 - 3 * i3 == 1), by_cases(d1 == 3), by_cases(i1 > i3)]
claim("BLM91-S95", "p = 4r + 1: a neighbour of the prime serves", forall(q, lo, hi, bad(q) >> good(q)), sizes=["r"], given=[given("p at least 10", r >= 3)],
      where=[let(p, 4 * r + 1), *PRIME, *COPRIME, *BETWEEN, BAD,
             function(good, [q], (p == 3 * q) & inside(q + 1) & inside(q - 1) & (coprime_(p, q + 1) | coprime_(p, q - 1)))],
      by=[arithmetic(*NEIGHBOURS), instances(r=range(3, 15)), example(r=2), example(r=5), example(r=8), example(r=14)],
      note="bad(q): q is prime and divides p; good(q): p = 3q, both q + 1 and q - 1 satisfy (5.11), one of them is coprime to p.")
ONE = (inside(q + 1) & coprime_(p, q + 1)) | (inside(q - 1) & coprime_(p, q - 1))
claim("BLM91-S96", "p = 4r + 3: a neighbour of the prime serves", forall(q, lo, hi, bad(q) >> good(q)), sizes=["r"], given=[standing("p at least 10", r >= 2)],
      where=[let(p, 4 * r + 3), *PRIME, *COPRIME, *BETWEEN, BAD, function(good, [q], (p == 3 * q) & inside(q + 1) & inside(q - 1) & ONE)],
      by=[example(r=3), instances(r=range(2, 15))],
      repair=repair("boundary case", "for p = 15, where r = 3 and 5 is the only prime between, p' + 1 = 6 is not less than 2[p/4] = 6; q = p' - 1 = 4 serves there, so the lemma stands",
                    forall(q, lo, hi, bad(q) >> good(q)), sizes=["r"], given=[standing("p at least 10", r >= 2)],
                    where=[let(p, 4 * r + 3), *PRIME, *COPRIME, *BETWEEN, BAD,
                           function(good, [q], (p == 3 * q) & iff(inside(q + 1), p != 15) & inside(q - 1) & ONE)],
                    by=[arithmetic(by_cases(i == 4), *NEIGHBOURS, by_cases(j == 1, [by_cases(4 * i1 > i2)])), instances(r=range(2, 15)), example(r=3), example(r=9), example(r=12)]),
      note="good(q): p = 3q, both q + 1 and q - 1 satisfy (5.11), one that does is coprime to p.")
