"""Typical wrong answers of students to the exercises of lesson 7.

A check must recognise the named misconception.
"""

import math
from pathlib import Path

import numpy as np

from kinoedu.course.bank import Solutions, wrong
from kinoedu.course.lessons.collision_detection.arm_pictures import bar, circle
from kinoedu.course.lessons.collision_detection.link_in_contact import ends_of_links
from kinoedu.geometry import (
    convex_hull,
    convex_polygons_intersect,
    minkowski_difference,
    minkowski_sum,
    point_in_convex_polygon,
    point_line_distance,
    point_segment_distance,
    segment_intersection,
    segments_intersect,
)

FULL = 2 * np.pi
solutions = Solutions(Path(__file__).parents[1] / "07_collision_detection.ipynb")
changed, varied = solutions.changed, solutions.varied
touched_link = solutions.right["link_in_contact"]


def edges(polygon):
    return list(zip(polygon, np.roll(polygon, -1, axis=0)))


def cross(u, v):
    return u[0] * v[1] - u[1] * v[0]


# A point in a convex polygon


@wrong("point_in_convex_polygon", slip="strict")
def without_the_boundary(q, P):
    """Excludes the boundary."""
    return all(cross(b - a, q - a) > 0 for a, b in edges(P))


@wrong("point_in_convex_polygon", slip="clockwise")
def inside_on_the_right(q, P):
    """Assumes clockwise vertices."""
    return all(cross(b - a, q - a) <= 0 for a, b in edges(P))


@wrong("point_in_convex_polygon", slip="clockwise")
def cross_product_turned_round(q, P):
    """Exchanges the factors of the cross product."""
    return all(cross(q - a, b - a) >= 0 for a, b in edges(P))


@wrong("point_in_convex_polygon", slip="open")
def one_edge_short(q, P):
    """Forgets the closing edge."""
    return all(cross(P[i + 1] - P[i], q - P[i]) >= 0 for i in range(len(P) - 1))


@wrong("point_in_convex_polygon", slip="any")
def one_edge_is_enough(q, P):
    """Uses any in place of all."""
    return any(cross(b - a, q - a) >= 0 for a, b in edges(P))


@wrong("point_in_convex_polygon", slip="first")
def returns_in_the_loop(q, P):
    """Returns at the first edge."""
    for a, b in edges(P):
        return cross(b - a, q - a) >= 0
    return True


@wrong("point_in_convex_polygon", slip="on_line")
def on_a_line_is_on_the_boundary(q, P):
    """Confuses the line of an edge with the edge."""
    sides = [cross(b - a, q - a) for a, b in edges(P)]
    return 0 in sides or min(sides) > 0


@wrong("point_in_convex_polygon", slip="box")
def in_the_box(q, P):
    """Compares with the bounding box."""
    return bool((q >= P.min(axis=0)).all() and (q <= P.max(axis=0)).all())


@wrong("point_in_convex_polygon")
def counts_crossings(q, P):
    """A ray to the right, counted wrongly on the boundary."""
    inside = False
    for a, b in edges(P):
        if (a[1] > q[1]) != (b[1] > q[1]) and q[0] < a[0] + (q[1] - a[1]) / (b[1] - a[1]) * (
            b[0] - a[0]
        ):
            inside = not inside
    return inside


@wrong("point_in_convex_polygon")
def says_one_and_zero(q, P):
    """Answers 1 for True."""
    return int(point_in_convex_polygon(q, P))


@wrong("point_in_convex_polygon")
def near_enough_is_inside(q, P):
    """As far from the middle as the farthest vertex."""
    middle = P.mean(axis=0)
    return math.dist(q, middle) <= max(math.dist(p, middle) for p in P)


# Two segments


def shares(p1, p2, p3, p4):
    whole = cross(p2 - p1, p4 - p3)
    return cross(p3 - p1, p4 - p3) / whole, cross(p3 - p1, p2 - p1) / whole


def is_parallel(p1, p2, p3, p4):
    return cross(p2 - p1, p4 - p3) == 0


@wrong("segment_intersection", slip="lines")
def where_the_lines_meet(p1, p2, p3, p4):
    """Uses lines in place of segments."""
    if is_parallel(p1, p2, p3, p4):
        return []
    t, _ = shares(p1, p2, p3, p4)
    return [p1 + t * (p2 - p1)]


