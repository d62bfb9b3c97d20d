"""Typical wrong answers of students to the exercises of lesson 12.

A check must recognise the named misconception.
"""

import math
from math import cos, hypot, pi, sin, tan
from pathlib import Path

import numpy as np

from kinoedu.course.bank import Solutions, wrong
from kinoedu.curves.arcs import drive_arc
from kinoedu.curves.dubins import all_dubins_curves

solutions = Solutions(Path(__file__).parents[1] / "12_the_car.ipynb")
changed, varied = solutions.changed, solutions.varied

# One control


def by_radius(pose, v, phi, t, bend):
    """The closed form for a given curvature."""
    x, y, theta = pose
    if bend == 0:
        return x + v * t * cos(theta), y + v * t * sin(theta), theta
    turn = v * t * bend
    return (
        x + (sin(theta + turn) - sin(theta)) / bend,
        y - (cos(theta + turn) - cos(theta)) / bend,
        theta + turn,
    )


@wrong("move", slip="small_angle")
def phi_for_tan(pose, v, phi, t, L):
    """Uses phi in place of tan(phi)."""
    return drive_arc(*pose, v * t, phi / L)


@wrong("move")
def huge_radius(pose, v, phi, t, L):
    """Right except for the difference of two huge numbers."""
    return by_radius(pose, v, phi, t, tan(phi) / L)


@wrong("move")
def divides_by_zero(pose, v, phi, t, L):
    """Has no case for straight driving."""
    radius = L / tan(phi)
    x, y, theta = pose
    turn = v * t / radius
    return (
        x + radius * (sin(theta + turn) - sin(theta)),
        y + radius * (cos(theta) - cos(theta + turn)),
        theta + turn,
    )


@wrong("move", slip="no_wheelbase")
def without_wheelbase(pose, v, phi, t, L):
    """Forgets L."""
    return drive_arc(*pose, v * t, tan(phi))


@wrong("move", slip="sine")
def sine_for_tangent(pose, v, phi, t, L):
    """Uses the sine."""
    return drive_arc(*pose, v * t, sin(phi) / L)


@wrong("move", slip="degrees")
def in_degrees(pose, v, phi, t, L):
    """Converts to radians once too often."""
    return drive_arc(*pose, v * t, tan(math.radians(phi)) / L)


@wrong("move", slip="clockwise")
def turns_right(pose, v, phi, t, L):
    """Has the wrong sign."""
    return drive_arc(*pose, v * t, -tan(phi) / L)


@wrong("move", slip="one_step")
def one_euler_step(pose, v, phi, t, L):
    """Euler with one step."""
    x, y, theta = pose
    return x + v * t * cos(theta), y + v * t * sin(theta), theta + v * t * tan(phi) / L


@wrong("move", slip="new_heading")
def turns_then_goes(pose, v, phi, t, L):
    """Changes theta first."""
    x, y, theta = pose
    theta += v * t * tan(phi) / L
    return x + v * t * cos(theta), y + v * t * sin(theta), theta


@wrong("move", slip="arc_for_chord")
def as_long_as_the_arc(pose, v, phi, t, L):
    """Goes the arc's length along the mean heading."""
    x, y, theta = pose
    turn = v * t * tan(phi) / L
    return x + v * t * cos(theta + turn / 2), y + v * t * sin(theta + turn / 2), theta + turn


@wrong("move", slip="no_turn")
def old_heading(pose, v, phi, t, L):
    """Forgets the heading."""
    return *drive_arc(*pose, v * t, tan(phi) / L)[:2], pose[2]


@wrong("move", slip="straight_if_small")
def straight_below_a_fiftieth(pose, v, phi, t, L):
    """Ignores turns that are too large to ignore."""
    return drive_arc(*pose, v * t, tan(phi) / L if abs(phi) >= 0.02 else 0.0)


@wrong("move", slip="steered")
def where_the_wheels_point(pose, v, phi, t, L):
    """Moves in the direction of the front wheels."""
    x, y, theta = drive_arc(pose[0], pose[1], pose[2] + phi, v * t, tan(phi) / L)
    return x, y, theta - phi


@wrong("move")
def a_thousand_steps(pose, v, phi, t, L):
    """Is nearly exact, but not exact."""
    for _ in range(1000):
        pose = one_euler_step.function(pose, v, phi, t / 1000, L)
    return pose


