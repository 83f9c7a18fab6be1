#include "board.h"

#include <stdint.h>

void start(void);

enum { WRITE0 = 0x04, EXIT = 0x18 };

#define APPLICATION_EXIT 0x20026u
#define RUN_TIME_ERROR 0x20023u

/* The emulator has cleared the memory and put everything where riscv.ld says. */
__asm__(
    ".section .init\n"
    ".global entry\n"
    "entry:\n"
    "    la sp, stack_top\n"
    "    la t0, trap\n"
    "    csrw mtvec, t0\n"
    "    j start\n"
    ".balign 4\n"
    "trap:\n"
    "    j fault\n"
    ".text\n");

/* Semihosting: three instructions that the emulator knows a question by. */
static void ask_host(uint32_t operation, uintptr_t parameter) {
    register uint32_t a0 __asm__("a0") = operation;
    register uintptr_t a1 __asm__("a1") = parameter;
    __asm__ volatile(
        ".option push\n"
        ".option norvc\n"
        ".balign 16\n"
        "slli zero, zero, 0x1f\n"
        "ebreak\n"
        "srai zero, zero, 7\n"
        ".option pop\n"
        : "+r"(a0)
        : "r"(a1)
        : "memory");
}

void print(const char *text) {
    ask_host(WRITE0, (uintptr_t)text);
}

static void end(uint32_t why) {
    for (;;)
        ask_host(EXIT, why);
}

void fault(void);

void fault(void) {
    print("fault\n");
    end(RUN_TIME_ERROR);
}

void start(void) {
    end(main() == 0 ? APPLICATION_EXIT : RUN_TIME_ERROR);
}
