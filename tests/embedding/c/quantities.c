/* Diffuse light, radiometry and black bodies. */
#include "hashes.h"
#include "inputs.h"

static void diffuse_q14(struct source *source, uint32_t *hash, int32_t ratio) {
    sunglint_sphere_q14_t sphere = sunglint_sphere_q14(ratio).sphere;
    int16_t albedo = lane_q14(source);
    uint32_t illuminance = size(source);
    int32_t cosine = either_sign(source);
    add_32(hash, sunglint_lambert_q14(albedo, illuminance, cosine));
    add_32(hash, sunglint_lambert_disc_q14(albedo, illuminance, cosine, sphere));
    add_32(hash, (uint32_t)sunglint_relative_illuminance_q14(cosine, sphere));
}

static void diffuse_q30(struct source *source, uint32_t *hash, int32_t ratio) {
    sunglint_sphere_q30_t sphere = sunglint_sphere_q30(ratio).sphere;
    int32_t albedo = either_sign(source);
    uint64_t illuminance = wide(source);
    int64_t cosine = wide_either_sign(source);
    add_64(hash, sunglint_lambert_q30(albedo, illuminance, cosine));
    add_64(hash, sunglint_lambert_disc_q30(albedo, illuminance, cosine, sphere));
    add_64(hash, (uint64_t)sunglint_relative_illuminance_q30(cosine, sphere));
}

uint32_t diffuse(void) {
    struct source source = source_new();
    uint32_t hash = HASH_OF_NOTHING;
    for (uint32_t i = 0; i < CASES; ++i) {
        int32_t of_light = ratio(&source);
        diffuse_q14(&source, &hash, of_light);
        diffuse_q30(&source, &hash, of_light);
    }
    return hash;
}

uint32_t radiometry(void) {
    struct source source = source_new();
    uint32_t hash = HASH_OF_NOTHING;
    for (uint32_t i = 0; i < CASES; ++i) {
        uint32_t intensity = size(&source);
        int16_t cosine = lane_q14(&source);
        uint32_t distance = size(&source);
        add_32(&hash, sunglint_irradiance_q16(intensity, cosine, distance));
        add_32(&hash, sunglint_diffuse_radiance_q16(cosine, intensity));
        uint32_t power = size(&source);
        uint32_t area = size(&source);
        sunglint_radiance_q16_made_t made = sunglint_area_radiance_q16(power, area, size(&source));
        add_32(&hash, (uint32_t)made.status);
        add_32(&hash, made.radiance);
    }
    return hash;
}

uint32_t black_bodies(void) {
    struct source source = source_new();
    uint32_t hash = HASH_OF_NOTHING;
    for (uint32_t i = 0; i < CASES; ++i) {
        uint32_t ratio = size(&source);
        add_32(&hash, (uint32_t)sunglint_relative_to_peak_q16(ratio));
        add_32(&hash, (uint32_t)sunglint_relative_to_peak_frequency_q16(ratio));
        uint32_t temperature = size(&source);
        sunglint_colour_q16_t wavelengths;
        wavelengths.red = size(&source);
        wavelengths.green = size(&source);
        wavelengths.blue = size(&source);
        sunglint_colour_q30_t tint = sunglint_tint_q16(temperature, wavelengths);
        add_32(&hash, (uint32_t)tint.red);
        add_32(&hash, (uint32_t)tint.green);
        add_32(&hash, (uint32_t)tint.blue);
    }
    return hash;
}