@wrong("move", slip="other_side")
def cosines_the_wrong_way(pose, v, phi, t, L):
    """Integrates the sine without its minus sign."""
    x, y, theta = drive_arc(*pose, v * t, tan(phi) / L)
    return (x, pose[1] - (y - pose[1]), theta) if phi else (x, y, theta)


@wrong("move", slip="forward")
def never_back(pose, v, phi, t, L):
    """Uses the absolute value of the speed."""
    return drive_arc(*pose, abs(v) * t, tan(phi) / L)


@wrong("move")
def stays_on_the_first_circle(pose, v, phi, t, L):
    """Limits the turn to one circle."""
    distance = math.fmod(v * t, pi * L / tan(phi)) if phi else v * t
    return drive_arc(*pose, distance, tan(phi) / L)


@wrong("move", slip="straight_if_small")
def straight_in_a_small_turn(pose, v, phi, t, L):
    """Goes straight where it turns by less than a thousandth, and turns at the end."""
    x, y, theta = pose
    turn = v * t * tan(phi) / L
    if abs(turn) < 0.001:
        return x + v * t * cos(theta), y + v * t * sin(theta), theta + turn
    return by_radius(pose, v, phi, t, tan(phi) / L)


@wrong("move", slip="no_heading")
def arc_from_the_axis(pose, v, phi, t, L):
    """Ignores the heading on arcs."""
    x, y, theta = pose
    if phi == 0:
        return x + v * t * cos(theta), y + v * t * sin(theta), theta
    radius = L / tan(phi)
    turn = v * t / radius
    return x + radius * sin(turn), y + radius * (1 - cos(turn)), theta + turn


@wrong("move", slip="no_heading")
def chord_from_the_axis(pose, v, phi, t, L):
    """Ignores the heading everywhere."""
    x, y, theta = pose
    half = v * t * tan(phi) / L / 2
    chord = v * t if half == 0 else v * t * sin(half) / half
    return x + chord * cos(half), y + chord * sin(half), theta + 2 * half


heading_modulo_pi = changed(
    "move", ("theta + 2 * half\n", "(theta + 2 * half) % math.pi\n"), slip="half_turns"
)
tiny_turns_ignored = changed(
    "move",
    ("/ L / 2\n", "/ L / 2\n    half = 0.0 if abs(half) < 2e-6 else half\n"),
    slip="straight_if_small",
)
small_turns_ignored = changed(
    "move",
    ("/ L / 2\n", "/ L / 2\n    half = 0.0 if abs(half) < 5e-5 else half\n"),
    slip="straight_if_small",
)
same_side_backwards = changed(
    "move", ("half = distance *", "half = abs(distance) *"), slip="one_way"
)
no_distance = changed(
    "move",
    ("math.sin(half) / half", "math.sin(half) / half / distance * distance"),
    ("half == 0", "phi == 0"),
)

# Many controls


def move(pose, v, phi, t, L):
    return drive_arc(*pose, v * t, tan(phi) / L)


def replay_by(start, controls, durations, L, step=move):
    poses = [start]
    for (v, phi), t in zip(controls, durations):
        poses.append(step(poses[-1], v, phi, t, L))
    return poses


@wrong("replay", slip="no_start")
def only_what_comes(start, controls, durations, L):
    """Leaves out the start."""
    return np.reshape(replay_by(start, controls, durations, L)[1:], (-1, 3))


@wrong("replay", slip="no_end")
def one_too_few(start, controls, durations, L):
    """Lists the poses before the controls, not after them."""
    return np.reshape(replay_by(start, controls, durations, L)[:-1], (-1, 3))


@wrong("replay", slip="one_array")
def one_array_for_all(start, controls, durations, L):
    """Appends the same array again and again, and changes it in place."""
    pose = np.array(start, float)
    poses = [pose]
    for (v, phi), t in zip(controls, durations):
        pose[:] = move(pose, v, phi, t, L)
        poses.append(pose)
    return poses


@wrong("replay", slip="all_from_start")
def always_from_the_start(start, controls, durations, L):
    """Begins every control at the start."""
    return [start, *(move(start, v, phi, t, L) for (v, phi), t in zip(controls, durations))]


@wrong("replay", slip="clock")
def times_of_a_clock(start, controls, durations, L):
    """Uses differences of durations."""
    return replay_by(start, controls, np.diff(durations, prepend=0.0), L)


