# SPDX-License-Identifier: MIT
"""What the parts of `exactkf.kernel.generic.Terms` ask of each other.

Main definitions
----------------
`Reading`
    Terms of a statement in a region: the names and their types.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from exactkf.kernel.known import Known
from exactkf.kernel.region import Form, Region
from exactkf.kernel.symbolic import Symbolic, SymbolicField

__all__ = ["Reading"]


class Reading:
    """Declarations alone; each is made by one of the parts."""

    region: Region
    definitions: dict[str, Any]
    sequences: set[str]
    recursive: set[str]
    inverting: set[str]
    closed: set[str]
    supported: set[str]
    known: Known
    limited: bool
    field: SymbolicField
    atoms: list[tuple]
    nested: int
    perhaps: int
    within: tuple[Form, set[str]] | None
    whole: set[str]
    ruled: set[str]
    letters: set[str]
    kept: dict[str, bool]
    shapes: dict[tuple[Region, str], tuple[Form, Form]]
    shaped: dict[tuple[int, int, Region], tuple[tuple[Form, Form], Any, Any]]
    atom: Callable[[tuple], Symbolic]
    number: Callable[[Any], Symbolic]
    index: Callable[..., Form]
    text: Callable[..., tuple[str, list[Form]]]
    condition: Callable[..., bool]
    value: Callable[..., Symbolic]
    entry: Callable[..., Symbolic]
    coefficient: Callable[..., Symbolic]
    shape: Callable[..., tuple[Form, Form]]
    has_letters: Callable[[Any], bool]
    is_matrix: Callable[[Any], bool]
    total: Callable[..., Symbolic]
    inverts: Callable[[Any], bool]
    not_smaller: Callable[..., bool]
    hides: Callable[..., bool]
    deeper: Callable[..., Symbolic]
    _meet: Callable[..., None]
    _factors: Callable[..., tuple[list[list], list]]
    _chain: Callable[..., Symbolic]
    _is_power_of_number: Callable[..., bool]
    _solved: Callable[..., Symbolic | None]
    _opens: Callable[..., bool]
    _need_one_shape: Callable[[Any], None]
    linear: Callable[[Form], Symbolic]
    named_at_z: Callable[..., Symbolic]
    power_of_z: Callable[..., Symbolic]
    again: Callable[[tuple], Symbolic]
    _call: Callable[..., Symbolic]
    _need_place: Callable[..., None]
    _need_within: Callable[[Form, Form, Form, Form], None]
    _need_first: Callable[[Form], None]
    _are_matrices: Callable[[list[list]], bool]
    has_z: Callable[[Any], bool]
    opaque: Callable[..., Symbolic]
    _sum: Callable[..., Symbolic]
    matrix_sum: Callable[..., Symbolic]
    word: Callable[..., Symbolic]
