/* Prints a line for every group. */
#include <inttypes.h>
#include <stdio.h>

#include "hashes.h"

int main(void) {
    for (int i = 0; i < GROUPS; ++i)
        printf("%s 0x%08" PRIx32 "\n", groups[i].name, groups[i].hash());
    return 0;
}
