# SPDX-License-Identifier: MIT
"""What other tools read: the JSON of a run, and the certificates as files.

Main definitions
----------------
`contract`
    Results as ``{"version", "claims", "totals"}``.
`export_certificates`
    Copies of certificates in a folder of the caller's choice.
"""

from __future__ import annotations

import os
import re
import shutil
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from exactkf import __version__
from exactkf.claims import Claim
from exactkf.describe import wrong_made
from exactkf.language.latex import statement_latex
from exactkf.store import file_stem

__all__ = ["contract", "export_certificates", "totals"]


def contract(results: Sequence[Mapping[str, Any]], claims: Mapping[str, Claim],
             files: Mapping[str, Sequence[str]]) -> dict[str, Any]:
    """The JSON object of a run.

    Parameters
    ----------
    results : sequence of dict
        From the engine, in reading order.
    claims : mapping of id to Claim
        For the statements: whole, with variables, definitions and hypotheses.
    files : mapping of id to paths
        Certificates, relative to the folder of the JSON file.
    """
    rows = [_row(r, claims[r["id"]], list(files.get(r["id"], ()))) for r in results]
    return {"version": __version__, "claims": rows, "totals": totals(results)}


def _row(result: Mapping[str, Any], claim: Claim, files: list[str]) -> dict[str, Any]:
    mutants = result["mutants"]
    return {
        "id": result["id"], "verdict": result["verdict"], "strength": result["strength"], "sizes": result["sizes"],
        "reason": result["reason"] or None, "repair": _repair(result["repair"], claim),
        "statement_latex": statement_latex(claim.statement) if claim.statement else "",
        "certificates": files,
        "mutants": {"made": wrong_made(mutants), "rejected": mutants["rejected"]},
        "checks": result["checks"], "seconds": result["seconds"],
    }


def _repair(fixed: Mapping[str, Any] | None, claim: Claim) -> dict[str, Any] | None:
    if not fixed:
        return None
    latex = statement_latex(claim.repair.statement) if claim.repair else fixed["statement_latex"]
    return {"statement_latex": latex, "verdict": fixed["verdict"], "strength": fixed["strength"], "kind": fixed["kind"]}


def totals(results: Iterable[Mapping[str, Any]]) -> dict[str, Any]:
    """Number of claims by source, verdict and strength, and of checks executed."""
    rows = list(results)

    def count(field: str) -> dict[str, int]:
        return dict(sorted(Counter(r[field] or "none" for r in rows).items()))

    return {"claims": len(rows), "by_source": count("paper"), "by_verdict": count("verdict"),
            "by_strength": count("strength"), "checks": sum(r["checks"] for r in rows)}


def export_certificates(results: Iterable[Mapping[str, Any]], state: Path, folder: Path) -> dict[str, list[Path]]:
    """Copy the certificates of results into ``folder/PAPER/``; those of an earlier run of the same claims go away."""
    copied: dict[str, list[Path]] = {}
    for result in results:
        home = folder / result["paper"]
        home.mkdir(parents=True, exist_ok=True)
        stem = file_stem(result["id"])
        fresh = [home / Path(name).name for name in result["certificates"]]
        for old in home.glob(f"{stem}-*.json"):
            if old not in fresh and re.fullmatch(rf"{re.escape(stem)}-\d+-[a-z -]+\.json", old.name):
                old.unlink()
        for name, target in zip(result["certificates"], fresh, strict=True):
            part = target.with_name(f".{target.name}.part")
            shutil.copyfile(state / name, part)
            os.replace(part, target)
        copied[result["id"]] = fresh
    return copied
