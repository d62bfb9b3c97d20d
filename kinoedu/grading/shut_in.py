"""A process shuts itself in before it runs a stranger's program: alone among processes, with files that vanish, without any right.

Linux only; for a process that is in a sandbox already and may still make namespaces there. Linux's own calls, as Python has none.
"""

import ctypes
import os
import resource
import signal
from pathlib import Path

NEW_MOUNTS, NEW_IPC, NEW_PROCESSES = 0x0002_0000, 0x0800_0000, 0x2000_0000
NO_SUID, NO_DEVICES, NO_PROGRAMS, AND_BELOW, PRIVATE = 2, 4, 8, 1 << 14, 1 << 18
DIE_WITH_PARENT, NO_NEW_RIGHTS = 1, 38
CAPABILITIES_OF_SELF = (ctypes.c_uint32 * 2)(0x2008_0522, 0)

LIBC = ctypes.CDLL(None, use_errno=True)


def alone() -> bool:
    """Fork a process that sees no other, and dies with this one: returns True there. This one waits, and ends as that did."""
    must(LIBC.unshare(NEW_MOUNTS | NEW_IPC | NEW_PROCESSES))
    child = os.fork()
    if child == 0:
        must(LIBC.prctl(DIE_WITH_PARENT, signal.SIGKILL))
        return True
    _, status = os.waitpid(child, 0)
    os._exit(min(255, os.WEXITSTATUS(status) if os.WIFEXITED(status) else 128 + os.WTERMSIG(status)))


def with_new_files(files: int) -> None:
    """Files of its own in /tmp, a few in /dev/shm, in all about so many bytes; nothing in /proc."""
    must(LIBC.mount(None, b"/", None, AND_BELOW | PRIVATE, None))
    for place, most in ((b"/tmp", files), (b"/dev/shm", 2**20), (b"/proc", 4096)):
        must(LIBC.mount(b"tmpfs", place, b"tmpfs", NO_SUID | NO_DEVICES | NO_PROGRAMS, b"mode=1777,size=%d" % most))
    os.chdir("/tmp")


def without_rights(user: int, *, memory: int, cpu: int, files: int) -> None:
    """From here on: no capability, nobody's files, bounded memory (bytes beyond what is mapped), processor (seconds) and files
    (bytes), and not one process or thread more. user : whom to become, where this is root; 0 to stay who it is.
    """
    mapped = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    with_new_files(files)
    if user:
        os.setgroups([])
        os.setresgid(user, user, user)
        os.setresuid(user, user, user)
    must(LIBC.prctl(NO_NEW_RIGHTS, 1, 0, 0, 0))
    must(LIBC.capset(CAPABILITIES_OF_SELF, (ctypes.c_uint32 * 6)()))
    for what, most in (
        (resource.RLIMIT_AS, mapped + memory),
        (resource.RLIMIT_CPU, cpu),
        (resource.RLIMIT_FSIZE, files),
        (resource.RLIMIT_NOFILE, 64),
        (resource.RLIMIT_CORE, 0),
        (resource.RLIMIT_NPROC, 0),
    ):
        resource.setrlimit(what, (most, most))


def must(result: int) -> None:
    """Raise what went wrong in a call of Linux."""
    if result != 0:
        error = ctypes.get_errno()
        raise OSError(error, os.strerror(error))
