/*
 * sunglint: light a surface by the Sun, or by any distant sphere, in fixed point.
 *
 * Vectors are Q14 (16384 is 1) or Q30 (1073741824 is 1) and, where a unit vector is asked for, of length 1 give or take
 * a rounding; up to 1.16 nothing overflows, and longer ones give some finite answer. Quantities of light are unsigned
 * Q16 (65536 is 1), those of Lambert's law beside Q30 vectors Q32; what is at most 1 is Q30, and relative illuminance
 * in the scale of a dot product, Q28 or Q60. Bounds of errors are against exact arithmetic on the same arguments.
 *
 * No argument does harm, as long as pointers are NULL or valid; NULL has the answer that is documented. What may be
 * refused comes beside a status, SUNGLINT_OK being 0. Nothing allocates, keeps a state, sets errno or calls the C
 * library's mathematics; all functions may be called from threads and interrupts at once.
 *
 * C99 or C++11. Made of src/capi by tests/embedding/tests/header.rs, which checks it; do not edit.
 */

#ifndef SUNGLINT_H
#define SUNGLINT_H

#include <stdbool.h>
#include <stdint.h>

/** The Sun from Earth, for a constant in flash: `static const sunglint_sphere_q14_t sun = SUNGLINT_SUN_Q14;` */
#define SUNGLINT_SUN_Q14 {1248350, 5805, 268432553, 2903}

/** The Sun from Earth for Q30 vectors. */
#define SUNGLINT_SUN_Q30 \
    {INT64_C(5361623711633374), INT64_C(24934055536549), INT64_C(1152909037511672320), INT64_C(12467095174625)}

/** Why a constructor did not make what was asked for. */
enum sunglint_status_t
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /** It did. */
    SUNGLINT_OK = 0,
    /** Radius over distance is out of 0 to 1. */
    SUNGLINT_RATIO = 1,
    /** A direction's length is not within a tenth of 1. */
    SUNGLINT_DIRECTION = 2,
    /** A channel of the albedo is out of 0 to 1. */
    SUNGLINT_ALBEDO = 3,
    /** `alpha` is neither 0 nor within 5e-4 to 1. */
    SUNGLINT_ALPHA = 4,
    /** A channel of the reflectance at normal incidence is out of 0 to 1. */
    SUNGLINT_F0 = 5,
    /** The area is 0. */
    SUNGLINT_AREA = 6,
    /** The solid angle is 0. */
    SUNGLINT_SOLID_ANGLE = 7,
    /** The answer is greater than its format's greatest number. */
    SUNGLINT_OVERFLOW = 8,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum sunglint_status_t sunglint_status_t;
#else
typedef uint32_t sunglint_status_t;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * A light's constants for Q14 vectors, each in Q28, as a constructor or a constant has them; of other numbers, zeros
 * too, answers mean nothing.
 */
typedef struct {
    /** Sine of the angular radius, which is radius over distance. */
    int32_t sin;
    /** Its square. */
    int32_t sin_square;
    /** Least cosine of a direction inside the disc. */
    int32_t cos;
    /** `1 - cos`. */
    int32_t versine;
} sunglint_sphere_q14_t;

/** A light for Q14 vectors, or why there is none; then the light is a point. */
typedef struct {
    /** Why there is none. */
    sunglint_status_t status;
    /** The light. */
    sunglint_sphere_q14_t sphere;
} sunglint_sphere_q14_made_t;

/**
 * A light's constants for Q30 vectors, each in Q60, as a constructor or a constant has them; of other numbers, zeros
 * too, answers mean nothing.
 */
typedef struct {
    /** Sine of the angular radius, which is radius over distance. */
    int64_t sin;
    /** Its square. */
    int64_t sin_square;
    /** Least cosine of a direction inside the disc. */
    int64_t cos;
    /** `1 - cos`. */
    int64_t versine;
} sunglint_sphere_q30_t;

