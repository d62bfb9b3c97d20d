"""Typical wrong answers of students to the exercises of lesson 5.

A check must recognise the named misconception.
"""

import math
from math import atan, atan2, cos, hypot, pi, sin
from pathlib import Path

import numpy as np

from kinoedu.course.bank import Solutions, wrong
from kinoedu.geometry.displacements import displacement, rotation
from kinoedu.spaces import circle_distance, torus_distance

lesson = Solutions(Path(__file__).parents[1] / "05_configuration_spaces.ipynb")
changed, varied = lesson.changed, lesson.varied

# Degrees of freedom


@wrong("degrees_of_freedom", slip="ground")
def ground_moves(bodies, joints):
    """Counts the ground as a moving body, without subtracting it."""
    return 3 * (bodies + 1) - 2 * sum(len(held) - 1 for held in joints)


@wrong("degrees_of_freedom", slip="less_one")
def ground_among_the_bodies(bodies, joints):
    """Subtracts the ground, although `bodies` does not count it."""
    return 3 * (bodies - 1) - 2 * sum(len(held) - 1 for held in joints)


@wrong("degrees_of_freedom", slip="shared")
def two_a_pin(bodies, joints):
    """Counts a pin through three bodies like one through two."""
    return 3 * bodies - 2 * len(joints)


@wrong("degrees_of_freedom", slip="three")
def glued(bodies, joints):
    """Lets a pin remove all three degrees of freedom."""
    return 3 * bodies - 3 * sum(len(held) - 1 for held in joints)


@wrong("degrees_of_freedom", slip="one")
def freedom_for_constraint(bodies, joints):
    """Lets a pin remove what it leaves."""
    return 3 * bodies - sum(len(held) - 1 for held in joints)


@wrong("degrees_of_freedom", slip="points")
def bodies_are_points(bodies, joints):
    """Forgets that a body can turn."""
    return 2 * bodies - 2 * sum(len(held) - 1 for held in joints)


@wrong("degrees_of_freedom", slip="every_body")
def every_body_loses_two(bodies, joints):
    """Counts the first body of a pin too."""
    return 3 * bodies - sum(2 * len(held) for held in joints)


@wrong("degrees_of_freedom", slip="every_body")
def every_moving_body_loses_two(bodies, joints):
    """Excludes only the ground."""
    return 3 * bodies - sum(2 for held in joints for body in held if body != 0)


@wrong("degrees_of_freedom", slip="pins")
def one_for_each_pin(bodies, joints):
    """Counts pins, which is right for arms."""
    return len(joints)


@wrong("degrees_of_freedom", slip="no_pins")
def all_bodies_free(bodies, joints):
    """Forgets the pins."""
    total = 0
    for _ in range(bodies):
        total += 3
    return total


@wrong("degrees_of_freedom", slip="never_less")
def never_below_zero(bodies, joints):
    """Limits the count to 0 from below."""
    return max(3 * bodies - 2 * sum(len(held) - 1 for held in joints), 0)


@wrong("degrees_of_freedom")
def bodies_that_pins_hold(bodies, joints):
    """Forgets a body without a pin."""
    moving = {body for held in joints for body in held} - {0}
    return 3 * len(moving) - 2 * sum(len(held) - 1 for held in joints)


@wrong("degrees_of_freedom")
def pins_to_the_ground_only(bodies, joints):
    """Forgets pins between moving bodies."""
    return 3 * bodies - 2 * sum(len(held) - 1 for held in joints if 0 in held)


@wrong("degrees_of_freedom")
def in_space(bodies, joints):
    """Counts six for each body and five for each hinge."""
    return 6 * bodies - 5 * sum(len(held) - 1 for held in joints)


equal_pins_once = changed(
    "degrees_of_freedom", ("for held in joints", "for held in set(map(tuple, joints))")
)
ground_only_if_first = changed(
    "degrees_of_freedom", ("(len(held) - 1)", "(len(held) - 1 - (0 in held[1:]))")
)
three_without_pins = changed(
    "degrees_of_freedom",
    ("3 * bodies -", "3 if not joints else 3 * bodies -"),
    slip="no_pin",
)

