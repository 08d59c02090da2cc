# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""The GIL, progress, cancellation, Ctrl+C, threads."""
import ctypes
import os
import signal
import threading
import time

import numpy as np
import pytest

import gonio


def seen_during(work):
    """Whether another Python thread runs in the middle of work()."""
    times, end = [], threading.Event()

    def note():
        while not end.is_set():
            times.append(time.perf_counter())
            time.sleep(0.001)

    thread = threading.Thread(target=note)
    thread.start()
    start = time.perf_counter()
    work()
    stop = time.perf_counter()
    end.set()
    thread.join()
    quarter = (stop - start) / 4
    return any(start + quarter < seen < stop - quarter for seen in times)


def test_the_gil_is_released(chrome, directions):
    wi, wo = directions(2_000_000), directions(2_000_000, seed=2)
    assert seen_during(lambda: chrome.evaluate(wi, wo))
    # The check itself: a call that holds the GIL.
    assert not seen_during(lambda: ctypes.PyDLL(None).usleep(200_000))


def test_progress_rises_on_the_calling_thread(paint):
    seen, threads = [], set()

    def progress(fraction):
        seen.append(fraction)
        threads.add(threading.get_ident())

    gonio.fit(paint, "ggx", progress=progress)
    assert seen and seen == sorted(seen) and 0 <= seen[0] and seen[-1] <= 1
    assert threads == {threading.get_ident()}


class Stop(Exception):
    pass


def test_an_exception_of_the_callback_stops_the_work(paint):
    calls = []

    def progress(fraction):
        calls.append(fraction)
        raise Stop

    with pytest.raises(Stop):
        gonio.fit_all(paint, progress=progress, size=16, samples=4)
    assert len(calls) == 1
    # Nothing is left behind: the next call works.
    gonio.fit(paint, "lambert")


def test_ctrl_c_stops_the_work(paint):
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        gonio.fit_all(paint)
    timer.join()


def test_any_number_of_threads_gives_the_same_bits(chrome, directions):
    wi, wo = directions(50_000), directions(50_000, seed=2)
    values = chrome.evaluate(wi, wo)
    gonio.set_threads(1)
    try:
        np.testing.assert_array_equal(chrome.evaluate(wi, wo), values)
    finally:
        gonio.set_threads(0)
    with pytest.raises(gonio.Error, match="threads"):
        gonio.set_threads(-1)


def test_two_python_threads_share_a_material(chrome, directions):
    wi, wo = directions(100_000), directions(100_000, seed=2)
    results = [None] * 4

    def evaluate(number):
        results[number] = chrome.evaluate(wi, wo)

    threads = [threading.Thread(target=evaluate, args=(number,)) for number in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for result in results[1:]:
        np.testing.assert_array_equal(result, results[0])
