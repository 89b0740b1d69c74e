//! What the machine can do at most: bytes from and to memory, and arithmetic in registers.

use luxel_math::{Simd, SimdLevel, dispatch, f32x16, prelude::*};
use rayon::prelude::*;
use std::hint::black_box;
use std::time::Instant;

/// Floats in each thread's part of memory: 256 MB, more than caches hold.
const FLOATS: usize = 64 << 20;
const ROUNDS: usize = 5;
/// Steps of arithmetic in a round, and values of sixteen lanes that do not wait for one another.
const STEPS: u32 = 10_000_000;
const CHAINS: usize = 5;

/// The least time of some rounds, in seconds.
fn least(mut work: impl FnMut()) -> f64 {
    let times = (0..ROUNDS).map(|_| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    });
    times.fold(f64::INFINITY, f64::min)
}

#[inline(always)]
fn sum<S: Simd>(simd: S, floats: &[f32]) -> f32 {
    let mut sums = [f32x16::splat(simd, 0.0); 4];
    for chunk in floats.chunks_exact(64) {
        for (sum, part) in sums.iter_mut().zip(chunk.chunks_exact(16)) {
            *sum += f32x16::from_slice(simd, part);
        }
    }
    let sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
    (0..16).map(|lane| sum[lane]).sum()
}

/// A product and a sum for each chain and step.
#[inline(always)]
fn multiply_and_add<S: Simd>(simd: S, by: f32, more: f32) -> f32 {
    let (by, more) = (f32x16::splat(simd, by), f32x16::splat(simd, more));
    let mut chains: [f32x16<S>; CHAINS] =
        std::array::from_fn(|chain| f32x16::splat(simd, chain as f32));
    for _ in 0..STEPS {
        for chain in &mut chains {
            *chain = *chain * by + more;
        }
    }
    let sum = chains.into_iter().fold(more, |sum, chain| sum + chain);
    (0..16).map(|lane| sum[lane]).sum()
}

/// Prints it.
pub fn told() {
    let Ok(level) = SimdLevel::Auto.resolve() else { return };
    println!("the machine, at {}:", SimdLevel::name_of(level));
    for threads in [1, std::thread::available_parallelism().map_or(1, usize::from)] {
        let Ok(pool) = rayon::ThreadPoolBuilder::new().num_threads(threads).build() else { return };
        pool.install(|| {
            let mut memory: Vec<Vec<f32>> =
                (0..threads).map(|_| vec![1.0; FLOATS / threads]).collect();
            let bytes = (threads * (FLOATS / threads) * 4) as f64;
            let read = least(|| {
                let sums =
                    memory.par_iter().map(|floats| dispatch!(level, simd => sum(simd, floats)));
                black_box(sums.sum::<f32>());
            });
            let mut value = 0.0;
            let write = least(|| {
                value += 1.0;
                memory.par_iter_mut().for_each(|floats| black_box(floats).fill(value));
            });
            let count = f64::from(STEPS) * (CHAINS * 16 * 2 * threads) as f64;
            let arithmetic = least(|| {
                let all = (0..threads).into_par_iter().map(|_| {
                    let (by, more) = black_box((0.999, 0.001));
                    dispatch!(level, simd => multiply_and_add(simd, by, more))
                });
                black_box(all.sum::<f32>());
            });
            println!(
                "{threads} threads: reads {:.1} GB/s, writes {:.1} GB/s, {:.0} G f32 operations/s",
                bytes / read * 1e-9,
                bytes / write * 1e-9,
                count / arithmetic * 1e-9
            );
        });
    }
}