# Rotations

absolute_angle = changed(
    "rotation",
    ("math.cos(theta), math.sin(theta)", "math.cos(theta), math.sin(abs(theta))"),
    slip="absolute",
)


rotation_modulo_pi = changed(
    "rotation", ("    c, s", "    theta %= math.pi\n    c, s"), slip="half_turns"
)
rounded_sine = changed(
    "rotation",
    ("math.cos(theta), math.sin(theta)", "round(math.cos(theta), 3), round(math.sin(theta), 3)"),
    slip="rounded",
)
displaced_modulo_pi = changed(
    "displacement", ("rotation(theta)", "rotation(theta % math.pi)"), slip="half_turns"
)
displaced_by_rounded_sine = changed(
    "displacement", ("rotation(theta)", "np.round(rotation(theta), 2)"), slip="rounded"
)


@wrong("rotation", slip="clockwise")
def to_the_right(theta):
    """Puts the minus sign at the other sine."""
    return [[cos(theta), sin(theta)], [-sin(theta), cos(theta)]]


@wrong("rotation", slip="degrees")
def radians_of_radians(theta):
    """Treats theta as degrees."""
    return rotation(math.radians(theta))


@wrong("rotation", slip="mirror")
def mirrored(theta):
    """Returns a reflection."""
    return [[cos(theta), sin(theta)], [sin(theta), -cos(theta)]]


@wrong("rotation", slip="swapped")
def sines_on_the_diagonal(theta):
    """Exchanges sine and cosine."""
    return [[sin(theta), -cos(theta)], [cos(theta), sin(theta)]]


@wrong("rotation", slip="sign")
def no_minus(theta):
    """Forgets the minus sign."""
    return [[cos(theta), sin(theta)], [sin(theta), cos(theta)]]


@wrong("rotation", slip="root")
def root_for_a_sine(theta):
    """Computes the sine by Pythagoras, which is never negative."""
    c = cos(theta)
    s = math.sqrt(1 - c * c)
    return [[c, -s], [s, c]]


@wrong("rotation", slip="half_turns")
def wrapped_by_half_turns(theta):
    """Removes half turns where whole ones were meant."""
    return rotation(theta % pi)


@wrong("rotation")
def small_angles(theta):
    """Uses the small-angle approximation."""
    return [[1.0, -theta], [theta, 1.0]]


@wrong("rotation", slip="rounded")
def rounded_matrix(theta):
    """Rounds its answer."""
    return np.round(rotation(theta), 3)


@wrong("rotation")
def four_numbers(theta):
    """Returns four numbers, not two rows of two."""
    return [cos(theta), -sin(theta), sin(theta), cos(theta)]


# Displacements


@wrong("displacement", slip="move_first")
def moves_first(x, y, theta):
    """Turns the shift."""
    return displacement(0, 0, theta) @ displacement(x, y, 0)


@wrong("displacement", slip="clockwise")
def turned_to_the_right(x, y, theta):
    """Puts the minus sign at the other sine."""
    c, s = cos(theta), sin(theta)
    return [[c, s, x], [-s, c, y], [0, 0, 1]]


@wrong("displacement", slip="transposed")
def shift_in_the_last_row(x, y, theta):
    """Uses the convention of row vectors."""
    c, s = cos(theta), sin(theta)
    return [[c, s, 0], [-s, c, 0], [x, y, 1]]


@wrong("displacement", slip="way_back")
def from_world_to_robot(x, y, theta):
    """Returns the inverse."""
    c, s = cos(theta), sin(theta)
    return [[c, s, -c * x - s * y], [-s, c, s * x - c * y], [0, 0, 1]]


@wrong("displacement", slip="no_one")
def zeros_below(x, y, theta):
    """Begins with np.zeros((3, 3)), and forgets the 1."""
    matrix = np.zeros((3, 3))
    matrix[:2, :2], matrix[:2, 2] = rotation(theta), (x, y)
    return matrix


