# SPDX-License-Identifier: MIT
"""Lemmas on Szego polynomials for every degree, by induction on it.

They are numbered in the order in which a proof lists them: the reversal of
phi_t, its leading coefficient, orthogonality (with r_t as the norm), the
reversal of psi_t, and the coefficients of psi_t by those of phi_t, which is
Lemma 3.3. Orthogonality goes from t to t + 1 because z^k against phi_{t+1} is
z^(k-1) against phi_t minus gamma_t times z^(t-k) against phi_t.
"""

from __future__ import annotations

from exactkf.evidence import lemma, use
from exactkf.language import Z, coeff, forall, rev, sum_of, sym, when
from proofs.blz94.notation import HALF, c, gamma, j, k, phi, phis, pi, psi, psis, r, rho, t

row, column, z = sym("row"), sym("column"), sym("z")

REVERSED = lemma(t, phis[t] == rev(phi[t], t), rule=True)
REVERSED_PSI = lemma(t, psis[t] == rev(psi[t], t), rule=True)
#: second of a list
MONIC = lemma(t, coeff(phi[t], t) == 1, uses=[use(1, t=t)])
#: third of a list, for correlations (3.10) and for any correlations
_AT = [use(1, t=t), use(2, t=t, k=k - 1), use(2, t=t, k=t - k)]
ORTHOGONAL = lemma(t, forall(k, 0, t, sum_of(j, 0, t, coeff(phi[t], j) * c[abs(j - k)]) == when(k == t, r[t], 0)), uses=[*_AT, use(c, t + 1)])
ORTHOGONAL_FREE = lemma(t, forall(k, 0, t, sum_of(j, 0, t, coeff(phi[t], j) * when(j == k, 1, c[abs(j - k)])) == when(k == t, r[t], 0)), uses=_AT)
#: fifth of a list: the induction of Lemma 3.3
FROM_PHI = lemma(t, forall(k, 0, t, coeff(psi[t], k) == coeff(phi[t], k) + sum_of(j, k + 1, t, 2 * c[j - k] * coeff(phi[t], j))),
                 uses=[*_AT, use(4, t=t, k=k - 1), use(4, t=t, k=t - k), use(c, t + 1)])
BOTH_MONIC = lemma(t, (coeff(phi[t], t) == 1) & (coeff(psi[t], t) == 1), uses=[use(2, t=t)])

PAIR = {"supported": [phi, phis]}
FOUR = {"supported": [phi, phis, psi, psis]}
WITH_C = {"closed": [c]}
LEMMA_3_3 = (REVERSED, MONIC, ORTHOGONAL, REVERSED_PSI, FROM_PHI)

#: (A-9) in the form of a sum for the reversed polynomials; first of a list
SUMS = lemma(t, (phis[t] == 1 - sum_of(k, 0, t - 1, gamma[k] * Z * phi[k])) & (psis[t] == 1 + sum_of(k, 0, t - 1, gamma[k] * Z * psi[k])),
             uses=[use(0, t=t, z=z)])
#: first and second of a list, for the polynomials phi(s, t) of shifted parameters
_PIS, _RHOS = HALF * (psis(0, t + 1) + phis(0, t + 1)), HALF * (psis(0, t + 1) - phis(0, t + 1))
SHIFT_BACK = lemma(t, (phi(1, t) == 1 / (Z * (1 - gamma[0])) * (pi(0, t + 1) - Z * rho(0, t + 1)))
                   & (psi(1, t) == 1 / (Z * (1 + gamma[0])) * (pi(0, t + 1) + Z * rho(0, t + 1)))
                   & (phis(1, t) == 1 / (Z * (1 - gamma[0])) * (Z * _PIS - _RHOS))
                   & (psis(1, t) == 1 / (Z * (1 + gamma[0])) * (Z * _PIS + _RHOS)),
                   bare=True, uses=[use(0, t=t, z=z - 1), use(0, t=t, z=z)])
SHIFTED_SUMS = lemma(t, (phis(0, t) == 1 - sum_of(k, 0, t - 1, gamma[k] * Z * phi(0, k)))
                     & (psis(0, t) == 1 + sum_of(k, 0, t - 1, gamma[k] * Z * psi(0, k))), uses=[use(1, t=t, z=z)])
SHIFTED_MONIC = lemma(t, (coeff(phi(0, t), t) == 1) & (coeff(psi(0, t), t) == 1), uses=[use(2, t=t)])
#: fourth of a list: (A-12) for the leading coefficient, and the lowest coefficients
SHIFTED_SECOND = lemma(t, (coeff(rho(0, t), t - 1) == gamma[0]) & (coeff(phis(0, t), t) == -coeff(psis(0, t), t))
                       & (coeff(psi(0, t), 0) == -coeff(phi(0, t), 0)) & (coeff(phis(0, t), 0) == 1) & (coeff(psis(0, t), 0) == 1)
                       & (coeff(psis(0, t), 1) == coeff(phis(0, t), 1) + 2 * gamma[0]), start=1, uses=[use(2, t=t), use(3, t=t)])
