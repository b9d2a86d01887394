# SPDX-License-Identifier: MIT
"""Stability of linear and of other systems (Chapter I, section D).

For x_{k+1} = Phi x_k let S solve S - Phi'S Phi = I. If S > 0, the function x'Sx falls by |x|^2
in a step, which no eigenvector at an eigenvalue on or outside the circle allows; if Phi is
stable, S is the sum of the (Phi')^k Phi^k. For dx/dt = Ax the equation is A'S + SA = -I, and
C = (I + A)(I - A)^{-1} carries it over: S - C'SC is twice a matrix W'W with W = (I - A)^{-1}, and an
eigenvalue a of A is left of the imaginary axis exactly if (1 + a)/(1 - a) is inside the
circle.

A function V that falls at every step has a limit along a trajectory. That the trajectory tends
to 0 is concluded at a point L of accumulation, where V(f(L)) = V(L); for that f is to be
continuous.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import EIGENVALUE, EIGENVECTOR, example, instances, order, restated, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    forall,
    function,
    given,
    iff,
    inv,
    let,
    loewner,
    matrix,
    nonneg,
    nonsingular,
    pd,
    polynomial,
    positive,
    psd,
    rec,
    scalar,
    schur,
    standing,
    substitute,
    symbols,
    symmetric_matrix,
    when,
)
from proofs.d71.notation import N, Phi, k, n

A, S, C, E, lam, X, x, f, c, r, L, q, V = symbols("A S C E lam X x f c r L q V")
I = Identity(n)

ODE = "an existence theorem for nonlinear differential equations; it has no instance that a computation could decide"

not_checked("D71-E1.76", "when an undriven system has a unique solution", ODE)
not_checked("D71-S4", "kinds of stability", "definitions: they fix what stable means and assert nothing")
not_checked("D71-T1.1", "a Lyapunov function in continuous time",
            "a theorem about all differential equations and all functions V that fall along their solutions; solutions are not exact objects here")

# --- linear systems --------------------------------------------------------------------------------------------------------

(xr, xi), (lr, li) = EIGENVECTOR, EIGENVALUE
FALL = (lr*lr + li*li - 1)*(T(xr)*S*xr + T(xi)*S*xi)

STEIN = given("S - Phi'S Phi = I", S - T(Phi)*S*Phi == I)
claim("D71-T1.6", "asymptotic stability in discrete time",
      iff(schur(Phi), psd(S)), sizes=["n"], over={Phi: matrix(n, n), S: symmetric_matrix(n)}, given=[STEIN],
      by=[order([I], [T(xr)*xr, T(xi)*xi, FALL], [T(xr)*xr, T(xi)*xi, FALL], inside=[within(0, stein=T(Phi)), within(1, vector="right")]),
          restated("x_{k+1} = Phi x_k is asymptotically stable exactly if S - Phi'S Phi = I has a solution S >= 0"),
          example(n=1, Phi=[[2]], S=[["-1/3"]]), example(n=1, Phi=[["1/2"]], S=[["4/3"]]), example(n=1, Phi=[[2]], S=[[1]]),
          example(n=1, Phi=[["1/2"]], S=[[-1]]), example(n=2, Phi=[[2, 0], [0, 0]], S=[["-1/3", 0], [0, 1]]),
          instances(6, n=(1, 2), using={r: scalar()}, made_by={Phi: r*I, S: inv((1 - r**2)*I)})],
      note="x_{k+1}'Sx_{k+1} = x_k'Sx_k - |x_k|^2 with S >= 0, so S >= I, is what asymptotic stability means for a linear system: the states fall like a "
           "power of a number below one, and no S >= 0 does that for a Phi with a state that does not tend to 0. It is stated for the Phi for which the "
           "equation has a solution; no two eigenvalues of a stable matrix have the product 1, and so it has one for them.")

W = inv(I - A)
LYAPUNOV = given("A'S + SA = -I", T(A)*S + S*A == -I)
claim("D71-T1.3", "asymptotic stability in continuous time",
      iff(schur(C), psd(S)), sizes=["n"], over={A: matrix(n, n), S: symmetric_matrix(n)}, where=[let(C, (I + A)*W)], given=[LYAPUNOV],
      by=[order([2*T(W)*W], *[[2*T(xr)*T(W)*W*xr, 2*T(xi)*T(W)*W*xi, FALL]]*2, [inv(W)],
                inside=[within(0, stein=T(C)), within(1, W*xr == Zero(n, 1), W*xi == Zero(n, 1), vector="right")]),
          restated("dx/dt = Ax is asymptotically stable exactly if A'S + SA = -I has a solution S >= 0",
                   "A has its eigenvalues left of the imaginary axis exactly if (I + A)(I - A)^{-1} has them inside the unit circle"),
          example(n=1, A=[[2]], S=[["-1/4"]]), example(n=1, A=[[-2]], S=[["1/4"]]), example(n=1, A=[[2]], S=[[1]]), example(n=1, A=[[-2]], S=[[-1]]),
          instances(6, n=(1, 2), using={E: nonsingular(n)}, made_by={A: -inv(E*T(E)), S: E*T(E)/2})],
      note="The eigenvalues of A are left of the imaginary axis exactly if those of C = (I + A)(I - A)^{-1} are inside the circle. The state falls like an "
           "exponential exactly if x'Sx >= 0, which has the derivative -|x|^2. That 1 is no eigenvalue of A, so that C exists, is a matter of the unit of "
           "time.")

# an eigenvector u + iw and a chain above x + iv: what a quadratic function that never grows allows
u, w, v, y, z, a, b, s, Lam = symbols("u w v y z a b s Lam")
VECTOR = matrix(n, 1)
CHAINS = {S: symmetric_matrix(n), u: VECTOR, w: VECTOR, x: VECTOR, v: VECTOR, y: VECTOR, z: VECTOR, b: scalar(), r: scalar(), E: nonsingular(n),
          Lam: matrix(n, n)}
NEVER = Zero(n, 1)
NO_CHAIN = (u == NEVER) & (w == NEVER) & (x == NEVER) & (v == NEVER)
ABSENT = {u: NEVER, w: NEVER, x: NEVER, v: NEVER}
OTHER = inv(E*T(E))


def energy(one, other, matrix_):
    """A quadratic form at a vector with real and imaginary part."""
    return T(one)*matrix_*one + T(other)*matrix_*other


def by_energy(loss, growth, last):
    """Each of the two vectors loses nothing of x'Sx, which leaves only zero."""
    return order([T(u)*loss*u, T(w)*loss*w, growth], [T(u)*S*u, T(w)*S*w], [T(u)*S*u, T(w)*S*w], [T(x)*loss*x, T(v)*loss*v], [T(x)*loss*x, T(v)*loss*v], [],
                 [T(x)*S*x, T(v)*S*v], [T(x)*S*x, T(v)*S*v], [inv(S)], [inv(S)], [inv(S)], [inv(S)], [last],
                 lemmas=[energy(u, w, S) == Zero(1, 1), S*u == NEVER, S*w == NEVER, loss*x == NEVER, loss*v == NEVER, energy(x, v, S) == Zero(1, 1),
                         S*x == NEVER, S*v == NEVER])


