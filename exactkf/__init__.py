# SPDX-License-Identifier: MIT
"""Exact, certificate-producing verification of the mathematics of Kalman filter dynamics.

`verify_statement` decides a statement of your own, `verify_claim` one of the
papers; `exactkf.language` says statements, `exactkf.evidence` what to look
for, `exactkf.theory` holds the mathematics as functions.
"""

from typing import Any

from exactkf._errors import BadInput, CertificateError, ExactkfError, Unsupported

__all__ = ["BadInput", "CertificateError", "ExactkfError", "Unsupported", "__version__", "verify_claim", "verify_statement"]

__version__ = "0.1.0"


def __getattr__(name: str) -> Any:  # the checker imports this package and must not load the engine
    if name in ("verify_claim", "verify_statement"):
        from exactkf import engine

        return getattr(engine, name)
    raise AttributeError(f"module 'exactkf' has no attribute {name!r}")