@wrong("displacement", slip="degrees")
def displaced_by_degrees(x, y, theta):
    """Treats theta as degrees."""
    return displacement(x, y, math.radians(theta))


@wrong("displacement", slip="no_turn")
def only_moves(x, y, theta):
    """Forgets theta."""
    return [[1, 0, x], [0, 1, y], [0, 0, 1]]


@wrong("displacement", slip="whole")
def array_of_whole_numbers(x, y, theta):
    """Fills an array of integers, which cuts off the fractions."""
    matrix = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    matrix[:2, :2] = rotation(theta)
    matrix[:2, 2] = x, y
    return matrix


@wrong("displacement")
def x_and_y_exchanged(x, y, theta):
    """Exchanges x and y."""
    return displacement(y, x, theta)


@wrong("displacement")
def only_two_rows(x, y, theta):
    """Leaves out the last row."""
    return displacement(x, y, theta)[:2]


@wrong("displacement")
def a_configuration(x, y, theta):
    """Returns its arguments."""
    return x, y, theta


# Forward kinematics


def joints(l1, l2, q):
    elbow = np.array([l1 * cos(q[0]), l1 * sin(q[0])])
    return elbow, elbow + np.array([l2 * cos(q[0] + q[1]), l2 * sin(q[0] + q[1])])


@wrong("forward_kinematics", slip="rounded")
def sines_rounded_too_early(l1, l2, q):
    """Rounds sines and cosines before it multiplies."""
    x, y = l1 * round(cos(q[0]), 2), l1 * round(sin(q[0]), 2)
    return (x, y), (x + l2 * round(cos(q[0] + q[1]), 2), y + l2 * round(sin(q[0] + q[1]), 2))


joints_rounded = changed(
    "forward_kinematics",
    ("return elbow, tip", "return elbow.round(2), tip.round(2)"),
    slip="rounded",
)


@wrong("forward_kinematics", slip="absolute")
def angles_from_the_x_axis(l1, l2, q):
    """Does not add the first angle to the second."""
    elbow = np.array([l1 * cos(q[0]), l1 * sin(q[0])])
    return elbow, elbow + np.array([l2 * cos(q[1]), l2 * sin(q[1])])


@wrong("forward_kinematics", slip="swapped")
def tip_first(l1, l2, q):
    """Returns the tip first."""
    return joints(l1, l2, q)[::-1]


@wrong("forward_kinematics", slip="from_elbow")
def tip_seen_from_the_elbow(l1, l2, q):
    """Does not add the elbow."""
    elbow, tip = joints(l1, l2, q)
    return elbow, tip - elbow


@wrong("forward_kinematics", slip="same_array")
def tip_is_the_elbow(l1, l2, q):
    """Uses +=, which changes the array that has both names."""
    elbow = np.array([l1 * cos(q[0]), l1 * sin(q[0])])
    tip = elbow
    tip += np.array([l2 * cos(q[0] + q[1]), l2 * sin(q[0] + q[1])])
    return elbow, tip


@wrong("forward_kinematics", slip="difference")
def bends_to_the_right(l1, l2, q):
    """Subtracts the second angle."""
    return joints(l1, l2, (q[0], -q[1]))


@wrong("forward_kinematics", slip="axes")
def sine_for_x(l1, l2, q):
    """Exchanges sine and cosine."""
    return [place[::-1] for place in joints(l1, l2, q)]


@wrong("forward_kinematics", slip="one_length")
def equal_links(l1, l2, q):
    """Uses l1 for both links."""
    return joints(l1, l1, q)


@wrong("forward_kinematics", slip="columns")
def points_as_columns(l1, l2, q):
    """Returns the points as columns."""
    return np.column_stack(joints(l1, l2, q))


@wrong("forward_kinematics", slip="degrees")
def arm_in_degrees(l1, l2, q):
    """Treats the angles as degrees."""
    return joints(l1, l2, np.radians(q))


@wrong("forward_kinematics")
def only_the_tip(l1, l2, q):
    """Forgets the elbow."""
    return joints(l1, l2, q)[1]