@wrong("segment_intersection", slip="one_sided")
def tests_the_first_only(p1, p2, p3, p4):
    """Tests only the first parameter."""
    if is_parallel(p1, p2, p3, p4):
        return []
    t, _ = shares(p1, p2, p3, p4)
    return [p1 + t * (p2 - p1)] if 0 <= t <= 1 else []


@wrong("segment_intersection", slip="one_sided")
def tests_the_second_only(p1, p2, p3, p4):
    """Tests only the second parameter."""
    if is_parallel(p1, p2, p3, p4):
        return []
    t, s = shares(p1, p2, p3, p4)
    return [p1 + t * (p2 - p1)] if 0 <= s <= 1 else []


@wrong("segment_intersection", slip="parallel")
def parallel_is_nothing(p1, p2, p3, p4):
    """Loses overlaps."""
    if is_parallel(p1, p2, p3, p4):
        return []
    t, s = shares(p1, p2, p3, p4)
    return [p1 + t * (p2 - p1)] if 0 <= t <= 1 and 0 <= s <= 1 else []


@wrong("segment_intersection", slip="open")
def without_ends(p1, p2, p3, p4):
    """Excludes the ends."""
    if is_parallel(p1, p2, p3, p4):
        return []
    t, s = shares(p1, p2, p3, p4)
    return [p1 + t * (p2 - p1)] if 0 < t < 1 and 0 < s < 1 else []


@wrong("segment_intersection", slip="upright")
def divides_by_x4_minus_x3(p1, p2, p3, p4):
    """Loses upright second segments."""
    return [] if p3[0] == p4[0] else segment_intersection(p1, p2, p3, p4)


@wrong("segment_intersection", slip="one_point")
def one_of_the_stretch(p1, p2, p3, p4):
    """Returns the first common point that it finds."""
    return segment_intersection(p1, p2, p3, p4)[:1]


@wrong("segment_intersection", slip="twice")
def both_ends_of_nothing(p1, p2, p3, p4):
    """Returns the two middle ones of four ends, even if they are equal."""
    found = segment_intersection(p1, p2, p3, p4)
    return np.vstack([found, found]) if len(found) == 1 and is_parallel(p1, p2, p3, p4) else found


@wrong("segment_intersection")
def a_point_without_brackets(p1, p2, p3, p4):
    """Returns a point where rows are required."""
    found = segment_intersection(p1, p2, p3, p4)
    return found[0] if len(found) == 1 else found


@wrong("segment_intersection")
def none_for_none(p1, p2, p3, p4):
    """Returns None where there is no point."""
    found = segment_intersection(p1, p2, p3, p4)
    return found if len(found) else None


@wrong("segment_intersection")
def on_one_line_always_overlaps(p1, p2, p3, p4):
    """Returns the two middle ends on one line, even if the segments are apart."""
    if not is_parallel(p1, p2, p3, p4):
        return segment_intersection(p1, p2, p3, p4)
    if cross(p2 - p1, p3 - p1) != 0:
        return []
    return sorted([p1, p2, p3, p4], key=tuple)[1:3]


@wrong("segment_intersection")
def by_slopes(p1, p2, p3, p4):
    """Slope and intercept: upright segments are lost."""
    with np.errstate(all="ignore"):
        m, n = (p2[1] - p1[1]) / (p2[0] - p1[0]), (p4[1] - p3[1]) / (p4[0] - p3[0])
        x = (p3[1] - n * p3[0] - p1[1] + m * p1[0]) / (m - n)
    return [(x, p1[1] + m * (x - p1[0]))] if len(segment_intersection(p1, p2, p3, p4)) == 1 else []


nearly_parallel = changed(
    "segment_intersection",
    ("whole != 0", "abs(whole) > 0.02 * math.dist(p1, p2) * math.dist(p3, p4)"),
)
small_product = changed("segment_intersection", ("whole != 0", "abs(whole) > 0.1"))
the_same_one_backwards_is_none = changed(
    "segment_intersection",
    ("[] if low > high", "[] if low > high or ((p1 == p4) & (p2 == p3)).all()"),
    slip="parallel",
)
tiny_angle = changed(
    "segment_intersection",
    ("whole != 0", "abs(whole) > 1e-6 * math.dist(p1, p2) * math.dist(p3, p4)"),
)
nearly_one_line = changed("segment_intersection", ("cross(u, w) != 0", "abs(cross(u, w)) > 0.5"))
ends_with_tolerance = changed(
    "segment_intersection",
    ("0 <= t <= 1 and 0 <= s <= 1", "-1e-3 <= t <= 1.001 and -1e-3 <= s <= 1.001"),
    slip="nearly",
)

