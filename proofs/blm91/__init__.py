# SPDX-License-Identifier: MIT
"""Byrnes, Lindquist, McGregor: predictability and unpredictability in Kalman filtering (1991)."""