@wrong("forward_kinematics")
def never_folds(l1, l2, q):
    """Wraps the second angle to half a turn."""
    return joints(l1, l2, (q[0], q[1] % pi))


@wrong("forward_kinematics")
def turns_the_array(l1, l2, q):
    """Uses q[1] += q[0] on the caller's array."""
    q[1] += q[0]
    elbow = np.array([l1 * cos(q[0]), l1 * sin(q[0])])
    return elbow, elbow + np.array([l2 * cos(q[1]), l2 * sin(q[1])])


# Inverse kinematics


def solutions(l1, l2, p):
    """Right solutions, for programs that go wrong elsewhere."""
    far = hypot(*p)
    if far == 0 and l1 == l2:
        raise ValueError("infinitely many")
    if far > l1 + l2 or far < abs(l1 - l2):
        return []
    bend = math.acos((far * far - l1 * l1 - l2 * l2) / (2 * l1 * l2))
    lead = atan2(l2 * sin(bend), l1 + l2 * cos(bend))
    heading = atan2(p[1], p[0])
    return [(heading - lead, bend), (heading + lead, -bend)]


@wrong("inverse_kinematics", slip="one")
def one_elbow(l1, l2, p):
    """Returns only the solution of acos."""
    return solutions(l1, l2, p)[:1]


@wrong("inverse_kinematics", slip="one")
def the_other_elbow(l1, l2, p):
    """Returns only the solution of -acos."""
    return solutions(l1, l2, p)[1:]


@wrong("inverse_kinematics", slip="half_mirrored")
def only_the_bend_mirrored(l1, l2, p):
    """Keeps the direction of link 1."""
    return [
        (first, sign * second) for first, second in solutions(l1, l2, p)[:1] for sign in (1, -1)
    ]


@wrong("inverse_kinematics", slip="half_mirrored")
def mirrored_in_the_x_axis(l1, l2, p):
    """Changes the signs of both angles, wherever p is."""
    return [
        (sign * first, sign * second)
        for first, second in solutions(l1, l2, p)[:1]
        for sign in (1, -1)
    ]


@wrong("inverse_kinematics", slip="mixed")
def wrongly_paired(l1, l2, p):
    """Pairs the signs wrongly."""
    return [(first, -second) for first, second in solutions(l1, l2, p)]


@wrong("inverse_kinematics", slip="absolute")
def second_from_the_x_axis(l1, l2, p):
    """Measures the second angle from the x-axis."""
    return [(first, first + second) for first, second in solutions(l1, l2, p)]


@wrong("inverse_kinematics", slip="half_plane")
def slope_of_p(l1, l2, p):
    """Uses atan(y / x), which covers two quadrants only."""
    heading = atan2(p[1], p[0])
    with np.errstate(all="ignore"):
        other = atan(p[1] / p[0])
    return [(first - heading + other, second) for first, second in solutions(l1, l2, p)]


@wrong("inverse_kinematics", slip="no_heading")
def always_to_the_right(l1, l2, p):
    """Forgets the direction of p."""
    heading = atan2(p[1], p[0])
    return [(first - heading, second) for first, second in solutions(l1, l2, p)]


@wrong("inverse_kinematics", slip="axes")
def x_before_y(l1, l2, p):
    """Uses atan2(x, y)."""
    return solutions(l1, l2, p[::-1])


@wrong("inverse_kinematics", slip="exchanged")
def other_side(l1, l2, p):
    """Uses the angle at the tip for the angle at the base."""
    found = solutions(l1, l2, p)
    if not found:
        return []
    far, heading = hypot(*p), atan2(p[1], p[0])
    lead = math.acos((l2 * l2 + far * far - l1 * l1) / (2 * l2 * far))
    return [(heading - lead, found[0][1]), (heading + lead, found[1][1])]


@wrong("inverse_kinematics", slip="inner_angle")
def angle_in_the_triangle(l1, l2, p):
    """Returns the inner angle at the elbow, not that of the joint."""
    return [
        (first, math.copysign(pi - abs(second), second)) for first, second in solutions(l1, l2, p)
    ]


