#!/bin/sh
# Runs a program on an emulated Cortex-M4. The program prints and exits by semihosting.
exec timeout 300 qemu-system-arm -M mps2-an386 -nographic -monitor none -serial none \
    -semihosting-config enable=on,target=native -kernel "$1"
