//! Names of objects: a name without object has been generated and never bound.

use std::collections::BTreeMap;

/// So many names that nobody has, up to a limit of all names.
pub(crate) fn generate<T>(
    names: &mut BTreeMap<u32, Option<T>>,
    count: usize,
    limit: usize,
) -> Vec<u32> {
    let mut found = Vec::new();
    let mut next = names.last_key_value().map_or(1, |(last, _)| last.wrapping_add(1));
    while found.len() < count && names.len() < limit {
        if next != 0 && !names.contains_key(&next) {
            names.insert(next, None);
            found.push(next);
        }
        next = next.wrapping_add(1);
    }
    found
}

/// Makes an object of a name that is bound; whether there can be one more.
pub(crate) fn bind<T: Default>(
    names: &mut BTreeMap<u32, Option<T>>,
    name: u32,
    limit: usize,
) -> bool {
    if names.len() >= limit && !names.contains_key(&name) {
        return false;
    }
    names.entry(name).or_default().get_or_insert_default();
    true
}
