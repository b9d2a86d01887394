# SPDX-License-Identifier: MIT
"""Bougerol, Kalman Filtering with Random Coefficients and Contractions, SIAM J. Control Optim. 31 (1993)."""
