# SPDX-License-Identifier: MIT
r"""Files of filters: one, or many.

Main definitions
----------------
``read_filters``  the filters in a file, with a label each
``meant``         the key that an unknown one is near
``is_of_many``    whether a file of that name holds many, whatever is in it

Notation
--------
A filter is a mapping as in `exactkf.dynamics.analyze`; ``name`` may label it.

======  ===============================================================================================
file    filters
======  ===============================================================================================
.toml   one at the top, or many, each below a line ``[[filter]]``
.json   one object, or a list of them
.jsonl  an object a line
.csv    a line each; the columns are keys with lists in quotes, ``"0,2"``, or numbered keys such as
        ``alpha_1, alpha_2, gamma_0, gamma_1``, of which the last may be empty where the order is smaller
======  ===============================================================================================
"""

from __future__ import annotations

import csv
import io
import json
import re
import sys
import tomllib
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from exactkf.exact._messages import bad

__all__ = ["FORMS", "OPTIONS", "is_of_many", "meant", "read_filters", "split_list"]

#: Sets of keys that describe a filter, and keys that may stand beside them.
FORMS = (("alpha", "gamma"), ("a", "g"), ("b", "a"), ("covariances",), ("F", "g", "h"), ("system",))
OPTIONS = ("floats", "order", "pi0")

_KEYS = {key for form in FORMS for key in form} | set(OPTIONS)
_NEAR = 0.7  # how alike two keys are for one to be taken as meant by the other
_VECTORS = {"alpha", "gamma", "a", "g", "b", "covariances"}
_MANY = (".jsonl", ".csv")


def is_of_many(path: str | Path) -> bool:
    """Whether the name is one of a file with a filter a line."""
    return Path(path).suffix.lower() in _MANY


def read_filters(path: str | Path) -> list[tuple[str, dict[str, Any]]]:
    """Return the filters in a file with their labels: names, or the file with the line or the place in its list.

    Floats in the file are kept as the decimals that are written there.

    Raises
    ------
    BadInput
        If the file cannot be read, is not of its kind, or holds what is no filter, with the line or place.
    """
    path = Path(path)
    kind = path.suffix.lower()
    if kind not in (".toml", ".json", *_MANY):
        raise bad("FILE", "ends in neither .toml nor .json, .jsonl or .csv", str(path), "pass a file that does")
    try:
        text = path.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise bad("FILE", "cannot be read", str(path), f"pass a text file that you may read ({getattr(error, 'strerror', None) or 'not UTF-8'})") from None
    match kind:
        case ".toml":
            found = _toml(text, path)
        case ".json":
            data = _parsed(text, path, "JSON")
            found = [(f"{path}[{k}]", x) for k, x in enumerate(data)] if isinstance(data, list) else [(str(path), data)]
        case ".jsonl":
            found = [(f"{path}:{k}", _parsed(line, f"{path}:{k}", "JSON")) for k, line in enumerate(text.splitlines(), 1) if line.strip()]
        case _:
            found = _csv(text, path)
    if not found:
        raise bad("FILE", "holds no filter", str(path), "write one, such as alpha and gamma")
    return [_labelled(place, data) for place, data in found]


def meant(key: str) -> str:
    """Name the key that an unknown one is near, or ''.

    Examples
    --------
    >>> meant("gamm"), meant("Alpha"), meant("x")
    ("did you mean 'gamma'?", "did you mean 'alpha'?", '')
    """
    for asked in (key, key.lower(), key.upper()):
        if found := get_close_matches(asked, _KEYS, 1, _NEAR):
            return f"did you mean {found[0]!r}?"
    return ""


def _labelled(place: str, data: Any) -> tuple[str, dict[str, Any]]:
    if not isinstance(data, dict):
        raise bad("FILE", "holds no table of keys", place, 'write alpha = ["1/2"], gamma = ["1/3"] or the like')
    unknown = set(data) - _KEYS - {"name"}
    if unknown:
        raise bad("FILE", f"has the unknown key {min(unknown)!r}", place, meant(min(unknown)) or "leave it out")
    name = data.pop("name", None)
    return place if name is None else " ".join(str(name).split()), data