/** A light for Q30 vectors, or why there is none; then the light is a point. */
typedef struct {
    /** Why there is none. */
    sunglint_status_t status;
    /** The light. */
    sunglint_sphere_q30_t sphere;
} sunglint_sphere_q30_made_t;

/** A vector in Q14: 16384 is 1. */
typedef struct {
    /** First lane. */
    int16_t x;
    /** Second lane. */
    int16_t y;
    /** Third lane. */
    int16_t z;
} sunglint_vector_q14_t;

/** A vector in Q30: 1073741824 is 1. */
typedef struct {
    /** First lane. */
    int32_t x;
    /** Second lane. */
    int32_t y;
    /** Third lane. */
    int32_t z;
} sunglint_vector_q30_t;

/**
 * The directions to a light for Q14 vectors. Made by `sunglint_cone_q14` alone; its words are not to be changed. All
 * words zero has zero for its directions and contains every one.
 */
typedef struct {
    uint32_t opaque[19];
} sunglint_cone_q14_t;

/**
 * The directions to a light for Q30 vectors. Made by `sunglint_cone_q30` alone; its words are not to be changed. All
 * words zero has zero for its directions and contains every one.
 */
typedef struct {
    uint32_t opaque[24];
} sunglint_cone_q30_t;

/** A point of the square of 0 to 1, in Q14: 16384 is 1. */
typedef struct {
    /** How far from a disc's centre to its rim, by area. */
    int16_t z;
    /** Where around it. */
    int16_t turn;
} sunglint_point_q14_t;

/** A point of the square of 0 to 1, in Q30: 1073741824 is 1. */
typedef struct {
    /** How far from a disc's centre to its rim, by area. */
    int32_t z;
    /** Where around it. */
    int32_t turn;
} sunglint_point_q30_t;

/** Two directions across a third, in Q14. */
typedef struct {
    /** The first. */
    sunglint_vector_q14_t t;
    /** The second. */
    sunglint_vector_q14_t b;
} sunglint_basis_q14_t;

/** Two directions across a third, in Q30. */
typedef struct {
    /** The first. */
    sunglint_vector_q30_t t;
    /** The second. */
    sunglint_vector_q30_t b;
} sunglint_basis_q30_t;

/** What a surface sees of a light, in Q30, each from 0 to 1. */
typedef struct {
    /** Share of the disc that is above the surface and seen. */
    int32_t visible;
    /** Mean over the disc of the cosine to the normal, of what is hidden 0. */
    int32_t mean_cosine;
} sunglint_soft_shadow_t;

/**
 * Asked whether the way from the surface into `direction` is free; `user` is what the caller gave. It has to
 * return, without an exception or a jump, and may call any function here, but not change the cone.
 */
typedef bool (*sunglint_sees_q14_t)(sunglint_vector_q14_t direction, void *user);

/**
 * Asked whether the way from the surface into `direction` is free; `user` is what the caller gave. It has to
 * return, without an exception or a jump, and may call any function here, but not change the cone.
 */
typedef bool (*sunglint_sees_q30_t)(sunglint_vector_q30_t direction, void *user);

/** A radiance, or why there is none. */
typedef struct {
    /** Why there is none. */
    sunglint_status_t status;
    /** The radiance in W/(m^2 sr), Q16. */
    uint32_t radiance;
} sunglint_radiance_q16_made_t;

/** Levels in Q30: 1073741824 is 1. */
typedef struct {
    /** Red. */
    int32_t red;
    /** Green. */
    int32_t green;
    /** Blue. */
    int32_t blue;
} sunglint_colour_q30_t;

/** Levels in unsigned Q16: 65536 is 1. */
typedef struct {
    /** Red. */
    uint32_t red;
    /** Green. */
    uint32_t green;
    /** Blue. */
    uint32_t blue;
} sunglint_colour_q16_t;

/** A material under one light, as `sunglint_pixel_q14` makes it. All words zero is black. */
typedef struct {
    uint32_t opaque[41];
} sunglint_pixel_q14_t;