# Two convex polygons


def some_in(P, Q):
    return bool(np.any(point_in_convex_polygon(P, Q)))


def some_edges_meet(P, Q):
    return any(segments_intersect(a, b, c, d) for a, b in edges(P) for c, d in edges(Q))


@wrong("convex_polygons_intersect", slip="edges")
def edges_only(P1, P2):
    """Forgets that one polygon can lie inside the other."""
    return some_edges_meet(P1, P2)


@wrong("convex_polygons_intersect", slip="vertices")
def vertices_only(P1, P2):
    """Forgets two bars that cross."""
    return some_in(P1, P2) or some_in(P2, P1)


@wrong("convex_polygons_intersect", slip="one_way")
def first_in_second(P1, P2):
    """Tests only the vertices of P1."""
    return some_edges_meet(P1, P2) or some_in(P1, P2)


@wrong("convex_polygons_intersect", slip="one_way")
def second_in_first(P1, P2):
    """Tests only the vertices of P2."""
    return some_edges_meet(P1, P2) or some_in(P2, P1)


@wrong("convex_polygons_intersect", slip="boxes")
def boxes_overlap(P1, P2):
    """Compares boxes."""
    return bool(
        (P1.min(axis=0) <= P2.max(axis=0)).all() and (P2.min(axis=0) <= P1.max(axis=0)).all()
    )


def separates(P, Q, strictly):
    heights = [[cross(b - a, q - a) for q in Q] for a, b in edges(P)]
    return any(max(row) < 0 or (not strictly and max(row) <= 0) for row in heights)


@wrong("convex_polygons_intersect", slip="open")
def touching_is_apart(P1, P2):
    """Lets a separating edge touch."""
    return not (separates(P1, P2, False) or separates(P2, P1, False))


@wrong("convex_polygons_intersect", slip="half")
def edges_of_the_first(P1, P2):
    """Tries the edges of P1 only."""
    return not separates(P1, P2, True)


@wrong("convex_polygons_intersect", slip="opposite")
def is_apart(P1, P2):
    """Returns the opposite answer."""
    return not convex_polygons_intersect(P1, P2)


@wrong("convex_polygons_intersect")
def middle_in_the_other(P1, P2):
    """Tests the middles, and edges that cross strictly."""
    return point_in_convex_polygon(P1.mean(axis=0), P2) or point_in_convex_polygon(
        P2.mean(axis=0), P1
    )


@wrong("convex_polygons_intersect")
def round_bodies(P1, P2):
    """Compares circles with the polygons' mean radius."""
    c, d = P1.mean(axis=0), P2.mean(axis=0)
    return math.dist(c, d) <= np.mean([math.dist(c, p) for p in P1]) + np.mean(
        [math.dist(d, p) for p in P2]
    )


@wrong("convex_polygons_intersect")
def without_closing_edges(P1, P2):
    """Forgets both closing edges in the test for crossings."""
    pairs = [
        (P1[i], P1[i + 1], P2[j], P2[j + 1]) for i in range(len(P1) - 1) for j in range(len(P2) - 1)
    ]
    return any(segments_intersect(*pair) for pair in pairs)


@wrong("convex_polygons_intersect")
def points_of_the_edges(P1, P2):
    """Tests 101 points of every edge, which misses thin bars that cross."""
    rows = [
        np.vstack([a + np.linspace(0, 1, 101)[:, None] * (b - a) for a, b in edges(P)])
        for P in (P1, P2)
    ]
    return some_in(rows[0], P2) or some_in(rows[1], P1)


takes_small_areas_for_zero = changed(
    "convex_polygons_intersect", (" < 0).all()", " < -1e-9).all()")
)


@wrong("convex_polygons_intersect")
def shadows_on_unit_normals(P1, P2):
    """Rounding divides polygons that touch."""
    for P in (P1, P2):
        for x, y in P - np.roll(P, 1, axis=0):
            normal = np.array([y, -x]) / math.hypot(x, y)
            a, b = P1 @ normal, P2 @ normal
            if a.max() < b.min() or b.max() < a.min():
                return False
    return True


# The C-obstacle


@wrong("c_obstacle", slip="sum")
def not_mirrored(robot, obstacle):
    """Adds instead of subtracting."""
    return minkowski_sum(obstacle, robot)


