//! Occlusion queries (OpenGL 1.5, section 4.1.7).

use super::names;
use crate::limits::QUERY_NAMES;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// The samples that passed the depth test.
pub(crate) type SampleCount = Arc<AtomicU64>;

/// The queries of a context, and the one that counts.
#[derive(Debug, Default)]
pub(crate) struct Queries {
    names: BTreeMap<u32, Option<SampleCount>>,
    /// Its name.
    pub(crate) active: Option<u32>,
}

impl Queries {
    /// So many names that nobody has; fewer at the limit.
    pub(crate) fn generate(&mut self, count: usize) -> Vec<u32> {
        names::generate(&mut self.names, count, QUERY_NAMES)
    }

    /// Whether it has been begun once.
    pub(crate) fn has(&self, name: u32) -> bool {
        self.names.get(&name).is_some_and(Option::is_some)
    }

    /// Deletes a name, and ends the query if it counts.
    pub(crate) fn delete(&mut self, name: u32) {
        if self.active == Some(name) {
            self.active = None;
        }
        self.names.remove(&name);
    }

    /// Begins a query at 0; whether there can be one more.
    pub(crate) fn begin(&mut self, name: u32) -> bool {
        if !names::bind(&mut self.names, name, QUERY_NAMES) {
            return false;
        }
        // Draws of an earlier query of that name keep its counter.
        self.names.insert(name, Some(Arc::default()));
        self.active = Some(name);
        true
    }

    /// The counter that draws add to.
    pub(crate) fn counter(&self) -> Option<SampleCount> {
        self.names.get(&self.active?)?.clone()
    }

    /// What a query has counted in draws that have been carried out.
    pub(crate) fn count(&self, name: u32) -> Option<u64> {
        let counter = self.names.get(&name)?.as_ref()?;
        Some(counter.load(Ordering::Relaxed))
    }
}