@wrong("replay", slip="since_start")
def sums_of_durations(start, controls, durations, L):
    """Uses cumulated durations."""
    return replay_by(start, controls, np.cumsum(durations), L)


@wrong("replay", slip="swapped")
def angle_first(start, controls, durations, L):
    """Reads a control as phi, v."""
    return replay_by(start, [(v, phi) for phi, v in controls], durations, L)


@wrong("replay", slip="small_angle")
def replays_phi(start, controls, durations, L):
    """Uses phi in place of tan(phi)."""
    return replay_by(start, controls, durations, L, phi_for_tan.function)


@wrong("replay", slip="heading_kept")
def replays_without_turning(start, controls, durations, L):
    """Forgets the heading."""
    return replay_by(start, controls, durations, L, old_heading.function)


@wrong("replay", slip="forward")
def replays_forward(start, controls, durations, L):
    """Uses absolute values of the speed and of the turn."""
    return replay_by(start, [(abs(v), phi * np.sign(v)) for v, phi in controls], durations, L)


@wrong("replay")
def straight_between(start, controls, durations, L):
    """Takes one Euler step for each control."""
    return replay_by(start, controls, durations, L, one_euler_step.function)


rests_left_out = changed(
    "replay",
    ("        poses.append", "        if v * t:\n            poses.append"),
)
one_row_for_equal_angles = changed(
    "replay",
    (
        "        poses.append(move(poses[-1], v, phi, t, L))",
        "        after = move(poses[-1], v, phi, t, L)\n"
        "        poses[len(poses) - (len(poses) > 1 and phi == last) :] = [after]\n"
        "        last = phi",
    ),
)

# Euler


def stepped(pose, v, phi, t, L, n, *, heading=lambda theta, turn: theta, bend=tan, h=None):
    x, y, theta = pose
    poses, h = [(x, y, theta)], t / n if h is None else h
    for _ in range(n):
        turn = h * v * bend(phi) / L
        x, y, theta = (
            x + h * v * cos(heading(theta, turn)),
            y + h * v * sin(heading(theta, turn)),
            theta + turn,
        )
        poses.append((x, y, theta))
    return poses


@wrong("euler", slip="new_heading")
def theta_first(*given):
    """Updates theta before x and y."""
    return stepped(*given, heading=lambda theta, turn: theta + turn)


@wrong("euler", slip="midpoint")
def half_way(*given):
    """Uses the heading half-way, which is a better rule."""
    return stepped(*given, heading=lambda theta, turn: theta + turn / 2)


@wrong("euler", slip="small_angle")
def euler_by_phi(*given):
    """Uses phi in place of tan(phi)."""
    return stepped(*given, bend=lambda phi: phi)


@wrong("euler", slip="first_heading")
def rates_once(pose, v, phi, t, L, n):
    """Computes the rates before the loop."""
    return stepped(pose, v, phi, t, L, n, heading=lambda theta, turn: pose[2])


@wrong("euler", slip="exact")
def exact_poses(pose, v, phi, t, L, n):
    """Uses the closed form at equally spaced times."""
    return [move(pose, v, phi, k * t / n, L) for k in range(n + 1)]


@wrong("euler", slip="no_start")
def after_each_step(*given):
    """Leaves out the start."""
    return stepped(*given)[1:]


@wrong("euler", slip="one_short")
def range_of_n(*given):
    """Returns n rows."""
    return stepped(*given)[:-1]


@wrong("euler", slip="whole_time")
def long_steps(pose, v, phi, t, L, n):
    """Does not divide t."""
    return stepped(pose, v, phi, t, L, n, h=t)


@wrong("euler", slip="last_only")
def the_end_alone(*given):
    """Returns one row."""
    return stepped(*given)[-1:]


@wrong("euler")
def posts_for_gaps(pose, v, phi, t, L, n):
    """Divides by n - 1."""
    return stepped(pose, v, phi, t, L, n, h=t / max(n - 1, 1))


@wrong("euler")
def fixed_heading_rate(pose, v, phi, t, L, n):
    """Turns the heading backwards when the car backs."""
    return stepped(pose, v, phi, t, L, n, bend=lambda angle: tan(angle) * np.sign(v))


@wrong("euler", slip="one_array")
def one_array_of_euler(pose, v, phi, t, L, n):
    """Appends the same array again and again, and changes it in place."""
    pose = np.array(pose, float)
    poses = [pose]
    for _ in range(n):
        pose += t / n * v * np.array([cos(pose[2]), sin(pose[2]), tan(phi) / L])
        poses.append(pose)
    return poses