@wrong("c_obstacle", slip="swapped")
def robot_minus_obstacle(robot, obstacle):
    """Subtracts in the wrong order."""
    return minkowski_difference(robot, obstacle)


@wrong("c_obstacle", slip="unchanged")
def the_obstacle_itself(robot, obstacle):
    """Treats the robot as a point."""
    return obstacle


@wrong("c_obstacle", slip="centred")
def about_the_middle(robot, obstacle):
    """Uses the middle as the reference point."""
    return minkowski_difference(obstacle, robot - robot.mean(axis=0))


@wrong("c_obstacle", slip="first_vertex")
def about_vertex_0(robot, obstacle):
    """Uses vertex 0 as the reference point."""
    return minkowski_difference(obstacle, robot - robot[0])


@wrong("c_obstacle", slip="box")
def grows_boxes(robot, obstacle):
    """Right for boxes only."""
    (x0, y0), (x1, y1) = (
        obstacle.min(axis=0) - robot.max(axis=0),
        obstacle.max(axis=0) - robot.min(axis=0),
    )
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


@wrong("c_obstacle", slip="all")
def every_difference_as_rows(robot, obstacle):
    """Does not take the convex hull."""
    return (obstacle[:, None] - robot).reshape(-1, 2)


@wrong("c_obstacle")
def corners_from_left_to_right(robot, obstacle):
    """Sorts the corners by x."""
    return np.array(sorted(map(tuple, minkowski_difference(obstacle, robot))))


@wrong("c_obstacle")
def grown_by_a_radius(robot, obstacle):
    """Moves every vertex away from the middle by the robot's size."""
    out = obstacle - obstacle.mean(axis=0)
    size = max(math.hypot(*b) for b in robot)
    return obstacle + size * out / np.linalg.norm(out, axis=1)[:, None]


@wrong("c_obstacle")
def one_corner_short(robot, obstacle):
    """Loses the last corner."""
    return convex_hull((obstacle[:, None] - robot).reshape(-1, 2))[:-1]


whole_numbers = changed(
    "c_obstacle", ("convex_hull(", "np.round(convex_hull("), ("for b in robot]", "for b in robot])")
)
two_decimals = changed(
    "c_obstacle",
    ("convex_hull(", "np.round(convex_hull("),
    ("b in robot])", "b in robot]), 2)"),
)

# The arm among discs


def link_by(distance, q, lengths, width, discs):
    ends = ends_of_links(q, lengths)
    for link in (1, 2):
        if any(
            distance(disc[:2], ends[link - 1], ends[link]) <= width / 2 + disc[2] for disc in discs
        ):
            return link
    return 0


@wrong("link_in_contact", slip="from_x")
def second_angle_from_the_axis(q, lengths, width, discs):
    """Does not add the first angle to the second."""
    return touched_link(np.array([q[0], q[1] - q[0]]), lengths, width, discs)


@wrong("link_in_contact", slip="degrees")
def converts_radians(q, lengths, width, discs):
    """Converts radians to radians."""
    return touched_link(np.radians(q), lengths, width, discs)


@wrong("link_in_contact", slip="thin")
def links_are_lines(q, lengths, width, discs):
    """Forgets the width."""
    return touched_link(q, lengths, 0.0, discs)


@wrong("link_in_contact", slip="whole_width")
def width_for_half_width(q, lengths, width, discs):
    """Uses W to each side."""
    return touched_link(q, lengths, 2 * width, discs)


links_exchanged = changed(
    "link_in_contact", ("return link\n", "return 3 - link\n"), slip="exchanged"
)


@wrong("link_in_contact", slip="squares")
def squared_distance_and_squared_radii(q, lengths, width, discs):
    """Compares the squared distance with r^2 + (W/2)^2."""
    joints = ends_of_links(q, lengths)
    for link, (a, b) in enumerate(zip(joints, joints[1:]), 1):
        for *centre, r in discs:
            if point_segment_distance(centre, a, b) ** 2 <= r**2 + (width / 2) ** 2:
                return link
    return 0


@wrong("link_in_contact", slip="centres")
def discs_are_points(q, lengths, width, discs):
    """Forgets the radius."""
    return touched_link(q, lengths, width, discs * (1, 1, 0))


@wrong("link_in_contact", slip="endless")
def lines_for_links(q, lengths, width, discs):
    """Measures to lines."""
    return link_by(point_line_distance, q, lengths, width, discs)


