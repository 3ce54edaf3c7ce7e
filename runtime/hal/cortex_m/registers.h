/* registers.h -- the registers that this port uses. */
#ifndef FROB_HAL_CORTEX_M_REGISTERS_H
#define FROB_HAL_CORTEX_M_REGISTERS_H

#include <stdint.h>

/* SysTick, the processor's timer, which counts down. */
struct systick {
    /* Bit 0 enables the timer, bit 1 its interrupt, bit 2 selects the processor's clock; bit 16
     * is set when the timer has wrapped around. */
    volatile uint32_t control;
    volatile uint32_t reload;
    volatile uint32_t value;
};
#define SYSTICK ((struct systick *)0xE000E010u)

/* Enables interrupts 0 to 31, one bit for each. */
#define NVIC_ENABLE (*(volatile uint32_t *)0xE000E100u)

/* Pending system exceptions; bit 26 is the timer's. */
#define ICSR (*(volatile uint32_t *)0xE000ED04u)
#define ICSR_SYSTICK_PENDING (1u << 26)

/* Access to the coprocessors; bits 20 to 23 are for the floating-point unit. */
#define CPACR (*(volatile uint32_t *)0xE000ED88u)

struct uart {
    volatile uint32_t data;
    volatile uint32_t state;     /* 1 transmitter full, 2 receiver full */
    volatile uint32_t control;   /* 1 transmit, 2 receive, 8 interrupt on receive */
    volatile uint32_t interrupt; /* write 2 to clear the receive interrupt */
    volatile uint32_t divider;   /* clock frequency / bit rate, at least 16 */
};
#define UART_0 ((struct uart *)0x40004000u)
#define UART_1 ((struct uart *)0x40005000u)
#define UART_0_RECEIVE_INTERRUPT 0u

#endif
