# SPDX-License-Identifier: MIT
"""The summary, the conclusions and the questions that stay open (Chapter IV).

Most of these repeat what has been shown. Two conclusions are shown here for one state: a slightly
negative variance of an undriven stable state returns to zero, and the variance of an unobservable
state moves by phi^2 p + h, which is unstable for phi^2 > 1 and grows for phi^2 = 1, h > 0.
"""

from exactkf.claims import claim, not_checked
from exactkf.evidence import example, instances, part
from exactkf.language import always, given, nonneg, rec, scalar, symbols, to_expr
from proofs.d71.notation import k

p0, x, y, h, phi, q0, gap = symbols("p0 x y h phi q0 gap")
SUMMARY = "a summary of what the thesis shows; each part is a claim of its own: {}"
QUESTION = "a question, not an assertion"

not_checked("D71-S68", "summary of the results", SUMMARY.format("the theorems of Chapter III"))

claim("D71-S70", "slightly indefinite covariances return",
      always(k, (x[k] <= 0) & (to_expr(2)**k*x[k] >= p0)), over={p0: scalar()}, where=[rec(x, k, p0, x[k]/4/(x[k] + 1))],
      given=[given("slightly negative", 2*p0 >= -1), given("negative", p0 <= 0)],
      by=[part("one state and phi = 1/2"), example(p0="-1/2"), example(p0="-1/10"), example(p0=-2), example(p0="-99/100"), example(p0=1),
          instances(made_by={p0: -1/(2 + y**2)}, using={y: scalar()})],
      note="For one state, phi = 1/2, h = 0, m = v = 1, whose only nonnegative equilibrium 0 is stable: from a negative p_0 >= -1/2 the solution returns to "
           "0, and is at least p_0/2^k. That this is so near every singular equilibrium of a regular process is Theorem 3.22.")

claim("D71-S71", "unobservable modes that are unstable, or driven random walks",
      always(k, (x[k] - y[k] == phi**(2*k)*(p0 - q0)) & (gap[k] == p0 + k*h)), over={p0: scalar(), q0: scalar(), phi: scalar(), h: nonneg()},
      where=[rec(x, k, p0, phi**2*x[k] + h), rec(y, k, q0, phi**2*y[k] + h), rec(gap, k, p0, gap[k] + h)],
      by=[part("one state"), instances(12, horizon=5)],
      note="For one state with m = 0: the difference of two solutions x and y grows like phi^{2k} if phi^2 > 1; for a random walk, whose solution is called "
           "gap, the variance is p_0 + kh, which is unbounded if h > 0.")

not_checked("D71-S73", "an undriven observable random walk mode", SUMMARY.format("D71-Q4.a and D71-E3.247"))
not_checked("D71-Q1", "are the conditions of Theorems 3.13 to 3.16 necessary", QUESTION + "; its parts are D71-Q1.a, D71-Q1.b and D71-Q1.c")
not_checked("D71-Q6", "derogatory R_p", QUESTION)
not_checked("D71-Q7", "can the conjectures on undriven modes be proved", QUESTION + "; the case of one random walk is D71-Q4.a")
not_checked("D71-Q8", "which initial values keep the actual covariance bounded", QUESTION)
not_checked("D71-Q9", "semidefinite V, and processes that change with time", QUESTION)