def beside_only(p, a, b):
    return (
        point_line_distance(p, a, b)
        if 0 <= np.dot(p - a, b - a) <= np.dot(b - a, b - a)
        else math.inf
    )


@wrong("link_in_contact", slip="square")
def square_ends(q, lengths, width, discs):
    """Links without rounded ends."""
    return link_by(beside_only, q, lengths, width, discs)


@wrong("link_in_contact", slip="ends_only")
def joints_only(q, lengths, width, discs):
    """Measures to the joints."""
    return link_by(lambda p, a, b: min(math.dist(p, a), math.dist(p, b)), q, lengths, width, discs)


@wrong("link_in_contact", slip="one_disc")
def first_disc(q, lengths, width, discs):
    """Returns inside the loop."""
    return touched_link(q, lengths, width, discs[:1])


@wrong("link_in_contact", slip="second_first")
def asks_link_2_first(q, lengths, width, discs):
    """Answers 2 where both links touch."""
    ends = ends_of_links(q, lengths)
    for link in (2, 1):
        if any(
            point_segment_distance(disc[:2], ends[link - 1], ends[link]) <= width / 2 + disc[2]
            for disc in discs
        ):
            return link
    return 0


@wrong("link_in_contact", slip="disc_first")
def loops_over_discs_outside(q, lengths, width, discs):
    """Stops at the first disc that is touched."""
    for disc in discs:
        link = touched_link(q, lengths, width, disc[None])
        if link:
            return link
    return 0


@wrong("link_in_contact", slip="open")
def touching_is_free(q, lengths, width, discs):
    """Uses < in place of <=."""
    ends = ends_of_links(q, lengths)
    for link in (1, 2):
        if any(
            point_segment_distance(disc[:2], ends[link - 1], ends[link]) < width / 2 + disc[2]
            for disc in discs
        ):
            return link
    return 0


@wrong("link_in_contact")
def says_true(q, lengths, width, discs):
    """Answers whether a link touches, not which one."""
    return touched_link(q, lengths, width, discs) > 0


@wrong("link_in_contact", slip="open")
def points_of_the_links(q, lengths, width, discs):
    """Measures to 101 points of each link."""
    return link_by(
        lambda p, a, b: min(math.dist(p, x) for x in np.linspace(a, b, 101)),
        q,
        lengths,
        width,
        discs,
    )


@wrong("link_in_contact", slip="nearest")
def only_the_nearest_centre(q, lengths, width, discs):
    """Tests each link with the disc whose centre is nearest, and not with larger ones."""
    ends = ends_of_links(q, lengths)
    for link in (1, 2):
        away = [point_segment_distance(d[:2], ends[link - 1], ends[link]) for d in discs]
        if len(discs) and min(away) <= width / 2 + discs[np.argmin(away)][2]:
            return link
    return 0


# A drawing of the arm


def drawn(q, lengths, width, discs, ax, *, rounded=True):
    ends = ends_of_links(q, lengths)
    for link in (1, 2):
        ax.fill(*bar(ends[link - 1], ends[link], width, rounded=rounded).T, label=f"link {link}")
    for disc in discs:
        ax.fill(*circle(disc[:2], disc[2]).T, label="disc")
    ax.plot(*ends.T, "o", label="joints")


@wrong("plot_environment", slip="square")
def draws_rectangles(q, lengths, width, discs, ax):
    """No rounded ends."""
    drawn(q, lengths, width, discs, ax, rounded=False)


@wrong("plot_environment", slip="from_x")
def draws_link_2_from_the_axis(q, lengths, width, discs, ax):
    """Does not add the angles."""
    drawn(np.array([q[0], q[1] - q[0]]), lengths, width, discs, ax)


@wrong("plot_environment", slip="degrees")
def draws_with_converted_angles(q, lengths, width, discs, ax):
    """Converts radians to radians."""
    drawn(np.radians(q), lengths, width, discs, ax)


@wrong("plot_environment", slip="whole_width")
def draws_twice_as_wide(q, lengths, width, discs, ax):
    """Uses W to each side."""
    drawn(q, lengths, 2 * width, discs, ax)


@wrong("plot_environment", slip="narrow")
def draws_half_as_wide(q, lengths, width, discs, ax):
    """Takes the width for twice the width."""
    drawn(q, lengths, width / 2, discs, ax)


