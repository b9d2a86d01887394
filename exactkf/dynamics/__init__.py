# SPDX-License-Identifier: MIT
"""What a filter does: orbits decided exactly, with a certificate."""

from exactkf.dynamics.answer import BEHAVIOURS, Answer, Fact
from exactkf.dynamics.order_one import decide_many, decide_order_one, decide_riccati_one

__all__ = ["BEHAVIOURS", "Answer", "Fact", "decide_many", "decide_order_one", "decide_riccati_one"]
