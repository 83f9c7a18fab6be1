/* Hashes of groups of functions, by name, in the order of ../src/hashes.rs. */
#ifndef HASHES_H
#define HASHES_H

#include <stdint.h>

#define GROUPS 9

struct group {
    const char *name;
    uint32_t (*hash)(void);
};

extern const struct group groups[GROUPS];

uint32_t directions_q14(void);
uint32_t directions_q30(void);
uint32_t lights(void);
uint32_t diffuse(void);
uint32_t sampling(void);
uint32_t radiometry(void);
uint32_t black_bodies(void);
uint32_t pixel(void);
uint32_t soft(void);

#endif
