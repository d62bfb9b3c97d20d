/* What the rulers share: worlds and trees, and kinoedu's exact test of a point's motion among polygons, in C on the same flat
   arrays. Where orientation is in doubt they give up (counted) instead of going exact. */
#include <math.h>
#include <stdint.h>

typedef double (*next_double)(void *state);

typedef struct {
    double *hull; int64_t hull_size;
    double *points; int64_t *first;
    double *boxes; int64_t *cell_first, *cell_parts;
    double x, y, cell; int64_t columns, rows;
} World;

static int64_t doubts;

static inline int turn(double ax, double ay, double bx, double by, double cx, double cy) {
    double left = (ax - cx) * (by - cy), right = (ay - cy) * (bx - cx), det = left - right;
    if (fabs(det) > 3.3306690738754716e-16 * (fabs(left) + fabs(right)) && fabs(det) > 1e-270) return det > 0 ? 1 : -1;
    doubts++;
    return 0;
}

static int inside(const World *w, double x, double y) {
    int64_t last = w->hull_size - 1;
    for (int64_t i = 0; i < w->hull_size; last = i++)
        if (turn(w->hull[2 * last], w->hull[2 * last + 1], w->hull[2 * i], w->hull[2 * i + 1], x, y) <= 0) return 0;
    return 1;
}

static int meets(const World *w, double ax, double ay, double bx, double by, int64_t i) {
    int64_t begin = w->first[i], end = w->first[i + 1], last = end - 1, left = 0, right = 0;
    const double *p = w->points;
    for (int64_t k = begin; k < end; last = k++) {
        int side = turn(ax, ay, bx, by, p[2 * k], p[2 * k + 1]);
        left += side > 0;
        right += side < 0;
        if (turn(p[2 * last], p[2 * last + 1], p[2 * k], p[2 * k + 1], ax, ay) < 0 &&
            turn(p[2 * last], p[2 * last + 1], p[2 * k], p[2 * k + 1], bx, by) < 0) return 0;
    }
    return left < end - begin && right < end - begin;
}

static inline int64_t clip(double value, int64_t high) { return (int64_t)fmin(fmax(value, 0.0), (double)high); }

static int free_path(const World *w, double ax, double ay, double bx, double by) {
    if (!inside(w, ax, ay) || !inside(w, bx, by)) return 0;
    double x0 = fmin(ax, bx), x1 = fmax(ax, bx), y0 = fmin(ay, by), y1 = fmax(ay, by);
    int64_t top = clip((y1 - w->y) / w->cell, w->rows - 1);
    for (int64_t j = clip((y0 - w->y) / w->cell, w->rows - 1); j <= top; j++) {
        double low = w->y + (j - 0.01) * w->cell, high = w->y + (j + 1.01) * w->cell, left = x0, right = x1;
        if (ay != by) {
            double px = ax, py = ay, qx = bx, qy = by;
            if (py > qy) { px = bx; py = by; qx = ax; qy = ay; }
            double s = py >= low ? px : px + (low - py) / (qy - py) * (qx - px);
            double t = qy <= high ? qx : px + (high - py) / (qy - py) * (qx - px);
            left = fmin(s, t);
            right = fmax(s, t);
        }
        int64_t begin = clip((left - w->x) / w->cell - 0.01, w->columns - 1), end = clip((right - w->x) / w->cell + 0.01, w->columns - 1);
        for (int64_t e = w->cell_first[j * w->columns + begin]; e < w->cell_first[j * w->columns + end + 1]; e++) {
            int64_t i = w->cell_parts[e];
            const double *box = w->boxes + 4 * i;
            if (x1 < box[0] || x0 > box[2] || y1 < box[1] || y0 > box[3]) continue;
            if (meets(w, ax, ay, bx, by, i)) return 0;
        }
    }
    return 1;
}

typedef struct {
    double *nodes; int64_t *parent; int64_t size, capacity;
    double x, y, cell; int64_t columns, rows;
    int64_t *head, *next;
} Tree;

static void bucket_of(const Tree *t, double x, double y, int64_t *i, int64_t *j) {
    *i = (int64_t)fmin(fmax((x - t->x) / t->cell, 0.0), t->columns - 1.0);
    *j = (int64_t)fmin(fmax((y - t->y) / t->cell, 0.0), t->rows - 1.0);
}