/** A material under one light, or why there is none; then it is black. */
typedef struct {
    /** Why there is none. */
    sunglint_status_t status;
    /** The material under the light. */
    sunglint_pixel_q14_t pixel;
} sunglint_pixel_q14_made_t;

/** A glossy surface, in Q30: 1073741824 is 1. */
typedef struct {
    /** Diffuse reflectance, each from 0 to 1. */
    sunglint_colour_q30_t albedo;
    /** The GGX width, perceptual roughness squared: 0 for a mirror, or from 5e-4 (536871) to 1. */
    int32_t alpha;
    /** Reflectance at normal incidence, each from 0 to 1; 0.02 to 0.05 for what is no metal. */
    sunglint_colour_q30_t f0;
} sunglint_material_q30_t;

/** A vector of floats. */
typedef struct {
    /** First lane. */
    float x;
    /** Second lane. */
    float y;
    /** Third lane. */
    float z;
} sunglint_vector_f32_t;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/**
 * The constants of a sphere whose radius over distance is `ratio`, in Q30, for Q14 vectors: for a lamp that moves.
 * Once a light, not per pixel.
 *
 * Within 0.51 units of Q28's last place. `SUNGLINT_RATIO` where `ratio` is out of 0 to 1 (2^30); the light is then a
 * point.
 */
sunglint_sphere_q14_made_t sunglint_sphere_q14(int32_t ratio);

/**
 * The constants of a sphere whose radius over distance is `ratio`, in Q30, for Q30 vectors: for a lamp that moves.
 * Once a light, not per pixel.
 *
 * Within 0.75 units of Q60's last place. `SUNGLINT_RATIO` where `ratio` is out of 0 to 1 (2^30); the light is then a
 * point.
 */
sunglint_sphere_q30_made_t sunglint_sphere_q30(int32_t ratio);

/**
 * The direction to shade a highlight with, in Q14: `l`, the unit direction to the light's centre, turned towards the
 * unit mirror ray `r` (see `sunglint_reflect_q14`) by the angle between them, but by no more than the light's angular
 * radius. The default.
 *
 * Error at the Sun at most 6.2e-5 rad, the step of Q14 being 6.1e-5; at most 1.7e-4 off length 1. Within a step of
 * `-l` it is some direction of the rim, and at `r = -l` it is `l`. A zero `r` gives zero, a zero `l` gives `x r`, `x`
 * being radius over distance. Vectors longer than 1.16 give some direction.
 */
sunglint_vector_q14_t sunglint_cap_q14(sunglint_vector_q14_t l, sunglint_vector_q14_t r, sunglint_sphere_q14_t light);

/**
 * The direction to shade a highlight with, in Q30: `l`, the unit direction to the light's centre, turned towards the
 * unit mirror ray `r` (see `sunglint_reflect_q30`) by the angle between them, but by no more than the light's angular
 * radius. The default.
 *
 * Error at the Sun at most 1.5e-9 rad, the step of Q30 being 9.3e-10; at most 3.0e-9 off length 1. Within a step of
 * `-l` it is some direction of the rim, and at `r = -l` it is `l`. A zero `r` gives zero, a zero `l` gives `x r`, `x`
 * being radius over distance. Vectors longer than 1.16 give some direction.
 */
sunglint_vector_q30_t sunglint_cap_q30(sunglint_vector_q30_t l, sunglint_vector_q30_t r, sunglint_sphere_q30_t light);

/**
 * Epic's representative point with the distance divided out, in Q14: `normalize(l + D min(1, x / |D|))` with `D =
 * (l.r) r - l`, `x` being radius over distance. Beside the light as `sunglint_cap_q14`; its turn falls to about `x
 * cos(angle)`, half at 60 degrees, and is away from `r` beyond 90.
 *
 * Error of this formula at the Sun at most 1.4e-4 rad. Zero where the sum is, for `x = 1` with `l` at a right angle
 * to `r`. Vectors longer than 1.16 give some direction.
 */