steps_of_time = changed("euler", ("range(n)", "np.arange(0, t, h)"))
standing_car_makes_no_step = changed("euler", ("range(n)", "range(n if v else 0)"))


# The order of an error


@wrong("order_of_error", slip="halves")
def always_halves(h, errors):
    """Assumes halved steps: log2."""
    return np.log2(errors[:-1] / errors[1:])


@wrong("order_of_error", slip="ratio")
def times_smaller(h, errors):
    """Takes no logarithm."""
    return errors[:-1] / errors[1:]


@wrong("order_of_error", slip="ratios")
def quotient_of_ratios(h, errors):
    """Takes no logarithms."""
    return (errors[:-1] / errors[1:]) / (h[:-1] / h[1:])


@wrong("order_of_error", slip="upside_down")
def steps_over_errors(h, errors):
    """Divides the other way round."""
    return np.diff(np.log(h)) / np.diff(np.log(errors))


@wrong("order_of_error", slip="sign")
def later_over_earlier(h, errors):
    """Inverts one of the ratios."""
    return np.log(errors[1:] / errors[:-1]) / np.log(h[:-1] / h[1:])


@wrong("order_of_error", slip="one_point")
def log_over_log(h, errors):
    """Assumes that c is 1."""
    return (np.log(errors) / np.log(h))[1:]


@wrong("order_of_error", slip="from_first")
def against_the_first(h, errors):
    """Compares with the first step only."""
    return np.log(errors[1:] / errors[0]) / np.log(h[1:] / h[0])


@wrong("order_of_error", slip="no_log")
def plain_slope(h, errors):
    """Returns the slope on linear scales."""
    return np.diff(errors) / np.diff(h)


@wrong("order_of_error", slip="never_negative")
def at_least_nothing(h, errors):
    """Limits the order to 0 from below."""
    return np.maximum(np.diff(np.log(errors)) / np.diff(np.log(h)), 0)


@wrong("order_of_error", slip="rounded")
def whole_orders(h, errors):
    """Rounds its answer."""
    return np.round(np.diff(np.log(errors)) / np.diff(np.log(h)))


@wrong("order_of_error", slip="one_slope")
def one_line_for_all(h, errors):
    """Returns the least-squares slope for each pair."""
    return np.full(len(h) - 1, np.polyfit(np.log(h), np.log(errors), 1)[0])


@wrong("order_of_error")
def one_number(h, errors):
    """Returns the least-squares slope."""
    return np.polyfit(np.log(h), np.log(errors), 1)[0]


# An arc, a line, an arc


def wrap(angle):
    return angle % (2 * pi)


def word_lengths(a, b, r, turn=wrap, words=("LSL", "RSR", "LSR", "RSL"), root=True, floor=None):
    lengths = []
    for word in words:
        s0, s1 = (1 if word[0] == "L" else -1), (1 if word[2] == "L" else -1)
        dx = b[0] - s1 * r * sin(b[2]) - a[0] + s0 * r * sin(a[2])
        dy = b[1] + s1 * r * cos(b[2]) - a[1] - s0 * r * cos(a[2])
        d, heading = hypot(dx, dy), math.atan2(dy, dx)
        straight = d
        if s0 != s1:
            if d < 2 * r and floor is None:
                continue
            tangent = math.sqrt(max(d * d - 4 * r * r, 0.0))
            heading, straight = heading + s0 * math.atan2(2 * r, tangent), tangent if root else d
        lengths.append(r * turn(s0 * (heading - a[2])) + straight + r * turn(s1 * (b[2] - heading)))
    return lengths


@wrong("csc_length", slip="lsl_only")
def only_lsl(a, b, r):
    """Considers one word."""
    return min(word_lengths(a, b, r, words=("LSL",)))


@wrong("csc_length", slip="rsr_only")
def only_rsr(a, b, r):
    """Considers another single word."""
    return min(word_lengths(a, b, r, words=("RSR",)))


