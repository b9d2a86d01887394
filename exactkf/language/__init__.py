# SPDX-License-Identifier: MIT
"""The language of statements: typed terms and formulas as plain data."""

from exactkf.language import statement as _statement
from exactkf.language import tree as _tree
from exactkf.language.statement import *
from exactkf.language.tree import *

__all__ = [*_tree.__all__, *_statement.__all__]
