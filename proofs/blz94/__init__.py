# SPDX-License-Identifier: MIT
"""Byrnes, Lindquist, Zhou: On the nonlinear dynamics of fast filtering algorithms (1994)."""
