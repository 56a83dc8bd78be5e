# SPDX-License-Identifier: GPL-3.0-or-later
"""The interpreter's lock is free while the module works, and Ctrl-C ends the work."""

import os
import signal
import threading
import time

import numpy as np
import pellucid
import pytest
from sheets import CAMERA, stack


def long_render():
    """Minutes of rays through 400 sheets."""
    stack([0.01] * 400, resolution=(4000, 4000)).render("raytrace")


def long_trace():
    pellucid.trace("abc", "hultquist:threshold=0.0005", [[2.6, 3.1, 3.1], [3.6, 3.1, 3.1]], 50)


def long_deep():
    stack([0.01] * 60, resolution=(4000, 4000)).deep()


def test_other_threads_run_meanwhile():
    scene = stack([0.5] * 100, resolution=(600, 600))
    worker = threading.Thread(target=scene.render)
    worker.start()
    turns = 0
    while worker.is_alive():
        turns += 1
        time.sleep(0.001)
    # With the lock held this loop would have had no turn.
    assert turns > 20


@pytest.mark.parametrize("work", [long_render, long_trace, long_deep])
def test_ctrl_c_ends_the_work(work):
    timer = threading.Timer(0.7, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        work()
    timer.join()
    assert time.monotonic() - begin < 20  # the whole takes minutes


def test_what_a_signals_handler_raises_is_raised():
    class Told(Exception):
        pass

    def tell(number, frame):
        raise Told

    before = signal.signal(signal.SIGALRM, tell)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.3)
        with pytest.raises(Told):
            long_render()
    finally:
        signal.signal(signal.SIGALRM, before)


def test_the_next_call_is_as_if_nothing_had_been():
    scene = stack([0.5, 0.5])
    assert scene.render().layers.max() == 2
    assert np.allclose(scene.render().image[..., 3], 0.75)
    assert CAMERA["height"] == 2
