/* A chip in QEMU, cortex_m.c or riscv.c: start, text to the host, end. */
#ifndef BOARD_H
#define BOARD_H

/* What the board calls once memory is as C has it; the emulator ends when it returns. */
int main(void);

void print(const char *text);

#endif
