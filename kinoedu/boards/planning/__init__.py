"""The planners' boards: plan while dragging, compare planners, and try one's own planner."""