sunglint_vector_q14_t sunglint_factored_q14(sunglint_vector_q14_t l,
                                            sunglint_vector_q14_t r,
                                            sunglint_sphere_q14_t light);

/**
 * Epic's representative point with the distance divided out, in Q30: `normalize(l + D min(1, x / |D|))` with `D =
 * (l.r) r - l`, `x` being radius over distance. Beside the light as `sunglint_cap_q30`; its turn falls to about `x
 * cos(angle)`, half at 60 degrees, and is away from `r` beyond 90.
 *
 * Error of this formula at the Sun at most 2.3e-9 rad. Zero where the sum is, for `x = 1` with `l` at a right angle
 * to `r`. Vectors longer than 1.16 give some direction.
 */
sunglint_vector_q30_t sunglint_factored_q30(sunglint_vector_q30_t l,
                                            sunglint_vector_q30_t r,
                                            sunglint_sphere_q30_t light);

/**
 * The mirror ray `2 (n.v) n - v` of the unit direction `v` from the surface to the camera, about the unit normal `n`,
 * in Q14. Each lane is within half a step. Shading languages' `reflect(i, n)` takes the direction to the surface,
 * `-v`.
 */
sunglint_vector_q14_t sunglint_reflect_q14(sunglint_vector_q14_t n, sunglint_vector_q14_t v);

/**
 * The mirror ray `2 (n.v) n - v` of the unit direction `v` from the surface to the camera, about the unit normal `n`,
 * in Q30. Each lane is within a step. Shading languages' `reflect(i, n)` takes the direction to the surface, `-v`.
 */
sunglint_vector_q30_t sunglint_reflect_q30(sunglint_vector_q30_t n, sunglint_vector_q30_t v);

/**
 * `v`, of any length, at length 1 in Q14: lanes may be of any other scale. Within 6.0e-5 rad, and 7.2e-5 of length 1.
 * A zero vector gives zero.
 */
sunglint_vector_q14_t sunglint_normalize_q14(sunglint_vector_q14_t v);

/**
 * `v`, of any length, at length 1 in Q30: lanes may be of any other scale. Within 9.0e-10 rad, and 1.2e-9 of length 1.
 * A zero vector gives zero.
 */
sunglint_vector_q30_t sunglint_normalize_q30(sunglint_vector_q30_t v);

/** `1 / sqrt(x)` of a Q16 number, in Q16: within 0.5003 of the last place, over all inputs. Zero gives 2^32 - 1. */
uint32_t sunglint_reciprocal_root_q16(uint32_t x);

/**
 * Lambert's law, the radiance `albedo / pi * illuminance * max(n.l, 0)` of a matt surface: `albedo` in Q14, from 0 to
 * 1; `illuminance`, that of a plane which faces the light, and the answer in unsigned Q16, in a unit of your choice;
 * `n_dot_l` in Q28, the plain sum of three products of the Q14 lanes of the normal and the direction to the light's
 * centre.
 *
 * Within 0.57 units of Q16 for an illuminance up to 1000, 1.4 for any. `n_dot_l` below 0 counts as 0, above 1 as 1. A
 * negative albedo gives 0; what is too great is 2^32 - 1.
 */
uint32_t sunglint_lambert_q14(int16_t albedo, uint32_t illuminance, int32_t n_dot_l);

/**
 * Lambert's law, the radiance `albedo / pi * illuminance * max(n.l, 0)` of a matt surface: `albedo` in Q30, from 0 to
 * 1; `illuminance`, that of a plane which faces the light, and the answer in unsigned Q32, in a unit of your choice;
 * `n_dot_l` in Q60, the plain sum of three products of the Q30 lanes of the normal and the direction to the light's
 * centre.
 *
 * Within 2.5 units of Q32, or of 31 bits where they are coarser, for an illuminance up to 1000, 2.9 for any. `n_dot_l`
 * below 0 counts as 0, above 1 as 1. A negative albedo gives 0; what is too great is 2^64 - 1.
 */
