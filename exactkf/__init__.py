# SPDX-License-Identifier: MIT
"""Exact, certificate-producing verification of the mathematics of Kalman filter dynamics.

`analyze` decides what the gain of a filter does, `prove_lemma` proves a lemma
of your own for every matrix size or refutes it, `verify_statement` decides a
statement by the evidence you name, `verify_claim` a claim of the papers;
`exactkf.language` says statements, `exactkf.evidence` what to look for,
`exactkf.theory` holds the mathematics as functions.
"""

from typing import TYPE_CHECKING, Any

from exactkf._errors import BadInput, CertificateError, ExactkfError, Unsupported

if TYPE_CHECKING:
    from exactkf.dynamics.analyze import analyze
    from exactkf.engine import verify_claim, verify_statement
    from exactkf.lemma import prove_lemma

__all__ = ["BadInput", "CertificateError", "ExactkfError", "Unsupported", "__version__", "analyze", "prove_lemma", "verify_claim", "verify_statement"]

__version__ = "0.1.0"


def __getattr__(name: str) -> Any:  # the checker imports this package and must not load the engine
    if name in ("verify_claim", "verify_statement"):
        from exactkf import engine

        return getattr(engine, name)
    if name == "analyze":
        from exactkf.dynamics.analyze import analyze

        return analyze
    if name == "prove_lemma":
        from exactkf.lemma import prove_lemma

        return prove_lemma
    raise AttributeError(f"module 'exactkf' has no attribute {name!r}")


def __dir__() -> list[str]:  # so that help() and completion know what comes later
    return sorted({*globals(), *__all__} - {"Any", "TYPE_CHECKING"})