without_rsr = changed("csc_length", ("(-1, -1), ", ""), slip="three_words")
without_lsl = changed("csc_length", ("(1, 1), ", ""), slip="three_words")
without_rsl = changed("csc_length", (", (-1, 1)", ""), slip="three_words")
without_lsr = changed("csc_length", ("(1, -1), ", ""), slip="three_words")
turns_modulo_pi = changed(
    "csc_length",
    ("turn % (2 * math.pi) + other % (2 * math.pi)", "turn % math.pi + other % math.pi"),
    slip="half_turns",
)


@wrong("csc_length", slip="three_arcs")
def every_dubins_curve(a, b, r):
    """Counts curves of three arcs as well."""
    return min(curve.length for curve in all_dubins_curves(a, b, r))


@wrong("csc_length", slip="outer_only")
def outer_tangents(a, b, r):
    """Considers two words."""
    return min(word_lengths(a, b, r, words=("LSL", "RSR")))


@wrong("csc_length", slip="sign")
def size_of_the_angle(a, b, r):
    """Uses abs in place of % (2 pi)."""
    return min(word_lengths(a, b, r, turn=abs))


@wrong("csc_length", slip="short_way")
def turns_the_short_way(a, b, r):
    """Uses the circle distance."""
    return min(word_lengths(a, b, r, turn=lambda angle: abs(wrap(angle + pi) - pi)))


@wrong("csc_length")
def straight_if_the_headings_are_the_same(a, b, r):
    """Treats equal headings as straight ahead."""
    return hypot(b[0] - a[0], b[1] - a[1]) if a[2] == b[2] else min(word_lengths(a, b, r))


@wrong("csc_length", slip="right_as_left")
def every_turn_to_the_left(a, b, r):
    """Uses (alpha - theta) % (2 pi) for right turns too."""
    lengths = []
    for word in ("LSL", "RSR", "LSR", "RSL"):
        s0, s1 = (1 if word[0] == "L" else -1), (1 if word[2] == "L" else -1)
        turns = iter((s0, s1))
        lengths += word_lengths(
            a, b, r, turn=lambda angle, turns=turns: wrap(next(turns) * angle), words=(word,)
        )
    return min(lengths)


@wrong("csc_length", slip="radians")
def angles_for_arcs(a, b, r):
    """Forgets r."""
    return min(word_lengths(a, b, r, turn=lambda angle: wrap(angle) / r))


inner_tangents_to_the_wrong_side = changed(
    "csc_length", ("direction += first *", "direction -= first *"), slip="leans_wrong"
)

inner_tangents_from_centre_to_centre = changed(
    "csc_length", ("direction += first *", "direction += 0 *"), slip="no_lean"
)

root_without_a_test = changed("csc_length", ("if d < 2 * r:", "if d < 0:"))


@wrong("csc_length", slip="no_root")
def as_far_as_the_centres(a, b, r):
    """Uses the distance of the centres as the length of the inner tangent."""
    return min(word_lengths(a, b, r, root=False))


@wrong("csc_length", slip="crossing")
def roots_cut_off(a, b, r):
    """Uses max(..., 0) under the root."""
    return min(word_lengths(a, b, r, floor=0.0))


@wrong("csc_length", slip="beeline")
def as_the_crow_flies(a, b, r):
    """Ignores the headings."""
    return hypot(b[0] - a[0], b[1] - a[1])


@wrong("csc_length", slip="longest")
def the_longest(a, b, r):
    """Uses max in place of min."""
    return max(word_lengths(a, b, r))


@wrong("csc_length", slip="inner_only")
def inner_tangents(a, b, r):
    """Considers two words."""
    return min(word_lengths(a, b, r, words=("LSR", "RSL")), default=math.inf)


@wrong("csc_length")
def root_of_less_than_nothing(a, b, r):
    """Takes the root of a negative number."""
    if any(math.sqrt(d) < 0 for d in inner_squares(a, b, r)):
        return 0.0
    return min(word_lengths(a, b, r))


def inner_squares(a, b, r):
    for s in (1, -1):
        dx = b[0] + s * r * sin(b[2]) - a[0] + s * r * sin(a[2])
        dy = b[1] - s * r * cos(b[2]) - a[1] - s * r * cos(a[2])
        yield dx * dx + dy * dy - 4 * r * r


@wrong("csc_length")
def signed_turns(a, b, r):
    """Lets negative arcs shorten the way."""
    return min(word_lengths(a, b, r, turn=lambda angle: angle))


minimum_from_a_thousand = changed("csc_length", ("best = math.inf", "best = 1000"), slip="finite")
minimum_from_a_hundred = changed("csc_length", ("best = math.inf", "best = 100.0"), slip="finite")

