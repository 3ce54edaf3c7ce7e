/* The vector table from which a Cortex-M starts. All other exceptions end the program by
 * semihosting with a nonzero exit status of qemu. */
extern void _start(void);
extern char __stack;

static void fault(void)
{
    for (;;) {
        /* SYS_EXIT, with a reason other than ADP_Stopped_ApplicationExit */
        __asm__ volatile("mov r0, #0x18\n mov r1, #0\n bkpt 0xab" ::: "r0", "r1", "memory");
    }
}

/* Enable the floating-point unit in CPACR; it is off after a reset. */
static void start(void)
{
    *(volatile unsigned *)0xE000ED88u |= 0xFu << 20;
    __asm__ volatile("dsb\n isb" ::: "memory");
    _start();
}

__attribute__((section(".vectors"), used)) static const struct {
    char *stack;
    void (*handlers[15])(void);
} vectors = {
    &__stack,
    { start, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
      fault, fault },
};
