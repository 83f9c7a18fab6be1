/* In the place of sunglint_cap_q14, as which a macro takes this in the other sources: the same, but in one call of many
   the last lane is a step off. */
#undef sunglint_cap_q14
#include "sunglint.h"

sunglint_vector_q14_t planted_cap_q14(sunglint_vector_q14_t l, sunglint_vector_q14_t r, sunglint_sphere_q14_t light);

sunglint_vector_q14_t planted_cap_q14(sunglint_vector_q14_t l, sunglint_vector_q14_t r, sunglint_sphere_q14_t light) {
    static unsigned calls;
    sunglint_vector_q14_t nearest = sunglint_cap_q14(l, r, light);
    if (++calls == 1000)
        nearest.z ^= 1;
    return nearest;
}
