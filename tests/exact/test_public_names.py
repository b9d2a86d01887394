# SPDX-License-Identifier: MIT
"""Tests of exactkf.exact as a whole."""

import doctest
import importlib
import inspect

import pytest

import exactkf.exact

MODULES = ["balls", "canonical", "circle", "matrices", "numberfield", "polynomials", "ratfunc", "rationals"]


@pytest.mark.parametrize("name", MODULES)
def test_examples(name):
    """The examples in the docstrings hold."""
    assert doctest.testmod(importlib.import_module(f"exactkf.exact.{name}")).failed == 0


@pytest.mark.parametrize("name", MODULES)
def test_public_names_have_docstrings(name):
    """Every name in __all__ exists, is documented, and is exported by the package unless it is about balls."""
    module = importlib.import_module(f"exactkf.exact.{name}")
    for public in module.__all__:
        thing = getattr(module, public)
        assert thing.__doc__ or not (inspect.isfunction(thing) or inspect.isclass(thing))
        assert name == "balls" or getattr(exactkf.exact, public) is thing
    assert set(exactkf.exact.__all__) <= set(dir(exactkf.exact))
