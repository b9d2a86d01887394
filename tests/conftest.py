# SPDX-License-Identifier: MIT
"""Settings that every test shares."""

from hypothesis import HealthCheck, settings

_SHARED = {"deadline": None, "max_examples": 60, "suppress_health_check": [HealthCheck.too_slow, HealthCheck.filter_too_much]}
settings.register_profile("same", derandomize=True, **_SHARED)  # a green run is green everywhere
settings.register_profile("explore", **_SHARED)
settings.load_profile("same")
