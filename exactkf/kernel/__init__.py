# SPDX-License-Identifier: MIT
"""The checker: what statements mean, and how certificates replay.

Nothing here imports anything outside the standard library. Read in this order:

- how much a certificate may ask for: `limits`;
- scalars and polynomials in z: `numbers`, `rational`, `packed`, `trials`, `symbolic`, `algebraic`, `cosines`; matrices: `linear`;
- root location: `roots`, and polynomials modulo a prime: `roots_modulo`;
- statements: `wellformed`, `meaning` (the value of one), `instances` (read, tested, or made of symbols);
- matrices of every size: `words`, `reader`, `definite`, `stable`, `continuity`, `order`, `recursion`, `every_size`, `existence`;
- coefficients, entries, sums and products at a generic index: `region`, `known`, `opaque`, `generic_reading`, `chains`, `indefinite`, `generic_polynomials`,
  `generic_matrices`, `generic`, `defined`, `generic_facts`, `index_induction`;
- numbers, and integers of any size: `polynomial_facts`, `explicit_matrices`, `facts_on_circle`, `values`, `arithmetic`;
- answers about orbits: `rotation`, `intervals`, `spectral`, `torus`, `irreducible`, `orbit`, `orbit_wandering`, `orbit_sieve`, `orbit_polynomial`,
  `orbit_dominated`, `orbit_n`, `orbit_structure`, `orbit_speed`, `orbit_ahead`, `orbit_answer`;
- kinds of certificates: `replay`; their text: `files`.
"""
