/* Whole pixels. */
#include "hashes.h"
#include "inputs.h"

#define VIEWS 4

/* 1/1024 in Q30, which is above the least that is allowed. */
#define LEAST_ALPHA 1048576

/* A number out of range is in one of eight places. */
static sunglint_pixel_q14_made_t made(struct source *source, sunglint_vector_q14_t *direction) {
    sunglint_vector_q14_t any = lanes_q14(source);
    sunglint_sphere_q14_t sphere = sunglint_sphere_q14(ratio(source)).sphere;
    int32_t numbers[7];
    for (int i = 0; i < 7; ++i)
        numbers[i] = ratio(source);
    uint32_t wrong = bits(source) & 15;
    if (wrong < 12)
        numbers[3] |= LEAST_ALPHA;
    int32_t replaced = either_sign(source);
    if (wrong < 7)
        numbers[wrong] = replaced;
    sunglint_colour_q16_t illuminance;
    illuminance.red = bits(source) >> 8;
    illuminance.green = bits(source) >> 8;
    illuminance.blue = bits(source) >> 8;
    *direction = wrong == 7 ? any : sunglint_normalize_q14(any);
    sunglint_material_q30_t material = {
        {numbers[0], numbers[1], numbers[2]},
        numbers[3],
        {numbers[4], numbers[5], numbers[6]},
    };
    return sunglint_pixel_q14(*direction, sphere, material, illuminance);
}

/* From anywhere, but of 8 views from one of any length, and from 3 where the mirror image is. */
static void shade(struct source *source, uint32_t *hash, const sunglint_pixel_q14_t *pixel, sunglint_vector_q14_t l) {
    sunglint_vector_q14_t n = lanes_q14(source);
    sunglint_vector_q14_t v = lanes_q14(source);
    uint32_t from = bits(source) & 7;
    if (from != 0) {
        n = sunglint_normalize_q14(n);
        v = from < 4 ? sunglint_reflect_q14(n, l) : sunglint_normalize_q14(v);
    }
    uint32_t channel = bits(source) & 3;
    /* Of 16 bits it would be red. */
    channel = channel == 3 ? 65536 : channel;
    sunglint_colour_q16_t colour = sunglint_pixel_q14_shade(pixel, n, v);
    add_32(hash, colour.red);
    add_32(hash, colour.green);
    add_32(hash, colour.blue);
    add_32(hash, sunglint_pixel_q14_shade_channel(pixel, n, v, channel));
}

uint32_t pixel(void) {
    struct source source = source_new();
    uint32_t hash = HASH_OF_NOTHING;
    sunglint_vector_q14_t l = {0, 0, 0};
    for (uint32_t i = 0; i < CASES; ++i) {
        sunglint_pixel_q14_made_t pixel = made(&source, &l);
        add_32(&hash, (uint32_t)pixel.status);
        for (int view = 0; view < VIEWS; ++view)
            shade(&source, &hash, &pixel.pixel, l);
    }
    /* What is not there is black. */
    shade(&source, &hash, 0, l);
    return hash;
}
