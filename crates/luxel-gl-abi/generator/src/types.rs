//! Types and names of C, as Rust has them.

/// A type of C that crosses the interface.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CType {
    /// In Rust's words.
    pub rust: String,
    /// Whether it is the address of memory of the caller.
    pub pointer: bool,
}

impl CType {
    /// Reads a type; `None` is `void`.
    pub fn parse(text: &str) -> Result<Option<Self>, String> {
        let constant = text.trim_start().starts_with("const");
        let stars = text.matches('*').count();
        let base = text.replace("const", "").replace('*', "");
        let base = base.trim();
        if base == "void" && stars == 0 {
            return Ok(None);
        }
        let mut rust = scalar(base).ok_or_else(|| format!("{text} is an unknown type"))?.to_owned();
        for star in 0..stars {
            // `const T *const *` and `T const **` alike: the outermost pointer of two is to constants if one is.
            let kind = if constant && (star == 0 || text.matches("const").count() > 1) {
                "const"
            } else {
                "mut"
            };
            rust = format!("*{kind} {rust}");
        }
        Ok(Some(Self { rust, pointer: stars > 0 }))
    }
}

fn scalar(name: &str) -> Option<&'static str> {
    Some(match name {
        "GLenum" | "GLbitfield" | "GLuint" | "GLhandleARB" => "u32",
        "GLint" | "GLsizei" | "GLfixed" | "GLclampx" => "i32",
        "GLfloat" | "GLclampf" => "f32",
        "GLdouble" | "GLclampd" => "f64",
        "GLboolean" | "GLubyte" => "u8",
        "GLbyte" => "i8",
        "GLshort" => "i16",
        "GLushort" => "u16",
        "GLint64" => "i64",
        "GLuint64" => "u64",
        "GLintptr" | "GLsizeiptr" | "GLintptrARB" | "GLsizeiptrARB" => "isize",
        "GLchar" | "GLcharARB" => "c_char",
        "void" => "c_void",
        // Handles and functions of the caller, which are never called: addresses both.
        "GLsync" => "*mut c_void",
        "GLDEBUGPROC" | "GLDEBUGPROCARB" => "*const c_void",
        _ => return None,
    })
}

/// A parameter's name in Rust: in snake case, and no keyword.
pub fn rust_name(name: &str) -> String {
    match name {
        "type" => return "kind".to_owned(),
        "ref" => return "reference".to_owned(),
        _ => {}
    }
    let mut made = String::new();
    let mut lower_before = false;
    for letter in name.chars() {
        if letter.is_ascii_uppercase() && lower_before {
            made.push('_');
        }
        lower_before = letter.is_ascii_lowercase() || letter.is_ascii_digit();
        made.push(letter.to_ascii_lowercase());
    }
    made
}
