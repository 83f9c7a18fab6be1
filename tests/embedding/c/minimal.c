/* The least that shows the Sun's glint: how many bytes is it? */
#include "board.h"
#include "sunglint.h"

static const sunglint_sphere_q14_t sun = SUNGLINT_SUN_Q14;

/* Three raw integers in and out, as a driver would write them. */
static volatile sunglint_vector_q14_t light, mirror, nearest;

int main(void) {
    sunglint_vector_q14_t l = {light.x, light.y, light.z};
    sunglint_vector_q14_t r = {mirror.x, mirror.y, mirror.z};
    sunglint_vector_q14_t s = sunglint_cap_q14(l, r, sun);
    nearest.x = s.x;
    nearest.y = s.y;
    nearest.z = s.z;
    return 0;
}
