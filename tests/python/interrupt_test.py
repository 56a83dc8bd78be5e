# SPDX-License-Identifier: GPL-3.0-or-later
"""The interpreter's lock is free while the module works, and Ctrl-C ends the work."""

import json
import os
import signal
import threading
import time

import numpy as np
import pellucid
import pytest
from sheets import CAMERA, sheet, stack


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


def test_ctrl_c_ends_a_study_that_waits_for_a_program(tmp_path):
    """A program may be given hours; Ctrl-C on the terminal does not reach it."""
    begun = tmp_path / "begun"
    sheet(0, (0, 0, 0, 0.5)).save(tmp_path / "sheet.ply")
    (tmp_path / "scene.json").write_text(json.dumps(
        {"format": "pellucid-scene", "version": 1, "resolution": [8, 8], "objects": [{"mesh": "sheet.ply"}]}))
    (tmp_path / "study.json").write_text(json.dumps(
        {"format": "pellucid-study", "version": 1, "title": "Slow", "scenes": ["scene.json"], "reference": "raytrace",
         "repeats": 1, "methods": [{"external": "slow", "command": ["sh", "-c", f"touch {begun}; sleep 60 # {{output}}"]}]}))

    def interrupt():
        while not begun.exists():
            time.sleep(0.05)
        os.kill(os.getpid(), signal.SIGINT)

    watcher = threading.Thread(target=interrupt, daemon=True)
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        watcher.start()
        pellucid.run_study(tmp_path / "study.json", tmp_path / "out")
    assert time.monotonic() - begin < 30


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
