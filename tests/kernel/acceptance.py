# SPDX-License-Identifier: MIT
"""Whether the checker accepts a certificate, and whether that is right."""

from __future__ import annotations

from exactkf.finders.arithmetic import find_arithmetic
from exactkf.kernel.meaning import World, truth
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.replay import Rejected, replay, seal

__all__ = ["is_accepted", "is_false", "is_proved"]


def is_accepted(certificate) -> bool:
    """A step that does not replay is a refusal; what is no certificate at all is a mistake of the test, and raises."""
    try:
        replay(certificate)
    except Rejected:
        return False
    return True


def is_proved(made, hints, seconds=0.3) -> bool:
    """Whether the search finds a proof with numbers that the checker accepts."""
    proof = find_arithmetic(made, hints, seconds)
    return proof is not None and is_accepted(seal("X", "arithmetic", made, {"proof": proof}))


def is_false(made, values) -> bool:
    """Whether the hypotheses of a statement are true on an instance and the conclusion is false; not where one of them has no value."""
    world = World(made, values)
    try:
        return all(truth(world, g[1], {}) for g in made["given"]) and not truth(world, made["says"], {})
    except (Undefined, Unknown):
        return False