DISCRETE = S - T(Phi)*S*Phi
SIMILAR = "a matrix with no such eigenvalue and no such chain is similar to a Lambda with {}"
ONE = {"n": 1, "S": [[1]], **{name: [[0]] for name in "u w x v y z".split()}, "a": 2, "b": 0, "q": 3, "s": 1, "r": 0, "E": [[1]], "Lam": [[1]]}
TWO = {"n": 2, "S": [[1, 0], [0, 1]], **{name: [[0], [0]] for name in "u w x v y z".split()}, "a": 2, "b": 0, "q": 3, "s": 1, "r": 0,
       "E": [[1, 1], [0, 1]], "Lam": [[0, 1], [-1, 0]]}

claim("D71-T1.5", "stability in discrete time",
      NO_CHAIN & loewner(OTHER, T(E*Lam*inv(E))*OTHER*(E*Lam*inv(E))),
      sizes=["n"], over={Phi: matrix(n, n), **CHAINS, q: positive(), a: scalar(), s: scalar()},
      given=[given("S > 0", pd(S)), given("x'Sx never grows", psd(DISCRETE)), given("u + iw at a + ib", (Phi*u == a*u - b*w) & (Phi*w == b*u + a*w)),
             given("outside the circle", a**2 + b**2 == 1 + q), given("x + iv at s + ir", (Phi*x == s*x - r*v) & (Phi*v == r*x + s*v)),
             given("y + iz above it", (Phi*y == s*y - r*z + x) & (Phi*z == r*y + s*z + v)), given("on the circle", s**2 + r**2 == 1),
             given("Lam'Lam <= I", loewner(I, T(Lam)*Lam))],
      by=[by_energy(DISCRETE, q*energy(u, w, S), T(inv(E))*(I - T(Lam)*Lam)*inv(E)),
          restated("x_{k+1} = Phi x_k is stable exactly if x'Sx never grows for some S > 0", SIMILAR.format("Lambda'Lambda <= I")),
          example({**ONE, "Phi": [[2]], "u": [[1]], "S": [[-1]]}), example({**ONE, "Phi": [[2]], "u": [[1]]}), example({**ONE, "Phi": [[1]], "u": [[1]]}),
          example({**ONE, "Phi": [[1]], "u": [[1]], "a": 1}), example({**ONE, "Phi": [[1]], "Lam": [[2]]}),
          example({**ONE, "Phi": [[0]], "x": [[1]], "y": [[-1]]}), example({**ONE, "Phi": [[1]], "x": [[1]], "y": [[1]]}),
          example({**TWO, "Phi": [[1, 0], [0, 1]]}), example({**TWO, "Phi": [[1, 1], [0, 1]], "S": [[0, 0], [0, -1]], "x": [[1], [0]], "y": [[0], [1]]}),
          example({**TWO, "Phi": [[1, 1], [0, 1]], "x": [[1], [0]], "y": [[0], [1]]}),
          example({**TWO, "Phi": [["1/2", 1], [0, "1/2"]], "s": "1/2", "S": [[1, 0], [0, 4]], "x": [[1], [0]], "y": [[0], [1]]}),
          instances(4, n=(1, 2), made_by={Phi: Zero(n, n), Lam: Zero(n, n), S: I, **ABSENT, y: NEVER, z: NEVER, a: 2, b: 0, q: 3, s: 1, r: 0})],
      note="Stable means that x'Sx never grows for some S > 0. Then there is no eigenvector u + iw at an eigenvalue a + ib outside the circle, and no chain "
           "x + iv, y + iz begins at an eigenvalue on the circle, which says that these are simple zeros of the minimal polynomial. Conversely a matrix "
           "without them is similar to a Lambda with Lambda'Lambda <= I, and S = (EE')^{-1} serves for it.")

