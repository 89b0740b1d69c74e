//! Runs of vertices without repetitions: each vertex of a mesh that a display list gives triangle by triangle is lit once.

use super::vertices::Vertices;

/// Places of vertices that are remembered. A mesh names a vertex again soon: what comes late is a vertex of its own.
const REMEMBERED: usize = 1 << 16;

/// A `glBegin`, its vertices and attributes, and a `glEnd`.
#[derive(Clone, Debug)]
pub(crate) struct Welded {
    pub(crate) mode: u32,
    /// Each vertex once.
    pub(crate) vertices: Vertices,
    /// Numbers of vertices, in the order of the commands.
    pub(crate) elements: Vec<u32>,
}

/// The different vertices of a run of primitives, and by their numbers those of the run. `None` if they aren't half as
/// many, or if some have attributes that are known only when the list is called.
pub(crate) fn welded(mode: u32, run: &Vertices) -> Option<Welded> {
    if !run.is_known() {
        return None;
    }
    let count = run.len();
    let mut remembered = vec![u32::MAX; REMEMBERED];
    let mut elements: Vec<u32> = Vec::with_capacity(count);
    // Where each of the different ones stands in the run.
    let mut places: Vec<u32> = Vec::new();
    for vertex in 0..count {
        let slot = &mut remembered[slot_of(run.positions[vertex])];
        let known = places.get(*slot as usize);
        if !known.is_some_and(|&place| run.are_alike(place as usize, vertex)) {
            *slot = places.len() as u32;
            places.push(vertex as u32);
        }
        elements.push(*slot);
    }
    (2 * places.len() <= count).then(|| Welded { mode, vertices: run.gathered(&places), elements })
}

/// Where a position is remembered: its bits, multiplied by odd numbers (of xxHash) so that all of them count.
fn slot_of(position: [f32; 4]) -> usize {
    let [x, y, z, w] = position.map(|value| u64::from(value.to_bits()));
    let mixed = (x | y << 32).wrapping_mul(0x9e37_79b1_85eb_ca87)
        ^ (z | w << 32).wrapping_mul(0xc2b2_ae3d_27d4_eb4f);
    (mixed.wrapping_mul(0x9e37_79b1_85eb_ca87) >> 48) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enums as gl;
    use crate::state::current::Current;

    /// Vertices of a list, by numbers from 0 to 9 that say which of them are alike.
    fn run(numbers: &[u32]) -> Vertices {
        let mut run = Vertices::default();
        for &number in numbers {
            let value = number as f32;
            run.set_normal([0.0, value, 1.0]);
            run.set_color([value / 10.0, 0.5, 0.25, 1.0]);
            run.push([value, 1.0, -value, 1.0]);
        }
        run
    }

    #[test]
    fn welded_vertices_are_those_of_the_run_in_their_order() {
        let numbers: Vec<u32> = (0..900_u32).map(|at| at * at % 10).collect();
        let run = run(&numbers);
        let Welded { vertices: welded, elements, .. } = welded(gl::TRIANGLES, &run).unwrap();
        assert_eq!((welded.len(), elements.len()), (6, 900));
        let unwelded = welded.gathered(&elements);
        let current = Current::default();
        let (unwelded, run) = (unwelded.view(&current), run.view(&current));
        for vertex in 0..900 {
            assert_eq!(unwelded.positions[vertex], run.positions[vertex]);
            assert_eq!(unwelded.normal.of(vertex), run.normal.of(vertex));
            assert_eq!(unwelded.color.of(vertex), run.color.of(vertex));
        }
    }

    #[test]
    fn vertices_that_differ_in_any_attribute_or_in_a_sign_of_zero_stay_apart() {
        let mut run = Vertices::default();
        for _ in 0..4 {
            for (x, green, s) in
                [(0.0, 0.5, 0.0), (-0.0, 0.5, 0.0), (0.0, 0.75, 0.0), (0.0, 0.5, 2.0)]
            {
                run.set_color([0.0, green, 0.0, 1.0]);
                run.set_tex_coord(1, [s, 0.0, 0.0, 1.0]);
                run.push([x, 0.0, 0.0, 1.0]);
            }
        }
        // Two places, each of which remembers the last vertex alone.
        assert!(welded(gl::TRIANGLES, &run).is_none());
        let alike = self::run(&[1, 1, 2, 2, 1, 1]);
        assert_eq!(welded(gl::TRIANGLES, &alike).unwrap().elements, [0, 0, 1, 1, 0, 0]);
    }

    #[test]
    fn what_is_known_only_when_the_list_is_called_is_not_welded() {
        let mut run = Vertices::default();
        (0..9).for_each(|_| run.push([0.0; 4]));
        run.set_normal([1.0, 0.0, 0.0]);
        (0..9).for_each(|_| run.push([0.0; 4]));
        assert!(welded(gl::TRIANGLES, &run).is_none());
        let mut constant = Vertices::default();
        (0..9).for_each(|_| constant.push([0.0; 4]));
        let Welded { vertices: welded, elements, .. } = welded(gl::TRIANGLES, &constant).unwrap();
        assert_eq!((welded.len(), elements.len()), (1, 9));
        let current = Current { color: [0.5; 4], ..Current::default() };
        assert_eq!(welded.view(&current).color.of(0), [0.5; 4]);
    }
}
