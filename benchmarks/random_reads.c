/* The ruler for growth: what the memory alone costs a search for the nearest node, whatever its layout. A random bucket is read,
   then the node that it names, and the next query waits for both, as a tree's next query does. */
#include <stdint.h>

double read_at_random(const int64_t *buckets, const double *nodes, int64_t n, int64_t queries) {
    uint64_t state = 88172645463325252u;
    double sum = 0.0;
    for (int64_t i = 0; i < queries; i++) {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        double x = nodes[2 * buckets[8 * (state % (uint64_t)n)]];
        sum += x;
        state += x > 1.0; /* never, but the processor must wait to know */
    }
    return sum;
}