@wrong("inverse_kinematics", slip="inner_angle")
def law_of_cosines_by_heart(l1, l2, p):
    """Uses the inner angle as the second angle throughout."""
    far = hypot(*p)
    if far == 0 and l1 == l2:
        raise ValueError("infinitely many")
    cosine = (l1 * l1 + l2 * l2 - far * far) / (2 * l1 * l2)
    if abs(cosine) > 1:
        return []
    bend = math.acos(cosine)
    lead = atan2(l2 * sin(bend), l1 + l2 * cos(bend))
    return [(atan2(p[1], p[0]) - lead, bend), (atan2(p[1], p[0]) + lead, -bend)]


@wrong("inverse_kinematics", slip="degrees")
def degrees_out(l1, l2, p):
    """Returns degrees."""
    return [(math.degrees(first), math.degrees(second)) for first, second in solutions(l1, l2, p)]


@wrong("inverse_kinematics")
def reaches_everything(l1, l2, p):
    """Clips the cosine, so that it points towards targets out of reach."""
    far = hypot(*p)
    if far == 0 and l1 == l2:
        raise ValueError("infinitely many")
    bend = math.acos(min(max((far * far - l1 * l1 - l2 * l2) / (2 * l1 * l2), -1.0), 1.0))
    lead = atan2(l2 * sin(bend), l1 + l2 * cos(bend))
    return [(atan2(p[1], p[0]) - lead, bend), (atan2(p[1], p[0]) + lead, -bend)]


@wrong("inverse_kinematics")
def complains_when_too_far(l1, l2, p):
    """Lets acos raise an error."""
    far = hypot(*p)
    if far == 0 and l1 == l2:
        raise ValueError("infinitely many")
    bend = math.acos((far * far - l1 * l1 - l2 * l2) / (2 * l1 * l2))
    lead = atan2(l2 * sin(bend), l1 + l2 * cos(bend))
    return [(atan2(p[1], p[0]) - lead, bend), (atan2(p[1], p[0]) + lead, -bend)]


@wrong("inverse_kinematics")
def nothing_at_the_rims(l1, l2, p):
    """Treats the rims as out of reach."""
    far = hypot(*p)
    return [] if far in (l1 + l2, abs(l1 - l2)) and far > 0 else solutions(l1, l2, p)


@wrong("inverse_kinematics")
def never_too_near(l1, l2, p):
    """Forgets the hole."""
    if hypot(*p) < abs(l1 - l2):
        return [(atan2(p[1], p[0]), pi)]
    return solutions(l1, l2, p)


@wrong("inverse_kinematics")
def hole_of_a_longer_first_link(l1, l2, p):
    """Compares with l1 - l2 and clips the cosine, so it finds no hole where link 2 is longer."""
    far = hypot(*p)
    if far == 0 and l1 == l2:
        raise ValueError("infinitely many")
    if not l1 - l2 <= far <= l1 + l2:
        return []
    bend = math.acos(min(max((far * far - l1 * l1 - l2 * l2) / (2 * l1 * l2), -1.0), 1.0))
    lead = atan2(l2 * sin(bend), l1 + l2 * cos(bend))
    return [(atan2(p[1], p[0]) - lead, bend), (atan2(p[1], p[0]) + lead, -bend)]


@wrong("inverse_kinematics")
def axis_for_the_base(l1, l2, p):
    """Treats a target with one zero coordinate as the base."""
    if l1 == l2 and not np.all(p):
        raise ValueError("infinitely many")
    return solutions(l1, l2, p)


@wrong("inverse_kinematics")
def refuses_every_base(l1, l2, p):
    """Rejects the origin, also where the links are not equal."""
    if hypot(*p) == 0:
        raise ValueError("infinitely many")
    return solutions(l1, l2, p)


@wrong("inverse_kinematics")
def one_of_infinitely_many(l1, l2, p):
    """Returns one solution at the base of an arm with equal links."""
    return [(0.0, pi)] if hypot(*p) == 0 and l1 == l2 else solutions(l1, l2, p)


