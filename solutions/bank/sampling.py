"""Wrong answers to the exercises of lesson 6.

Each is a mistake that students make; `slip` is the misconception that a check must recognise.
"""

import math
from itertools import product
from pathlib import Path

import numpy as np

from kinoedu.course.bank import Solutions, wrong

solutions = Solutions(Path(__file__).parents[1] / "06_sampling.ipynb")
changed, varied = solutions.changed, solutions.varied


def whole_root(n, d):
    """Return k with k^d = n, or raise a ValueError."""
    k = round(n ** (1 / d))
    if k**d != n:
        raise ValueError("no grid has so many points")
    return k


def combined(along, d):
    """Return all combinations of d coordinates."""
    return list(product(along, repeat=d))


# The corner grid


@wrong("corner_grid", slip="both_ends")
def from_end_to_end(n, d):
    """Uses linspace, which includes both ends."""
    return combined(np.linspace(0, 1, whole_root(n, d)), d)


@wrong("corner_grid", slip="centres")
def centres_for_corners(n, d):
    """Is Sukharev's grid."""
    k = whole_root(n, d)
    return combined([(i + 0.5) / k for i in range(k)], d)


@wrong("corner_grid", slip="upper")
def counted_from_one(n, d):
    """Loops over i = 1, ..., k."""
    k = whole_root(n, d)
    return combined([i / k for i in range(1, k + 1)], d)


@wrong("corner_grid", slip="unscaled")
def numbers_of_cells(n, d):
    """Forgets to divide by k."""
    return combined(range(whole_root(n, d)), d)


@wrong("corner_grid", slip="diagonal")
def one_loop(n, d):
    """Pairs i with i."""
    k = whole_root(n, d)
    return [[i / k] * d for i in range(k)]


@wrong("corner_grid", slip="all_along")
def n_points_in_one_loop(n, d):
    """Returns n points along the diagonal."""
    whole_root(n, d)
    return [[i / n] * d for i in range(n)]


@wrong("corner_grid")
def n_along_each_side(n, d):
    """Uses n instead of k."""
    whole_root(n, d)
    return combined([i / n for i in range(n)], d) if n**d < 20_000 else []


@wrong("corner_grid")
def root_cut_off(n, d):
    """Truncates the root: int(64 ** (1/3)) is 3."""
    k = int(n ** (1 / d))
    if k**d != n:
        raise ValueError("no grid has so many points")
    return combined([i / k for i in range(k)], d)


@wrong("corner_grid")
def always_in_the_plane(n, d):
    """Ignores d."""
    k = whole_root(n, 2)
    return combined([i / k for i in range(k)], 2)


@wrong("corner_grid")
def as_many_as_fit(n, d):
    """Never raises."""
    k = math.floor(n ** (1 / d) + 1e-9)
    return combined([i / k for i in range(k)], d)


@wrong("corner_grid")
def numbers_on_a_line_flat(n, d):
    """Returns a flat array in one dimension."""
    k = whole_root(n, d)
    return [i / k for i in range(k)] if d == 1 else combined([i / k for i in range(k)], d)


@wrong("corner_grid")
def two_arrays(n, d):
    """Returns xpoints and ypoints."""
    k = whole_root(n, d)
    return np.meshgrid(*[np.arange(k) / k] * d)


@wrong("corner_grid")
def added_up(n, d):
    """Adds up the step: ten times 0.1 is a little less than 1, which makes one point too many."""
    k, along, x = whole_root(n, d), [], 0.0
    while x < 1:
        along.append(x)
        x += 1 / k
    return combined(along, d)


@wrong("corner_grid")
def power_two_or_nothing(n, d):
    """Tests for a square, whatever d is."""
    k = whole_root(n, 2)
    k = round(n ** (1 / d)) if d != 2 else k
    return combined([i / k for i in range(k)], d)


