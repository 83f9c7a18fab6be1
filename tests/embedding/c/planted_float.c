/* Float arithmetic that a check has to find. */
#include "board.h"

static volatile float number;

int main(void) {
    number *= number;
    return 0;
}