@wrong("inverse_kinematics", slip="sines")
def by_the_law_of_sines(l1, l2, p):
    """The program of the "break it" exercise."""
    found = solutions(l1, l2, p)
    if not found:
        return []
    heading, bend = atan2(p[1], p[0]), found[0][1]
    lead = math.asin(min(1.0, l2 * sin(bend) / hypot(*p)))
    return [(heading - lead, bend), (heading + lead, -bend)]


@wrong("inverse_kinematics")
def none_for_nothing(l1, l2, p):
    """Returns None where there is no solution."""
    return solutions(l1, l2, p) or None


near_the_base = changed("inverse_kinematics", ("far == 0.0 and", "far < 0.1 * l1 and"))
longer_reach = changed(
    "inverse_kinematics",
    ("far > l1 + l2 or", "far > 1.02 * (l1 + l2) or"),
    (
        "math.acos((far * far - l1 * l1 - l2 * l2) / (2.0 * l1 * l2))",
        "math.acos(min(1.0, (far * far - l1 * l1 - l2 * l2) / (2.0 * l1 * l2)))",
    ),
)

# The circle


@wrong("circle_distance")
def neither_arc(a, b):
    """Halves the angle."""
    return circle_distance(a, b) / 2


@wrong("circle_distance", slip="no_wrap")
def on_a_line(a, b):
    """Treats angles as numbers on a line."""
    return abs(a - b)


@wrong("circle_distance", slip="one_way")
def always_to_the_left(a, b):
    """Returns the arc in one direction."""
    return (b - a) % (2 * pi)


@wrong("circle_distance", slip="signed")
def with_a_sense(a, b):
    """Forgets the absolute value."""
    return (b - a + pi) % (2 * pi) - pi


@wrong("circle_distance", slip="half_turns")
def remainder_by_pi(a, b):
    """Removes half turns."""
    return abs(a - b) % pi


@wrong("circle_distance", slip="half_turns")
def shorter_remainder_by_pi(a, b):
    """Right but for pi in place of 2 pi."""
    apart = abs(a - b) % pi
    return min(apart, pi - apart)


@wrong("circle_distance", slip="once")
def one_turn_at_most(a, b):
    """Right for wrapped angles."""
    return min(abs(a - b), 2 * pi - abs(a - b))


@wrong("circle_distance", slip="long")
def the_long_way(a, b):
    """max where min belongs."""
    apart = abs(a - b) % (2 * pi)
    return max(apart, 2 * pi - apart)


@wrong("circle_distance", slip="chord")
def straight_through(a, b):
    """Returns the distance of the points on the circle."""
    return math.dist((cos(a), sin(a)), (cos(b), sin(b)))


@wrong("circle_distance", slip="degrees")
def a_turn_of_360(a, b):
    """Uses 360 for a whole turn."""
    apart = abs(a - b) % 360
    return min(apart, 360 - apart)


@wrong("circle_distance", slip="degrees")
def answer_in_degrees(a, b):
    """Returns degrees."""
    return math.degrees(circle_distance(a, b))


@wrong("circle_distance")
def angle_between_directions(a, b):
    """Takes acos of a dot product, which may be rounded to more than 1."""
    return math.acos(math.cos(a) * math.cos(b) + math.sin(a) * math.sin(b))


@wrong("circle_distance", slip="rounded")
def circle_rounded(a, b):
    """Rounds its answer."""
    return round(float(circle_distance(a, b)), 2)


@wrong("circle_distance", slip="short_pi")
def turns_by_pi_written_short(a, b):
    """Uses 3.14 for pi."""
    apart = abs(a - b) % 6.28
    return min(apart, 6.28 - apart)


@wrong("circle_distance", slip="one_side")
def wraps_only_one_side(a, b):
    """Forgets a difference below -pi."""
    turn = b - a
    while turn > pi:
        turn -= 2 * pi
    return abs(turn)


