"""The kernels in which nbval runs notebooks."""

import conftest
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
