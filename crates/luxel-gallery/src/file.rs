//! Files of the gallery.

/// A file of the gallery.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Its name, without folders.
    pub name: String,
    /// The content.
    pub bytes: Vec<u8>,
}

/// The image that a command line draws into a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reproduced {
    /// The file of the gallery.
    pub file: String,
    /// The words of the command, the program's name first.
    pub command: Vec<String>,
}
