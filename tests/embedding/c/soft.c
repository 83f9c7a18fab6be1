/* float in integers. */
#include "hashes.h"
#include "inputs.h"

union single {
    uint32_t bits;
    float number;
};

static float of_bits(uint32_t bits) {
    union single single;
    single.bits = bits;
    return single.number;
}

static void add_float(uint32_t *hash, float number) {
    union single single;
    single.number = number;
    add_32(hash, single.bits);
}

static void add(uint32_t *hash, sunglint_vector_f32_t v) {
    add_float(hash, v.x);
    add_float(hash, v.y);
    add_float(hash, v.z);
}

static sunglint_vector_f32_t of_any_bits(struct source *source) {
    sunglint_vector_f32_t v;
    v.x = of_bits(bits(source));
    v.y = of_bits(bits(source));
    v.z = of_bits(bits(source));
    return v;
}

/* Its size is from 2^-6 to 4. */
static float about_one(struct source *source) {
    uint32_t sign_and_mantissa = bits(source) & 0x807fffffu;
    return of_bits(sign_and_mantissa | ((121 + (bits(source) & 7)) << 23));
}

static sunglint_vector_f32_t lanes_about_one(struct source *source) {
    sunglint_vector_f32_t v;
    v.x = about_one(source);
    v.y = about_one(source);
    v.z = about_one(source);
    return v;
}

uint32_t soft(void) {
    struct source source = source_new();
    uint32_t hash = HASH_OF_NOTHING;
    for (uint32_t i = 0; i < CASES; ++i) {
        sunglint_sphere_q30_t sphere = sunglint_sphere_q30(ratio(&source)).sphere;
        uint32_t x = bits(&source);
        add_float(&hash, sunglint_soft_reciprocal_root(of_bits(x)));
        add_float(&hash, sunglint_soft_root(of_bits(x)));
        sunglint_vector_f32_t any = of_any_bits(&source);
        sunglint_vector_f32_t n = lanes_about_one(&source);
        sunglint_vector_f32_t v = lanes_about_one(&source);
        sunglint_vector_f32_t l = sunglint_soft_normalize(n);
        sunglint_vector_f32_t r = sunglint_soft_reflect(l, sunglint_soft_normalize(v));
        add(&hash, sunglint_soft_normalize(any));
        add(&hash, sunglint_soft_reflect(n, v));
        add(&hash, l);
        add(&hash, r);
        add(&hash, sunglint_soft_cap(l, r, sphere));
        add(&hash, sunglint_soft_cap(n, v, sphere));
        add(&hash, sunglint_soft_cap(any, l, sphere));
        add(&hash, sunglint_soft_cap(l, any, sphere));
    }
    return hash;
}