uint64_t sunglint_lambert_q30(int32_t albedo, uint64_t illuminance, int64_t n_dot_l);

/**
 * Lambert's law with the light's true size, so that it fades out as it sets: `albedo / pi * illuminance` times
 * `sunglint_relative_illuminance_q14`.
 *
 * Formats and special cases are those of `sunglint_lambert_q14` and of that one; the error is the one's more than the
 * other's.
 */
uint32_t sunglint_lambert_disc_q14(int16_t albedo, uint32_t illuminance, int32_t n_dot_l, sunglint_sphere_q14_t light);

/**
 * Lambert's law with the light's true size, so that it fades out as it sets: `albedo / pi * illuminance` times
 * `sunglint_relative_illuminance_q30`.
 *
 * Formats and special cases are those of `sunglint_lambert_q30` and of that one; the error is the one's more than the
 * other's.
 */
uint64_t sunglint_lambert_disc_q30(int32_t albedo, uint64_t illuminance, int64_t n_dot_l, sunglint_sphere_q30_t light);

/**
 * Illuminance of a plane under a disc, over that of a plane which faces it: `n_dot_l` in Q28, see
 * `sunglint_lambert_q14`; the answer in Q28, from 0 to 2^28.
 *
 * `n.l` itself where the disc is wholly above the plane, zero where it is wholly below, `2 x / (3 pi)` when its centre
 * sets, `x` being radius over distance. Relative error 2.9e-7 at every elevation down to the last sliver, before the
 * rounding to Q28; 1.4e-7 absolute for discs beyond half the sky.
 */
int32_t sunglint_relative_illuminance_q14(int32_t n_dot_l, sunglint_sphere_q14_t light);

/**
 * Illuminance of a plane under a disc, over that of a plane which faces it: `n_dot_l` in Q60, see
 * `sunglint_lambert_q30`; the answer in Q60, from 0 to 2^60, of which 31 bits are significant.
 *
 * `n.l` itself where the disc is wholly above the plane, zero where it is wholly below, `2 x / (3 pi)` when its centre
 * sets, `x` being radius over distance. Relative error 2.9e-7 at every elevation down to the last sliver; 1.4e-7
 * absolute for discs beyond half the sky.
 */
int64_t sunglint_relative_illuminance_q30(int64_t n_dot_l, sunglint_sphere_q30_t light);

/**
 * The directions of `light` about the unit direction `l` to its centre, for Q14 vectors. Once a light, not per pixel.
 *
 * An `l` longer than 2 is taken for zero; samples are then meaningless.
 */
sunglint_cone_q14_t sunglint_cone_q14(sunglint_vector_q14_t l, sunglint_sphere_q14_t light);

/**
 * The directions of `light` about the unit direction `l` to its centre, for Q30 vectors. Once a light, not per pixel.
 *
 * An `l` longer than 2 is taken for zero; samples are then meaningless.
 */
sunglint_cone_q30_t sunglint_cone_q30(sunglint_vector_q30_t l, sunglint_sphere_q30_t light);

/**
 * The direction of the light's disc at `point`, in Q14: even over the disc's solid angle if the points are over the
 * square, as those of `sunglint_point_q14` are. `z` 0 is the centre, 1 the rim; the turn begins at the first vector of
 * `sunglint_basis_q14` and goes towards the second.
 *
 * Error at the Sun at most 1.2e-4 rad, of any disc 2.7e-4; `sunglint_cone_contains_q14` holds for every answer.
 * Numbers below 0 count as 0, above 1 as 1. Zero where `cone` is NULL.
 */
sunglint_vector_q14_t sunglint_cone_direction_q14(const sunglint_cone_q14_t *cone, sunglint_point_q14_t point);

/**
 * The direction of the light's disc at `point`, in Q30: even over the disc's solid angle if the points are over the
 * square, as those of `sunglint_point_q30` are. `z` 0 is the centre, 1 the rim; the turn begins at the first vector of
 * `sunglint_basis_q30` and goes towards the second.
 *
 * Error at the Sun at most 1.9e-9 rad, of any disc 5.0e-9; `sunglint_cone_contains_q30` holds for every answer.
 * Numbers below 0 count as 0, above 1 as 1. Zero where `cone` is NULL.
 */
