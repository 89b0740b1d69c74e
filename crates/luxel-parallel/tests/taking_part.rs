//! A program whose thread takes part in the work, which holds for the whole process.

use luxel_parallel::{fill, install, pool, take_part, threads};
use std::thread;

#[test]
fn the_thread_that_takes_part_does_its_work_itself_and_needs_no_pool_of_as_many() {
    take_part(2);
    assert_eq!(threads(), 2);
    let own = thread::current().id();
    assert_eq!(install(None, || thread::current().id()), own);

    assert!(pool(2).is_none());
    let other = pool(3).unwrap();
    assert_ne!(install(Some(&other), || thread::current().id()), own);

    assert!(thread::spawn(|| pool(2)).join().unwrap().is_some());

    let mut squares = vec![0; 1 << 16];
    fill(&mut squares, 1 << 8, &|start, run| {
        for (number, square) in (start..).zip(run) {
            *square = number * number;
        }
    });
    assert!(squares.iter().enumerate().all(|(number, &square)| square == number * number));
}