@wrong("corner_grid")
def nearly_whole_root(n, d):
    """Tests the root with a tolerance: that of 2501 is nearly 50."""
    k = round(n ** (1 / d))
    if abs(n ** (1 / d) - k) > 0.01:
        raise ValueError("no grid has so many points")
    return combined([i / k for i in range(k)], d)


@wrong("corner_grid")
def corners_to_two_digits(n, d):
    """Rounds the coordinates."""
    k = whole_root(n, d)
    return combined([round(i / k, 2) for i in range(k)], d)


steps_added_up = changed("corner_grid", ("[i / k for i in range(k)]", "np.arange(0, 1, 1 / k)"))


# Sukharev's grid


@wrong("sukharev_grid", slip="corners")
def corners_for_centres(n, d):
    """Is the corner grid."""
    k = whole_root(n, d)
    return combined([i / k for i in range(k)], d)


@wrong("sukharev_grid", slip="both_ends")
def on_the_walls(n, d):
    """Uses linspace, which includes both ends."""
    return combined(np.linspace(0, 1, whole_root(n, d)), d)


@wrong("sukharev_grid", slip="wide_margin")
def equal_gaps(n, d):
    """Keeps as far from the walls as from other points."""
    return combined(np.linspace(0, 1, whole_root(n, d) + 2)[1:-1], d)


@wrong("sukharev_grid", slip="half")
def half_a_side(n, d):
    """Computes i / k + 1 / 2."""
    k = whole_root(n, d)
    return combined([i / k + 1 / 2 for i in range(k)], d)


@wrong("sukharev_grid", slip="half_of_n")
def half_a_share_of_n(n, d):
    """Has 1 / (2 n) instead of 1 / (2 k)."""
    k = whole_root(n, d)
    return combined([i / k + 1 / (2 * n) for i in range(k)], d)


@wrong("sukharev_grid", slip="unscaled")
def half_undivided(n, d):
    """Computes i + 1/2, and does not divide by k."""
    return combined([i + 0.5 for i in range(whole_root(n, d))], d)


@wrong("sukharev_grid", slip="diagonal")
def centres_in_one_loop(n, d):
    """Pairs i with i."""
    k = whole_root(n, d)
    return [[(i + 0.5) / k] * d for i in range(k)]


@wrong("sukharev_grid")
def middles_between_corners(n, d):
    """Takes the midpoints of k points from wall to wall, which are only k - 1."""
    k = whole_root(n, d)
    walls = np.linspace(0, 1, k)
    return combined((walls[:-1] + walls[1:]) / 2, d)


@wrong("sukharev_grid")
def moved_along_one_axis(n, d):
    """Moves by half a cell to the right only."""
    k = whole_root(n, d)
    return [(x + 0.5 / k, *rest) for x, *rest in combined([i / k for i in range(k)], d)]


@wrong("sukharev_grid")
def refuses_with_a_message(n, d):
    """Prints a message and returns None."""
    k = round(n ** (1 / d))
    return combined([(i + 0.5) / k for i in range(k)], d) if k**d == n else None


@wrong("sukharev_grid")
def root_not_rounded(n, d):
    """Does not round the root: 64 ** (1/3) is not whole on a computer."""
    k = n ** (1 / d)
    if k != int(k):
        raise ValueError("no grid has so many points")
    return combined([(i + 0.5) / k for i in range(int(k))], d)


@wrong("sukharev_grid")
def root_and_a_little(n, d):
    """Adds a little before it truncates the root, and does not test the result exactly."""
    k = int(n ** (1 / d) + 0.001)
    if not math.isclose(k**d, n, rel_tol=0.001):
        raise ValueError("no grid has so many points")
    return combined([(i + 0.5) / k for i in range(k)], d)


@wrong("sukharev_grid")
def searches_up_to_fifty(n, d):
    """Tries too few k."""
    for k in range(1, 51):
        if k**d == n:
            return combined([(i + 0.5) / k for i in range(k)], d)
    raise ValueError("no grid has so many points")


# Random points


@wrong("uniform_random")
def in_order(n, d, rng):
    """Sorts the random points."""
    return np.sort(np.random.default_rng(rng).random((n, d)), axis=0)


