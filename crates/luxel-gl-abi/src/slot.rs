//! One address for each thread: the current context's.
//!
//! Programs call `glVertex` millions of times, and each call begins here. In a shared library Rust reaches variables of
//! threads through a function of the loader, around which arguments in registers have to be saved: that took 10 ns a
//! call where the whole of it may take 5. On x86-64 Linux with glibc the variable is therefore declared in assembly and
//! read at its fixed distance from the thread's block (the "initial exec" model), as graphics libraries do: two loads. The
//! loader keeps room for the variables of libraries that are loaded late; those of this one take 160 bytes of it.

#[cfg(all(target_arch = "x86_64", target_os = "linux", target_env = "gnu", not(miri)))]
mod variable {
    use std::arch::{asm, global_asm};

    global_asm!(
        ".pushsection .tbss.luxel_gl_current,\"awT\",@nobits",
        ".p2align 3",
        ".globl luxel_gl_current",
        ".hidden luxel_gl_current",
        ".type luxel_gl_current,@object",
        ".size luxel_gl_current,8",
        "luxel_gl_current:",
        ".zero 8",
        ".popsection",
    );

    /// The thread's address; null at first.
    #[inline(always)]
    pub(crate) fn get<T>() -> *mut T {
        let address: *mut T;
        // SAFETY: reads the thread's own variable, which is always there.
        unsafe {
            asm!(
                "mov {0}, qword ptr [rip + luxel_gl_current@GOTTPOFF]",
                "mov {0}, qword ptr fs:[{0}]",
                out(reg) address,
                options(pure, readonly, nostack, preserves_flags),
            );
        }
        address
    }

    /// Changes the thread's address.
    pub(crate) fn set<T>(address: *mut T) {
        // SAFETY: writes the thread's own variable, which is always there.
        unsafe {
            asm!(
                "mov {0}, qword ptr [rip + luxel_gl_current@GOTTPOFF]",
                "mov qword ptr fs:[{0}], {1}",
                out(reg) _,
                in(reg) address,
                options(nostack, preserves_flags),
            );
        }
    }
}

#[cfg(not(all(target_arch = "x86_64", target_os = "linux", target_env = "gnu", not(miri))))]
mod variable {
    use std::cell::Cell;
    use std::ffi::c_void;
    use std::ptr;

    thread_local! {
        static CURRENT: Cell<*mut c_void> = const { Cell::new(ptr::null_mut()) };
    }

    /// The thread's address; null at first.
    #[inline(always)]
    pub(crate) fn get<T>() -> *mut T {
        CURRENT.get().cast()
    }

    /// Changes the thread's address.
    pub(crate) fn set<T>(address: *mut T) {
        CURRENT.set(address.cast());
    }
}

pub(crate) use variable::{get, set};
