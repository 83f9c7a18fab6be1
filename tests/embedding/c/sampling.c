/* Cones, their directions and soft shadows in both formats. */
#include "hashes.h"
#include "inputs.h"

/* A wall through the light's centre, and how often it was asked. */
struct wall_q14 {
    int16_t x;
    uint32_t asked;
};

struct wall_q30 {
    int32_t x;
    uint32_t asked;
};

static bool sees_q14(sunglint_vector_q14_t direction, void *user) {
    struct wall_q14 *wall = (struct wall_q14 *)user;
    ++wall->asked;
    return direction.x > wall->x;
}

static bool sees_q30(sunglint_vector_q30_t direction, void *user) {
    struct wall_q30 *wall = (struct wall_q30 *)user;
    ++wall->asked;
    return direction.x > wall->x;
}

static void add_shadow(uint32_t *hash, sunglint_soft_shadow_t shadow) {
    add_32(hash, (uint32_t)shadow.visible);
    add_32(hash, (uint32_t)shadow.mean_cosine);
}

static void q14(struct source *source, uint32_t *hash, bool unit) {
    sunglint_vector_q14_t any = lanes_q14(source);
    sunglint_sphere_q14_t sphere = sunglint_sphere_q14(ratio(source)).sphere;
    sunglint_vector_q14_t l = unit ? sunglint_normalize_q14(any) : any;
    sunglint_cone_q14_t cone = sunglint_cone_q14(l, sphere);
    sunglint_basis_q14_t basis = sunglint_basis_q14(l);
    add_q14(hash, basis.t);
    add_q14(hash, basis.b);
    uint32_t first = bits(source);
    sunglint_point_q14_t point = sunglint_point_q14(first);
    add_16(hash, point.z);
    add_16(hash, point.turn);
    add_16(hash, 0);
    add_q14(hash, sunglint_cone_direction_q14(&cone, point));
    any = lanes_q14(source);
    point.z = any.x;
    point.turn = any.y;
    sunglint_vector_q14_t direction = sunglint_cone_direction_q14(&cone, point);
    add_q14(hash, direction);
    sunglint_vector_q14_t n = lanes_q14(source);
    add_32(hash, sunglint_cone_contains_q14(&cone, direction));
    add_32(hash, sunglint_cone_contains_q14(&cone, n));
    struct wall_q14 wall = {l.x, 0};
    uint32_t count = bits(source) & 15;
    add_shadow(hash, sunglint_soft_shadow_q14(&cone, n, first, count, sees_q14, &wall));
    add_32(hash, wall.asked);
}

static void q30(struct source *source, uint32_t *hash, bool unit) {
    sunglint_vector_q30_t any = lanes_q30(source);
    sunglint_sphere_q30_t sphere = sunglint_sphere_q30(ratio(source)).sphere;
    sunglint_vector_q30_t l = unit ? sunglint_normalize_q30(any) : any;
    sunglint_cone_q30_t cone = sunglint_cone_q30(l, sphere);
    sunglint_basis_q30_t basis = sunglint_basis_q30(l);
    add_q30(hash, basis.t);
    add_q30(hash, basis.b);
    uint32_t first = bits(source);
    sunglint_point_q30_t point = sunglint_point_q30(first);
    add_32(hash, (uint32_t)point.z);
    add_32(hash, (uint32_t)point.turn);
    add_32(hash, 0);
    add_q30(hash, sunglint_cone_direction_q30(&cone, point));
    any = lanes_q30(source);
    point.z = any.x;
    point.turn = any.y;
    sunglint_vector_q30_t direction = sunglint_cone_direction_q30(&cone, point);
    add_q30(hash, direction);
    sunglint_vector_q30_t n = lanes_q30(source);
    add_32(hash, sunglint_cone_contains_q30(&cone, direction));
    add_32(hash, sunglint_cone_contains_q30(&cone, n));
    struct wall_q30 wall = {l.x, 0};
    uint32_t count = bits(source) & 15;
    add_shadow(hash, sunglint_soft_shadow_q30(&cone, n, first, count, sees_q30, &wall));
    add_32(hash, wall.asked);
}

/* What is not there gives zeros, and nobody is asked. */
static void nothing_q14(uint32_t *hash) {
    const sunglint_sphere_q14_t sun = SUNGLINT_SUN_Q14;
    sunglint_vector_q14_t up = {0, 0, 16384};
    sunglint_point_q14_t point = {1, 2};
    struct wall_q14 wall = {0, 0};
    sunglint_cone_q14_t cone = sunglint_cone_q14(up, sun);
    add_q14(hash, sunglint_cone_direction_q14(0, point));
    add_32(hash, sunglint_cone_contains_q14(0, up));
    add_shadow(hash, sunglint_soft_shadow_q14(0, up, 0, 4, sees_q14, &wall));
    add_shadow(hash, sunglint_soft_shadow_q14(&cone, up, 0, 4, 0, &wall));
    add_32(hash, wall.asked);
}

static void nothing_q30(uint32_t *hash) {
    const sunglint_sphere_q30_t sun = SUNGLINT_SUN_Q30;
    sunglint_vector_q30_t up = {0, 0, 1073741824};
    sunglint_point_q30_t point = {1, 2};
    struct wall_q30 wall = {0, 0};
    sunglint_cone_q30_t cone = sunglint_cone_q30(up, sun);
    add_q30(hash, sunglint_cone_direction_q30(0, point));
    add_32(hash, sunglint_cone_contains_q30(0, up));
    add_shadow(hash, sunglint_soft_shadow_q30(0, up, 0, 4, sees_q30, &wall));
    add_shadow(hash, sunglint_soft_shadow_q30(&cone, up, 0, 4, 0, &wall));
    add_32(hash, wall.asked);
}

uint32_t sampling(void) {
    struct source source = source_new();
    uint32_t hash = HASH_OF_NOTHING;
    for (uint32_t i = 0; i < CASES; ++i) {
        q14(&source, &hash, (i & 1) == 0);
        q30(&source, &hash, (i & 1) == 0);
    }
    nothing_q14(&hash);
    nothing_q30(&hash);
    return hash;
}
