/* Prints a line for every group. */
#include "board.h"
#include "hashes.h"

static void print_hash(uint32_t hash) {
    static char text[] = " 0x00000000\n";
    for (int digit = 0; digit < 8; ++digit)
        text[3 + digit] = "0123456789abcdef"[hash >> (28 - 4 * digit) & 15];
    print(text);
}

int main(void) {
    for (int i = 0; i < GROUPS; ++i) {
        print(groups[i].name);
        print_hash(groups[i].hash());
    }
    return 0;
}
