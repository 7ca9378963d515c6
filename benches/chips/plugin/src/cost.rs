//! The cost of each instruction of ARMv6-M on a Cortex-M0+, by the timings in its reference manual.
//!
//! Assumes a multiplier of one cycle, as in the RP2040 and most others, and memory without wait
//! states. A memory access takes two cycles. The model has no port with accesses of one cycle. It
//! has no stall by another bus master, by flash or by its cache.

/// The cost of an instruction.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Cost {
    /// The first of the two marks.
    Begin,
    /// The second.
    End,
    /// Always this many cycles.
    Plain(u32),
    /// A branch on a condition.
    Branch { not_taken: u32, more_if_taken: u32 },
}

use Cost::Plain;

const BEGIN: u16 = 0x46c9;
const END: u16 = 0x46d2;

/// The cost of the instruction at the start of these bytes.
///
/// The emulator may report two bytes too many. Two bytes before the end of a page (1 KB), it reads
/// the next two to see whether an instruction crosses that end. It counts them as part of the
/// instruction before. So the first two bytes decide the length, not the number of bytes.
pub fn of_bytes(bytes: &[u8]) -> Cost {
    let first = u16::from_le_bytes([bytes[0], bytes[1]]);
    // 11101, 11110 and 11111 start an instruction of four bytes.
    if first >= 0xe800 { of_long(first) } else { of(first) }
}

/// The cost of an instruction of two bytes.
fn of(code: u16) -> Cost {
    let listed = |bits: u16| (code & bits).count_ones();
    match code {
        BEGIN => Cost::Begin,
        END => Cost::End,
        // BX, BLX.
        _ if code & 0xff00 == 0x4700 => Plain(2),
        // ADD and MOV to the program counter.
        _ if code & 0xff87 == 0x4487 || code & 0xff87 == 0x4687 => Plain(2),
        // Loads of literals. Loads and stores with a register, with a number, and from the stack.
        _ if code & 0xf800 == 0x4800 || (0x5000..0xa000).contains(&code) => Plain(2),
        // PUSH. Its ninth bit is the link register.
        _ if code & 0xfe00 == 0xb400 => Plain(1 + listed(0x1ff)),
        // POP. With the program counter it is also a branch.
        _ if code & 0xff00 == 0xbc00 => Plain(1 + listed(0xff)),
        _ if code & 0xff00 == 0xbd00 => Plain(3 + listed(0x1ff)),
        // LDM, STM.
        _ if code & 0xf000 == 0xc000 => Plain(1 + listed(0xff)),
        // B on a condition. UDF and SVC share its first bits.
        _ if code & 0xf000 == 0xd000 && code & 0x0e00 != 0x0e00 => Cost::Branch { not_taken: 1, more_if_taken: 1 },
        // B.
        _ if code & 0xf800 == 0xe000 => Plain(2),
        // Everything else, including the product.
        _ => Plain(1),
    }
}

/// The cost of an instruction of four bytes, given its first half: BL, special registers and
/// barriers. All take three.
fn of_long(_: u16) -> Cost {
    Plain(3)
}

#[cfg(test)]
mod tests {
    use super::{Cost, of, of_bytes};

    /// An assembler made the encodings. The costs are from the manual's table.
    #[test]
    fn costs_are_those_of_the_manual() {
        let expected = [
            (0x1888, "adds r0, r1, r2", 1),
            (0x4348, "muls r0, r1", 1),
            (0xb2c0, "uxtb r0, r0", 1),
            (0xb082, "sub sp, #8", 1),
            (0xa801, "add r0, sp, #4", 1),
            (0x46c0, "nop", 1),
            (0x4801, "ldr r0, [pc, #4]", 2),
            (0x6808, "ldr r0, [r1]", 2),
            (0x5888, "ldr r0, [r1, r2]", 2),
            (0x7008, "strb r0, [r1]", 2),
            (0x8808, "ldrh r0, [r1]", 2),
            (0x9801, "ldr r0, [sp, #4]", 2),
            (0xb500, "push {lr}", 2),
            (0xb5f0, "push {r4-r7, lr}", 6),
            (0xbcf0, "pop {r4-r7}", 5),
            (0xbd00, "pop {pc}", 4),
            (0xbdf0, "pop {r4-r7, pc}", 8),
            (0xc903, "ldm r1!, {r0, r1}", 3),
            (0xc103, "stm r1!, {r0, r1}", 3),
            (0xe7fe, "b .", 2),
            (0x4770, "bx lr", 2),
            (0x4788, "blx r1", 2),
            (0x4687, "mov pc, r0", 2),
            (0x4497, "add pc, r2", 2),
            (0x4685, "mov sp, r0", 1),
        ];
        for (code, text, cycles) in expected {
            assert_eq!(of(code), Cost::Plain(cycles), "{text}");
        }
        assert_eq!(of(0xd0fe), Cost::Branch { not_taken: 1, more_if_taken: 1 }, "beq .");
        assert_eq!((of(0x46c9), of(0x46d2)), (Cost::Begin, Cost::End));
    }
    /// Two bytes of the next instruction, behind one of two bytes and one of four.
    #[test]
    fn bytes_of_the_next_instruction_do_not_count() {
        let subs_and_bne = [0x6d, 0x1e, 0xfd, 0xd1];
        assert_eq!(of_bytes(&subs_and_bne), Cost::Plain(1));
        let bl_and_push = [0xff, 0xf7, 0xfe, 0xff, 0xf0, 0xb5];
        assert_eq!(of_bytes(&bl_and_push), Cost::Plain(3));
        let (push, branch) = ([0xf0, 0xb5], [0xfe, 0xe7]);
        assert_eq!((of_bytes(&push), of_bytes(&branch)), (Cost::Plain(6), Cost::Plain(2)));
    }
}