@wrong("plot_environment", slip="exchanged")
def labels_the_other_link(q, lengths, width, discs, ax):
    """Counts the links from the tip."""
    drawn(q, lengths, width, discs, ax)
    for patch, label in zip(ax.patches, ("link 2", "link 1")):
        patch.set_label(label)


@wrong("plot_environment", slip="half_discs")
def takes_radii_for_diameters(q, lengths, width, discs, ax):
    """Draws half the radius."""
    drawn(q, lengths, width, discs * (1, 1, 0.5), ax)


@wrong("plot_environment", slip="one_disc")
def draws_one_disc(q, lengths, width, discs, ax):
    """Draws only the first disc."""
    drawn(q, lengths, width, discs[:1], ax)


@wrong("plot_environment")
def draws_without_labels(q, lengths, width, discs, ax):
    """Forgets the labels."""
    drawn(q, lengths, width, discs, ax)
    for artist in [*ax.patches, *ax.lines]:
        artist.set_label("")


@wrong("plot_environment")
def draws_nothing(q, lengths, width, discs, ax):
    """Draws into other axes."""


@wrong("plot_environment")
def forgets_the_base(q, lengths, width, discs, ax):
    """Draws two of the three joints."""
    drawn(q, lengths, width, discs, ax)
    ax.lines[0].set_data(*ends_of_links(q, lengths)[1:].T)


@wrong("plot_environment")
def draws_boxes_for_discs(q, lengths, width, discs, ax):
    """Draws squares of half-width r."""
    ends = ends_of_links(q, lengths)
    for link in (1, 2):
        ax.fill(*bar(ends[link - 1], ends[link], width).T, label=f"link {link}")
    for x, y, r in discs:
        ax.fill([x - r, x + r, x + r, x - r], [y - r, y - r, y + r, y + r], label="disc")
    ax.plot(*ends.T, "o", label="joints")


@wrong("plot_environment", slip="one_disc")
def labels_the_first_disc(q, lengths, width, discs, ax):
    """Labels only one disc, as for a legend."""
    drawn(q, lengths, width, discs, ax)
    for patch in ax.patches[3:]:
        patch.set_label(None)


# The picture of the configuration space


def dotted(places, samples, arm, ax, colours=("blue", "black", "red")):
    links = np.array([touched_link(q, *arm) for q in samples])
    for link, colour in enumerate(colours):
        ax.plot(*places[links == link].T, "o", color=colour)


@wrong("plot_configuration_space", slip="unscaled")
def takes_samples_for_angles(samples, lengths, width, discs, ax):
    """Uses [0, 1] in place of [0, 2 pi]."""
    dotted(samples, samples, (lengths, width, discs), ax)


@wrong("plot_configuration_space", slip="unscaled_dots")
def draws_the_samples(samples, lengths, width, discs, ax):
    """Scales the samples for the colours only."""
    dotted(samples, FULL * samples, (lengths, width, discs), ax)


@wrong("plot_configuration_space", slip="unscaled_links")
def asks_about_the_samples(samples, lengths, width, discs, ax):
    """Scales the samples for the dots only."""
    dotted(FULL * samples, samples, (lengths, width, discs), ax)


@wrong("plot_configuration_space", slip="root")
def draws_the_root_of_n(samples, lengths, width, discs, ax):
    """Uses sqrt(n) samples."""
    few = FULL * samples[: round(len(samples) ** 0.5)]
    dotted(few, few, (lengths, width, discs), ax)


@wrong("plot_configuration_space", slip="degrees")
def draws_degrees(samples, lengths, width, discs, ax):
    """Draws dots in degrees."""
    dotted(360 * samples, FULL * samples, (lengths, width, discs), ax)


@wrong("plot_configuration_space", slip="transposed")
def exchanges_the_axes(samples, lengths, width, discs, ax):
    """Draws the second angle along x."""
    dotted(FULL * samples[:, ::-1], FULL * samples, (lengths, width, discs), ax)


@wrong("plot_configuration_space", slip="only_free")
def draws_free_ones_only(samples, lengths, width, discs, ax):
    """Draws no dots in contact."""
    free = FULL * np.array(
        [s for s in samples if touched_link(FULL * s, lengths, width, discs) == 0]
    ).reshape(-1, 2)
    ax.plot(*free.T, "o", color="b")


