#!/usr/bin/env bash
# Cargo's runner for bare metal. qemu.sh TARGET ELF [WORD...] runs the program on the emulated board
# of that target, with the words as its command line. Exits with the program's status, with 3
# without an emulator, or with 124 after a time-out. QEMU_OPTIONS adds options for the emulator.
set -euo pipefail

target=$1 elf=$2
semihosting=enable=on,target=native
for word in "$(basename "$elf")" "${@:3}"; do
    semihosting+=,arg=$word
done
# One instruction takes 2^8 ns of virtual time (on RISC-V 1 ns). So runs repeat exactly, and the
# counting firmware reads instructions from a timer.
arch=arm shift=8
case $target in
# More memory than the real one has: what a program may use is said by memory.x.
thumbv6m-*) board=(microbit -global nrf51-soc.sram-size=65536 -global nrf51-soc.flash-size=524288) ;;
thumbv7m-*) board=(mps2-an385) ;;
thumbv7em-*) board=(mps2-an386) ;;
# The boards with a Cortex-M33 have their flash at another address. This board takes any core.
thumbv8m.main-*) board=(lm3s6965evb -cpu cortex-m33) ;;
riscv32*) board=(virt -bios none) arch=riscv32 shift=0 ;;
*)
    echo "qemu.sh: no board is known for $target" >&2
    exit 2
    ;;
esac

qemu=$("$(dirname "${BASH_SOURCE[0]}")/get-emulators.sh" "$arch") || exit 3

# Without "-monitor none -serial none" the emulator would read the terminal.
exec timeout "${QEMU_SECONDS:-120}" "$qemu" -machine "${board[@]}" -icount "shift=$shift" \
    -nographic -monitor none -serial none -semihosting-config "$semihosting" ${QEMU_OPTIONS:-} -kernel "$elf" </dev/null
