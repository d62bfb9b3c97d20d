/* The ruler for the kinodynamic RRT among polygons: the same loop as kinoedu/planners/kinodynamic_rrt.py in C, on the same flat
   arrays and the same random numbers, so that it must grow the very same tree. What is near to zero is computed again with 113
   bits, where kinoedu goes exact. */
#include "ruler.h"

typedef __float128 Exact;
typedef struct { double x, y, theta; } Pose;
typedef struct { double x, y, vx, vy; double bend; } Corner;
typedef struct { double *outline, *speeds; int64_t gears; double wheelbase, steering, weight, contact; } Car;
typedef struct { int64_t goal_every, region_every; double region, region_turn; } Bias;
typedef struct { int64_t trials, steps; double step; int64_t batches; } Drives;
typedef struct { void *state; next_double draw; } Random;

static const double PI = 3.141592653589793, ROUNDING = 3.3306690738754716e-16;

static inline double wrapped(double angle) {
    if (-PI <= angle && angle < PI) return angle;
    double inside = angle - 2.0 * PI * floor((angle + PI) / (2.0 * PI));
    return -PI <= inside && inside < PI ? inside : -PI;
}

static inline double short_way(double a, double b) {
    double turn = b - a, part = turn - b;
    if (-PI <= turn && turn < PI) return turn;
    return wrapped(wrapped(turn) + ((b - (turn - part)) + (-a - part)));
}

static inline Pose driven(Pose q, double distance, double curvature) {
    double half = 0.5 * curvature * distance, chord = half == 0.0 ? distance : distance * (sin(half) / half);
    return (Pose){q.x + chord * cos(q.theta + half), q.y + chord * sin(q.theta + half), wrapped(q.theta + 2.0 * half)};
}

static inline double length(double x, double y) { return sqrt(x * x + y * y); }

static inline int side_of(double ax, double ay, double bx, double by, double cx, double cy) {
    double left = (ax - cx) * (by - cy), right = (ay - cy) * (bx - cx), det = left - right;
    if (fabs(det) > ROUNDING * (fabs(left) + fabs(right))) return det > 0 ? 1 : -1;
    Exact exact = ((Exact)ax - cx) * ((Exact)by - cy) - ((Exact)ay - cy) * ((Exact)bx - cx);
    return (exact > 0) - (exact < 0);
}

static inline int facing(double ax, double ay, double bx, double by, double cx, double cy) {
    double along = (bx - ax) * (cx - ax), across = (by - ay) * (cy - ay), dot = along + across;
    if (fabs(dot) > ROUNDING * (fabs(along) + fabs(across))) return dot > 0 ? 1 : -1;
    Exact exact = ((Exact)bx - ax) * ((Exact)cx - ax) + ((Exact)by - ay) * ((Exact)cy - ay);
    return (exact > 0) - (exact < 0);
}

static inline double height(double ax, double ay, double bx, double by, double px, double py) {
    double left = (ax - px) * (by - py), right = (ay - py) * (bx - px), det = left - right, base = length(bx - ax, by - ay);
    if (fabs(det) > 1e-3 * (fabs(left) + fabs(right))) return det / base;
    return (double)(((Exact)ax - px) * ((Exact)by - py) - ((Exact)ay - py) * ((Exact)bx - px)) / base;
}

static inline double segment_distance(double px, double py, double ax, double ay, double bx, double by) {
    if (facing(ax, ay, bx, by, px, py) <= 0) return length(px - ax, py - ay);
    if (facing(bx, by, ax, ay, px, py) <= 0) return length(px - bx, py - by);
    return fabs(height(ax, ay, bx, by, px, py));
}

/* Both kinds of convex pieces, the car's corners and a part's points, as rows of so many doubles that begin with x and y. */
typedef struct { const double *rows; int64_t size, width; } Piece;

static inline double px(Piece P, int64_t i) { return P.rows[i * P.width]; }
static inline double py(Piece P, int64_t i) { return P.rows[i * P.width + 1]; }

static int lies_beyond_edge(Piece P, Piece Q) {
    for (int64_t i = 0, last = P.size - 1; i < P.size; last = i++) {
        int64_t j = 0;
        while (j < Q.size && side_of(px(P, last), py(P, last), px(P, i), py(P, i), px(Q, j), py(Q, j)) < 0) j++;
        if (j == Q.size) return 1;
    }
    return 0;
}