CONTINUOUS = -(T(A)*S + S*A)
claim("D71-T1.2", "stability in continuous time",
      NO_CHAIN & psd(-(T(E*Lam*inv(E))*OTHER + OTHER*(E*Lam*inv(E)))),
      sizes=["n"], over={A: matrix(n, n), **CHAINS, q: positive()},
      given=[given("S > 0", pd(S)), given("x'Sx never grows", psd(CONTINUOUS)), given("u + iw at q + ib, q > 0", (A*u == q*u - b*w) & (A*w == b*u + q*w)),
             given("x + iv at ir", (A*x == -r*v) & (A*v == r*x)), given("y + iz above it", (A*y == x - r*z) & (A*z == r*y + v)),
             given("Lam + Lam' <= 0", psd(-(Lam + T(Lam))))],
      by=[by_energy(CONTINUOUS, 2*q*energy(u, w, S), T(inv(E))*(-(Lam + T(Lam)))*inv(E)),
          restated("dx/dt = Ax is stable exactly if x'Sx never grows for some S > 0", SIMILAR.format("Lambda + Lambda' <= 0")),
          *(example({**{key: value for key, value in ONE.items() if key not in "as"}, "q": 1, "Lam": [[0]], **more}) for more in (
              {"A": [[1]], "u": [[1]], "S": [[-1]]}, {"A": [[1]], "u": [[1]]}, {"A": [[0]], "u": [[1]]}, {"A": [[0]], "x": [[1]], "y": [[1]]},
              {"A": [[-1]], "x": [[1]], "y": [[-1]]}, {"A": [[0]], "Lam": [[1]]})),
          *(example({**{key: value for key, value in TWO.items() if key not in "as"}, "q": 1, **more}) for more in (
              {"A": [[0, 1], [0, 0]], "S": [[0, 0], [0, -1]], "x": [[1], [0]], "y": [[0], [1]]}, {"A": [[0, 1], [0, 0]], "x": [[1], [0]], "y": [[0], [1]]},
              {"A": [[0, 1], [-1, 0]]})),
          instances(4, n=(1, 2), made_by={A: Zero(n, n), Lam: Zero(n, n), S: I, **ABSENT, y: NEVER, z: NEVER, b: 0, r: 0})],
      note="As D71-T1.5: u + iw would be an eigenvector right of the imaginary axis, and x + iv, y + iz a chain at the eigenvalue ir. Conversely a matrix "
           "without them is similar to a Lambda with Lambda + Lambda' <= 0.")