sunglint_vector_q30_t sunglint_cone_direction_q30(const sunglint_cone_q30_t *cone, sunglint_point_q30_t point);

/**
 * Whether the unit vector `direction`, in Q14, is within the light's disc: `|direction - l|^2 <= 2 w`, `w` being the
 * versine of the angular radius.
 *
 * Directions that are told wrong are at most 2.9e-6 rad from the rim of a disc of 0.001 to 0.01 rad, as the Sun is,
 * and at most 8.9e-5 from any. False where `cone` is NULL.
 */
bool sunglint_cone_contains_q14(const sunglint_cone_q14_t *cone, sunglint_vector_q14_t direction);

/**
 * Whether the unit vector `direction`, in Q30, is within the light's disc: `|direction - l|^2 <= 2 w`, `w` being the
 * versine of the angular radius.
 *
 * Directions that are told wrong are at most 1.2e-11 rad from the rim of a disc of 0.001 to 0.01 rad, as the Sun is,
 * and at most 1.6e-9 from any. False where `cone` is NULL.
 */
bool sunglint_cone_contains_q30(const sunglint_cone_q30_t *cone, sunglint_vector_q30_t direction);

/**
 * Two unit vectors perpendicular to the unit vector `l` and to each other, in Q14, with `t x b = l`: the x and y axes
 * carried along by the least rotation that takes the z axis to `l` (where `l.z` is negative its negative, and that of
 * y).
 *
 * Angles and lengths are within 1.5e-4. For a zero `l`, and one longer than 2, those of the z axis.
 */
sunglint_basis_q14_t sunglint_basis_q14(sunglint_vector_q14_t l);

/**
 * Two unit vectors perpendicular to the unit vector `l` and to each other, in Q30, with `t x b = l`: the x and y axes
 * carried along by the least rotation that takes the z axis to `l` (where `l.z` is negative its negative, and that of
 * y).
 *
 * Angles and lengths are within 2.3e-9. For a zero `l`, and one longer than 2, those of the z axis.
 */
sunglint_basis_q30_t sunglint_basis_q30(sunglint_vector_q30_t l);

/**
 * The point `index` of the sequence R2, in Q14: any run of its points fills the square of 0 to 1 evenly. `(1/2 + index
 * / g, 1/2 + index / g^2)` modulo 1, `g` being 1.3247, the plastic number; comes round after 2^32.
 *
 * To give every pixel points of its own, let pixel `k` begin at `k` times the count, wrapping.
 */
sunglint_point_q14_t sunglint_point_q14(uint32_t index);

/**
 * The point `index` of the sequence R2, in Q30: any run of its points fills the square of 0 to 1 evenly. `(1/2 + index
 * / g, 1/2 + index / g^2)` modulo 1, `g` being 1.3247, the plastic number; comes round after 2^32.
 *
 * To give every pixel points of its own, let pixel `k` begin at `k` times the count, wrapping.
 */
sunglint_point_q30_t sunglint_point_q30(uint32_t index);

/**
 * What a surface with the unit normal `n` sees of a light: asks `sees` for `count` directions to it, those of the
 * points from `first` on, whether they are free, passing `user` on as it is. Directions under the surface count as
 * hidden and are not asked for.
 *
 * The visible share is within `2 count^-0.75` of the area that is seen, and the mean cosine as a share of its
 * greatest, of discs that a plane, a sphere or the surface's own horizon cuts; at the Sun, which is few steps of Q14
 * wide, 0.0021 are added. Zeros where `cone` or `sees` is NULL, and for a `count` of 0.
 */
sunglint_soft_shadow_t sunglint_soft_shadow_q14(const sunglint_cone_q14_t *cone,
                                                sunglint_vector_q14_t n,
                                                uint32_t first,
                                                uint32_t count,
                                                sunglint_sees_q14_t sees,
                                                void *user);

