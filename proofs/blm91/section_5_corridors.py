# SPDX-License-Identifier: MIT
"""Section V, (5.4)-(5.10): the Riccati equation, rotations, and the proof of Theorem 3.7.

alpha = alpha_0/(1 - pi) carries the scalar Riccati equation into the map alpha' =
1/(2/kappa - alpha) of the first section, so that the two are one system in two
coordinates; phi(pi) = (1 - pi)^2 (alpha^2 - (2/kappa) alpha + 1).

For |kappa| > 1 put 1/kappa = cos(theta), 0 < theta < pi. In the basis (cos(theta), 1)',
(-sin(theta), 0)' the matrix A is the rotation by theta (in the given basis it is not). A line comes back
after t steps when t theta is a multiple of pi; if theta = pi n/d in lowest terms that is every d-th step. Slopes that end at
infinity are alpha^(i) = U_i/U_(i-1), U_(i-1) = sin(i theta)/sin(theta); i = 1, .., d - 1.

A point of the hyperbola is told by a = alpha - gamma, b = alpha + gamma with 1 + ab = lambda(a + b), lambda = 1/kappa:
b = (lambda a - 1)/(a - lambda), so that a takes every value but lambda. The step of a is that of
the matrix A_1 = I - A, whose eigenvalues 1 - exp(-+ i theta) have the arguments +- omega, omega = (pi -
theta)/2. So a, and with it the point, has the period p for omega = pi q/p in lowest terms. kappa > 1 is 1/4 < q/p < 1/2,
kappa < -1 is 0 < q/p < 1/4, and p = 4 belongs to kappa infinite.

The slope alpha^(d-1) is 0. Its points (0, 1), (0, -1) have |gamma| = 1, so that the algorithm ends there
at once, while the slope map goes on through 1/(2 lambda): in counts of escaping points that is a special case.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import arithmetic, by_cases, cleared, example, identity, induction, instances, square_of, steps, valued
from exactkf.language import *
from proofs.blm91.consequences_angles import ANGLE as BY_ANGLE
from proofs.blm91.consequences_angles import LOWEST
from proofs.blm91.lemmas_turns import LINES_TURN, OF_LINES, SINES_D, X1, X2, v1, v2
from proofs.blm91.notation import *

A, B, p, y, bp, bm, vp, vm, V, Lp, Lm, be, v, pit, phi_, Rot, Pb, Pw = symbols("A B p y beta_plus beta_minus v_plus v_minus v L_plus L_minus b v_i pi_t phi_pi Rot P Apow")
gcd, d, odd, back, whole, far, flag, fx, near, away, cs, sn, nn = symbols("gcd d between back whole far region f_x image stays cos sin n_angle")
A_KAPPA = let(A, rows([[2 / kap, -1], [1, 0]]))
A_LAMBDA = let(A, rows([[2 * lam, -1], [1, 0]]))
KAPPA = let(kap, 2 * al0 / (1 + al0**2 - ga0**2))
POINT = {al0: nonzero(), ga0: scalar()}
RICCATI = rec(pit, t, x, (al0 - ga0) ** 2 * pit[t] + (ga0 + (al0 - ga0) * pit[t]) ** 2 / (1 - pit[t]))
PHI = let(phi_, x**2 - 2 * (1 - al0 / kap) * x + ga0**2)

# ---------------------------------------------------------------------- conjugacy of (4.7) and (5.1)
claim("BLM91-E5.4", "the Riccati equation in the coordinate alpha",
      always(t, be[t] == al0 / (1 - pit[t])), over={**POINT, x: scalar()}, where=[KAPPA, RICCATI, rec(be, t, al0 / (1 - x), kap / (2 - kap * be[t]))],
      by=[induction(), instances()], note="x is pi_0, b the orbit of (5.1).")
PRINTED = rows([[1 / al0**2, -1 / al0], [ga0**2 / al0, (al0**2 - ga0**2) / al0]])
MEANT = rows([[1 / al0, -1 / al0], [ga0**2 / al0, (al0**2 - ga0**2) / al0]])
SIMILAR = inv(rows([[1, -1], [al0, 0]])) * A * rows([[1, -1], [al0, 0]])
MOBIUS = (B[2, 1] + B[2, 2] * x) / (B[1, 1] + B[1, 2] * x) == ((al0**2 - ga0**2) * x + ga0**2) / (1 - x)
claim("BLM91-E5.5", "similarity of the two matrices", (B == SIMILAR) & MOBIUS, over={**POINT, x: scalar()}, where=[KAPPA, A_KAPPA, let(B, PRINTED)],
      by=[example(alpha0=2, gamma0=1, x=0), instances()],
      repair=repair("factor", "the first entry is 1/alpha_0, not 1/alpha_0^2", (B == SIMILAR) & MOBIUS, over={**POINT, x: scalar()}, where=[KAPPA, A_KAPPA, let(B, MEANT)],
                    by=[identity(), instances()]),
      note="The second equation says that the left member is a matrix of (4.7') in the sense of (4.24).")
claim("BLM91-S69", "topological conjugacy", (far(fx) == kap / (2 - kap * far(x))) & (1 - al0 / far(x) == x), over={**POINT, x: scalar()},
      where=[KAPPA, function(far, [y], al0 / (1 - y)), let(fx, ((al0**2 - ga0**2) * x + ga0**2) / (1 - x))], by=[identity(), instances()],
      note="far(pi) = alpha_0/(1 - pi) is invertible and carries the map (4.7') into (5.1).")
ROOT = given("p on the hyperbola", p * (1 + al0**2 - ga0**2) == (1 + p**2) * al0)
BETWEEN = function(flag, [t], (be[t] - p) * (be[t] - 1 / p) <= 0)
DRAW_ROOT = dict(using={u: scalar(), s1: nonzero(), y: scalar()}, made_by={
    p: u / (1 + abs(u)), al0: p * ((s1 + SIGN) ** 2 - 1) / ((s1 + SIGN) ** 2 - p**2), ga0: (s1 + SIGN) * (p**2 - 1) / ((s1 + SIGN) ** 2 - p**2)})
claim("BLM91-S70", "what lies between the fixed points", iff(near, odd) & (odd >> away) & (phi_ == (1 - x) ** 2 * (be[0] - p) * (be[0] - 1 / p)), sizes=["m"],
      over={**POINT, p: nonzero(), x: scalar()},
      where=[let(kap, 2 * p / (1 + p**2)), PHI, rec(be, t, al0 / (1 - x), kap / (2 - kap * be[t])), BETWEEN, let(odd, flag(0)), let(near, phi_ <= 0), let(away, defined(be[m]) & flag(m))],
      given=[ROOT, standing("smaller root", abs(p) < 1)],
      by=[steps("BLM91-E5.4", "BLM91-S58", facts=["an iteration has countably many preimages of one point"], prose="p_+ and p_- are 1 - alpha_0/p and 1 - alpha_0 p, where phi is zero by the last equation; a slope between p and 1/p stays there; the escaping slopes are countably many"),
          instances(60, m=(1, 2, 3), using={**DRAW_ROOT["using"]}, made_by={**DRAW_ROOT["made_by"], x: y}),
          instances(40, m=(1, 2), using={**DRAW_ROOT["using"]}, made_by={**DRAW_ROOT["made_by"], x: 1 - al0 / (p + (1 / p - p) / (1 + abs(y)))})],
      note="alpha_+ = p, alpha_- = 1/p; image: phi(pi_0) <= 0; between: alpha between the fixed points; stays: the slope is there still at time m. Outside phi >= 0, and the points that end are countably many.")

# ---------------------------------------------------------------------- rotations
# real and imaginary parts: v_+ = (exp(i theta), 1)', beta_+ = beta_re + i beta_im, lambda_+^t = C_t + i S_t
COMPLEX = (let(cs, (1 - y**2) / (1 + y**2)), let(sn, 2 * y / (1 + y**2)), let(kap, 1 / cs), A_KAPPA, rec(Lp, t, 1, cs * Lp[t] - sn * Lm[t]), rec(Lm, t, 0, sn * Lp[t] + cs * Lm[t]),
           let(vp, rows([[cs], [1]])), let(vm, rows([[sn], [0]])), rec(V, t, 2 * (bp * vp - bm * vm), A * V[t]))
claim("BLM91-S71", "powers of A in complex eigenvectors",
      always(t, (V[t] == 2 * ((bp * Lp[t] - bm * Lm[t]) * vp - (bp * Lm[t] + bm * Lp[t]) * vm)) & (A * vp == cs * vp - sn * vm) & (A * vm == sn * vp + cs * vm) & (cs**2 + sn**2 == 1)),
      over={y: nonzero(), bp: scalar(), bm: scalar()}, where=COMPLEX,
      by=[induction(cofactors=[[(A, 0, 1)], [], [], []]), instances()],
      note="Real and imaginary parts: v_+ is v_plus + i v_minus with eigenvalue cos(theta) + i sin(theta), kappa = 1/cos(theta), y = tan(theta/2); beta_+ is beta_plus + i beta_minus, lambda_+^t is L_plus + i L_minus, "
           "and v_-, lambda_-, beta_- are conjugate, so that the sum is twice the real part. For every theta but 0 and those with cosine 0.")
many = sym("divides")
TURNS = (rec(cs, t, 1, lam * cs[t] - (1 - lam**2) * sn[t]), rec(sn, t, 0, cs[t] + lam * sn[t]))
FRACTIONS = {top: integer(-13, 13), low: integer(1, 13)}
claim("BLM91-S72", "finite and dense orbits on the circle",
      forall(t, 1, 12, iff(cs[t] == 1, back(t))) & near, over=FRACTIONS,
      where=[AS_FRACTION, *TURNS, MANY, function(back, [t], (lam == 1) | (lam == -1) & many(2, t) | (2 * lam == -1) & many(3, t) | (lam == 0) & many(4, t) | (2 * lam == 1) & many(6, t)), let(near, exists(t, 1, 30, cs[t] > rational("97/100")))],
      given=[standing("a cosine", abs(lam) <= 1)],
      by=[steps("BLM91-X.6", facts=["Kronecker: multiples of an irrational part of a full turn are dense on the circle", "a rational zero of a monic polynomial with integer coefficients is an integer"],
                prose="for theta = 2 pi q/p the powers are the p-th roots of unity"), instances(60),
          *(example(numerator=k_, denominator=d_) for k_, d_ in ((1, 1), (-1, 1), (1, 2), (-1, 2), (0, 1), (3, 5)))],
      note="On fractions lambda = cos(theta) with terms up to 13: a return within 12 steps exactly for lambda = 1, -1, -1/2, 0, 1/2 (all rational angles with rational cosine) after 1, 2, 3, 4, 6 steps, and in every case a near return within 30 steps, "
           "cos(t theta) > 97/100. cos and sin/sin(theta) of t theta by recursion.")
HALF = (let(lam, (1 - y**2) / (1 + y**2)), A_LAMBDA, let(Rot, rows([[lam, -2 * y / (1 + y**2)], [2 * y / (1 + y**2), lam]])), let(v, rows([[bp], [bm]])))
claim("BLM91-S73", "A turns lines by theta", det(hstack(A**m * v, Rot**m * v)) == 0, sizes=["m"], over={y: nonzero(), bp: scalar(), bm: scalar()}, where=HALF,
      by=[example(m=1, y="1/2", beta_plus=1, beta_minus=0), instances(m=(1, 2))],
      repair=repair("missing hypothesis", "A is not a rotation in the given coordinates (it takes (1, 0)' to (2 cos(theta), 1)'); in the basis (cos(theta), 1)', (-sin(theta), 0)' it is the rotation by theta",
                    always(t, V[t] == Pb * Pw[t]), over={y: nonzero()},
                    where=[*HALF[:3], let(Pb, rows([[lam, -2 * y / (1 + y**2)], [1, 0]])), rec(V, t, Pb, A * V[t]), rec(Pw, t, Identity(2), Rot * Pw[t])],
                    by=[induction(cofactors=[[(A, 0, 1)]]), instances()]),
      note="cos(theta) = (1 - y^2)/(1 + y^2), sin(theta) = 2y/(1 + y^2). The print says that A^t takes the line through exp(i theta_v) to the line through exp(i(t theta + theta_v)).")
SLOPES = rec(be, t, x, 1 / (2 * lam - be[t]))
claim("BLM91-S74", "slopes: periodic or dense, by theta", forall(t, 1, 6, iff(be[t] == x, back(t))), over={**FRACTIONS, x: scalar()},
      where=[AS_FRACTION, SLOPES, function(back, [t], (lam == 0) & exists(k, 1, 3, 2 * k == t) | (4 * lam**2 == 1) & exists(k, 1, 2, 3 * k == t))], given=[standing("|kappa| > 1", abs(lam) < 1)],
      by=[steps("BLM91-S71", "BLM91-X.6", facts=["Kronecker: multiples of an irrational part of a full turn are dense on the circle"], prose="a line is turned by theta in a suitable basis; it is back when t theta is a multiple of pi"),
          instances(40), *(example(numerator=k_, denominator=2, x=x_) for k_ in (1, 0, -1) for x_ in (3, "-2/5"))],
      note="On fractions 1/kappa with terms up to 13, where the rational angles are those with 1/kappa = 0, 1/2, -1/2. theta is that of (5.2b); the print names (5.3).")
ANGLE = {nn: integer(1, 23)}
LOW = [standing("angle", nn < d), standing("lowest terms", gcd(d, nn) == 1)]
POWERS = (GCD, let(lam, cospi(nn, d)), A_LAMBDA, rec(Pw, t, Identity(2), A * Pw[t]), function(back, [t], Pw[t] == Pw[t][1, 1] * Identity(2)))
claim("BLM91-S75", "when every line is back", back(p) & forall(k, 1, d - 1, ~back(k)), sizes=["d"], over={**ANGLE, p: integer(1, 24)}, where=POWERS, given=LOW,
      by=[example(d=3, n_angle=1, p=2), instances(d=range(2, 9))],
      repair=repair("index", "the exponent is d, not p: A^p l = l for all l only if d divides p", forall(k, 1, d, iff(X1[k] * v2 == X2[k] * v1, k == d)), sizes=["n", "d"], over={v1: scalar(), v2: scalar()}, where=[*BY_ANGLE, *LINES_TURN],
                    given=[*LOWEST, given("a line", (v1 != 0) | (v2 != 0))],
                    by=[arithmetic(*SINES_D, *OF_LINES), instances(16, n=range(1, 8), d=range(2, 9)), example(n=1, d=3, v1=1, v2=0), example(n=1, d=2, v1=0, v2=1)]),
      note="theta = n pi/d, d >= 2. A^k l = l for all l means that A^k is a multiple of the identity; in the correction the line through any (v_1, v_2)' is followed, V_t = A^t v. p is not defined where it stands, and is read as any natural number; were it the period of Theorem 3.7, which is d or 2d, the "
           "equation would be right. Every d >= 2 occurs, with n = 1.")
claim("BLM91-S76", "no real zeros of phi for |kappa| > 1", phi_ > 0, over={**POINT, kap: scalar(), x: scalar()}, where=[PHI], given=[given("kappa", kap * (1 + al0**2 - ga0**2) == 2 * al0), given("|kappa| > 1", kap**2 > 1)],
      by=[arithmetic(valued(), cleared(), by_cases(al0**2 > 0), square_of(kap * x - kap + al0)),
          instances(60, using={u: scalar(), y: scalar(), s1: nonzero()}, made_by={kap: s1 + SIGN, x: u, al0: (2 / kap + 2 * y) / (1 - y**2), ga0: 1 + y * al0}),
          example(alpha0="1/2", gamma0=0, kappa="4/5", x="1/2"), example(alpha0=1, gamma0=1, kappa=5, x="1/2"), example(alpha0=1, gamma0=0, kappa=1, x=0), example(alpha0=1, gamma0=3, kappa=2, x=3)],
      note="Even > 0.")
