"""Calls of Linux that a student's program may not make: they start processes, reach others, open
networks and shared memory, or ask the kernel for more than a calculation needs.

Most are stopped by something else as well. This is the wall where there is none other: memory that
no limit counts (System V's, memfd), and new user namespaces, in which everybody is root. Linux
filters calls by a small program, see seccomp(2).
"""

import ctypes
import errno
import platform
import struct

SECCOMP, BY_FILTER = 22, 2  # prctl's
LOAD, JUMP_IF_EQUAL, JUMP_IF_AT_LEAST, RETURN = 0x20, 0x15, 0x35, 0x06
ALLOW, KILL, REFUSE = 0x7FFF_0000, 0x8000_0000, 0x0005_0000 | errno.EPERM
OTHER_CALLS = 0x4000_0000  # from here on x86_64 has each call once more

NEW = (
    425,
    427,
    428,
    429,
    430,
    432,
    433,
    434,
    435,
    442,
)  # io_uring, mounts, pidfd_open, clone3: the same number everywhere
CALLS: dict[
    str, tuple[int, int, tuple[int, ...]]
] = {  # the machine: its mark, clone, and what is refused
    "x86_64": (
        0xC000_003E,
        56,
        (
            *(56, 57, 58, 59, 322),  # clone, fork, vfork, execve, execveat
            *(
                41,
                53,
                101,
                310,
                311,
                312,
            ),  # socket, socketpair, ptrace, process_vm_readv, process_vm_writev, kcmp
            *(
                29,
                64,
                68,
                240,
                319,
                447,
            ),  # shmget, semget, msgget, mq_open, memfd_create, memfd_secret
            *(
                135,
                155,
                161,
                165,
                166,
                272,
                308,
            ),  # personality, pivot_root, chroot, mount, umount2, unshare, setns
            *(
                248,
                249,
                250,
                298,
                321,
                323,
            ),  # add_key, request_key, keyctl, perf_event_open, bpf, userfaultfd
        ),
    ),
    "aarch64": (  # the same, without fork and vfork, which it has not
        0xC000_00B7,
        220,
        (
            *(220, 221, 281),
            *(198, 199, 117, 270, 271, 272),
            *(194, 190, 186, 180, 279, 447),
            *(92, 41, 51, 40, 39, 97, 268),
            *(217, 218, 219, 241, 280, 282),
        ),
    ),
}
MARK, FORK, REFUSED = CALLS.get(platform.machine(), (0, -1, ()))


class Filter(ctypes.Structure):
    """A filter as Linux wants it: how many steps, and where they are."""

    _fields_ = [("length", ctypes.c_ushort), ("steps", ctypes.c_char_p)]


def filtering() -> Filter:
    """The filter of this machine. Its steps: is it this machine's way to call, and is the call one
    of those refused?
    """
    refused = REFUSED + NEW
    steps = [(LOAD, 0, 0, 4), (JUMP_IF_EQUAL, 1, 0, MARK), (RETURN, 0, 0, KILL), (LOAD, 0, 0, 0)]
    steps += [(JUMP_IF_AT_LEAST, len(refused) + 1, 0, OTHER_CALLS)]
    steps += [(JUMP_IF_EQUAL, len(refused) - at, 0, call) for at, call in enumerate(refused)]
    steps += [(RETURN, 0, 0, ALLOW), (RETURN, 0, 0, REFUSE)]
    return Filter(len(steps), b"".join(struct.pack("=HBBI", *step) for step in steps))
