# SPDX-License-Identifier: MIT
"""A lemma of one's own: read, prove for every size, or refute."""