/**
 * What a surface with the unit normal `n` sees of a light: asks `sees` for `count` directions to it, those of the
 * points from `first` on, whether they are free, passing `user` on as it is. Directions under the surface count as
 * hidden and are not asked for.
 *
 * The visible share is within `2 count^-0.75` of the area that is seen, and the mean cosine as a share of its
 * greatest, of discs that a plane, a sphere or the surface's own horizon cuts. Zeros where `cone` or `sees` is NULL,
 * and for a `count` of 0.
 */
sunglint_soft_shadow_t sunglint_soft_shadow_q30(const sunglint_cone_q30_t *cone,
                                                sunglint_vector_q30_t n,
                                                uint32_t first,
                                                uint32_t count,
                                                sunglint_sees_q30_t sees,
                                                void *user);

/**
 * Irradiance by a point, `I cos / r^2`: `intensity` in W/sr and `distance` in metres in Q16, the cosine of the angle
 * to the surface's normal in Q14; the answer in W/m^2 in Q16.
 *
 * Within half a unit of the last place and 2.1e-9 of the answer. A negative cosine, and a distance of 0, give 0; what
 * is too great is 2^32 - 1.
 */
uint32_t sunglint_irradiance_q16(uint32_t intensity, int16_t cos, uint32_t distance);

/**
 * Radiance of a matt surface, `rho E / pi`: `albedo` in Q14, from 0 to 1; `irradiance` in W/m^2 and the answer in
 * W/(m^2 sr), both in Q16.
 *
 * Within half a unit of the last place and 1.3e-9 of the answer. A negative albedo gives 0; an answer that is too
 * great is 2^32 - 1.
 */
uint32_t sunglint_diffuse_radiance_q16(int16_t albedo, uint32_t irradiance);

/**
 * Radiance of a lamp that shines evenly, `Phi / (A Omega)`: watts, square metres and steradians in Q16, the answer in
 * W/(m^2 sr) in Q16.
 *
 * Within half a unit of the last place and 1.7e-9 of the answer. `SUNGLINT_AREA` and `SUNGLINT_SOLID_ANGLE` where that
 * is 0; the radiance is then 0. `SUNGLINT_OVERFLOW` from 65536 W/(m^2 sr) on; it is then 2^32 - 1.
 */
sunglint_radiance_q16_made_t sunglint_area_radiance_q16(uint32_t power, uint32_t area, uint32_t solid_angle);

/**
 * Planck's law by wavelength over its peak, `y^-5 expm1(a) / expm1(a / y)` with `a = 4.965114`: of a wavelength
 * `ratio` times the peak's, in Q16 (the peak is at 2.8978 micrometres times kilokelvins); the answer in Q30, from 0 to
 * 1.
 *
 * Within 4 units of the last place. Zero for a ratio of 0.
 */
int32_t sunglint_relative_to_peak_q16(uint32_t ratio);

/**
 * Planck's law by frequency over its peak, `z^3 expm1(a) / expm1(a z)` with `a = 2.821439`: of a frequency `ratio`
 * times the peak's, in Q16 (the peak is at 58.789 THz per kilokelvin); the answer in Q30, from 0 to 1.
 *
 * Within 4 units of the last place. Zero for a ratio of 0.
 */
int32_t sunglint_relative_to_peak_frequency_q16(uint32_t ratio);

/**
 * The colour of a black body: Planck's law by wavelength at three wavelengths, over the greatest of the three, which
 * is exactly 1. `temperature` in kilokelvins and `wavelengths` in micrometres, in Q16, those within a factor of 8 of
 * each other; the answer in Q30.
 *
 * Within 12 units of the last place, for 0.8 to 40 kK at 0.38 to 0.78 micrometres. Zeros where the temperature or a
 * wavelength is 0.
 */
sunglint_colour_q30_t sunglint_tint_q16(uint32_t temperature, sunglint_colour_q16_t wavelengths);

