# SPDX-License-Identifier: MIT
"""The exceptions that exactkf raises on purpose.

Every message is one line: it names the argument, shows its value and says
what to do about it.
"""

from __future__ import annotations

__all__ = ["BadInput", "CertificateError", "ExactkfError", "Unsupported"]


class ExactkfError(Exception):
    """Base of everything exactkf raises on purpose."""


class BadInput(ExactkfError, ValueError):
    """An argument has a value that cannot be used."""


class Unsupported(ExactkfError):
    """The question is well posed, but this engine has no exact answer to it."""


class CertificateError(ExactkfError, ValueError):
    """A certificate is unreadable, of the wrong version, or was altered."""
