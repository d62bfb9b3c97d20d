"""The kernels in which nbval runs notebooks."""

import os
import subprocess

import conftest
import nbval.kernel
import nbval.plugin
import pytest


def test_a_kernel_that_does_not_answer_is_started_once_more(monkeypatch):
    """A second kernel that does not answer is an error."""
    answers = [RuntimeError("no answer"), "a kernel", RuntimeError("none"), RuntimeError("again")]

    def start(name):
        assert name == "python3"
        answer = answers.pop(0)
        if isinstance(answer, RuntimeError):
            raise answer
        return answer

    assert nbval.plugin.RunningKernel is conftest.start_kernel
    monkeypatch.setattr(conftest, "RunningKernel", start)
    assert conftest.start_kernel("python3") == "a kernel"
    with pytest.raises(RuntimeError, match="again"):
        conftest.start_kernel("python3")


def test_no_kernel_leaves_a_file_open(monkeypatch):
    """nbval's file for the errors of a kernel is closed, and the null device takes them."""
    given = {}
    assert nbval.kernel.start_new_kernel is conftest.start_silent_kernel
    monkeypatch.setattr(conftest, "start_new_kernel", given.update)
    file = open(os.devnull, "w")  # noqa: SIM115 (as nbval does)
    nbval.kernel.start_new_kernel(kernel_name="python3", stderr=file)
    assert file.closed
    assert given == {"kernel_name": "python3", "stderr": subprocess.DEVNULL}
