# SPDX-License-Identifier: MIT
"""Exact, certificate-producing verification of the mathematics of Kalman filter dynamics."""

from exactkf._errors import BadInput, CertificateError, ExactkfError, Unsupported

__all__ = ["BadInput", "CertificateError", "ExactkfError", "Unsupported", "__version__"]

__version__ = "0.1.0"