static double nearest_corner(Piece P, Piece Q, int64_t *corner, int64_t *tail, int64_t *head) {
    double best = INFINITY;
    for (int64_t i = 0; i < P.size; i++)
        for (int64_t j = 0, last = Q.size - 1; j < Q.size; last = j++) {
            double d = segment_distance(px(P, i), py(P, i), px(Q, last), py(Q, last), px(Q, j), py(Q, j));
            if (d < best) { best = d; *corner = i; *tail = last; *head = j; }
        }
    return best;
}

/* The point of the edge a-b of Q nearest to the corner i of P, and the unit vector from there to it. */
static void line_towards(Piece P, int64_t i, Piece Q, int64_t a, int64_t b, double *x, double *y, double *nx, double *ny) {
    double cx = px(P, i), cy = py(P, i), ax = px(Q, a), ay = py(Q, a), bx = px(Q, b), by = py(Q, b);
    int end = facing(ax, ay, bx, by, cx, cy) <= 0 ? 1 : facing(bx, by, ax, ay, cx, cy) <= 0 ? 2 : 0;
    *x = end == 2 ? bx : ax;
    *y = end == 2 ? by : ay;
    double ux = end ? cx - *x : ay - by, uy = end ? cy - *y : bx - ax, size = length(ux, uy);
    int side = end ? 1 : side_of(ax, ay, bx, by, cx, cy);
    *nx = side * (ux / size);
    *ny = side * (uy / size);
}

/* 0 where the pieces meet; a line that keeps them apart otherwise. */
static int dividing_line(Piece P, Piece Q, double *x, double *y, double *nx, double *ny) {
    if (!lies_beyond_edge(P, Q) && !lies_beyond_edge(Q, P)) return 0;
    int64_t i = 0, a = 0, b = 0, j = 0, c = 0, d = 0;
    double one = nearest_corner(P, Q, &i, &a, &b), other = nearest_corner(Q, P, &j, &c, &d);
    if (one <= other) {
        line_towards(P, i, Q, a, b, x, y, nx, ny);
    } else {
        line_towards(Q, j, P, c, d, x, y, nx, ny);
        *x = px(Q, j);
        *y = py(Q, j);
        *nx = -*nx;
        *ny = -*ny;
    }
    return 1;
}

static void place(const Car *car, Pose a, double s, double turning, double t, Corner *corners) {
    Pose q = driven(a, t * s, s != 0.0 ? turning / s : 0.0);
    double cosine = cos(q.theta), sine = sin(q.theta);
    for (int64_t k = 0; k < 4; k++) {
        double x = car->outline[2 * k], y = car->outline[2 * k + 1], rx = cosine * x - sine * y, ry = sine * x + cosine * y;
        corners[k] = (Corner){q.x + rx, q.y + ry, s * cosine - turning * ry, s * sine + turning * rx,
                              fabs(turning * s) + turning * turning * length(x, y)};
    }
}

static inline double time_across(double room, double speed, double bend) {
    if (room <= 0.0) return 0.0;
    double root = sqrt(speed * speed + 2.0 * bend * room);
    if (speed > 0.0) return 2.0 * room / (speed + root);
    return bend > 0.0 ? (root - speed) / bend : INFINITY;
}

static double clear_time(const Corner *corners, double x, double y, double nx, double ny, double kept, double *time) {
    double least = INFINITY;
    *time = INFINITY;
    for (int64_t k = 0; k < 4; k++) {
        double room = (corners[k].x - x) * nx + (corners[k].y - y) * ny - kept;
        least = fmin(least, room);
        *time = fmin(*time, time_across(room, -(corners[k].vx * nx + corners[k].vy * ny), corners[k].bend));
    }
    return least;
}

/* Whether the car does not keep clear of a part; of the outer side of an edge of the rim where the part has two points. */
static int meets_part(const Car *car, Pose a, double s, double turning, Piece part) {
    Corner corners[4];
    double t = 0.0, x, y, nx, ny, time;
    if (part.size == 2) {
        double size = length(px(part, 1) - px(part, 0), py(part, 1) - py(part, 0));
        x = px(part, 0);
        y = py(part, 0);
        nx = (py(part, 0) - py(part, 1)) / size;
        ny = (px(part, 1) - px(part, 0)) / size;
    }
    while (1) {
        place(car, a, s, turning, t, corners);
        if (part.size > 2 && !dividing_line((Piece){&corners[0].x, 4, 5}, part, &x, &y, &nx, &ny)) return 1;
        double room = clear_time(corners, x, y, nx, ny, car->contact, &time);
        t += time;
        if (room <= 0.0 || t > 1.0) return room <= 0.0;
        if (room <= car->contact) return 1;
    }
}

