//! Selected, hidden and hovered objects.

use std::collections::BTreeSet;

/// Selected, hidden and hovered objects, by their indices in the scene.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Selection {
    selected: BTreeSet<usize>,
    hidden: BTreeSet<usize>,
    /// The object under the pointer.
    pub(crate) hovered: Option<usize>,
}

/// How a new selection combines with the present one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SelectMode {
    /// Replaces it.
    Replace,
    /// Extends it.
    Add,
    /// Toggles each object.
    Toggle,
}

impl Selection {
    /// Selects objects. [`SelectMode::Replace`] with no objects clears the selection.
    pub(crate) fn select(&mut self, objects: impl IntoIterator<Item = usize>, mode: SelectMode) {
        if mode == SelectMode::Replace {
            self.selected.clear();
        }
        for object in objects {
            let is_new = self.selected.insert(object);
            if mode == SelectMode::Toggle && !is_new {
                self.selected.remove(&object);
            }
        }
    }

    /// Hides the selected objects and deselects them.
    pub(crate) fn hide_selected(&mut self) {
        self.hidden.append(&mut self.selected);
        self.drop_hidden();
    }

    /// Hides all of the `count` objects but the selected ones; no effect without a selection.
    pub(crate) fn isolate(&mut self, count: usize) {
        if !self.selected.is_empty() {
            self.hidden = (0..count).filter(|object| !self.selected.contains(object)).collect();
            self.drop_hidden();
        }
    }

    /// Shows all objects.
    pub(crate) fn show_all(&mut self) {
        self.hidden.clear();
    }

    /// Toggles an object's visibility.
    pub(crate) fn toggle_shown(&mut self, object: usize) {
        if !self.hidden.remove(&object) {
            self.hidden.insert(object);
            self.drop_hidden();
        }
    }

    /// Hidden objects are neither selected nor hovered.
    fn drop_hidden(&mut self) {
        self.selected.retain(|object| !self.hidden.contains(object));
        self.hovered = self.hovered.filter(|object| !self.hidden.contains(object));
    }

    pub(crate) fn selected(&self) -> &BTreeSet<usize> {
        &self.selected
    }

    pub(crate) fn hidden(&self) -> &BTreeSet<usize> {
        &self.hidden
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn selecting(objects: &[usize]) -> Selection {
        let mut selection = Selection::default();
        selection.select(objects.iter().copied(), SelectMode::Replace);
        selection
    }

    fn list(set: &BTreeSet<usize>) -> Vec<usize> {
        set.iter().copied().collect()
    }

    #[test]
    fn a_click_on_nothing_selects_nothing_and_keys_keep_what_was() {
        let mut selection = selecting(&[1, 3]);
        selection.select([2, 3], SelectMode::Add);
        assert_eq!(list(selection.selected()), [1, 2, 3]);
        selection.select([3, 5], SelectMode::Toggle);
        assert_eq!(list(selection.selected()), [1, 2, 5]);
        selection.select(None, SelectMode::Add);
        assert_eq!(list(selection.selected()), [1, 2, 5]);
        selection.select(None, SelectMode::Replace);
        assert_eq!(selection, Selection::default());
    }

    #[test]
    fn what_is_hidden_is_not_selected_and_comes_back() {
        let mut selection = selecting(&[0, 2]);
        selection.hovered = Some(2);
        selection.hide_selected();
        assert_eq!((list(selection.hidden()), list(selection.selected())), (vec![0, 2], vec![]));
        assert_eq!(selection.hovered, None);
        selection.toggle_shown(0);
        selection.select([0, 1], SelectMode::Replace);
        selection.toggle_shown(1);
        assert_eq!((list(selection.hidden()), list(selection.selected())), (vec![1, 2], vec![0]));
        selection.show_all();
        assert_eq!((list(selection.hidden()), list(selection.selected())), (vec![], vec![0]));
    }

    #[test]
    fn isolating_hides_all_others_and_nothing_where_nothing_is_selected() {
        let mut selection = selecting(&[1, 2]);
        selection.toggle_shown(0);
        selection.isolate(5);
        assert_eq!(
            (list(selection.hidden()), list(selection.selected())),
            (vec![0, 3, 4], vec![1, 2])
        );
        let mut none = Selection::default();
        none.isolate(5);
        assert_eq!(none, Selection::default());
    }
}