@wrong("circle_distance", slip="half_turns")
def wraps_by_sines(a, b):
    """Uses asin, which covers half of the circle."""
    return abs(math.asin(sin(a - b)))


# The torus


@wrong("torus_distance", slip="no_wrap")
def in_the_plane(a, b):
    """Treats the square's edges as walls."""
    return float(np.linalg.norm(a - b))


@wrong("torus_distance", slip="sum")
def one_joint_after_the_other(a, b):
    """Adds the circle distances."""
    return sum(circle_distance(x, y) for x, y in zip(a, b))


@wrong("torus_distance", slip="largest")
def the_slowest_joint(a, b):
    """Returns the largest of the circle distances."""
    return max(circle_distance(x, y) for x, y in zip(a, b))


@wrong("torus_distance", slip="square")
def no_root(a, b):
    """Forgets the root."""
    return sum(circle_distance(x, y) ** 2 for x, y in zip(a, b))


@wrong("torus_distance", slip="two")
def two_joints(a, b):
    """Uses two angles only."""
    return torus_distance(a[:2], b[:2])


@wrong("torus_distance", slip="first")
def wraps_the_first(a, b):
    """Wraps only the first angle."""
    return hypot(circle_distance(a[0], b[0]), float(np.linalg.norm(a[1:] - b[1:])))


@wrong("torus_distance", slip="whole")
def wraps_the_whole(a, b):
    """Wraps after the root."""
    apart = float(np.linalg.norm(a - b))
    return min(apart, 2 * pi - apart)


@wrong("torus_distance", slip="once")
def angles_one_turn_at_most(a, b):
    """Right for wrapped angles."""
    apart = np.abs(a - b)
    return float(np.linalg.norm(np.minimum(apart, 2 * pi - apart)))


@wrong("torus_distance", slip="long")
def all_to_the_left(a, b):
    """One of the two arcs of each."""
    return float(np.linalg.norm((b - a) % (2 * pi)))


@wrong("torus_distance")
def three_numbers_needed(a, b):
    """Expects exactly two angles."""
    (a1, a2), (b1, b2) = a, b
    return hypot(circle_distance(a1, b1), circle_distance(a2, b2))


@wrong("torus_distance")
def in_space_straight(a, b):
    """Measures straight through space, between the points of circles."""
    return float(np.linalg.norm([np.cos(a) - np.cos(b), np.sin(a) - np.sin(b)]))


@wrong("torus_distance")
def each_angle(a, b):
    """Returns a distance for each angle."""
    return circle_distance(a, b)


# Break it


@wrong("exposing_reach")
def longer_first_link():
    """The program is right for such arms."""
    return 2, 1, (2, 1)


@wrong("exposing_reach")
def far_enough_out():
    """Link 2 is longer, but the target is far out."""
    return 1, 2, (2.5, 0)


@wrong("exposing_reach")
def much_longer_second_link():
    """It exposes the program, but the links are not nearly equal."""
    return 1, 2, (1.2, 0)


@wrong("exposing_reach")
def out_of_reach():
    """No arm reaches this target."""
    return 1, 2, (4, 0)


@wrong("exposing_reach")
def in_the_hole():
    """No arm reaches this target either."""
    return 1, 2, (0.5, 0)


@wrong("exposing_reach")
def equal_links_at_the_base():
    """The target is not valid."""
    return 1, 1, (0, 0)


@wrong("exposing_reach")
def link_without_length():
    """A link has no length."""
    return 1, 0, (1, 0)


@wrong("exposing_reach")
def angles_for_a_target():
    """Angles without an arm."""
    return 0.5, 1.5


@wrong("exposing_reach")
def nowhere():
    """A coordinate is nan."""
    return 1, 1.1, (math.nan, 0)


cosine_of_two_digits = changed(
    "inverse_kinematics",
    (
        "math.acos((far * far - l1 * l1 - l2 * l2) / (2.0 * l1 * l2))",
        "math.acos(round((far * far - l1 * l1 - l2 * l2) / (2.0 * l1 * l2), 2))",
    ),
)


# Variants

