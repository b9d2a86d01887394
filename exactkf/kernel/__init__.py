# SPDX-License-Identifier: MIT
"""The checker: what statements mean, and how certificates replay.

Nothing here imports anything outside the standard library. Read in this
order: `numbers` (scalars and polynomials in z), `linear` (matrices), `roots`
(root location), `meaning` (the value of a statement on an instance),
`replay` (kinds of certificates).
"""
