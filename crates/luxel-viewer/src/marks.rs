//! Which objects of the scene are selected, hidden, under the pointer: without a window.

use std::collections::BTreeSet;

/// What is told apart of the objects, by their numbers in the whole scene.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Marks {
    selected: BTreeSet<usize>,
    hidden: BTreeSet<usize>,
    /// The object under the pointer.
    pub(crate) hovered: Option<usize>,
}

/// What becomes of the objects that were selected before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Choice {
    /// They are no more.
    Replace,
    /// They stay.
    Add,
    /// They stay, but those chosen again.
    Toggle,
}

impl Marks {
    /// Selects objects; none are, with [`Choice::Replace`], if there are none.
    pub(crate) fn select(&mut self, objects: impl IntoIterator<Item = usize>, choice: Choice) {
        if choice == Choice::Replace {
            self.selected.clear();
        }
        for object in objects {
            let is_new = self.selected.insert(object);
            if choice == Choice::Toggle && !is_new {
                self.selected.remove(&object);
            }
        }
    }

    /// The selected objects are not drawn any more, nor selected.
    pub(crate) fn hide_selected(&mut self) {
        self.hidden.append(&mut self.selected);
        self.forget_hidden();
    }

    /// Of so many objects, only those that are selected are drawn; nothing changes, if none is.
    pub(crate) fn isolate(&mut self, count: usize) {
        if !self.selected.is_empty() {
            self.hidden = (0..count).filter(|object| !self.selected.contains(object)).collect();
            self.forget_hidden();
        }
    }

    /// Everything is drawn.
    pub(crate) fn show_all(&mut self) {
        self.hidden.clear();
    }

    /// Hides one object, or shows it again.
    pub(crate) fn toggle_shown(&mut self, object: usize) {
        if !self.hidden.remove(&object) {
            self.hidden.insert(object);
            self.forget_hidden();
        }
    }

    /// What is hidden is neither selected nor pointed at.
    fn forget_hidden(&mut self) {
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

    fn selecting(objects: &[usize]) -> Marks {
        let mut marks = Marks::default();
        marks.select(objects.iter().copied(), Choice::Replace);
        marks
    }

    fn list(set: &BTreeSet<usize>) -> Vec<usize> {
        set.iter().copied().collect()
    }

    #[test]
    fn a_click_on_nothing_selects_nothing_and_keys_keep_what_was() {
        let mut marks = selecting(&[1, 3]);
        marks.select([2, 3], Choice::Add);
        assert_eq!(list(marks.selected()), [1, 2, 3]);
        marks.select([3, 5], Choice::Toggle);
        assert_eq!(list(marks.selected()), [1, 2, 5]);
        marks.select(None, Choice::Add);
        assert_eq!(list(marks.selected()), [1, 2, 5]);
        marks.select(None, Choice::Replace);
        assert_eq!(marks, Marks::default());
    }

    #[test]
    fn what_is_hidden_is_not_selected_and_comes_back() {
        let mut marks = selecting(&[0, 2]);
        marks.hovered = Some(2);
        marks.hide_selected();
        assert_eq!((list(marks.hidden()), list(marks.selected())), (vec![0, 2], vec![]));
        assert_eq!(marks.hovered, None);
        marks.toggle_shown(0);
        marks.select([0, 1], Choice::Replace);
        marks.toggle_shown(1);
        assert_eq!((list(marks.hidden()), list(marks.selected())), (vec![1, 2], vec![0]));
        marks.show_all();
        assert_eq!((list(marks.hidden()), list(marks.selected())), (vec![], vec![0]));
    }

    #[test]
    fn isolating_hides_all_others_and_nothing_where_nothing_is_selected() {
        let mut marks = selecting(&[1, 2]);
        marks.toggle_shown(0);
        marks.isolate(5);
        assert_eq!((list(marks.hidden()), list(marks.selected())), (vec![0, 3, 4], vec![1, 2]));
        let mut none = Marks::default();
        none.isolate(5);
        assert_eq!(none, Marks::default());
    }
}