ROOT = "math.hypot(*(circle_distance(x, y) for x, y in zip(a, b)))"
sum_of_arcs = varied(
    "torus_distance", "sum", (ROOT, "sum(circle_distance(x, y) for x, y in zip(a, b))")
)
largest_arc = varied(
    "torus_distance", "largest", (ROOT, "max(circle_distance(x, y) for x, y in zip(a, b))")
)
sum_of_differences = changed(
    "torus_distance", (ROOT, "sum(abs(a - b))"), variant="sum", slip="no_wrap"
)
sum_of_squares = changed(
    "torus_distance",
    (ROOT, "sum(circle_distance(x, y) ** 2 for x, y in zip(a, b))"),
    variant="sum",
    slip="square",
)
largest_difference = changed(
    "torus_distance", (ROOT, "max(abs(a - b))"), variant="largest", slip="no_wrap"
)
sum_for_the_largest = changed(
    "torus_distance",
    (ROOT, "sum(circle_distance(x, y) for x, y in zip(a, b))"),
    variant="largest",
)

COUNT = "3 * bodies - sum(2 * (len(held) - 1) for held in joints)"
with_the_ground = varied(
    "degrees_of_freedom", "moving_ground", (COUNT, COUNT.replace("bodies", "(bodies + 1)"))
)
pins_in_slots = varied("degrees_of_freedom", "slots", (COUNT, COUNT.replace("2 * ", "")))
one_for_each_slot = changed(
    "degrees_of_freedom", (COUNT, "3 * bodies - len(joints)"), variant="slots", slip="shared"
)
two_for_each_pin = changed(
    "degrees_of_freedom",
    (COUNT, "3 * bodies + 3 - 2 * len(joints)"),
    variant="moving_ground",
    slip="shared",
)
MATRIX = "    return matrix"
back_again = varied("displacement", "way_back", (MATRIX, "    return np.linalg.inv(matrix)"))
moved_before_turned = varied(
    "displacement",
    "move_first",
    ("matrix[:2, 2] = x, y", "matrix[:2, 2] = rotation(theta) @ (x, y)"),
)
only_the_turn_undone = changed(
    "displacement", ("rotation(theta)", "rotation(-theta)"), variant="way_back"
)
only_signs_changed = changed(
    "displacement",
    ("rotation(theta)", "rotation(-theta)"),
    ("= x, y", "= -x, -y"),
    variant="way_back",
    slip="move_first",
)
SUM = "math.cos(q[0] + q[1]), math.sin(q[0] + q[1])"
from_the_x_axis = varied("forward_kinematics", "absolute", (SUM, "math.cos(q[1]), math.sin(q[1])"))
angles_clockwise = varied(
    "forward_kinematics", "clockwise", ("    elbow = l1", "    q = -q\n    elbow = l1")
)
only_the_first_clockwise = changed(
    "forward_kinematics",
    ("    elbow = l1", "    q = -q[0], q[1]\n    elbow = l1"),
    variant="clockwise",
    slip="difference",
)
tip_without_the_elbow = changed(
    "forward_kinematics",
    ("elbow + l2", "l2"),
    (SUM, "math.cos(q[1]), math.sin(q[1])"),
    variant="absolute",
    slip="from_elbow",
)
PAIRS = "return [(heading - lead, bend), (heading + lead, -bend)]"
directions_of_both = varied(
    "inverse_kinematics",
    "absolute",
    (
        PAIRS,
        "return [(heading - lead, heading - lead + bend), (heading + lead, heading + lead - bend)]",
    ),
)
solutions_clockwise = varied(
    "inverse_kinematics",
    "clockwise",
    (PAIRS, "return [(lead - heading, -bend), (-heading - lead, bend)]"),
)
one_direction_of_two = changed(
    "inverse_kinematics",
    (PAIRS, "return [(heading - lead, heading - lead + bend)]"),
    variant="absolute",
    slip="one",
)
only_bends_clockwise = changed(
    "inverse_kinematics",
    (PAIRS, "return [(heading - lead, -bend), (heading + lead, bend)]"),
    variant="clockwise",
)
