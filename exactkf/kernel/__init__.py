# SPDX-License-Identifier: MIT
"""The checker: what statements mean, and how certificates replay.

Nothing here imports anything outside the standard library. Read in this
order: `numbers`, `symbolic`, `algebraic` (scalars and polynomials in z),
`linear` (matrices), `roots` (root location), `meaning` (the value of a
statement), `instances` (instances read, tested, or made of symbols), `words`
and `order` (matrices of every size), `replay` (kinds of certificates).
"""