@wrong("uniform_random")
def k_for_n(n, d, rng):
    """Draws only as many numbers as a grid has along a side."""
    return np.random.default_rng(rng).random((math.ceil(math.sqrt(n)), d))


@wrong("uniform_random")
def large_seeds_leave_the_cube(n, d, rng):
    """Stretches the points with the seed, so that only small seeds stay in the cube."""
    return np.random.default_rng(rng).random((n, d)) * max(1.0, rng / 1000)


@wrong("uniform_random")
def large_seeds_draw_more(n, d, rng):
    """Draws more points for a large seed."""
    return np.random.default_rng(rng).random((n + rng // 1000, d))


@wrong("uniform_random")
def whole_numbers(n, d, rng):
    """Draws whole numbers."""
    return np.random.default_rng(rng).integers(1, 7, (n, d))


@wrong("uniform_random")
def places_of_a_lattice(n, d, rng):
    """Draws whole numbers and divides them."""
    return np.random.default_rng(rng).integers(0, 10, (n, d)) / 10


@wrong("uniform_random")
def rounded(n, d, rng):
    """Rounds to two decimals."""
    return np.round(np.random.default_rng(rng).random((n, d)), 2)


@wrong("uniform_random")
def without_a_seed(n, d, rng):
    """Uses a generator without a seed."""
    return np.random.random((n, d))


@wrong("uniform_random")
def seed_taken_for_a_generator(n, d, rng):
    """Calls a method of a generator on the seed."""
    return rng.random((n, d))


@wrong("uniform_random")
def own_seed(n, d, rng):
    """Uses a fixed seed."""
    return np.random.default_rng(0).random((n, d))


@wrong("uniform_random")
def new_generator_for_each_coordinate(n, d, rng):
    """Draws the same numbers for each coordinate."""
    return np.column_stack([np.random.default_rng(rng).random(n) for _ in range(d)])


@wrong("uniform_random")
def new_generator_for_each_number(n, d, rng):
    """Draws the same number again and again."""
    return [[np.random.default_rng(rng).random() for _ in range(d)] for _ in range(n)]


@wrong("uniform_random")
def seeds_in_a_row_for_points(n, d, rng):
    """Uses seeds rng, rng + 1, ...: rng + 1 gives all points but one again."""
    return [np.random.default_rng(rng + i).random(d) for i in range(n)]


@wrong("uniform_random")
def seeds_in_a_row_for_coordinates(n, d, rng):
    """Uses seeds rng and rng + 1: the y of this rng are the x of the next."""
    return np.column_stack([np.random.default_rng(rng + j).random(n) for j in range(d)])


@wrong("uniform_random")
def cut_off_at_the_walls(n, d, rng):
    """Draws normal numbers and clips them."""
    return np.clip(np.random.default_rng(rng).normal(0.5, 0.2, (n, d)), 0, 1)


@wrong("uniform_random")
def bell_curve(n, d, rng):
    """Draws normal numbers and wraps them into the unit interval."""
    drawn = np.random.default_rng(rng).normal(0.5, 0.2, (n, d))
    return drawn % 1.0


@wrong("uniform_random")
def standard_normal(n, d, rng):
    """Uses normal instead of random."""
    return np.random.default_rng(rng).normal(size=(n, d))


@wrong("uniform_random")
def mean_of_two(n, d, rng):
    """Averages two random numbers, which is less uniform."""
    generator = np.random.default_rng(rng)
    return (generator.random((n, d)) + generator.random((n, d))) / 2


@wrong("uniform_random")
def from_minus_one(n, d, rng):
    """Draws from the square from -1 to 1."""
    return np.random.default_rng(rng).uniform(-1, 1, (n, d))


@wrong("uniform_random")
def rows_for_columns(n, d, rng):
    """Returns shape (d, n)."""
    return np.random.default_rng(rng).random((d, n))


@wrong("uniform_random")
def one_in_each_slice(n, d, rng):
    """Draws one coordinate in each of n equal parts, which is too even."""
    generator = np.random.default_rng(rng)
    return np.column_stack([(generator.permutation(n) + generator.random(n)) / n for _ in range(d)])


@wrong("uniform_random")
def second_half_mirrored(n, d, rng):
    """Draws half of the points, and mirrors them."""
    half = np.random.default_rng(rng).random(((n + 1) // 2, d))
    return np.concatenate([half, 1 - half])[:n]


@wrong("uniform_random")
def neighbours_in_one_row(n, d, rng):
    """Uses each number as x of one point and as y of another."""
    drawn = np.random.default_rng(rng).random(n + d)
    return np.column_stack([drawn[j : j + n] for j in range(d)])


@wrong("uniform_random")
def ten_seeds(n, d, rng):
    """Uses the last digit of the seed only."""
    return np.random.default_rng(rng % 10).random((n, d))


@wrong("uniform_random")
def fixed_points_moved(n, d, rng):
    """Moves the same points a little for each seed."""
    return (np.random.default_rng(0).random((n, d)) + 0.001 * rng) % 1


# The radical inverse


@wrong("radical_inverse", slip="forward")
def not_mirrored(i, base):
    """Returns 0.110 for 110."""
    size = 1
    while base**size <= i:
        size += 1
    return i / base**size


@wrong("radical_inverse", slip="left")
def first_digit_before_the_point(i, base):
    """Begins the weight at 1."""
    total, weight = 0, 1
    while i > 0:
        total += i % base * weight
        i, weight = i // base, weight / base
    return total


@wrong("radical_inverse", slip="right")
def one_place_too_far(i, base):
    """Divides the weight twice at first."""
    total, weight = 0, 1 / base
    while i > 0:
        weight /= base
        total += i % base * weight
        i //= base
    return total


@wrong("radical_inverse", slip="whole")
def mirrored_before_the_point(i, base):
    """Returns a whole number."""
    total = 0
    while i > 0:
        total = total * base + i % base
        i //= base
    return total


@wrong("radical_inverse", slip="decimal")
def read_as_a_decimal(i, base):
    """Takes 0.011 for eleven thousandths."""
    text = ""
    while i > 0:
        text += str(i % base)
        i //= base
    return float("0." + (text or "0"))


@wrong("radical_inverse", slip="base_two")
def always_binary(i, base):
    """Uses bin(), which knows only base 2."""
    text = bin(i)[2:][::-1]
    return sum(int(c) / 2 ** (k + 1) for k, c in enumerate(text))


@wrong("radical_inverse", slip="next")
def one_further(i, base):
    """Returns the inverse of i + 1."""
    total, weight, i = 0, 1 / base, i + 1
    while i > 0:
        total += i % base * weight
        i, weight = i // base, weight / base
    return total


@wrong("radical_inverse", slip="first_lost")
def stops_early(i, base):
    """Ends while one digit is left."""
    total, weight = 0, 1 / base
    while i >= base:
        total += i % base * weight
        i, weight = i // base, weight / base
    return total


@wrong("radical_inverse", slip="first_lost")
def logarithm_rounded_up(i, base):
    """Counts one digit too few of each power of the base."""
    count = math.ceil(math.log(i, base)) if i > 1 else 1
    return sum(i // base**k % base / base ** (k + 1) for k in range(count))


@wrong("radical_inverse")
def digits_counted_by_logarithm(i, base):
    """Counts digits by log(243) / log(3), which is 4.999999999999999."""
    size = int(math.log(i) / math.log(base)) + 1 if i > 0 else 0
    return sum(i // base**k % base / base ** (k + 1) for k in range(size))


@wrong("radical_inverse", slip="last_only")
def no_loop(i, base):
    """Has an `if` instead of a `while`."""
    return i % base / base if i > 0 else 0


@wrong("radical_inverse", slip="divided")
def fraction_left_over(i, base):
    """Has / instead of //."""
    total, weight = 0, 1
    while i > 0 and weight > 0:
        weight /= base
        total += i % base * weight
        i = i / base
    return total


@wrong("radical_inverse")
def ten_digits(i, base):
    """Has a loop of fixed length."""
    total = 0
    for k in range(10):
        total += i // base**k % base / base ** (k + 1)
    return total


@wrong("radical_inverse")
def digits_as_letters(i, base):
    """Writes a digit beyond 9 with two characters."""
    text = ""
    while i > 0:
        text += str(i % base)
        i //= base
    return sum(int(c) / base ** (k + 1) for k, c in enumerate(text))


@wrong("radical_inverse")
def nothing_for_zero(i, base):
    """Computes log(0)."""
    return sum(i // base**k % base / base ** (k + 1) for k in range(int(math.log(i, base)) + 2))


@wrong("radical_inverse")
def six_digits(i, base):
    """Rounds its answer."""
    return round(mirrored(i, base), 6)


# Halton's sequence


def mirrored(i, base):
    """Return the radical inverse."""
    total, weight = 0, 1 / base
    while i > 0:
        total += i % base * weight
        i, weight = i // base, weight / base
    return total


@wrong("halton", slip="from_zero")
def begins_in_the_corner(n, primes):
    """Loops over range(n)."""
    return [[mirrored(i, p) for p in primes] for i in range(n)]


@wrong("halton", slip="from_two")
def begins_with_two(n, primes):
    """Uses i + 2."""
    return [[mirrored(i + 2, p) for p in primes] for i in range(n)]


@wrong("halton", slip="one_base")
def one_base_for_all(n, primes):
    """Uses the first prime for all coordinates."""
    return [[mirrored(i, primes[0]) for _ in primes] for i in range(1, n + 1)]


@wrong("halton", slip="own_bases")
def two_three_four(n, primes):
    """Uses bases that are not primes."""
    return [[mirrored(i, base) for base in range(2, 2 + len(primes))] for i in range(1, n + 1)]


@wrong("halton", slip="own_primes")
def primes_not_read(n, primes):
    """Uses the first primes instead of the given ones."""
    return [[mirrored(i, p) for p in (2, 3, 5, 7, 11, 13)[: len(primes)]] for i in range(1, n + 1)]


@wrong("halton", slip="sorted")
def primes_sorted(n, primes):
    """Sorts the primes."""
    return [[mirrored(i, p) for p in sorted(primes)] for i in range(1, n + 1)]


@wrong("halton", slip="backwards")
def last_prime_first(n, primes):
    """Swaps the columns."""
    return [[mirrored(i, p) for p in reversed(primes)] for i in range(1, n + 1)]


@wrong("halton", slip="forward")
def digits_not_mirrored(n, primes):
    """Returns 0.110 for 110."""
    return [[not_mirrored.function(i, p) for p in primes] for i in range(1, n + 1)]


@wrong("halton")
def a_row_for_each_prime(n, primes):
    """Returns shape (d, n)."""
    return [[mirrored(i, p) for i in range(1, n + 1)] for p in primes]


@wrong("halton")
def k_points(n, primes):
    """Returns only as many points as a grid has along a side."""
    return [[mirrored(i, p) for p in primes] for i in range(1, math.ceil(math.sqrt(n)) + 1)]


@wrong("halton")
def one_too_few(n, primes):
    """Loops over range(1, n)."""
    return [[mirrored(i, p) for p in primes] for i in range(1, n)]


@wrong("halton")
def sorted_points(n, primes):
    """Sorts the points from left to right."""
    return sorted([mirrored(i, p) for p in primes] for i in range(1, n + 1))


@wrong("halton")
def two_coordinates_only(n, primes):
    """Returns two coordinates only."""
    return [[mirrored(i, p) for p in primes[:2]] for i in range(1, n + 1)]


@wrong("halton")
def eight_digits(n, primes):
    """Mirrors eight digits, which are too few from number 256 on."""
    return [[mirrored(i % p**8, p) for p in primes] for i in range(1, n + 1)]


@wrong("halton")
def begins_again_after_a_hundred(n, primes):
    """Repeats the hundred points of the book."""
    return [[mirrored((i - 1) % 100 + 1, p) for p in primes] for i in range(1, n + 1)]


@wrong("halton")
def digits_up_to_z(n, primes):
    """Writes digits with 36 characters, and so has no larger base."""
    return [[mirrored(i, min(p, 36)) for p in primes] for i in range(1, n + 1)]


@wrong("halton")
def a_grid_of_both(n, primes):
    """Combines every number of one sequence with every number of the other."""
    k = math.ceil(n ** (1 / len(primes)))
    return list(product(*[[mirrored(i, p) for i in range(1, k + 1)] for p in primes]))[:n]


# Bounds of the dispersion


HALF = math.sqrt(2) / 80  # half the diagonal of a cell


def probes(m=40):
    """Return the centres of m x m cells."""
    along = (np.arange(m) + 0.5) / m
    return np.array(list(product(along, repeat=2)))


def gaps(places, points):
    """Return the absolute differences of coordinates of places and points, (n, m, 2)."""
    return np.abs(places[:, None] - points[None])


def farthest(places, points):
    """Return the greatest distance of a place from its nearest point."""
    return np.sqrt((gaps(places, points) ** 2).sum(axis=2)).min(axis=1).max()


@wrong("dispersion_bounds")
def nothing_added(points):
    """Takes the probes for the whole square."""
    low = farthest(probes(), points)
    return low, low


@wrong("dispersion_bounds")
def half_a_side_added(points):
    """Adds half the side of a cell instead of half its diagonal."""
    low = farthest(probes(), points)
    return low, low + 1 / 80


def probes_at_the_walls(m):
    """Return m x m probes, the first and the last of each row at the walls."""
    return np.array(list(product(np.linspace(0, 1, m), repeat=2)))


@wrong("dispersion_bounds")
def half_a_side_between_walls(points):
    """Adds half the side of a cell; its probes at the walls find the farthest corner and side."""
    low = farthest(probes_at_the_walls(51), points)
    return low, low + 1 / 100


@wrong("dispersion_bounds")
def too_few_between_walls(points):
    """Adds 0.02, where half the diagonal of a cell is longer."""
    low = farthest(probes_at_the_walls(25), points)
    return low, low + 0.02


@wrong("dispersion_bounds")
def too_few_probes(points):
    """Returns right bounds that are far apart."""
    low = farthest(probes(10), points)
    return low, low + math.sqrt(2) / 20


@wrong("dispersion_bounds")
def half_the_way_between_points(points):
    """Measures between points, never at the walls."""
    nearest = [
        min((math.dist(p, q) for q in points if (p != q).any()), default=1.0) for p in points
    ]
    return max(nearest) / 2, max(nearest) / 2 + 0.02


@wrong("dispersion_bounds")
def farthest_point_of_all(points):
    """Uses max instead of min."""
    low = np.sqrt((gaps(probes(), points) ** 2).sum(axis=2)).max()
    return low, low + HALF


@wrong("dispersion_bounds")
def sup_norm(points):
    """Takes the larger of the two differences."""
    low = gaps(probes(), points).max(axis=2).min(axis=1).max()
    return low, low + HALF


@wrong("dispersion_bounds")
def root_forgotten(points):
    """Takes the square of the distance."""
    low = (gaps(probes(), points) ** 2).sum(axis=2).min(axis=1).max()
    return low, low + HALF


@wrong("dispersion_bounds")
def half_the_diagonal_without_brackets(points):
    """Computes sqrt(2) / 2 * m instead of sqrt(2) / (2 * m)."""
    low = farthest(probes(), points)
    return low, low + math.sqrt(2) / 2 * 40


@wrong("dispersion_bounds")
def corner_probes(points):
    """Puts probes at lower corners, a whole cell away from the upper and right walls."""
    low = farthest(probes() - 1 / 80, points)
    return low, low + HALF


@wrong("dispersion_bounds")
def along_the_streets(points):
    """Takes the sum of the two differences."""
    low = gaps(probes(), points).sum(axis=2).min(axis=1).max()
    return low, low + HALF


@wrong("dispersion_bounds")
def high_before_low(points):
    """Returns the bounds in the wrong order."""
    low = farthest(probes(), points)
    return low + HALF, low


@wrong("dispersion_bounds")
def around_the_estimate(points):
    """Puts half of the error below and half above."""
    middle = farthest(probes(), points)
    return middle - 0.01, middle + 0.01


@wrong("dispersion_bounds")
def probes_inside_only(points):
    """Keeps the probes away from the walls."""
    low = farthest(0.1 + 0.8 * probes(), points)
    return low, low + HALF


@wrong("dispersion_bounds")
def diameter(points):
    """Returns the diameter of the hole instead of its radius."""
    low = 2 * farthest(probes(), points)
    return low, low + HALF


@wrong("dispersion_bounds")
def mean_distance(points):
    """Takes the mean instead of the largest distance."""
    low = np.sqrt((gaps(probes(), points) ** 2).sum(axis=2)).min(axis=1).mean()
    return low, low + HALF


@wrong("dispersion_bounds")
def one_number(points):
    """Returns one number instead of two."""
    return farthest(probes(), points)


# Break it


@wrong("exposing_corridor")
def between_the_points_of_the_finest(*_):
    """Ignores the points of coarser grids."""
    return 1 / 32, 0, 3 / 32, 1


@wrong("exposing_corridor")
def too_narrow(*_):
    """Is hidden, but not as wide as possible."""
    return 0.51, 0, 0.53, 1


@wrong("exposing_corridor")
def not_across(*_):
    """Gives a rectangle that is not a corridor."""
    return 0.001, 0.1, 0.03, 0.9


@wrong("exposing_corridor")
def in_the_middle(*_):
    """Gives a corridor at the first point."""
    return 0, 0.49, 1, 0.522


@wrong("exposing_corridor")
def corners_exchanged(*_):
    """Gives the upper right corner first."""
    return 1 / 16, 1, 1 / 32, 0


@wrong("exposing_corridor")
def centre_and_size(*_):
    """Gives centre and size of the rectangle."""
    return 3 / 64, 1 / 2, 1 / 32, 1


@wrong("exposing_corridor")
def beyond_the_square(*_):
    """Gives a corridor outside the square."""
    return -0.1, 0, 0.03, 1


@wrong("exposing_corridor")
def two_corners(*_):
    """Gives two points."""
    return [(1 / 32, 0), (1 / 16, 1)]


# Variants

from_ten = varied("halton", "from_ten", ("range(1, n + 1)", "range(10, n + 10)"))
from_the_last = varied("halton", "reversed", ("range(1, n + 1)", "range(n, 0, -1)"))
from_nine = changed(
    "halton", ("range(1, n + 1)", "range(9, n + 9)"), variant="from_ten", slip="from_zero"
)
down_to_zero = changed(
    "halton", ("range(1, n + 1)", "range(n - 1, -1, -1)"), variant="reversed", slip="from_zero"
)

BOUNDS = "return low, low + math.sqrt(2) / (2 * m)"
bounds_of_the_diameter = varied(
    "dispersion_bounds", "diameter", (BOUNDS, "return 2 * low, 2 * low + math.sqrt(2) / m")
)
middle_of_the_bounds = varied(
    "dispersion_bounds",
    "middle",
    (BOUNDS, "return low + math.sqrt(2) / (4 * m), math.sqrt(2) / (4 * m)"),
)
middle_and_whole_difference = changed(
    "dispersion_bounds",
    (BOUNDS, "return low + math.sqrt(2) / (4 * m), math.sqrt(2) / (2 * m)"),
    variant="middle",
)
only_low_is_doubled = changed(
    "dispersion_bounds", (BOUNDS, BOUNDS.replace("low,", "2 * low,")), variant="diameter"
)
