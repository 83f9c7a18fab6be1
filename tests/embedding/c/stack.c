/* Prints the bytes of stack, below its caller's, that sunglint_cap_q14 takes at most. */
#include "board.h"
#include "inputs.h"

#define WORDS 512
#define PAINT 0x5ac3c35au

static const sunglint_sphere_q14_t sun = SUNGLINT_SUN_Q14;

static void print_number(uint32_t number) {
    char text[12];
    char *at = text + sizeof text;
    *--at = '\0';
    *--at = '\n';
    do {
        *--at = (char)('0' + number % 10);
        number /= 10;
    } while (number != 0);
    print(at);
}

int main(void) {
    struct source source = source_new();
    volatile int16_t nearest;
    volatile uint32_t *top;
    __asm__ volatile("mov %0, sp" : "=r"(top));
    for (uint32_t i = 1; i <= WORDS; ++i)
        *(top - i) = PAINT;
    for (uint32_t i = 0; i < CASES; ++i) {
        sunglint_vector_q14_t l = lanes_q14(&source);
        nearest = sunglint_cap_q14(l, lanes_q14(&source), sun).x;
    }
    (void)nearest;
    uint32_t deepest = WORDS;
    while (deepest > 0 && *(top - deepest) == PAINT)
        --deepest;
    print_number(4 * deepest);
    return 0;
}
