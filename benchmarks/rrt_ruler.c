/* The ruler for RRT among polygons: the same loop as kinoedu/planners/rrt.py in C, on the same flat arrays and the same random
   numbers, so that it must grow the very same tree. */
#include "ruler.h"

static int64_t add(Tree *t, double x, double y, int64_t parent) {
    int64_t i, j, node = t->size++;
    t->nodes[2 * node] = x;
    t->nodes[2 * node + 1] = y;
    t->parent[node] = parent;
    bucket_of(t, x, y, &i, &j);
    t->next[node] = t->head[j * t->columns + i];
    t->head[j * t->columns + i] = node;
    return node;
}

static inline double squared(const Tree *t, int64_t node, double x, double y) {
    double dx = t->nodes[2 * node] - x, dy = t->nodes[2 * node + 1] - y;
    return dx * dx + dy * dy;
}

static int64_t nearest(const Tree *t, double x, double y) {
    int64_t best = 0, column, row;
    double least = INFINITY;
    if (t->size <= 150) {
        for (int64_t node = 0; node < t->size; node++) {
            double d = squared(t, node, x, y);
            if (d < least) { least = d; best = node; }
        }
        return best;
    }
    bucket_of(t, x, y, &column, &row);
    int64_t rings = t->columns > t->rows ? t->columns : t->rows;
    double dx = x - t->x - column * t->cell, dy = y - t->y - row * t->cell;
    double margin = fmin(fmin(dx, t->cell - dx), fmin(dy, t->cell - dy)) - 1e-9 * t->cell;
    for (int64_t ring = 0; ring < rings; ring++) {
        double gap = (ring - 1) * t->cell + margin;
        if (gap > 0.0 && least < gap * gap) break;
        for (int64_t j = row - ring < 0 ? 0 : row - ring; j <= row + ring && j < t->rows; j++) {
            double between = fmax(j * t->cell - (y - t->y), (y - t->y) - (j + 1) * t->cell) - 1e-9 * t->cell;
            if (j != row && between > 0.0 && between * between > least) continue;
            int64_t stride = j == row - ring || j == row + ring ? 1 : (ring ? 2 * ring : 1);
            for (int64_t i = column - ring; i <= column + ring; i += stride) {
                if (i < 0 || i >= t->columns) continue;
                for (int64_t node = t->head[j * t->columns + i]; node >= 0; node = t->next[node]) {
                    double d = squared(t, node, x, y);
                    if (d < least || (d == least && node < best)) { least = d; best = node; }
                }
            }
        }
    }
    return best;
}

static int64_t join_goal(const World *w, Tree *t, const double *goal, int64_t node, double step) {
    double x = t->nodes[2 * node], y = t->nodes[2 * node + 1];
    double dx = goal[0] - x, dy = goal[1] - y;
    if (sqrt(dx * dx + dy * dy) > step || !free_path(w, x, y, goal[0], goal[1])) return -1;
    return add(t, goal[0], goal[1], node);
}

int64_t grow(const World *w, Tree *t, const double *lo, const double *hi, const double *start, const double *goal, double step,
             double bias, int64_t limit, void *state, next_double draw, int64_t *iterations) {
    doubts = 0;
    int64_t at_goal = join_goal(w, t, goal, add(t, start[0], start[1], -1), step), made = 0;
    while (at_goal < 0 && made < limit && t->size < t->capacity - 1) {
        made++;
        double x = goal[0], y = goal[1];
        if (draw(state) >= bias) {
            x = lo[0] + (hi[0] - lo[0]) * draw(state);
            y = lo[1] + (hi[1] - lo[1]) * draw(state);
        }
        int64_t near = nearest(t, x, y);
        double nx = t->nodes[2 * near], ny = t->nodes[2 * near + 1], dx = x - nx, dy = y - ny, d = sqrt(dx * dx + dy * dy);
        if (d > step) {
            double share = step / d;
            x = nx + share * dx;
            y = ny + share * dy;
        }
        if (free_path(w, nx, ny, x, y)) at_goal = join_goal(w, t, goal, add(t, x, y, near), step);
    }
    *iterations = made;
    return doubts ? -2 : at_goal;
}
