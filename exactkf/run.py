# SPDX-License-Identifier: MIT
"""Running claims, going on where an earlier run stopped."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from exactkf.claims import Claim
from exactkf.store import Store, claim_key
from exactkf.workers import Options, work

__all__ = ["run"]


def run(claims: Sequence[Claim], registry: Mapping[str, Claim], options: Options, store: Store, *,
        fresh: bool = False, idle: Callable[[], None] | None = None) -> Iterator[dict[str, Any]]:
    """Results of the claims, in the order in which they come.

    Parameters
    ----------
    claims : sequence of Claim
        What to run.
    registry : mapping of id to Claim
        All claims; a claim may lean on others.
    options : Options
    store : Store
        Results found there are not run again.
    fresh : bool
        Run everything all the same.
    idle : callable, optional
        Called now and then while nothing comes.

    Yields
    ------
    dict
        A result of the engine, its certificates as names of files in the state folder.
    """
    keys = {c.id: claim_key(c, registry, options.seed) for c in claims}
    kept = {} if fresh else {c.id: found for c in claims if (found := store.get(keys[c.id]))}
    pending = [c for c in claims if c.id not in kept]
    if pending:
        store.check_writable()
    for result in kept.values():
        yield {**result, "reused": True}
    for claim, result in work("verify_claim", pending, options, idle):
        yield store.put(keys[claim.id], result)
