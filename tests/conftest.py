# SPDX-License-Identifier: MIT
"""Settings that every test shares."""

import signal

from hypothesis import HealthCheck, settings

_SHARED = {"deadline": None, "max_examples": 60, "suppress_health_check": [HealthCheck.too_slow, HealthCheck.filter_too_much]}
settings.register_profile("same", derandomize=True, **_SHARED)  # a green run is green everywhere
settings.register_profile("explore", **_SHARED)
settings.load_profile("same")

if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # a run in the background ignores Ctrl-C, and so would the programs that tests start and stop
    signal.signal(signal.SIGINT, signal.default_int_handler)
