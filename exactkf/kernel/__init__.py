# SPDX-License-Identifier: MIT
"""The checker: what statements mean, and how certificates replay.

Nothing here imports anything outside the standard library. Read in this
order: `numbers`, `symbolic`, `algebraic` (scalars and polynomials in z),
`linear` (matrices), `roots` (root location), `meaning` (the value of a
statement), `instances` (instances read, tested, or made of symbols), `words`,
`order` and `stable` (matrices of every size), `rotation`, `orbit`, `intervals`,
`orbit_wandering` and `orbit_n` (answers about orbits), `replay` (kinds of certificates).
"""
