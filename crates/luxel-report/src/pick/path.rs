//! Names of picked objects.

use luxel_pick::PickView;

/// The path of an object, by its index in the scene; empty if there is no such object.
pub(super) fn path_of<'a>(view: &PickView<'a>, object: usize) -> Vec<&'a str> {
    let picker = view.picker();
    let object = picker.objects().get(object);
    object.map(|object| picker.scene().path(object.node)).unwrap_or_default()
}
