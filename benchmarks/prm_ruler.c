/* The ruler for PRM: the same steps as kinoedu/planners/prm.py in C: sample, join neighbours, search. The neighbours are given.
   It must find the very same nodes, edges and path length. */
#include <stdlib.h>
#include "ruler.h"

typedef struct { double f, h; int64_t node; } Entry;

int64_t sample_free(const World *w, double *nodes, int64_t n, int64_t tries, const double *lo, const double *hi, void *state,
                    next_double draw) {
    int64_t size = 2;
    for (int64_t i = 0; i < tries && size < n + 2; i++) {
        double x = lo[0] + (hi[0] - lo[0]) * draw(state), y = lo[1] + (hi[1] - lo[1]) * draw(state);
        if (!free_path(w, x, y, x, y)) continue;
        nodes[2 * size] = x;
        nodes[2 * size + 1] = y;
        size++;
    }
    return size;
}

static int asked_before(const int64_t *neighbours, int64_t k, int64_t i, int64_t j) {
    if (j > i) return 0;
    for (int64_t e = 0; e < k; e++)
        if (neighbours[j * k + e] == i) return 1;
    return 0;
}

static double apart(const double *nodes, int64_t i, int64_t j) {
    double dx = nodes[2 * j] - nodes[2 * i], dy = nodes[2 * j + 1] - nodes[2 * i + 1];
    return sqrt(dx * dx + dy * dy);
}

int64_t join(const World *w, const double *nodes, int64_t n, const int64_t *neighbours, int64_t k, int64_t *edges, double *lengths) {
    int64_t size = 0;
    doubts = 0;
    for (int64_t i = 0; i < n; i++)
        for (int64_t e = 0; e < k; e++) {
            int64_t j = neighbours[i * k + e];
            if (asked_before(neighbours, k, i, j)) continue;
            if (!free_path(w, nodes[2 * i], nodes[2 * i + 1], nodes[2 * j], nodes[2 * j + 1])) continue;
            edges[2 * size] = i;
            edges[2 * size + 1] = j;
            lengths[size++] = apart(nodes, i, j);
        }
    return doubts ? -1 : size;
}

static int before(Entry a, Entry b) { return a.f < b.f || (a.f == b.f && (a.h < b.h || (a.h == b.h && a.node < b.node))); }

static void push(Entry *heap, int64_t at, Entry item) {
    for (; at > 0 && before(item, heap[(at - 1) / 2]); at = (at - 1) / 2) heap[at] = heap[(at - 1) / 2];
    heap[at] = item;
}

static Entry pop(Entry *heap, int64_t size) {
    Entry top = heap[0], item = heap[size - 1];
    int64_t at = 0, child;
    while ((child = 2 * at + 1) < size - 1) {
        if (child + 1 < size - 1 && before(heap[child + 1], heap[child])) child++;
        if (!before(heap[child], item)) break;
        heap[at] = heap[child];
        at = child;
    }
    heap[at] = item;
    return top;
}

/* The flat form of a graph: what leaves u is half[first[u]] to half[first[u + 1]]; half 2 e goes along edge e, 2 e + 1 against it. */
static void flatten(int64_t n, const int64_t *edges, int64_t m, int64_t *first, int64_t *half) {
    for (int64_t e = 0; e < 2 * m; e++) first[edges[e] + 2]++;
    for (int64_t u = 2; u < n + 2; u++) first[u] += first[u - 1];
    for (int64_t e = 0; e < 2 * m; e++) half[first[edges[e] + 1]++] = e;
}

/* A* from node 0 to node 1; fills parent, and returns the path's length. */
double search(const double *nodes, int64_t n, const int64_t *edges, const double *lengths, int64_t m, int64_t *parent) {
    int64_t *first = calloc(n + 2, sizeof *first), *half = malloc((2 * m + 1) * sizeof *half), size = 0;
    double *cost = malloc(n * sizeof *cost), *left = malloc(n * sizeof *left);
    char *settled = calloc(n, 1);
    Entry *heap = malloc((2 * m + 1) * sizeof *heap);
    flatten(n, edges, m, first, half);
    for (int64_t u = 0; u < n; u++) {
        cost[u] = INFINITY;
        parent[u] = -1;
        left[u] = apart(nodes, u, 1);
    }
    cost[0] = 0.0;
    push(heap, size++, (Entry){left[0], left[0], 0});
    while (size > 0) {
        int64_t u = pop(heap, size--).node;
        if (settled[u]) continue;
        settled[u] = 1;
        if (u == 1) break;
        for (int64_t at = first[u]; at < first[u + 1]; at++) {
            int64_t v = edges[half[at] ^ 1];
            double there = cost[u] + lengths[half[at] / 2];
            if (there >= cost[v]) continue;
            cost[v] = there;
            parent[v] = u;
            push(heap, size++, (Entry){there + left[v], left[v], v});
        }
    }
    double found = cost[1];
    free(first), free(half), free(cost), free(left), free(settled), free(heap);
    return found;
}