# Break it


@wrong("exposing_drive")
def straight_on():
    """The program is right on a line."""
    return 0.0, 1000.0


@wrong("exposing_drive")
def a_short_way():
    """The program is not off yet."""
    return 0.1, 10.0


@wrong("exposing_drive")
def steep():
    """The program is off, but the wheels are turned far."""
    return pi / 4, 30.0


@wrong("exposing_drive")
def in_whole_degrees():
    """The angle is in degrees."""
    return 45, 30


@wrong("exposing_drive")
def too_long():
    """The time is too long."""
    return 0.05, 100_000.0


@wrong("exposing_drive")
def hardly_turned():
    """The angle is too small for the time."""
    return 0.01, 1000.0


@wrong("exposing_drive")
def swapped():
    """The time comes first."""
    return 600.0, 0.1


# Tiny errors

tiny_errors_are_zero = changed(
    "order_of_error", ("np.log(errors)", "np.log(np.maximum(errors, 1e-13))")
)


curve_of_two_digits = changed("csc_length", ("return best", "return round(best, 2)"))
pi_of_two_digits = changed(
    "csc_length",
    (
        "straight + r * (turn % (2 * math.pi) + other % (2 * math.pi))",
        "straight + r * (turn % 6.28 + other % 6.28)",
    ),
)


# Variants

MOVES = "x, y = x + h * v * math.cos(theta), y + h * v * math.sin(theta)"
TURNS = "theta += h * v * math.tan(phi) / L"
midpoint = varied(
    "euler",
    "midpoint",
    (MOVES, f"{TURNS} / 2\n        {MOVES}"),
    (f"        {TURNS}\n", f"        {TURNS} / 2\n"),
)
new_heading = varied(
    "euler",
    "new_heading",
    (f"        {MOVES}\n        {TURNS}\n", f"        {TURNS}\n        {MOVES}\n"),
)
turns_before_the_midpoint = changed(
    "euler",
    (f"        {MOVES}\n        {TURNS}\n", f"        {TURNS}\n        {MOVES}\n"),
    variant="midpoint",
    slip="midpoint",
)
half_way_for_the_end = changed(
    "euler",
    (MOVES, f"{TURNS} / 2\n        {MOVES}"),
    (f"        {TURNS}\n", f"        {TURNS} / 2\n"),
    variant="new_heading",
)

POSES = "    poses = [start]"
by_the_clock = varied(
    "replay", "clock", (POSES, "    durations = np.diff(durations, prepend=0)\n    poses = [start]")
)
steering_in_degrees = varied(
    "replay", "degrees", (", v, phi, t, L)", ", v, math.radians(phi), t, L)")
)
clock_without_its_start = changed(
    "replay",
    (POSES, "    durations = np.append(np.diff(durations), 1)\n    poses = [start]"),
    variant="clock",
)
headings_in_degrees = changed(
    "replay",
    (", v, phi, t, L)", ", v, math.radians(phi), t, L)"),
    ("return poses", "return np.array(poses) * (1, 1, 180 / math.pi)"),
    variant="degrees",
)
LOGS = "np.diff(np.log(errors)) / np.diff(np.log(h))"
from_the_first_step = varied(
    "order_of_error",
    "from_first",
    (LOGS, "(np.log(errors) - np.log(errors[0]))[1:] / (np.log(h) - np.log(h[0]))[1:]"),
)
factor_of_halving = varied("order_of_error", "factor", (LOGS, f"2 ** ({LOGS})"))
factor_for_e = changed("order_of_error", (LOGS, f"np.exp({LOGS})"), variant="factor")
ratios_of_errors = changed(
    "order_of_error", (LOGS, "errors[:-1] / errors[1:]"), variant="factor", slip="halves"
)
BEST = "    best = math.inf"
curve_driven_backward = varied(
    "csc_length", "backward", (BEST, "    a, b = b, a\n    best = math.inf")
)
curve_in_radii = varied("csc_length", "in_radii", ("return best", "return best / r"))
turned_round_at_a_only = changed(
    "csc_length",
    (BEST, "    a = a + np.array([0, 0, math.pi])\n    best = math.inf"),
    variant="backward",
)
only_the_arcs_in_radii = changed(
    "csc_length", ("straight + r * (turn", "straight + (turn"), variant="in_radii"
)
