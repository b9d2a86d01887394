# SPDX-License-Identifier: MIT
"""A lemma of one's own: read, proved for every size, or refuted by explicit matrices."""

from exactkf.lemma.grammar import read_lemma
from exactkf.lemma.outcome import Outcome
from exactkf.lemma.prove import prove_lemma
from exactkf.lemma.write import write_lemma

__all__ = ["Outcome", "prove_lemma", "read_lemma", "write_lemma"]
