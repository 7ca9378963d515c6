//! Counts instructions. The program runs itself under callgrind, which counts single passes only.

use std::ffi::CString;
use std::path::Path;
use std::process::{Command, ExitStatus};

const TOGGLE_COLLECT: u64 = 0x4354_0002;
const DUMP_STATS_AT: u64 = 0x4354_0003;
const START_INSTRUMENTATION: u64 = 0x4354_0004;
const STOP_INSTRUMENTATION: u64 = 0x4354_0005;

/// Valgrind's client request: instructions without effect, which mean something to it.
#[cfg(target_arch = "x86_64")]
#[inline(never)]
fn request(code: u64, argument: u64) {
    let arguments = [code, argument, 0, 0, 0, 0];
    // SAFETY: it rotates by 128 bits in all and exchanges a register with itself. It changes only
    // rdx, which is declared.
    unsafe {
        std::arch::asm!(
            "rol rdi, 3", "rol rdi, 13", "rol rdi, 61", "rol rdi, 51", "xchg rbx, rbx",
            in("rax") arguments.as_ptr(),
            inout("rdx") 0u64 => _,
        );
    }
}

/// Other machines count nothing. The driver finds no counts and says so.
#[cfg(not(target_arch = "x86_64"))]
fn request(_: u64, _: u64) {}

/// Runs passes in instrumented code. The code around them runs at full speed.
pub fn instrumented(passes: impl FnOnce()) {
    request(START_INSTRUMENTATION, 0);
    passes();
    request(STOP_INSTRUMENTATION, 0);
}

/// Counts one pass under a label.
pub fn count(label: &str, pass: impl FnOnce()) {
    request(TOGGLE_COLLECT, 0);
    pass();
    request(TOGGLE_COLLECT, 0);
    let label = CString::new(label).expect("labels have no zero bytes");
    request(DUMP_STATS_AT, label.as_ptr() as u64);
}

/// Runs this program again under callgrind. Its dumps go to a file.
pub fn run(arguments: &[String], dumps: &Path) -> std::io::Result<ExitStatus> {
    let own = std::env::current_exe()?;
    Command::new("valgrind")
        .args(["--quiet", "--tool=callgrind", "--instr-atstart=no", "--collect-atstart=no", "--combine-dumps=yes"])
        .arg(format!("--callgrind-out-file={}", dumps.display()))
        .arg(own)
        .args(arguments)
        .status()
}

/// Labels with their instructions, in the order of the dumps.
pub fn read(dumps: &str) -> Vec<(String, u64)> {
    let (mut counts, mut label) = (Vec::<(String, u64)>::new(), None);
    for line in dumps.lines() {
        if let Some(trigger) = line.strip_prefix("desc: Trigger: ") {
            label = trigger.strip_prefix("Client Request: ").map(str::to_owned);
        } else if let Some(total) = line.strip_prefix("totals: ").or_else(|| line.strip_prefix("summary: "))
            && let (Some(label), Ok(n)) = (label.clone(), total.trim().parse())
        {
            counts.retain(|count| count.0 != label);
            counts.push((label, n));
        }
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::read;

    #[test]
    fn dumps_are_read_by_label() {
        let dumps = "desc: Trigger: Client Request: a|b\nevents: Ir\nsummary: 12\ntotals: 12\n\
                     desc: Trigger: Client Request: c\nsummary: 7\n\ndesc: Trigger: Program termination\ntotals: 99\n";
        let counts = read(dumps);
        assert_eq!(counts, [("a|b".to_owned(), 12), ("c".to_owned(), 7)]);
    }
}
