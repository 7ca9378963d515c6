//! Converts the linker's file to a cartridge.

const BASE: usize = 0x0800_0000;
const LARGEST: usize = 32 << 20;
/// The bytes that the header's checksum covers, and the checksum's position.
const CHECKED: std::ops::Range<usize> = 0xa0..CHECKSUM;
const CHECKSUM: usize = 0xbd;
const LOAD: u32 = 1;

/// The loaded parts of a 32-bit little-endian ELF file, laid out as in the cartridge, with the
/// header's checksum.
pub fn from_elf(elf: &[u8]) -> Result<Vec<u8>, &'static str> {
    const CUT: &str = "the program's file is too short";
    if !elf.starts_with(b"\x7fELF\x01\x01") {
        return Err("the program is not a 32-bit ELF file");
    }
    let word = |at: usize| Some(u32::from_le_bytes(elf.get(at..at + 4)?.try_into().ok()?) as usize);
    let half = |at: usize| Some(usize::from(u16::from_le_bytes(elf.get(at..at + 2)?.try_into().ok()?)));
    let (first, size, count) = (word(28).ok_or(CUT)?, half(42).ok_or(CUT)?, half(44).ok_or(CUT)?);
    let mut rom = Vec::new();
    for at in (0..count).map(|i| first + i * size) {
        let field = |n: usize| word(at + 4 * n).ok_or(CUT);
        // Type, offset in the file, address at run time, address in the cartridge, bytes in the
        // file.
        let (kind, offset, address, length) = (field(0)?, field(1)?, field(3)?, field(4)?);
        if kind != LOAD as usize || length == 0 {
            continue;
        }
        let start = address.checked_sub(BASE).filter(|start| start + length <= LARGEST);
        let start = start.ok_or("a part of the program is outside the cartridge")?;
        let bytes = elf.get(offset..offset + length).ok_or(CUT)?;
        rom.resize(rom.len().max(start + length), 0);
        rom[start..start + length].copy_from_slice(bytes);
    }
    let header = rom.get(CHECKED).ok_or("the program has no cartridge header")?;
    let sum = header.iter().fold(0x19u8, |sum, byte| sum.wrapping_add(*byte));
    rom[CHECKSUM] = sum.wrapping_neg();
    Ok(rom)
}