def _parsed(text: str, place: Any, kind: str) -> Any:
    try:
        return tomllib.loads(text, parse_float=str) if kind == "TOML" else json.loads(text, parse_float=str, parse_constant=str, object_pairs_hook=_once)
    except (ValueError, RecursionError) as error:
        if "integer string conversion" in str(error):
            raise bad("FILE", f"has an integer of more than {sys.get_int_max_str_digits()} digits", str(place), "put it in quotes") from None
        raise bad("FILE", f"is not {kind} ({' '.join(str(error).split())})", str(place), "mend it") from None


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """A table; one of two values to a key would be lost."""
    data = dict(pairs)
    if len(data) < len(pairs):
        names = [name for name, _ in pairs]
        raise ValueError(f"the key {next(name for name in names if names.count(name) > 1)!r} comes twice")
    return data


def _toml(text: str, path: Path) -> list[tuple[str, Any]]:
    data = _parsed(text, path, "TOML")
    many = data.get("filter")
    if not isinstance(many, list):
        return [(str(path), data)]
    if len(data) > 1:
        raise bad("FILE", f"has the key {min(set(data) - {'filter'})!r} outside its filters", str(path), "write it below a line [[filter]]")
    return [(f"{path}[{k}]", x) for k, x in enumerate(many)]


# ---------------------------------------------------------------------- columns
def _csv(text: str, path: Path) -> list[tuple[str, Any]]:
    reader = csv.reader(io.StringIO(text), strict=True, skipinitialspace=True)
    try:
        header = [name.strip() for name in next(reader, [])]
        columns = [_column(name, path) for name in header]
        if len(set(columns)) < len(columns):
            raise bad("FILE", "names a column twice", str(path), f"leave one of {', '.join(header)} out")
        for key in {key for key, place in columns if place is not None}:
            places = [place for name, place in columns if name == key and place is not None]
            if (key, None) in columns or max(places) - min(places) >= len(places):
                raise bad("FILE", f"does not number the columns of {key} one after the other", str(path), f"write {key}_1, {key}_2, ... or {key} alone")
        return [(f"{path}:{reader.line_num}", _row(columns, row, f"{path}:{reader.line_num}")) for row in reader if any(cell.strip() for cell in row)]
    except csv.Error as error:
        raise bad("FILE", f"is not CSV ({error})", f"{path}:{reader.line_num}", "mend it") from None


def _column(name: str, path: Path) -> tuple[str, int | None]:
    """The key of a column, and the number of the entry that it holds."""
    found = re.fullmatch(r"([a-z]+)_?(\d+)", name)
    key, place = (found[1], int(found[2])) if found else (name, None)
    if key not in (_VECTORS if found else _VECTORS | {"order", "pi0", "name"}):
        near = "separate columns by commas" if ";" in name or "\t" in name else meant(key)
        raise bad("FILE", f"has the unknown column {name!r}", str(path), near if near else "name columns alpha, gamma, a, g, b, covariances, order, pi0, name, "
                  "or the entries of vectors alpha_1, alpha_2, ...")
    return key, place


def _row(columns: list[tuple[str, int | None]], row: list[str], place: str) -> dict[str, Any]:
    if len(row) != len(columns):
        raise bad("FILE", f"has {len(row)} cells where there are {len(columns)} columns", place, "quote lists that hold commas")
    data: dict[str, Any] = {}
    for (key, entry), cell in sorted(zip(columns, row, strict=True), key=lambda x: (x[0][0], x[0][1] or 0)):
        text = cell.strip()
        if entry is None and text:
            data[key] = (int(text) if key == "order" and text.isdecimal() else text) if key not in _VECTORS else split_list(f"FILE, {key} of {place}", text)
        elif entry is not None:
            data.setdefault(key, []).append(text)
    for key, values in data.items():
        while isinstance(values, list) and values and not values[-1]:
            values.pop()
        if isinstance(values, list) and not all(values):
            raise bad("FILE", f"has an empty entry of {key}", place, "fill it; only the last ones may be empty")
    return {key: values for key, values in data.items() if values}


def split_list(name: str, text: str) -> list[str]:
    """Split at the commas outside parentheses.

    Raises
    ------
    BadInput
        If an entry is empty.

    Examples
    --------
    >>> split_list("alpha", "1/2, root(x^2 - 2, 1, 2)")
    ['1/2', 'root(x^2 - 2, 1, 2)']
    """
    parts, depth = [""], 0
    for c in text:
        depth += (c == "(") - (c == ")")
        if c == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += c
    parts = [p.strip() for p in parts]
    if not all(parts):
        raise bad(name, "has an empty entry", text, "separate numbers by single commas")
    return parts