# --- discrete time, nonlinear ----------------------------------------------------------------------------------------------

not_checked("D71-S5", "when a discrete-time system has a unique solution",
            "a recursion determines its values one after the other, whatever the function is; there is nothing to compute")

FALLS = given("V falls at every state but 0", forall(k, 0, N, (X[k] != 0) >> (f(X[k])**2 < X[k]**2)))
claim("D71-T1.4", "a Lyapunov function in discrete time",
      L == 0,
      sizes=["N"], over={c: nonneg(), r: positive(), x: positive(), L: scalar()},
      where=[function(f, [y], when(y > c, c + r*(y - c), r*y)), rec(X, k, x, f(X[k]))],
      given=[standing("r < 1", r < 1), given("x_k tends to L, like r^k", forall(k, 0, N, f(X[k]) - L == r*(X[k] - L))), FALLS],
      by=[example(N=3, c=1, r="1/2", x=2, L=1), instances(N=(2, 3), made_by={c: 0, L: 0})],
      repair=repair(
          "missing hypothesis", "f is to be continuous, as the textbooks have it; a trajectory may else come to rest before a jump of f",
          L == 0, sizes=["N"], over={q: polynomial(N), L: scalar()},
          given=[given("V falls at every state but 0", (L != 0) >> (substitute(q, L)**2 < L**2)), given("L is a limit, so f(L) = L", substitute(q, L) == L)],
          by=[example(N=1, q=[0, 1], L=1), example(N=1, q=[0, "1/2"], L=1), instances(N=(1, 2, 3), made_by={L: 0}), instances(N=(1, 2, 3))]),
      note="For V(x) = x^2 and the functions f that are rx up to c and c + r(x - c) above c, 0 < r < 1, c >= 0: f(0) = 0, and V falls at every state but 0. "
           "In the counterexample c = 1, r = 1/2: the trajectory of 2 is 1 + 2^{-k} and tends to 1. The theorem does not ask that f is continuous. In the "
           "repair, f is a polynomial; continuity makes a limit L of a trajectory a solution of f(L) = L, and 0 is the only one.")
