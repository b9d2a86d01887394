# SPDX-License-Identifier: MIT
"""Evidence that could not have failed is no evidence."""

from exactkf import verify_statement
from exactkf.evidence import instances
from exactkf.language import Statement, defined, scalar, sym


def test_a_statement_that_rejects_no_neighbour_is_open():
    """A number is always defined, and nothing can be changed in saying so: the verdict is open, with the reason."""
    x = sym("x")
    result = verify_statement(Statement(over={"x": scalar()}, says=defined(x)), [instances()])
    assert result["verdict"] == "open"
    assert result["reason"] == "no wrong neighbour was there to be rejected"
