//! The stencil test (OpenGL 1.5, section 4.1.5), lane by lane: values are integers of 8 bits.

use super::pipeline::StencilTest;
use crate::enums as gl;
use luxel_math::{LANES, lanes_of};

impl StencilTest {
    /// The lanes that pass.
    pub(super) fn passing(&self, lanes: u32, stored: &[u32; LANES]) -> u32 {
        let reference = self.reference & self.value_mask;
        let mut passing = 0;
        for lane in lanes_of(lanes) {
            let value = stored[lane] & self.value_mask;
            let passes = match self.func {
                gl::NEVER => false,
                gl::LESS => reference < value,
                gl::LEQUAL => reference <= value,
                gl::EQUAL => reference == value,
                gl::GREATER => reference > value,
                gl::GEQUAL => reference >= value,
                gl::NOTEQUAL => reference != value,
                _ => true,
            };
            passing |= u32::from(passes) << lane;
        }
        passing
    }

    /// Changes the values of lanes: those that failed, those whose depth failed, those that passed.
    pub(super) fn update(&self, lanes: [u32; 3], stored: &mut [u32; LANES]) {
        for (lanes, operation) in lanes.into_iter().zip(self.operations) {
            if operation == gl::KEEP {
                continue;
            }
            for lane in lanes_of(lanes) {
                let before = stored[lane];
                let after = match operation {
                    gl::ZERO => 0,
                    gl::REPLACE => self.reference,
                    gl::INCR => (before + 1).min(255),
                    gl::DECR => before.saturating_sub(1),
                    gl::INVERT => !before,
                    gl::INCR_WRAP => before + 1,
                    gl::DECR_WRAP => before.wrapping_sub(1),
                    _ => before,
                };
                stored[lane] = before & !self.write_mask | after & self.write_mask;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn test(func: u32, operations: [u32; 3]) -> StencilTest {
        StencilTest { func, reference: 0x15, value_mask: 0x0f, write_mask: 0xff, operations }
    }

    #[test]
    fn section_4_1_5_the_masked_reference_is_compared_with_the_masked_value() {
        let stored = std::array::from_fn(|lane| lane as u32 | 0x40);
        let passing = |func| test(func, [gl::KEEP; 3]).passing(0xffff, &stored);
        assert_eq!(passing(gl::EQUAL), 1 << 5);
        assert_eq!(passing(gl::LESS), 0xffc0);
        assert_eq!(passing(gl::GEQUAL), 0x3f);
        assert_eq!((passing(gl::NEVER), passing(gl::ALWAYS)), (0, 0xffff));
    }

    #[test]
    fn section_4_1_5_operations_saturate_or_wrap_within_the_mask() {
        let after = |operation, before, write_mask| {
            let mut stored = [before; LANES];
            let of = StencilTest { write_mask, ..test(gl::ALWAYS, [operation; 3]) };
            of.update([1, 0, 0], &mut stored);
            assert_eq!(stored[1], before);
            stored[0]
        };
        assert_eq!([after(gl::INCR, 255, 255), after(gl::DECR, 0, 255)], [255, 0]);
        assert_eq!([after(gl::INCR_WRAP, 255, 255), after(gl::DECR_WRAP, 0, 255)], [0, 255]);
        assert_eq!([after(gl::REPLACE, 0, 0xf0), after(gl::INVERT, 0x0f, 255)], [0x10, 0xf0]);
    }
}