@wrong("plot_configuration_space", slip="one_red")
def all_contact_is_red(samples, lengths, width, discs, ax):
    """Uses two colours only."""
    dotted(FULL * samples, FULL * samples, (lengths, width, discs), ax, ("blue", "red", "red"))


COLOURS = '(0, "blue"), (1, "black"), (2, "red")'
free_and_contact_exchanged = changed(
    "plot_configuration_space",
    (COLOURS, '(0, "black"), (1, "blue"), (2, "red")'),
    slip="permuted",
)
free_is_red = changed(
    "plot_configuration_space",
    (COLOURS, '(0, "red"), (1, "black"), (2, "blue")'),
    slip="permuted",
)
colours_in_another_order = changed(
    "plot_configuration_space",
    (COLOURS, '(0, "black"), (1, "red"), (2, "blue")'),
    slip="permuted",
)


@wrong("plot_configuration_space", slip="swapped")
def black_for_link_2(samples, lengths, width, discs, ax):
    """Exchanges black and red."""
    dotted(FULL * samples, FULL * samples, (lengths, width, discs), ax, ("blue", "red", "black"))


@wrong("plot_configuration_space")
def green_is_free(samples, lengths, width, discs, ax):
    """Uses another colour."""
    dotted(FULL * samples, FULL * samples, (lengths, width, discs), ax, ("green", "black", "red"))


@wrong("plot_configuration_space")
def a_line_through_the_dots(samples, lengths, width, discs, ax):
    """Forgets the marker."""
    ax.plot(*(FULL * samples).T, color="blue")


dots_on_a_line = changed(
    "plot_configuration_space", ('"o", color=colour', 'marker="o", color=colour')
)


@wrong("plot_configuration_space")
def pale_colours(samples, lengths, width, discs, ax):
    """Draws grey for black, and a pale blue."""
    dotted(
        FULL * samples,
        FULL * samples,
        (lengths, width, discs),
        ax,
        ("skyblue", "dimgray", "crimson"),
    )


@wrong("plot_configuration_space")
def half_a_turn_off(samples, lengths, width, discs, ax):
    """Shifts the samples by half a turn, to the range from -pi to pi."""
    dotted(FULL * samples - np.pi, FULL * samples - np.pi, (lengths, width, discs), ax)


# Break it


@wrong("overlooked_gap")
def two_that_meet(*_):
    """The program is right: the polygons meet."""
    return [(0, 0), (4, 0), (0, 4)], [(1, 1), (5, 1), (1, 5)]


@wrong("overlooked_gap")
def two_boxes_apart(*_):
    """The program is right: an edge of the first separates them."""
    return [(0, 0), (1, 0), (1, 1), (0, 1)], [(3, 0), (4, 0), (4, 1), (3, 1)]


@wrong("overlooked_gap")
def edge_against_a_corner(*_):
    """The program is right: an edge of the first polygon separates them."""
    return [(1, -9), (9, 0), (1, 9)], [(0, 0), (-1, 4), (-1, -4)]


@wrong("overlooked_gap")
def a_corner_against_a_box(*_):
    """It exposes the program, but is not the smallest."""
    return [(0, 0), (-1, 4), (-1, -4)], [(1, -9), (9, -9), (9, 9), (1, 9)]


@wrong("overlooked_gap")
def not_convex(*_):
    """One polygon is not convex."""
    return [(0, 0), (-1, 4), (-0.5, 0), (-1, -4)], [(1, -9), (9, 0), (1, 9)]


@wrong("overlooked_gap")
def a_segment(*_):
    """Two points are not a polygon."""
    return [(0, 0), (-1, 4)], [(1, -9), (9, 0), (1, 9)]


@wrong("overlooked_gap")
def far_away(*_):
    """The coordinates are too large."""
    return [(0, 0), (-1, 4), (-1, -4)], [(1, -90000), (90000, 0), (1, 90000)]


# Small shapes, sharp corners, many vertices

inside_by_a_tolerance = changed("point_in_convex_polygon", ("< 0", "< -1e-3"))
eight_edges = changed("point_in_convex_polygon", ("range(len(P))", "range(min(len(P), 8))"))
short_segments_are_parallel = changed("segment_intersection", ("whole != 0", "abs(whole) > 1e-9"))
small_angle = changed(
    "segment_intersection",
    ("whole != 0", "abs(whole) > 1e-3 * np.linalg.norm(u) * np.linalg.norm(v)"),
)
nearly_on_one_line = changed(
    "segment_intersection", ("cross(u, w) != 0", "abs(cross(u, w)) > 1e-3")
)
nearly_one_point = changed(
    "segment_intersection", ("low == high", "np.allclose(low, high)"), slip="one_point"
)
contact_within_a_thousandth = changed("link_in_contact", ("r + width / 2", "r + width / 2 + 0.001"))


