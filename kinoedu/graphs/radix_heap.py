"""A priority queue for searches, whose priorities mostly rise: it sorts by bits, and compares next
to nothing.

The bits of a float of zero or more, read as a whole number, come in the order of the floats. Let
`least` be the bits of the priority last retrieved. What first differs from it at bit b, counted
from 1 for the lowest, waits in bucket b; what equals it, in bucket 0. So all of a bucket comes
before all of any higher one:

    retrieve the first
     1  if bucket 0 is empty:
     2      b := the lowest bucket that is not
     3      least := the least priority in b
     4      move each entry of b to the bucket where it belongs now
     5  take the first entry of bucket 0

In line 4 every entry goes down, since nothing has changed from bit b upwards: it moves at most once
for each bit, on a grid four times. A binary heap compares at each of its levels instead, and a
processor guesses every other comparison wrong.

A bucket is a list in which the last to come is the first: of equal priorities the node inserted
last is retrieved first. So A* goes on from where it is.

Where an estimate is not consistent, a priority may come that is below `least`. It becomes the least
then, and first differs from the old one at bit b, which it does not have. What was in buckets 0 to
b - 1 has that bit: it all goes to bucket b, which was empty, as what is there would have to be
above the old least and lack the bit.

R. K. Ahuja, K. Mehlhorn, J. B. Orlin, R. E. Tarjan, "Faster algorithms for the shortest path
problem" (1990).
"""

from operator import itemgetter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import callable_from_compiled

PRIORITY, NODE, NEXT = 0, 1, 2  # of an entry
BUCKETS = 64
# behind the buckets: the list of entries to use again, how many were ever used, the bits of the
# least
FREE, USED, LEAST = 64, 65, 66
NONE = -1


class RadixHeap(NamedTuple):
    """entries (capacity, 3): the bits of a priority, its node, the next entry in the list. heads
    (67,): each list's first entry.
    """

    entries: NDArray[np.int64]
    heads: NDArray[np.int64]


@callable_from_compiled
def radix_heap(capacity: int) -> RadixHeap:
    """An empty queue with room for so many nodes."""
    heads = np.full(67, NONE)
    heads[USED] = heads[LEAST] = 0
    return RadixHeap(np.empty((capacity, 3), np.int64), heads)


@callable_from_compiled
def has_room(queue: RadixHeap, count: int) -> bool:
    """Whether there is room for `count` nodes more, whatever was retrieved."""
    return queue.heads[USED] + count <= len(queue.entries)


@callable_from_compiled
def enlarged(queue: RadixHeap, count: int) -> RadixHeap:
    """The same queue with twice the room and that for `count` nodes more. The one given must not be
    used again.
    """
    entries = np.empty((2 * len(queue.entries) + count, 3), np.int64)
    entries[: len(queue.entries)] = queue.entries
    return RadixHeap(entries, queue.heads)


@callable_from_compiled
def insert(queue: RadixHeap, node: int, priority: float) -> None:
    """Insert a node; there must be room."""
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
    put_first(queue, bucket_of(queue, entry), entry)


@callable_from_compiled
def lower_least(queue: RadixHeap, bits: np.int64) -> None:
    """Make `bits` the least, and move what is in the buckets below the bit in which it differs from
    the old one.
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
def first(queue: RadixHeap) -> int:
    """The node of the least priority, of several the one inserted last; -1 where the queue is
    empty.
    """
    if queue.heads[0] == NONE and not fill_first_bucket(queue):
        return NONE
    return queue.entries[queue.heads[0], NODE]


@callable_from_compiled
def remove_first(queue: RadixHeap) -> None:
    """Take out what `first` has just told."""
    entry = queue.heads[0]
    queue.heads[0] = queue.entries[entry, NEXT]
    put_first(queue, FREE, entry)


def in_order(queue: RadixHeap) -> list[int]:
    """All nodes that are in the queue, as often as they are, in the order in which they would be
    retrieved. O(n log n).
    """
    waiting: list[tuple[int, int]] = []
    for entry in queue.heads[:BUCKETS]:
        while entry != NONE:
            waiting.append((int(queue.entries[entry, PRIORITY]), int(queue.entries[entry, NODE])))
            entry = queue.entries[entry, NEXT]
    return [
        node for _, node in sorted(waiting, key=itemgetter(0))
    ]  # equal ones are in one list and keep its order


@callable_from_compiled
def fill_first_bucket(queue: RadixHeap) -> bool:
    """Lines 2 to 4; false where all buckets are empty. The list is turned round first, so that the
    last to come stays the first.
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
        put_first(queue, bucket_of(queue, entry), entry)
        entry = after
    return True


@callable_from_compiled
def bucket_of(queue: RadixHeap, entry: int) -> int:
    """Where an entry belongs: the highest bit in which its priority differs from the least."""
    return bit_length(queue.entries[entry, PRIORITY] ^ queue.heads[LEAST])


@callable_from_compiled
def put_first(queue: RadixHeap, head: int, entry: int) -> None:
    """Make an entry the first of a list."""
    queue.entries[entry, NEXT] = queue.heads[head]
    queue.heads[head] = entry


@callable_from_compiled
def bit_length(number: int) -> int:
    """How many bits a whole number of zero or more has, by halves.

    >>> [bit_length(number) for number in (0, 1, 2, 3, 4, 2**62)]
    [0, 1, 2, 2, 3, 63]
    """
    length = 0
    for half in (32, 16, 8, 4, 2, 1):
        if number >> half:
            number >>= half
            length += half
    return length + number
