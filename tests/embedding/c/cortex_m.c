#include "board.h"

#include <stdint.h>

/* Places from cortex_m.ld. */
extern uint32_t data_in_flash[], data_start[], data_end[], bss_start[], bss_end[], stack_top[];

void reset(void);

enum { WRITE0 = 0x04, EXIT = 0x18 };

#define APPLICATION_EXIT 0x20026u
#define RUN_TIME_ERROR 0x20023u

/* Semihosting: an operation in r0, its parameter in r1. */
static void ask_host(uint32_t operation, uintptr_t parameter) {
    register uint32_t r0 __asm__("r0") = operation;
    register uintptr_t r1 __asm__("r1") = parameter;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void print(const char *text) {
    ask_host(WRITE0, (uintptr_t)text);
}

static void end(uint32_t why) {
    for (;;)
        ask_host(EXIT, why);
}

static void fault(void) {
    print("fault\n");
    end(RUN_TIME_ERROR);
}

void reset(void) {
    uint32_t *from = data_in_flash;
    for (uint32_t *to = data_start; to < data_end; ++to)
        *to = *from++;
    for (uint32_t *to = bss_start; to < bss_end; ++to)
        *to = 0;
#ifdef __ARM_FP
    /* Coprocessors 10 and 11 are the FPU. */
    *(volatile uint32_t *)0xe000ed88u |= 0xfu << 20;
    __asm__ volatile("dsb\n\tisb");
#endif
    end(main() == 0 ? APPLICATION_EXIT : RUN_TIME_ERROR);
}

typedef void (*handler)(void);

struct vectors {
    uint32_t *stack;
    handler reset, nmi, hard_fault, memory_fault, bus_fault, usage_fault;
};

/* Nothing interrupts, so the table ends with the faults. */
__attribute__((section(".vectors"), used)) static const struct vectors vectors = {
    stack_top, reset, fault, fault, fault, fault, fault,
};