@wrong("point_in_convex_polygon")
def sum_of_angles(q, P):
    """Adds up the angles at which q sees the edges, which fails at a sharp vertex."""
    total = 0.0
    for a, b in edges(P):
        u, v = a - q, b - q
        total += math.atan2(u[0] * v[1] - u[1] * v[0], u @ v)
    return abs(total) > 1.0


# Variants

obstacle_moves = varied("c_obstacle", "obstacle_moves", ("a - b for a", "b - a for a"))
HULL = "convex_hull([a - b for a in obstacle for b in robot])"
box_round = """convex_hull(
        [(x, y) for x in WHERE[:, 0] for y in WHERE[:, 1]]
    )"""
bounding_box = varied(
    "c_obstacle",
    "bounding_box",
    (HULL, box_round.replace("WHERE", "np.array([a - b for a in obstacle for b in robot])")),
)
box_of_the_obstacle = changed(
    "c_obstacle",
    (HULL, box_round.replace("WHERE", "obstacle")),
    variant="bounding_box",
    slip="unchanged",
)
moves_by_the_sum = changed("c_obstacle", ("a - b", "a + b"), variant="obstacle_moves")
mirrored_obstacle = changed(
    "c_obstacle", (HULL, "-obstacle"), variant="obstacle_moves", slip="unchanged"
)

TO_THE_RIGHT = "if x * v - y * u < 0:\n            return False\n    return True"
strictly_outside = varied(
    "point_in_convex_polygon",
    "outside",
    (
        TO_THE_RIGHT,
        TO_THE_RIGHT.replace("True", "no").replace("False", "True").replace("no", "False"),
    ),
)
strictly_inside = varied(
    "point_in_convex_polygon", "interior", (TO_THE_RIGHT, TO_THE_RIGHT.replace("<", "<="))
)
outside_or_on_the_boundary = changed(
    "point_in_convex_polygon",
    (
        TO_THE_RIGHT,
        TO_THE_RIGHT.replace("<", "<=")
        .replace("True", "no")
        .replace("False", "True")
        .replace("no", "False"),
    ),
    variant="outside",
    slip="strict",
)
inside_all_but_the_closing_edge = changed(
    "point_in_convex_polygon",
    ("range(len(P))", "range(1, len(P))"),
    (TO_THE_RIGHT, TO_THE_RIGHT.replace("<", "<=")),
    variant="interior",
    slip="open",
)
SEGMENTS = "u, v, w = p2 - p1, p4 - p3, p3 - p1"
segments_by_vectors = varied(
    "segment_intersection", "vectors", (SEGMENTS, f"p2, p4 = p1 + p2, p3 + p4\n    {SEGMENTS}")
)
segments_seen_from_p1 = varied(
    "segment_intersection",
    "from_p1",
    (SEGMENTS, f"p2, p3, p4, p1 = p2 - p1, p3 - p1, p4 - p1, 0 * p1\n    {SEGMENTS}"),
)
second_segment_by_ends = changed(
    "segment_intersection", (SEGMENTS, f"p2 = p1 + p2\n    {SEGMENTS}"), variant="vectors"
)
seen_from_p1_on_one_line_only = changed(
    "segment_intersection", ("[p1 + t * u]", "[p1 + t * u - p1 / 2]"), variant="from_p1"
)
INTERSECT = "return not (is_separated(P1, P2) or is_separated(P2, P1))"
polygons_apart = varied(
    "convex_polygons_intersect", "apart", (INTERSECT, INTERSECT.replace("not ", ""))
)
polygons_overlap = varied(
    "convex_polygons_intersect", "overlap", ("y * way[:, 0] < 0", "y * way[:, 0] <= 0")
)
apart_by_one = changed(
    "convex_polygons_intersect",
    (INTERSECT, "return is_separated(P1, P2)"),
    variant="apart",
    slip="half",
)
apart_or_touching = changed(
    "convex_polygons_intersect",
    ("y * way[:, 0] < 0", "y * way[:, 0] <= 0"),
    (INTERSECT, INTERSECT.replace("not ", "")),
    variant="apart",
    slip="open",
)
