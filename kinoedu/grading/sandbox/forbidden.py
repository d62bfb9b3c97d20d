"""System calls that a student's program may not make.

They start processes, reach other processes, open networks or shared memory, ask what others have
done, such as which pages of a file are in memory, or ask the kernel for more than a calculation
needs. Most of them are prevented by something else as well. Two are prevented only here: memory
that no limit counts (System V's, memfd), and new user namespaces, in which every user is root.
Linux filters system calls by a small program; see seccomp(2).
"""

import ctypes
import errno
import platform
import struct

SECCOMP, BY_FILTER = 22, 2  # arguments of prctl
LOAD, JUMP_IF_EQUAL, JUMP_IF_AT_LEAST, RETURN = 0x20, 0x15, 0x35, 0x06
ALLOW, KILL, REFUSE = 0x7FFF_0000, 0x8000_0000, 0x0005_0000 | errno.EPERM
OTHER_CALLS = 0x4000_0000  # x86_64 repeats all its calls from this number on

# pidfd_send_signal, io_uring, mounts, pidfd_open, clone3, pidfd_getfd, process_madvise, cachestat:
# their numbers are the same on every machine
NEW = (424, 425, 427, 428, 429, 430, 432, 433, 434, 435, 438, 440, 442, 451)
# for each machine: its mark, the number of clone, and the numbers of refused calls
CALLS: dict[str, tuple[int, int, tuple[int, ...]]] = {
    "x86_64": (
        0xC000_003E,
        56,
        (
            # clone, fork, vfork, execve, execveat
            *(56, 57, 58, 59, 322),
            # socket, socketpair, ptrace, process_vm_readv, process_vm_writev, kcmp
            *(41, 53, 101, 310, 311, 312),
            # shmget, semget, msgget, mq_open, memfd_create, memfd_secret
            *(29, 64, 68, 240, 319, 447),
            # personality, pivot_root, chroot, mount, umount2, unshare, setns
            *(135, 155, 161, 165, 166, 272, 308),
            # add_key, request_key, keyctl, perf_event_open, bpf, userfaultfd
            *(248, 249, 250, 298, 321, 323),
            # fadvise64, mincore, preadv2, readahead, flock, inotify_init, inotify_init1
            *(221, 27, 327, 187, 73, 253, 294),
            # fanotify_init, name_to_handle_at, open_by_handle_at, syslog, sysinfo
            *(300, 303, 304, 103, 99),
            # utime, utimes, futimesat, utimensat
            *(132, 235, 261, 280),
        ),
    ),
    "aarch64": (  # the same calls, but for fork, vfork, inotify_init and utime, which it lacks
        0xC000_00B7,
        220,
        (
            *(220, 221, 281),
            *(198, 199, 117, 270, 271, 272),
            *(194, 190, 186, 180, 279, 447),
            *(92, 41, 51, 40, 39, 97, 268),
            *(217, 218, 219, 241, 280, 282),
            *(223, 232, 286, 213, 32, 26),
            *(262, 264, 265, 116, 179),
            *(88,),
        ),
    ),
}
MARK, FORK, REFUSED = CALLS.get(platform.machine(), (0, -1, ()))
PIVOT_ROOT = {"x86_64": 155, "aarch64": 41}.get(platform.machine(), -1)


class Filter(ctypes.Structure):
    """A filter as Linux expects it: the number of its steps, and their address."""

    _fields_ = [("length", ctypes.c_ushort), ("steps", ctypes.c_char_p)]


def make_filter() -> Filter:
    """The filter of this machine.

    Its steps check that the call is made in this machine's own way, and that it is not a refused
    one.
    """
    refused = REFUSED + NEW
    steps = [(LOAD, 0, 0, 4), (JUMP_IF_EQUAL, 1, 0, MARK), (RETURN, 0, 0, KILL), (LOAD, 0, 0, 0)]
    steps += [(JUMP_IF_AT_LEAST, len(refused) + 1, 0, OTHER_CALLS)]
    steps += [(JUMP_IF_EQUAL, len(refused) - at, 0, call) for at, call in enumerate(refused)]
    steps += [(RETURN, 0, 0, ALLOW), (RETURN, 0, 0, REFUSE)]
    return Filter(len(steps), b"".join(struct.pack("=HBBI", *step) for step in steps))
