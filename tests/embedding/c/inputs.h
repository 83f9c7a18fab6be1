/* Inputs that any language makes alike, and a hash of what becomes of them: as in ../src/hashes.rs. */
#ifndef INPUTS_H
#define INPUTS_H

#include "sunglint.h"

#define CASES 4096u

struct source {
    uint32_t bits;
};

static inline struct source source_new(void) {
    struct source source = {0x5eed5eedu};
    return source;
}

static inline uint32_t bits(struct source *source) {
    source->bits ^= source->bits << 13;
    source->bits ^= source->bits >> 17;
    source->bits ^= source->bits << 5;
    return source->bits;
}

static inline int16_t lane_q14(struct source *source) {
    return (int16_t)(bits(source) >> 16);
}

static inline sunglint_vector_q14_t lanes_q14(struct source *source) {
    sunglint_vector_q14_t v;
    v.x = lane_q14(source);
    v.y = lane_q14(source);
    v.z = lane_q14(source);
    return v;
}

static inline sunglint_vector_q30_t lanes_q30(struct source *source) {
    sunglint_vector_q30_t v;
    v.x = (int32_t)bits(source);
    v.y = (int32_t)bits(source);
    v.z = (int32_t)bits(source);
    return v;
}

/* A number of any size. */
static inline uint32_t size(struct source *source) {
    uint32_t number = bits(source);
    return number >> (bits(source) & 31);
}

/* Such a number or its complement. */
static inline int32_t either_sign(struct source *source) {
    uint32_t number = size(source);
    return (int32_t)(number ^ (0u - (bits(source) & 1)));
}

/* The same in 64 bits. */
static inline uint64_t wide(struct source *source) {
    uint64_t number = (uint64_t)bits(source) << 32;
    number |= bits(source);
    return number >> (bits(source) & 63);
}

static inline int64_t wide_either_sign(struct source *source) {
    uint64_t number = wide(source);
    return (int64_t)(number ^ (UINT64_C(0) - (bits(source) & 1)));
}

/* Radius over distance in Q30. */
static inline int32_t ratio(struct source *source) {
    return (int32_t)(size(source) >> 2);
}

#define HASH_OF_NOTHING 0x811c9dc5u

/* The least byte first. */
static inline void add_bytes(uint32_t *hash, uint64_t number, int bytes) {
    for (; bytes > 0; --bytes, number >>= 8)
        *hash = (*hash ^ (uint32_t)(number & 255)) * 0x01000193u;
}

static inline void add_16(uint32_t *hash, int16_t number) {
    add_bytes(hash, (uint16_t)number, 2);
}

static inline void add_32(uint32_t *hash, uint32_t number) {
    add_bytes(hash, number, 4);
}

static inline void add_64(uint32_t *hash, uint64_t number) {
    add_bytes(hash, number, 8);
}

static inline void add_q14(uint32_t *hash, sunglint_vector_q14_t v) {
    add_16(hash, v.x);
    add_16(hash, v.y);
    add_16(hash, v.z);
}

static inline void add_q30(uint32_t *hash, sunglint_vector_q30_t v) {
    add_32(hash, (uint32_t)v.x);
    add_32(hash, (uint32_t)v.y);
    add_32(hash, (uint32_t)v.z);
}

#endif
