//! A plugin of QEMU that models the cycles of a Cortex-M0+ while a program for the Cortex-M0 runs.
//!
//! It reports every stretch between `mov r9, r9` and `mov r10, r10`. No compiler writes these two
//! instructions, which do nothing. The line is `instructions N cycles M`, without the second of the
//! two. It uses version 1 of the plugin interface.

mod cost;

use cost::Cost;
use std::cell::Cell;
use std::ffi::{CString, c_char, c_int, c_uint, c_void};

/// The version of the interface. The emulator checks it before it loads the plugin.
#[unsafe(no_mangle)]
#[allow(non_upper_case_globals, reason = "the emulator's name")]
pub static qemu_plugin_version: c_int = 1;

unsafe extern "C" {
    fn qemu_plugin_register_vcpu_tb_trans_cb(id: u64, call: extern "C" fn(u64, *mut c_void));
    fn qemu_plugin_tb_n_insns(block: *const c_void) -> usize;
    fn qemu_plugin_tb_get_insn(block: *const c_void, i: usize) -> *mut c_void;
    fn qemu_plugin_insn_data(instruction: *const c_void) -> *const u8;
    fn qemu_plugin_insn_size(instruction: *const c_void) -> usize;
    fn qemu_plugin_insn_vaddr(instruction: *const c_void) -> u64;
    fn qemu_plugin_register_vcpu_insn_exec_cb(
        instruction: *mut c_void,
        call: extern "C" fn(c_uint, *mut c_void),
        flags: c_int,
        data: *mut c_void,
    );
    fn qemu_plugin_outs(text: *const c_char);
}

/// Facts about an instruction before it runs.
struct Known {
    address: u32,
    cost: Cost,
}

/// The current stretch.
#[derive(Clone, Copy)]
struct Stretch {
    on: bool,
    instructions: u64,
    cycles: u64,
    /// The next address if the branch before was not taken, and its cost if it was.
    branch: Option<(u32, u32)>,
}

const NONE: Stretch = Stretch { on: false, instructions: 0, cycles: 0, branch: None };

thread_local! {
    // The emulated core runs on one thread.
    static STRETCH: Cell<Stretch> = const { Cell::new(NONE) };
}

extern "C" fn runs(_: c_uint, data: *mut c_void) {
    // SAFETY: `translated` gave the emulator this pointer with this callback. It is never freed.
    let known = unsafe { &*data.cast::<Known>() };
    let mut stretch = STRETCH.get();
    if !stretch.on {
        if matches!(known.cost, Cost::Begin) {
            STRETCH.set(Stretch { on: true, ..NONE });
        }
        return;
    }
    if let Some((through, taken)) = stretch.branch.take()
        && known.address != through
    {
        stretch.cycles += u64::from(taken);
    }
    match known.cost {
        Cost::Begin => stretch = Stretch { on: true, ..NONE },
        Cost::End => {
            tell(&format!("instructions {} cycles {}\n", stretch.instructions, stretch.cycles));
            stretch.on = false;
        }
        Cost::Plain(cycles) => {
            stretch.instructions += 1;
            stretch.cycles += u64::from(cycles);
        }
        Cost::Branch { not_taken, more_if_taken } => {
            stretch.instructions += 1;
            stretch.cycles += u64::from(not_taken);
            // All branches on a condition are two bytes long.
            stretch.branch = Some((known.address + 2, more_if_taken));
        }
    }
    STRETCH.set(stretch);
}

fn tell(text: &str) {
    if let Ok(text) = CString::new(text) {
        // SAFETY: a string that ends in 0. The emulator copies it.
        unsafe { qemu_plugin_outs(text.as_ptr()) }
    }
}

extern "C" fn translated(_: u64, block: *mut c_void) {
    // SAFETY: the emulator's own objects, used only while it lends them. An instruction has at
    // least two bytes.
    unsafe {
        for i in 0..qemu_plugin_tb_n_insns(block) {
            let instruction = qemu_plugin_tb_get_insn(block, i);
            let bytes =
                std::slice::from_raw_parts(qemu_plugin_insn_data(instruction), qemu_plugin_insn_size(instruction));
            let known = Known { address: qemu_plugin_insn_vaddr(instruction) as u32, cost: cost::of_bytes(bytes) };
            // One program has too few of them to need freeing.
            let data = Box::into_raw(Box::new(known)).cast();
            qemu_plugin_register_vcpu_insn_exec_cb(instruction, runs, 0, data);
        }
    }
}

/// The emulator calls this when it loads the plugin.
///
/// # Safety
/// Only the emulator may call it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn qemu_plugin_install(id: u64, _: *const c_void, _: c_int, _: *const *const c_char) -> c_int {
    // SAFETY: the emulator gave this id for this call.
    unsafe { qemu_plugin_register_vcpu_tb_trans_cb(id, translated) };
    0
}
