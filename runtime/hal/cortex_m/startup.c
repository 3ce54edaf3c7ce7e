/* Startup code: the vector table, and a reset handler that initializes memory and the
 * floating-point unit and calls main. */
#include "hal/cortex_m/board.h"
#include "hal/cortex_m/registers.h"

/* Defined in the linker script. */
extern uint32_t board_data_from[], board_data_start[], board_data_end[];
extern uint32_t board_bss_start[], board_bss_end[];
extern uint32_t board_stack_low[], board_stack_high[];

extern int main(void);

/* Value that fills the unused part of the stack. */
#define UNUSED 0xA5A5A5A5u

size_t board_stack_size(void)
{
    return (size_t)(board_stack_high - board_stack_low) * sizeof(uint32_t);
}

size_t board_stack_used(void)
{
    const uint32_t *at = board_stack_low;
    while (at < board_stack_high && *at == UNUSED)
        at++;
    return (size_t)(board_stack_high - at) * sizeof(uint32_t);
}

static void reset(void)
{
    const uint32_t *from = board_data_from;
    uint32_t *here;
    CPACR |= 0xFu << 20;
    __asm__ volatile("dsb\n isb" ::: "memory");
    for (uint32_t *to = board_data_start; to < board_data_end; to++)
        *to = *from++;
    for (uint32_t *to = board_bss_start; to < board_bss_end; to++)
        *to = 0;
    /* Fill the stack below the part that this function itself uses. */
    __asm__ volatile("mov %0, sp" : "=r"(here));
    for (uint32_t *to = board_stack_low; to < here - 16; to++)
        *to = UNUSED;
    main();
    board_on_fault();
}

static void unexpected(void)
{
    board_on_fault();
}

__attribute__((section(".vectors"), used)) static const struct {
    uint32_t *stack;
    void (*system[15])(void);
    void (*devices[32])(void);
} vectors = {
    board_stack_high,
    /* reset, NMI, hard fault, memory, bus, usage, -, -, -, -, SVC, debug, -, PendSV, SysTick */
    { reset, unexpected, unexpected, unexpected, unexpected, unexpected, unexpected, unexpected,
      unexpected, unexpected, unexpected, unexpected, unexpected, unexpected, board_on_tick },
    { board_on_receive, unexpected, unexpected, unexpected, unexpected, unexpected, unexpected,
      unexpected,       unexpected, unexpected, unexpected, unexpected, unexpected, unexpected,
      unexpected,       unexpected, unexpected, unexpected, unexpected, unexpected, unexpected,
      unexpected,       unexpected, unexpected, unexpected, unexpected, unexpected, unexpected,
      unexpected,       unexpected, unexpected, unexpected },
};