/**
 * The constants of a material under one light: its centre in the unit `direction`, in Q14; `illuminance`, in unsigned
 * Q16 and a unit of your choice, what it gives to a surface that faces it. Once a light.
 *
 * `SUNGLINT_ALBEDO`, `SUNGLINT_F0` and `SUNGLINT_ALPHA` where the material is out of its ranges, `SUNGLINT_DIRECTION`
 * where the direction's length is not within a tenth of 1; the pixel is then black.
 */
sunglint_pixel_q14_made_t sunglint_pixel_q14(sunglint_vector_q14_t direction,
                                             sunglint_sphere_q14_t light,
                                             sunglint_material_q30_t material,
                                             sunglint_colour_q16_t illuminance);

/**
 * Radiance in red, green and blue, in Q16 and the illuminance's unit, that a surface of the unit normal `n` sends
 * towards the unit direction `v` to the camera, both in Q14: Lambert's law, and GGX averaged over the light's disc
 * with Smith's shadowing and Schlick's reflectance.
 *
 * Within 6e-5 of the diffuse part, 6e-4 of the highlight (root mean square 4e-5) times the formula's condition, which
 * is 2 away from the disc's image and grows at the rim of a sharp one and near the horizon, 2e-5 of what the highlight
 * would be with a reflectance of 1, and 0.6 of the last place. No highlight where `n.v` or `n.l` is at most 2^-14,
 * nor for a mirror (`alpha` 0) under a point. For more lights add up their pixels, saturating.
 * Black where the surface faces away from the camera, and where `pixel` is NULL; what is too great is 2^32 - 1.
 */
sunglint_colour_q16_t sunglint_pixel_q14_shade(const sunglint_pixel_q14_t *pixel,
                                               sunglint_vector_q14_t n,
                                               sunglint_vector_q14_t v);

/**
 * `sunglint_pixel_q14_shade` in one channel: 0 is red, 1 green, 2 blue. Any other gives 0, and so does a `pixel` that
 * is NULL.
 */
uint32_t sunglint_pixel_q14_shade_channel(const sunglint_pixel_q14_t *pixel,
                                          sunglint_vector_q14_t n,
                                          sunglint_vector_q14_t v,
                                          uint32_t channel);

/**
 * `1 / sqrt(x)` in integers, correctly rounded, over all inputs. Of zero infinity with its sign, of infinity zero, of
 * what is negative NaN.
 */
float sunglint_soft_reciprocal_root(float x);

/** `sqrt(x)` in integers, correctly rounded, over all inputs. Of either zero that zero, of what is negative NaN. */
float sunglint_soft_root(float x);

/**
 * `sunglint_cap_q30` of unit vectors of floats: through Q30, in integers.
 *
 * Error in radians `5.4e-8 + 1.15e-9 x / gap` for a radius over distance `x` up to 0.05, 1.1e-7 in place of 5.4e-8 up
 * to 1, `gap` being the angle between `r` and `-l`. Lanes below 2^-7 are rounded to multiples of 2^-30. Where a lane
 * of `l` is NaN or 2 and more the answer is zero, where one of `r` is, it is `l`; a zero `r` gives zero.
 */
sunglint_vector_f32_t sunglint_soft_cap(sunglint_vector_f32_t l, sunglint_vector_f32_t r, sunglint_sphere_q30_t light);

/**
 * `sunglint_reflect_q30` of unit vectors of floats: through Q30, in integers. Each lane is within 6.1e-8. Zero where a
 * lane is NaN or 2 and more.
 */
sunglint_vector_f32_t sunglint_soft_reflect(sunglint_vector_f32_t n, sunglint_vector_f32_t v);

/**
 * `v`, of any length, at length 1, in integers: within 5.0e-8 rad. A zero vector, and one with a NaN or an infinity,
 * gives zero.
 */
sunglint_vector_f32_t sunglint_soft_normalize(sunglint_vector_f32_t v);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* SUNGLINT_H */
