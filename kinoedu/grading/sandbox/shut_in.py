"""How a process isolates itself before it runs a student's program.

It sees no other process, its files vanish with it, and it has no rights. Linux only, for a process
that is in a sandbox already and may still make namespaces there. Python lacks some of Linux's
system calls, so they are called through libc.
"""

import ctypes
import os
import resource
import signal
from pathlib import Path

from . import forbidden

NEW_MOUNTS, NEW_IPC, NEW_PROCESSES = 0x0002_0000, 0x0800_0000, 0x2000_0000
NO_SUID, NO_PROGRAMS, AND_BELOW, PRIVATE = 2, 8, 1 << 14, 1 << 18
DETACH = 2  # an argument of umount2
NO_NEW_RIGHTS = 38
CAPABILITIES_OF_SELF = (ctypes.c_uint32 * 2)(0x2008_0522, 0)

LIBC = ctypes.PyDLL(None, use_errno=True)  # PyDLL keeps Python's lock, as a fork must


def fork_alone() -> int:
    """Fork a process that sees and signals no other, and return its number; 0 in the new process.

    When it ends, so does every process that it may have started. This takes a single system call.
    If a process made a new process namespace first and forked then, it would stand between the two
    and could be killed alone.
    """
    ctypes.pythonapi.PyOS_BeforeFork()
    child = int(LIBC.syscall(forbidden.FORK, NEW_PROCESSES | signal.SIGCHLD, 0, 0, 0, 0))
    if child == 0:
        ctypes.pythonapi.PyOS_AfterFork_Child()
        os.setsid()  # signals to its group would reach the others, though it does not see them
        check_call(LIBC.unshare(NEW_MOUNTS | NEW_IPC))
        return 0
    ctypes.pythonapi.PyOS_AfterFork_Parent()
    check_call(min(child, 0))
    return child


def leave_disk(files: int) -> None:
    """Give this process an empty disk of its own, of at most `files` bytes.

    It has /tmp and an empty file /dev/null, and nothing else: no library, no program, and not the
    machine's own /dev/null, by whose locks and times programs could tell each other something.
    """
    check_call(LIBC.mount(None, b"/", None, AND_BELOW | PRIVATE, None))
    options = b"mode=755,size=%d" % files
    check_call(LIBC.mount(b"tmpfs", b"/tmp", b"tmpfs", NO_SUID | NO_PROGRAMS, options))
    for folder, mode in (("/tmp/tmp", 0o1777), ("/tmp/dev", 0o755), ("/tmp/old", 0o700)):
        os.mkdir(folder)
        os.chmod(folder, mode)
    Path("/tmp/dev/null").touch()
    os.chmod("/tmp/dev/null", 0o666)
    check_call(LIBC.syscall(forbidden.PIVOT_ROOT, b"/tmp", b"/tmp/old"))
    os.chdir("/")
    check_call(LIBC.umount2(b"/old", DETACH))
    os.rmdir("/old")
    os.chdir("/tmp")


def give_up_rights(user: int, *, memory: int, cpu: int, files: int) -> None:
    """Give up every right, for good.

    No capability is left, and no file of others. Bounded are memory, processor time and files; no
    further process or thread can be started, and only system calls that a calculation needs are
    allowed.

    user : the user to become where this is root; 0 to remain who it is.
    memory : bytes beyond what is mapped now.
    cpu : seconds.
    files : bytes.
    """
    mapped = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    leave_disk(files)
    if user:
        os.setgroups([])
        os.setresgid(user, user, user)
        os.setresuid(user, user, user)
    check_call(LIBC.prctl(NO_NEW_RIGHTS, 1, 0, 0, 0))
    check_call(LIBC.capset(CAPABILITIES_OF_SELF, (ctypes.c_uint32 * 6)()))
    for what, most in (
        (resource.RLIMIT_AS, mapped + memory),
        (resource.RLIMIT_CPU, cpu),
        (resource.RLIMIT_FSIZE, files),
        (resource.RLIMIT_NOFILE, 64),
        (resource.RLIMIT_CORE, 0),
        (resource.RLIMIT_NPROC, 0),
    ):
        resource.setrlimit(what, (most, most))
    check_call(
        LIBC.prctl(
            forbidden.SECCOMP, forbidden.BY_FILTER, ctypes.byref(forbidden.make_filter()), 0, 0
        )
    )


def check_call(result: int) -> None:
    """Raise OSError if a system call failed."""
    if result != 0:
        error = ctypes.get_errno()
        raise OSError(error, os.strerror(error))
