"""Challenges for the boards of the tour and the lessons, two or more in each; see `challenge`."""

from .bugs import bug0_is_lost, bug2_walks_farther
from .cars import reverse_halves, three_arcs
from .collision import both_links_touch, free_in_the_obstacle
from .configurations import elbows_agree, short_way_round
from .decomposition import eight_edges, one_event_for_two
from .geometry import between_two_walls, diagonal_tangent
from .graphs import astar_saves, depth_first_detour
from .kinodynamic import mostly_backwards, small_tree
from .moving import no_risk_no_way, without_waiting
from .polygons import detour, more_samples_help
from .roadmaps import long_way_round, missed_way
from .sampling import in_the_largest_hole, random_beats_halton
from .terrains import much_longer, only_one_finds
from .tour import lucky_roadmap, many_nodes
from .trees import path_jumps, second_tree_pays

__all__ = [
    "astar_saves",
    "between_two_walls",
    "both_links_touch",
    "bug0_is_lost",
    "bug2_walks_farther",
    "depth_first_detour",
    "detour",
    "diagonal_tangent",
    "eight_edges",
    "elbows_agree",
    "free_in_the_obstacle",
    "in_the_largest_hole",
    "long_way_round",
    "lucky_roadmap",
    "many_nodes",
    "missed_way",
    "more_samples_help",
    "mostly_backwards",
    "much_longer",
    "no_risk_no_way",
    "one_event_for_two",
    "only_one_finds",
    "path_jumps",
    "random_beats_halton",
    "reverse_halves",
    "second_tree_pays",
    "short_way_round",
    "small_tree",
    "three_arcs",
    "without_waiting",
]
