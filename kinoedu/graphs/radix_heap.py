"""A radix heap: a priority queue for searches, in which priorities mostly increase.

The bits of a float of zero or more, read as an integer, are ordered as the floats are. Let `least`
be the bits of the priority that was retrieved last. An entry whose highest bit different from
`least` is bit b, counted from 1 for the lowest bit, is kept in bucket b; an entry equal to `least`
is kept in bucket 0. So every entry of a bucket comes before every entry of a higher bucket:

    retrieve the first
     1  if bucket 0 is empty:
     2      b := the lowest bucket that is not empty
     3      least := the least priority in b
     4      move each entry of b to the bucket where it now belongs
     5  take the first entry of bucket 0

In line 4 every entry moves to a lower bucket, because nothing has changed from bit b upwards. So it
moves at most once for each bit; on a grid it moves four times. A binary heap compares priorities at
each of its levels instead, and a processor mispredicts half of those branches.

A bucket is a list with the newest entry first. Ties go to the most recently inserted node, so A*
continues from where it is.

Where a heuristic is not consistent, a priority may arrive that is below `least`. It then becomes
`least`. Let b be the highest bit in which it differs from the old one: the old value has that bit,
the new one does not. All entries of buckets 0 to b - 1 have it, so they move to bucket b. Bucket b
was empty, because its entries would be above the old `least` and lack that bit.

R. K. Ahuja, K. Mehlhorn, J. B. Orlin, R. E. Tarjan, "Faster algorithms for the shortest path
problem" (1990).
"""

from operator import itemgetter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import callable_from_compiled

PRIORITY, NODE, NEXT = 0, 1, 2  # the columns of an entry
BUCKETS = 64
# heads[FREE] is the list of entries to reuse, heads[USED] the number of entries ever used, and
# heads[LEAST] the bits of the least priority
FREE, USED, LEAST = 64, 65, 66
NONE = -1


class RadixHeap(NamedTuple):
    """A queue in flat arrays.

    entries : (capacity, 3), the bits of a priority, its node, the next entry in the list.
    heads : (67,), the first entry of each list, and three more values: see the constants above.
    """

    entries: NDArray[np.int64]
    heads: NDArray[np.int64]


@callable_from_compiled
def empty_heap(capacity: int) -> RadixHeap:
    """An empty queue with room for `capacity` entries."""
    heads = np.full(67, NONE)
    heads[USED] = heads[LEAST] = 0
    return RadixHeap(np.empty((capacity, 3), np.int64), heads)


@callable_from_compiled
def has_room(queue: RadixHeap, count: int) -> bool:
    """Whether there is room for `count` more entries, however many were retrieved."""
    return queue.heads[USED] + count <= len(queue.entries)


@callable_from_compiled
def enlarge(queue: RadixHeap, count: int) -> RadixHeap:
    """A queue with the same entries and twice the room, and room for `count` more.

    The queue that was given must not be used again.
    """
    entries = np.empty((2 * len(queue.entries) + count, 3), np.int64)
    entries[: len(queue.entries)] = queue.entries
    return RadixHeap(entries, queue.heads)


@callable_from_compiled
def insert(queue: RadixHeap, node: int, priority: float) -> None:
    """Insert a node; the queue must have room."""
    entry = queue.heads[FREE]
    if entry == NONE:
        entry = queue.heads[USED]
        queue.heads[USED] += 1
    else:
        queue.heads[FREE] = queue.entries[entry, NEXT]
    bits = np.float64(priority).view(np.int64)
    if bits < queue.heads[LEAST]:
        lower_least(queue, bits)
    queue.entries[entry, PRIORITY], queue.entries[entry, NODE] = bits, node
    push_front(queue, bucket_of(queue, entry), entry)


@callable_from_compiled
def lower_least(queue: RadixHeap, bits: np.int64) -> None:
    """Make `bits` the least priority.

    Buckets below the highest bit in which it differs from the old least are moved to that bit's
    bucket.
    """
    bucket = bit_length(bits ^ queue.heads[LEAST])
    for lower in range(bucket):
        entry = queue.heads[lower]
        if entry != NONE:
            while queue.entries[entry, NEXT] != NONE:
                entry = queue.entries[entry, NEXT]
            queue.entries[entry, NEXT] = queue.heads[bucket]
            queue.heads[bucket], queue.heads[lower] = queue.heads[lower], NONE
    queue.heads[LEAST] = bits


@callable_from_compiled
def peek(queue: RadixHeap) -> int:
    """The node of least priority, or -1 where the queue is empty.

    Ties go to the most recently inserted node.
    """
    if queue.heads[0] == NONE and not fill_first_bucket(queue):
        return NONE
    return queue.entries[queue.heads[0], NODE]


@callable_from_compiled
def remove_first(queue: RadixHeap) -> None:
    """Remove the entry whose node `peek` has just returned."""
    entry = queue.heads[0]
    queue.heads[0] = queue.entries[entry, NEXT]
    push_front(queue, FREE, entry)


def list_in_order(queue: RadixHeap) -> list[int]:
    """All nodes in the queue, with repetitions, in the order of retrieval. O(n log n)."""
    waiting: list[tuple[int, int]] = []
    for entry in queue.heads[:BUCKETS]:
        while entry != NONE:
            waiting.append((int(queue.entries[entry, PRIORITY]), int(queue.entries[entry, NODE])))
            entry = queue.entries[entry, NEXT]
    # equal priorities are in one list, and the sort keeps its order
    return [node for _, node in sorted(waiting, key=itemgetter(0))]


@callable_from_compiled
def fill_first_bucket(queue: RadixHeap) -> bool:
    """Lines 2 to 4; false where all buckets are empty.

    The list is reversed first, so that the newest entry stays the first of its new list.
    """
    bucket = 1
    while bucket < BUCKETS and queue.heads[bucket] == NONE:
        bucket += 1
    if bucket == BUCKETS:
        return False
    entry, before = queue.heads[bucket], NONE
    least = queue.entries[entry, PRIORITY]
    while entry != NONE:
        least = min(least, queue.entries[entry, PRIORITY])
        after = queue.entries[entry, NEXT]
        queue.entries[entry, NEXT] = before
        entry, before = after, entry
    queue.heads[bucket], queue.heads[LEAST] = NONE, least
    entry = before
    while entry != NONE:
        after = queue.entries[entry, NEXT]
        push_front(queue, bucket_of(queue, entry), entry)
        entry = after
    return True


@callable_from_compiled
def bucket_of(queue: RadixHeap, entry: int) -> int:
    """The bucket of an entry: the highest bit in which its priority differs from the least."""
    return bit_length(queue.entries[entry, PRIORITY] ^ queue.heads[LEAST])


@callable_from_compiled
def push_front(queue: RadixHeap, head: int, entry: int) -> None:
    """Insert an entry at the front of a list."""
    queue.entries[entry, NEXT] = queue.heads[head]
    queue.heads[head] = entry


@callable_from_compiled
def bit_length(number: int) -> int:
    """The number of bits of an integer of zero or more: the exponent of that number as a float.

    Every bit below a one is cleared first, so that the float is not rounded up to a power of two.
    There are no branches, which a processor would mispredict.

    Examples
    --------
    >>> [bit_length(number) for number in (0, 1, 2, 3, 4, 2**62, 2**63 - 1)]
    [0, 1, 2, 2, 3, 63, 63]
    """
    return max(int(np.float64(number & ~(number >> 1)).view(np.int64) >> 52) - 1022, 0)
