# SPDX-License-Identifier: MIT
"""What a filter does: orbits decided exactly, with a certificate.

Main definitions
----------------
``analyze``              the decision about a filter in any form
``Filter``               an exact filter, from polynomials, coordinates, covariances or a realization
``decide``               a state (a, g) of any order
``decide_order_one``     a point (alpha, gamma)
``decide_riccati_one``   the Riccati equation of order one
``decide_many``          many filters of any orders, in several processes
``limit_digits``         digits of a limit
``rate_digits``          digits of a rate of convergence
``structure``            `D` on the circle, `S`, its Jordan structure and its invariant subspaces
``certify_ahead``        a certificate with the state far ahead
``state_ahead``          the exact state far ahead
``digits_ahead``         its digits
``Answer``, ``Fact``     what all of them return
"""

from exactkf.dynamics.ahead import digits_ahead, state_ahead
from exactkf.dynamics.analyze import analyze
from exactkf.dynamics.answer import BEHAVIOURS, Answer, Fact
from exactkf.dynamics.certified import certify_ahead
from exactkf.dynamics.every_order import decide, limit_digits, rate_digits
from exactkf.dynamics.filter import Filter
from exactkf.dynamics.many import decide_many
from exactkf.dynamics.numbers import number, numbers
from exactkf.dynamics.order_one import decide_order_one, decide_riccati_one
from exactkf.dynamics.structure import Structure, structure

__all__ = [
    "BEHAVIOURS", "Answer", "Fact", "Filter", "Structure", "analyze", "certify_ahead", "decide", "decide_many", "decide_order_one", "decide_riccati_one",
    "digits_ahead", "limit_digits", "number", "numbers", "rate_digits", "state_ahead", "structure",
]
