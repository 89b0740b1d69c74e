//! Where in a JSON text a parser has stopped, as a pointer.
//!
//! Errors of values carry the line and column of the last byte that was read. Finding the value by them,
//! once a text has failed, costs sound texts nothing; keeping the path of every value while it is read made
//! the reader a third larger.

/// The pointer (RFC 6901) of the value that ends with a byte, or else begins behind it: the byte by its line
/// and its column, from 1. The text up to there must be sound JSON.
pub(crate) fn pointer_at(json: &[u8], line: usize, column: usize) -> String {
    let before: usize =
        json.split(|&byte| byte == b'\n').take(line - 1).map(|of| of.len() + 1).sum();
    Walk { json, at: 0, open: Vec::new() }.to(before + column)
}

/// An array or object around the place.
enum Open {
    /// How many elements came before.
    Array(usize),
    /// The key that was read last, as it is written.
    Object(Vec<u8>),
}

struct Walk<'j> {
    json: &'j [u8],
    at: usize,
    open: Vec<Open>,
}

impl Walk<'_> {
    /// Goes on to the value that ends at `end`, which counts the bytes before and of it, or else begins there.
    fn to(mut self, end: usize) -> String {
        while let Some(&byte) = self.json.get(self.at) {
            let begins_behind = self.at >= end;
            match byte {
                b'[' | b'{' if begins_behind => break,
                b'[' => self.open.push(Open::Array(0)),
                b'{' => self.open.push(Open::Object(Vec::new())),
                b']' | b'}' => {
                    self.open.pop();
                    if self.at + 1 >= end {
                        break;
                    }
                }
                b',' => {
                    if let Some(Open::Array(before)) = self.open.last_mut() {
                        *before += 1;
                    }
                }
                b':' | b' ' | b'\t' | b'\r' | b'\n' => {}
                _ => {
                    let length = scalar(&self.json[self.at..]);
                    let token = &self.json[self.at..self.at + length];
                    self.at += length;
                    let is_key = self.key_follows(token);
                    if self.at >= end {
                        if is_key {
                            // What is wrong with a key is the object's fault.
                            self.open.pop();
                        }
                        break;
                    }
                    continue;
                }
            }
            self.at += 1;
        }
        self.pointer()
    }

    /// Whether a scalar that was just read is a key, which is kept.
    fn key_follows(&mut self, token: &[u8]) -> bool {
        let rest = self.json[self.at..].iter().find(|byte| !byte.is_ascii_whitespace());
        match self.open.last_mut() {
            Some(Open::Object(key)) if rest == Some(&b':') => {
                *key = token.to_vec();
                true
            }
            _ => false,
        }
    }

    fn pointer(&self) -> String {
        let mut pointer = String::new();
        for open in &self.open {
            match open {
                Open::Array(before) => pointer += &format!("/{before}"),
                Open::Object(key) => {
                    let key: String = serde_json::from_slice(key).unwrap_or_default();
                    // RFC 6901 escapes its two special characters.
                    pointer += &format!("/{}", key.replace('~', "~0").replace('/', "~1"));
                }
            }
        }
        pointer
    }
}

/// The length of the string, number or word that a text begins with; at least 1.
fn scalar(json: &[u8]) -> usize {
    if json[0] != b'"' {
        let ends =
            |byte: &u8| matches!(byte, b',' | b':' | b']' | b'}') || byte.is_ascii_whitespace();
        return json.iter().position(ends).unwrap_or(json.len()).max(1);
    }
    let mut escaped = false;
    for (at, byte) in json.iter().enumerate().skip(1) {
        match byte {
            b'"' if !escaped => return at + 1,
            _ => escaped = *byte == b'\\' && !escaped,
        }
    }
    json.len()
}
