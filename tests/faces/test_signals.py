# SPDX-License-Identifier: MIT
"""Ctrl-C while processes begin."""

import os
import signal
import subprocess
import sys

import pytest

from exactkf.signals import ctrl_c_later, sigterm_as_ctrl_c

pytestmark = pytest.mark.skipif(not hasattr(signal, "pthread_sigmask"), reason="no such signals")


def test_ctrl_c_waits_while_processes_begin():
    """It comes at the end of the block, is not lost, and a process begun meanwhile never hears of it."""
    done = []
    with pytest.raises(KeyboardInterrupt), ctrl_c_later():
        os.kill(os.getpid(), signal.SIGINT)
        call = "import signal; print(signal.SIGINT in signal.pthread_sigmask(signal.SIG_BLOCK, []))"
        done.append(subprocess.run([sys.executable, "-c", call], capture_output=True, text=True, check=True).stdout)
    assert done == ["True\n"] and signal.SIGINT not in signal.pthread_sigmask(signal.SIG_BLOCK, [])


def test_sigterm_is_ctrl_c_while_they_work():
    """And afterwards it is what it was."""
    before = signal.getsignal(signal.SIGTERM)
    with pytest.raises(KeyboardInterrupt), sigterm_as_ctrl_c():
        os.kill(os.getpid(), signal.SIGTERM)
    assert signal.getsignal(signal.SIGTERM) == before
