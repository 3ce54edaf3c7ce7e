/* The table of exceptions that a Cortex-M starts from. Whatever else occurs
 * ends the program by semihosting: qemu's exit status is then not 0. */
extern void _start(void);
extern char __stack;

static void fault(void)
{
    for (;;) {
        /* SYS_EXIT, for a reason that is not ADP_Stopped_ApplicationExit */
        __asm__ volatile("mov r0, #0x18\n mov r1, #0\n bkpt 0xab" ::: "r0", "r1", "memory");
    }
}

/* The unit for floats is off until CPACR says otherwise. */
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
