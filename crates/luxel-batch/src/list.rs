//! The list of tasks: lines of a file.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Cursor, Read};
use std::path::{Path, PathBuf};

/// Where the tasks are.
#[derive(Clone, Debug)]
pub enum List {
    /// A file.
    File(PathBuf),
    /// Its bytes, as read from the standard input.
    Bytes(Vec<u8>),
}

/// The longest line in bytes.
const LONGEST: u64 = 64 << 20;

impl List {
    /// What places in it are called by.
    pub(crate) fn name(&self) -> String {
        match self {
            Self::File(path) => path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
            Self::Bytes(_) => "-".to_owned(),
        }
    }

    /// The folder that models are relative to.
    #[must_use]
    pub fn folder(&self) -> PathBuf {
        match self {
            Self::File(path) => match path.parent() {
                Some(folder) if !folder.as_os_str().is_empty() => folder.to_owned(),
                _ => PathBuf::from("."),
            },
            Self::Bytes(_) => PathBuf::from("."),
        }
    }

    /// The lines.
    ///
    /// # Errors
    /// The file can't be opened.
    pub(crate) fn lines(&self) -> io::Result<Lines<'_>> {
        let input: Box<dyn BufRead + Send + '_> = match self {
            Self::File(path) => Box::new(BufReader::new(open(path)?)),
            Self::Bytes(bytes) => Box::new(Cursor::new(bytes)),
        };
        Ok(Lines { input, number: 0 })
    }
}

fn open(path: &Path) -> io::Result<File> {
    let file = File::open(path)?;
    if file.metadata()?.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "this is a folder"));
    }
    Ok(file)
}

/// The lines of a list that aren't blank.
pub(crate) struct Lines<'l> {
    input: Box<dyn BufRead + Send + 'l>,
    number: u64,
}

/// A line: its number, from 1, and its text, or what is wrong with it.
pub(crate) type Line = (u64, Result<String, String>);

impl Iterator for Lines<'_> {
    type Item = io::Result<Line>;

    fn next(&mut self) -> Option<io::Result<Line>> {
        loop {
            let mut bytes = Vec::new();
            let read = (&mut self.input).take(LONGEST + 1).read_until(b'\n', &mut bytes);
            match read {
                Ok(0) => return None,
                Ok(_) => self.number += 1,
                Err(error) => return Some(Err(error)),
            }
            if bytes.len() as u64 > LONGEST {
                if !bytes.ends_with(b"\n")
                    && let Err(error) = self.skip_line()
                {
                    return Some(Err(error));
                }
                return Some(Ok((self.number, Err(format!("longer than {LONGEST} bytes")))));
            }
            let text = bytes.strip_prefix(b"\xef\xbb\xbf").filter(|_| self.number == 1);
            let text = text.unwrap_or(&bytes).trim_ascii();
            if !text.is_empty() {
                let text = std::str::from_utf8(text).map(str::to_owned);
                let text =
                    text.map_err(|error| format!("not UTF-8 from byte {}", error.valid_up_to()));
                return Some(Ok((self.number, text)));
            }
        }
    }
}

impl Lines<'_> {
    fn skip_line(&mut self) -> io::Result<()> {
        loop {
            let block = self.input.fill_buf()?;
            if block.is_empty() {
                return Ok(());
            }
            let end = block.iter().position(|&byte| byte == b'\n');
            let used = end.map_or(block.len(), |end| end + 1);
            self.input.consume(used);
            if end.is_some() {
                return Ok(());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blank_lines_are_counted_and_skipped_and_bad_bytes_have_their_place() {
        let list = List::Bytes(b"\xef\xbb\xbf{}\r\n\n  \na\xffb\n{\"last\": 1}".to_vec());
        let lines: Vec<Line> = list.lines().unwrap().map(Result::unwrap).collect();
        assert_eq!(lines[0], (1, Ok("{}".to_owned())));
        assert_eq!(lines[1], (4, Err("not UTF-8 from byte 1".to_owned())));
        assert_eq!(lines[2], (5, Ok("{\"last\": 1}".to_owned())));
        assert_eq!(lines.len(), 3);
    }
}
