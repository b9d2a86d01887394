# SPDX-License-Identifier: MIT
"""Settings of the property tests: reproducible, bounded, without deadline."""

from hypothesis import HealthCheck, settings

settings.register_profile(
    "theory", max_examples=40, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("theory")
