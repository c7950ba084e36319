"""Tests of reports, logs, Ctrl-C, and of other threads of Python."""

import _thread
import signal
import threading
import time
import warnings

import numpy
import pytest
from small_scene import endless, quick

import sunfleck


def press_ctrl_c(after=0.2):
    timer = threading.Timer(after, _thread.interrupt_main)
    timer.start()
    return timer


def test_what_is_raised_comes_out_of_the_call_that_it_ends(scene):
    renderer = endless(scene)

    def stop(_):
        _thread.interrupt_main()
        raise ValueError("from the report")

    with pytest.raises(KeyboardInterrupt) as raised:
        renderer.run(stop)
    assert "from the report" in str(raised.value.__context__)
    assert renderer.step(1)
    with pytest.raises(ValueError):
        renderer.start(lambda _: int("none"))
        renderer.wait()
    assert renderer.step(1)


def test_what_a_log_raises_comes_out_of_the_call_that_logs(scene):
    is_angry = False

    def log(_, line):
        if is_angry:
            raise ValueError(line)

    renderer = quick(scene, photon_sampler="paper", passes=1, log=log)
    is_angry = True
    crop = (0, 6, 0, 8)
    turn = ("perspective", {"float fov": 50}, sunfleck.Transform.translate((0, 0, -9)))
    for change in (lambda: renderer.set_resolution(12, 8), lambda: renderer.set_crop(crop),
                   lambda: renderer.set_camera(*turn)):
        with pytest.raises(ValueError, match="biased"):
            change()
    is_angry = False
    assert renderer.run()
    is_angry = True
    with pytest.raises(ValueError, match="biased"):
        quick(scene, photon_sampler="paper", passes=1, log=log)


def test_warnings_as_errors_come_out_of_the_call_that_warns(scene):
    renderer = quick(scene, photon_sampler="paper", passes=1, log=lambda *_: None)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(UserWarning, match="biased"):
            quick(scene, photon_sampler="paper", passes=1)
    assert renderer.run()


def test_warnings_name_the_line_that_has_called(scene):
    with pytest.warns(UserWarning, match="biased") as warned:
        renderer = quick(scene, photon_sampler="paper", passes=1)
        renderer.set_resolution(12, 8)
    assert warned[0].filename.endswith("small_scene.py") and warned[1].filename == __file__


def test_reports_and_logs_are_functions(scene):
    with pytest.raises(TypeError):
        quick(scene, log=5)
    for call in (quick(scene).run, quick(scene).start):
        with pytest.raises(TypeError):
            call(5)


def test_wait_in_a_report_is_refused(scene):
    renderer = endless(scene)
    renderer.start(lambda _: renderer.wait())
    with pytest.raises(sunfleck.Error, match="wait"):
        renderer.wait()
    assert renderer.step(1)


def test_one_thread_waits_at_a_time(scene):
    renderer = endless(scene)
    renderer.start()
    ends = []
    thread = threading.Thread(target=lambda: ends.append(renderer.wait()))
    thread.start()
    time.sleep(0.1)
    with pytest.raises(sunfleck.Error, match="another thread"):
        renderer.wait()
    renderer.cancel()
    thread.join()
    assert ends == [False]


def test_ctrl_c_ends_a_wait_after_which_the_render_goes_on(scene):
    renderer = endless(scene)
    renderer.start()
    timer = press_ctrl_c()
    with pytest.raises(KeyboardInterrupt):
        renderer.wait()
    timer.join()
    assert not renderer.is_running and renderer.step(1)


@pytest.mark.parametrize("call", ["wait", "run"])
def test_a_second_ctrl_c_leaves_a_report_that_does_not_return(scene, call):
    renderer = endless(scene)
    gate = threading.Event()
    timers = [press_ctrl_c(0.2), press_ctrl_c(0.6)]
    with pytest.raises(KeyboardInterrupt):
        if call == "run":
            renderer.run(lambda _: gate.wait())
        renderer.start(lambda _: gate.wait())
        renderer.wait()
    for timer in timers:
        timer.join()
    assert renderer.is_running
    gate.set()
    while renderer.is_running:
        time.sleep(0.01)
    if call == "wait":
        assert not renderer.wait()
    assert renderer.step(1)


def test_a_handler_of_another_signal_ends_a_wait(scene):
    def stop(*_):
        raise TimeoutError

    before = signal.signal(signal.SIGUSR1, stop)
    renderer = endless(scene)
    renderer.start()
    timer = threading.Timer(0.2, signal.raise_signal, [signal.SIGUSR1])
    timer.start()
    with pytest.raises(TimeoutError):
        renderer.wait()
    timer.join()
    signal.signal(signal.SIGUSR1, before)


@pytest.mark.parametrize("call", ["set_resolution", "set_crop", "save", "load"])
def test_other_threads_run_during_long_calls(scene, tmp_path, call):
    renderer = quick(scene, resolution=(1200, 1200), photon_sampler="uniform")
    picture, path = renderer.picture(), str(tmp_path / "large.exr")
    picture.save(path)
    calls = {"set_resolution": lambda: renderer.set_resolution(1300, 1200),
             "set_crop": lambda: renderer.set_crop((0, 1199, 0, 1199)),
             "save": lambda: picture.save(path),
             "load": lambda: sunfleck.Picture.load(path)}
    ticks, is_done = [], threading.Event()

    def tick():
        while not is_done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    begin = time.monotonic()
    calls[call]()
    end = time.monotonic()
    is_done.set()
    thread.join()
    moments = [begin, *(tick for tick in ticks if begin < tick < end), end]
    assert numpy.diff(moments).max() < 0.8 * (end - begin)
