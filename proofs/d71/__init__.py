# SPDX-License-Identifier: MIT
"""D. J. Duven, Convergence of the difference equation for the error covariance matrix arising in Kalman filter theory (1971)."""
