# SPDX-License-Identifier: MIT
"""Tasks in worker processes: every item comes back, with its task or as left by a pool that broke."""

import os
from collections import deque

import pytest

from exactkf.pool import PoolBroken, Tasks


def test_each_item_comes_with_its_task():
    """What is put into the queue meanwhile is taken too."""
    waiting, found = deque(range(4)), {}
    for item, task in Tasks(pow, lambda k: (k, 2), os.getpid, ()).ended(waiting, 2):
        found[item] = task.result()
        if item == 3:
            waiting.append(10)
    assert found == {0: 0, 1: 1, 2: 4, 3: 9, 10: 100}
    assert not waiting


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_pool_that_breaks_loses_no_item(jobs):
    """Workers that end before they begin leave what was running; the rest is still in the queue."""
    waiting = deque(range(6))
    with pytest.raises(PoolBroken) as broken:
        list(Tasks(pow, lambda k: (k, 2), os._exit, (3,)).ended(waiting, jobs))
    assert broken.value.left
    assert sorted([*broken.value.left, *waiting]) == list(range(6))


def test_an_empty_queue_has_no_tasks():
    """Nothing is yielded and nothing is wrong."""
    assert list(Tasks(pow, lambda k: (k, 2), os.getpid, ()).ended(deque(), 1)) == []
