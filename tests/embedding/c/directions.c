/* Directions in both formats, and lights of all sizes. */
#include "hashes.h"
#include "inputs.h"

static const sunglint_sphere_q14_t sun_q14 = SUNGLINT_SUN_Q14;
static const sunglint_sphere_q30_t sun_q30 = SUNGLINT_SUN_Q30;

uint32_t directions_q14(void) {
    struct source source = source_new();
    uint32_t hash = HASH_OF_NOTHING;
    for (uint32_t i = 0; i < CASES; ++i) {
        sunglint_vector_q14_t n = sunglint_normalize_q14(lanes_q14(&source));
        sunglint_vector_q14_t v = sunglint_normalize_q14(lanes_q14(&source));
        sunglint_vector_q14_t l = sunglint_normalize_q14(lanes_q14(&source));
        sunglint_vector_q14_t r = sunglint_reflect_q14(n, v);
        add_q14(&hash, n);
        add_q14(&hash, v);
        add_q14(&hash, l);
        add_q14(&hash, r);
        add_q14(&hash, sunglint_cap_q14(l, r, sun_q14));
    }
    return hash;
}

uint32_t directions_q30(void) {
    struct source source = source_new();
    uint32_t hash = HASH_OF_NOTHING;
    for (uint32_t i = 0; i < CASES; ++i) {
        sunglint_vector_q30_t n = sunglint_normalize_q30(lanes_q30(&source));
        sunglint_vector_q30_t v = sunglint_normalize_q30(lanes_q30(&source));
        sunglint_vector_q30_t l = sunglint_normalize_q30(lanes_q30(&source));
        sunglint_vector_q30_t r = sunglint_reflect_q30(n, v);
        add_q30(&hash, n);
        add_q30(&hash, v);
        add_q30(&hash, l);
        add_q30(&hash, r);
        add_q30(&hash, sunglint_cap_q30(l, r, sun_q30));
        add_q30(&hash, sunglint_factored_q30(l, r, sun_q30));
        /* Of any length. */
        n = lanes_q30(&source);
        v = lanes_q30(&source);
        add_q30(&hash, sunglint_reflect_q30(n, v));
        add_q30(&hash, sunglint_cap_q30(n, v, sun_q30));
        add_32(&hash, sunglint_reciprocal_root_q16(size(&source)));
    }
    return hash;
}

/* Ratios at the ends of what is allowed, and beyond. */
static const int32_t ends[] = {0, 1073741824, 1073741825, -1, INT32_MIN, INT32_MAX};

static void light_q14(struct source *source, uint32_t *hash, int32_t ratio) {
    sunglint_sphere_q14_made_t made = sunglint_sphere_q14(ratio);
    add_32(hash, (uint32_t)made.status);
    add_32(hash, (uint32_t)made.sphere.sin);
    add_32(hash, (uint32_t)made.sphere.sin_square);
    add_32(hash, (uint32_t)made.sphere.cos);
    add_32(hash, (uint32_t)made.sphere.versine);
    sunglint_vector_q14_t l = lanes_q14(source);
    sunglint_vector_q14_t r = lanes_q14(source);
    add_q14(hash, sunglint_cap_q14(l, r, made.sphere));
    add_q14(hash, sunglint_factored_q14(l, r, made.sphere));
}

static void light_q30(struct source *source, uint32_t *hash, int32_t ratio) {
    sunglint_sphere_q30_made_t made = sunglint_sphere_q30(ratio);
    add_32(hash, (uint32_t)made.status);
    add_64(hash, (uint64_t)made.sphere.sin);
    add_64(hash, (uint64_t)made.sphere.sin_square);
    add_64(hash, (uint64_t)made.sphere.cos);
    add_64(hash, (uint64_t)made.sphere.versine);
    sunglint_vector_q30_t l = lanes_q30(source);
    sunglint_vector_q30_t r = lanes_q30(source);
    add_q30(hash, sunglint_cap_q30(l, r, made.sphere));
    add_q30(hash, sunglint_factored_q30(l, r, made.sphere));
}

uint32_t lights(void) {
    struct source source = source_new();
    uint32_t hash = HASH_OF_NOTHING;
    for (uint32_t i = 0; i < CASES; ++i) {
        int32_t ratio = i < sizeof ends / sizeof ends[0] ? ends[i] : either_sign(&source);
        light_q14(&source, &hash, ratio);
        light_q30(&source, &hash, ratio);
    }
    return hash;
}
