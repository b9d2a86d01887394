# SPDX-License-Identifier: MIT
"""What a filter does: orbits decided exactly, with a certificate."""

from exactkf.dynamics.answer import BEHAVIOURS, Answer, Fact

__all__ = ["BEHAVIOURS", "Answer", "Fact"]
