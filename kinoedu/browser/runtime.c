/* What compiled bodies need besides themselves: memory, numba's few functions, and the random
   numbers of numpy's default_rng(seed), so that one seed gives one plan everywhere.

   M. E. O'Neill, "PCG: a family of simple fast space-efficient statistically good algorithms for
   random number generation" (2014); numpy/random/bit_generator.pyx for the seeding. */

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#define EXPORT(name) __attribute__((export_name(name)))

/* ---- memory */

EXPORT("allocate") void *allocate(uint32_t size) { return malloc(size); }
EXPORT("release") void release(void *memory) { free(memory); }

/* The head of an array's memory, as numba lays it out: the count has 64 bits on every machine. */
typedef struct { int64_t count; void *destructor, *about, *data; int64_t size; } Memory;

Memory *NRT_MemInfo_alloc_aligned(int64_t size, int32_t align) {
    Memory *memory = malloc(sizeof(Memory) + size + align);
    uintptr_t data = ((uintptr_t)(memory + 1) + align - 1) & ~(uintptr_t)(align - 1);
    *memory = (Memory){1, 0, 0, (void *)data, size};
    return memory;
}

void NRT_MemInfo_call_dtor(Memory *memory) { free(memory); }
void *NRT_Allocate(int64_t size) { return malloc(size); }
void NRT_Free(void *memory) { free(memory); }

/* The strides of an array in another shape, without a copy: for arrays without gaps. */
int numba_attempt_nocopy_reshape(int64_t nd, const int64_t *dims, const int64_t *strides,
                                 int64_t newnd, const int64_t *newdims, int64_t *newstrides,
                                 int64_t item, int fortran) {
    int64_t step = item;
    if (fortran) return 0;
    for (int64_t k = nd - 1; k >= 0; k--) {
        if (dims[k] != 1 && strides[k] != step) return 0;
        step *= dims[k];
    }
    step = item;
    for (int64_t k = newnd - 1; k >= 0; k--) {
        newstrides[k] = step;
        step *= newdims[k];
    }
    return 1;
}

double numba_ldexp(double x, int32_t exponent) { return ldexp(x, exponent); }
double numba_frexp(double x, int32_t *exponent) { return frexp(x, exponent); }

/* ---- SeedSequence: a seed of 32 bits spread over a pool of four words */

#define POOL 4
typedef struct { uint32_t constant; } Mixer;

static uint32_t hashed(uint32_t value, Mixer *mixer, uint32_t multiplier) {
    value ^= mixer->constant;
    mixer->constant *= multiplier;
    value *= mixer->constant;
    return value ^ (value >> 16);
}

static uint32_t mixed(uint32_t x, uint32_t y) {
    uint32_t value = 0xca01f9ddu * x - 0x4973f715u * y;
    return value ^ (value >> 16);
}

static void fill_pool(uint32_t pool[POOL], uint32_t seed) {
    Mixer mixer = {0x43b0d7e5u};
    for (int i = 0; i < POOL; i++) pool[i] = hashed(i == 0 ? seed : 0, &mixer, 0x931e8875u);
    for (int from = 0; from < POOL; from++)
        for (int to = 0; to < POOL; to++)
            if (from != to) pool[to] = mixed(pool[to], hashed(pool[from], &mixer, 0x931e8875u));
}

/* ---- PCG64 (XSL RR 128/64) */

typedef unsigned __int128 Wide;
typedef struct { Wide state, increment; uint32_t half; int has_half; } Generator;

static Wide advanced(const Generator *g) {
    const Wide multiplier = ((Wide)2549297995355413924ULL << 64) | 4865540595714422341ULL;
    return g->state * multiplier + g->increment;
}

EXPORT("seeded") Generator *seeded(uint32_t seed) {
    uint32_t pool[POOL], words[8];
    Mixer mixer = {0x8b51f9ddu};
    fill_pool(pool, seed);
    for (int i = 0; i < 8; i++) words[i] = hashed(pool[i % POOL], &mixer, 0x58f38dedu);
    uint64_t drawn[4];
    for (int i = 0; i < 4; i++) drawn[i] = words[2 * i] | (uint64_t)words[2 * i + 1] << 32;
    Generator *g = calloc(1, sizeof *g);
    g->increment = (((Wide)drawn[2] << 64 | drawn[3]) << 1) | 1;
    g->state = advanced(g);
    g->state += (Wide)drawn[0] << 64 | drawn[1];
    g->state = advanced(g);
    return g;
}

/* Compiled code passes the generator as a number of 64 bits. */
static uint64_t next64(int64_t at) {
    Generator *g = (Generator *)(uintptr_t)at;
    g->state = advanced(g);
    uint64_t folded = (uint64_t)(g->state >> 64) ^ (uint64_t)g->state;
    unsigned turn = g->state >> 122;
    return folded >> turn | folded << (-turn & 63);
}

static uint32_t next32(int64_t at) {
    Generator *g = (Generator *)(uintptr_t)at;
    if (g->has_half) { g->has_half = 0; return g->half; }
    uint64_t both = next64(at);
    g->has_half = 1;
    g->half = both >> 32;
    return (uint32_t)both;
}

static double next_double(int64_t at) { return (next64(at) >> 11) * (1.0 / 9007199254740992.0); }

/* The numbers of the three functions, for the generator's record. */
EXPORT("draw64") uintptr_t draw64(void) { return (uintptr_t)next64; }
EXPORT("draw32") uintptr_t draw32(void) { return (uintptr_t)next32; }
EXPORT("draw_double") uintptr_t draw_double(void) { return (uintptr_t)next_double; }