static int box_within(const World *w, double x0, double y0, double x1, double y1) {
    for (int64_t i = 0, last = w->hull_size - 1; i < w->hull_size; last = i++) {
        const double *p = w->hull + 2 * last, *q = w->hull + 2 * i;
        if (height(p[0], p[1], q[0], q[1], q[1] < p[1] ? x0 : x1, q[0] > p[0] ? y0 : y1) <= 0.0) return 0;
    }
    return 1;
}

static inline int64_t number_of(double value, int64_t count) { return clip(floor(value), count - 1); }

static int free_drive(const World *w, const Car *car, Pose a, double s, double curvature) {
    double turning = s * curvature, x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;
    Corner corners[4];
    place(car, a, s, turning, 0.5, corners);
    for (int64_t k = 0; k < 4; k++) {
        double off = car->contact + corners[k].bend / 8.0, dx = fabs(corners[k].vx) / 2.0 + off, dy = fabs(corners[k].vy) / 2.0 + off;
        x0 = fmin(x0, corners[k].x - dx);
        y0 = fmin(y0, corners[k].y - dy);
        x1 = fmax(x1, corners[k].x + dx);
        y1 = fmax(y1, corners[k].y + dy);
    }
    if (!box_within(w, x0, y0, x1, y1))
        for (int64_t i = 0, last = w->hull_size - 1; i < w->hull_size; last = i++) {
            double edge[4] = {w->hull[2 * last], w->hull[2 * last + 1], w->hull[2 * i], w->hull[2 * i + 1]};
            if (meets_part(car, a, s, turning, (Piece){edge, 2, 2})) return 0;
        }
    int64_t i0 = number_of((x0 - w->x) / w->cell - 0.01, w->columns), i1 = number_of((x1 - w->x) / w->cell + 0.01, w->columns);
    int64_t j0 = number_of((y0 - w->y) / w->cell - 0.01, w->rows), j1 = number_of((y1 - w->y) / w->cell + 0.01, w->rows);
    for (int64_t j = j0; j <= j1; j++)
        for (int64_t i = i0; i <= i1; i++)
            for (int64_t e = w->cell_first[j * w->columns + i]; e < w->cell_first[j * w->columns + i + 1]; e++) {
                int64_t part = w->cell_parts[e], begin = w->first[part], size = w->first[part + 1] - begin;
                const double *box = w->boxes + 4 * part;
                if (x1 < box[0] || x0 > box[2] || y1 < box[1] || y0 > box[3]) continue;
                int64_t left = number_of((box[0] - w->x) / w->cell - 0.01, w->columns);
                int64_t low = number_of((box[1] - w->y) / w->cell - 0.01, w->rows);
                if (i != (left > i0 ? left : i0) || j != (low > j0 ? low : j0)) continue;
                if (meets_part(car, a, s, turning, (Piece){w->points + 2 * begin, size, 2})) return 0;
            }
    return 1;
}

static inline double squared(const Tree *t, const Car *car, int64_t node, Pose q) {
    const double *at = t->nodes + 3 * node;
    double dx = at[0] - q.x, dy = at[1] - q.y, turn = car->weight * short_way(q.theta, at[2]);
    return dx * dx + dy * dy + turn * turn;
}

static int64_t nearest(const Tree *t, const Car *car, Pose q) {
    int64_t best = 0, column, row;
    double least = INFINITY;
    if (t->size <= 150) {
        for (int64_t node = 0; node < t->size; node++) {
            double d = squared(t, car, node, q);
            if (d < least) { least = d; best = node; }
        }
        return best;
    }
    bucket_of(t, q.x, q.y, &column, &row);
    int64_t rings = t->columns > t->rows ? t->columns : t->rows;
    double dx = q.x - t->x - column * t->cell, dy = q.y - t->y - row * t->cell;
    double margin = fmin(fmin(dx, t->cell - dx), fmin(dy, t->cell - dy)) - 1e-9 * t->cell;
    for (int64_t ring = 0; ring < rings; ring++) {
        double gap = (ring - 1) * t->cell + margin;
        if (gap > 0.0 && least < gap * gap) break;
        for (int64_t j = row - ring < 0 ? 0 : row - ring; j <= row + ring && j < t->rows; j++) {
            int64_t stride = j == row - ring || j == row + ring ? 1 : (ring ? 2 * ring : 1);
            for (int64_t i = column - ring; i <= column + ring; i += stride) {
                if (i < 0 || i >= t->columns) continue;
                for (int64_t node = t->head[j * t->columns + i]; node >= 0; node = t->next[node]) {
                    double d = squared(t, car, node, q);
                    if (d < least || (d == least && node < best)) { least = d; best = node; }
                }
            }
        }
    }
    return best;
}

