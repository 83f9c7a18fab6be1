#include "hashes.h"

const struct group groups[GROUPS] = {
    {"directions_q14", directions_q14},
    {"directions_q30", directions_q30},
    {"lights", lights},
    {"diffuse", diffuse},
    {"sampling", sampling},
    {"radiometry", radiometry},
    {"black_bodies", black_bodies},
    {"pixel", pixel},
    {"soft", soft},
};
