# SPDX-License-Identifier: MIT
"""Nikoukhah, Willsky, Levy: Kalman Filtering and Riccati Equations for Descriptor Systems, IEEE TAC 37 (1992)."""