static int64_t add(Tree *t, Pose q, int64_t parent) {
    int64_t i, j, node = t->size++;
    t->nodes[3 * node] = q.x;
    t->nodes[3 * node + 1] = q.y;
    t->nodes[3 * node + 2] = q.theta;
    t->parent[node] = parent;
    bucket_of(t, q.x, q.y, &i, &j);
    t->next[node] = t->head[j * t->columns + i];
    t->head[j * t->columns + i] = node;
    return node;
}

static int64_t closest_step(const Car *car, Pose q, Pose to, double v, double curvature, const Drives *drives, double *least) {
    double bend = car->weight * curvature, pace = fabs(v) * sqrt(1.0 + bend * bend) * drives->step;
    int64_t best = 0;
    for (int64_t k = 1; k <= drives->steps;) {
        Pose there = driven(q, v * (k * drives->step), curvature);
        double dx = to.x - there.x, dy = to.y - there.y, turn = car->weight * short_way(there.theta, to.theta);
        double apart = sqrt(dx * dx + dy * dy + turn * turn);
        if (apart < *least) { best = k; *least = apart; }
        int64_t passed = (int64_t)((apart - *least) / pace);
        k += passed > 1 ? passed : 1;
    }
    return best;
}

static Pose next_place(const double *lo, const double *hi, Pose goal, const Bias *bias, int64_t turn, Random r) {
    if (bias->region_every > 0 && turn % bias->region_every == 0) {
        double off = bias->region * r.draw(r.state), towards = 2.0 * PI * r.draw(r.state);
        double heading = wrapped(goal.theta + bias->region_turn * (2.0 * r.draw(r.state) - 1.0));
        return (Pose){goal.x + off * cos(towards), goal.y + off * sin(towards), heading};
    }
    if (bias->goal_every > 0 && turn % bias->goal_every == 0) return goal;
    double x = lo[0] + (hi[0] - lo[0]) * r.draw(r.state), y = lo[1] + (hi[1] - lo[1]) * r.draw(r.state);
    return (Pose){x, y, lo[2] + (hi[2] - lo[2]) * r.draw(r.state)};
}

/* The time for which the best drive lasts, 0 where none is free. */
static double best_drive(const World *w, const Car *car, Pose q, Pose to, const Drives *drives, Random r, double *v, double *phi) {
    for (int64_t batch = 0; batch < drives->batches; batch++) {
        double least = INFINITY;
        int64_t best = 0;
        for (int64_t trial = 0; trial < drives->trials; trial++) {
            double speed = car->speeds[(int64_t)(car->gears * r.draw(r.state))];
            double steering = car->steering * (2.0 * r.draw(r.state) - 1.0);
            int64_t step = closest_step(car, q, to, speed, tan(steering) / car->wheelbase, drives, &least);
            if (step > 0) { best = step; *v = speed; *phi = steering; }
        }
        if (free_drive(w, car, q, *v * (best * drives->step), tan(*phi) / car->wheelbase)) return best * drives->step;
    }
    return 0.0;
}

static inline Pose pose_of(const double *q) { return (Pose){q[0], q[1], q[2]}; }

void grow(const World *w, Tree *t, double *controls, double *durations, const Car *car, const double *lo, const double *hi,
          const double *start, const double *goal, const Bias *bias, const Drives *drives, int64_t iterations, void *state,
          next_double draw) {
    Random r = {state, draw};
    add(t, pose_of(start), -1);
    for (int64_t turn = 1; turn <= iterations; turn++) {
        Pose to = next_place(lo, hi, pose_of(goal), bias, turn, r);
        int64_t near = nearest(t, car, to);
        Pose from = pose_of(t->nodes + 3 * near);
        double v = 0.0, phi = 0.0, time = best_drive(w, car, from, to, drives, r, &v, &phi);
        if (time > 0.0) {
            int64_t node = add(t, driven(from, v * time, tan(phi) / car->wheelbase), near);
            controls[2 * node] = v;
            controls[2 * node + 1] = phi;
            durations[node] = time;
        }
    }
}
