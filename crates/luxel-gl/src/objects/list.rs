//! Display lists (OpenGL 1.5, section 5.4): commands in the order of their calls.
//!
//! A list holds what was called, not what it meant then: state that a command reads is that of the moment when the
//! list is executed, and so are its errors.

use crate::enums as gl;
use crate::limits::{LIST_COMMANDS, PART_VERTICES, WAITING_VERTICES};
use crate::objects::image_calls::{
    BitmapCall, CopyTexImage, CopyTexSubImage, DrawPixels, TexImage, TexSubImage, WithPixels,
};
use crate::objects::map_calls::MapCall;
use crate::vertex::{ArrayDraw, Vertices, Welded, welded};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A command of a list, with its arguments.
#[derive(Clone, Debug)]
pub(crate) enum Command {
    /// One that sets an error.
    Error(u32),
    Begin(u32),
    End,
    /// Vertices and attributes, as many as come one after the other.
    Vertices(Box<Vertices>),
    Index(f32),
    RasterPos([f32; 4]),
    WindowPos([f32; 3]),
    Rect([f32; 2], [f32; 2]),
    MatrixMode(u32),
    LoadIdentity,
    LoadMatrix(Box<[f64; 16]>),
    MultMatrix(Box<[f64; 16]>),
    PushMatrix,
    PopMatrix,
    Rotate(Box<[f64; 4]>),
    Scale(Box<[f64; 3]>),
    Translate(Box<[f64; 3]>),
    Frustum(Box<[f64; 6]>),
    Ortho(Box<[f64; 6]>),
    Viewport([i32; 4]),
    DepthRange([f64; 2]),
    ClipControl(u32, u32),
    ActiveTexture(u32),
    Light(u32, u32, [f32; 4]),
    LightModel(u32, [f32; 4]),
    Material(u32, u32, [f32; 4]),
    ColorMaterial(u32, u32),
    ShadeModel(u32),
    Fog(u32, [f32; 4]),
    Enable(u32),
    Disable(u32),
    Hint(u32, u32),
    CullFace(u32),
    FrontFace(u32),
    PolygonMode(u32, u32),
    PolygonOffset([f32; 2]),
    PolygonStipple(Box<[u32; 32]>),
    LineWidth(f32),
    LineStipple(i32, u16),
    PointSize(f32),
    PointParameter(u32, [f32; 4]),
    ClipPlane(u32, Box<[f64; 4]>),
    Scissor([i32; 4]),
    SampleCoverage(f32, bool),
    AlphaFunc(u32, f32),
    DepthFunc(u32),
    DepthMask(bool),
    ColorMask([bool; 4]),
    StencilFunc(u32, i32, u32),
    StencilOp([u32; 3]),
    StencilMask(u32),
    BlendFunc([u32; 4]),
    BlendEquation([u32; 2]),
    BlendColor([f32; 4]),
    LogicOp(u32),
    IndexMask(u32),
    Clear(u32),
    ClearColor([f32; 4]),
    ClearDepth(f64),
    ClearStencil(i32),
    ClearAccum([f32; 4]),
    ClearIndex(f32),
    DrawBuffer(u32),
    ReadBuffer(u32),
    CallList(u32),
    CallLists(Box<[u32]>),
    ListBase(u32),
    PushAttrib(u32),
    PopAttrib,
    InitNames,
    LoadName(u32),
    PushName(u32),
    PopName,
    PassThrough(f32),
    Bitmap(Arc<BitmapCall>),
    Accum(u32, f32),
    PixelZoom([f32; 2]),
    PixelTransfer(u32, f32),
    PixelMap(u32, i32, Box<[f32]>),
    DrawPixels(Box<WithPixels<DrawPixels>>),
    CopyPixels(Box<[i32; 4]>, u32),
    Map(Box<MapCall>),
    MapGrid1(i32, [f32; 2]),
    MapGrid2([i32; 2], [[f32; 2]; 2]),
    EvalCoord1(f32),
    EvalCoord2([f32; 2]),
    EvalPoint1(i32),
    EvalPoint2([i32; 2]),
    EvalMesh1(u32, [i32; 2]),
    EvalMesh2(u32, Box<[i32; 4]>),
    BindTexture(u32, u32),
    PrioritizeTextures(i32, Box<[(u32, f32)]>),
    TexParameter(u32, u32, [f32; 4]),
    TexEnv(u32, u32, [f32; 4]),
    TexGen(u32, u32, [f32; 4]),
    TexImage(Box<WithPixels<TexImage>>),
    TexSubImage(Box<WithPixels<TexSubImage>>),
    CopyTexImage(Box<CopyTexImage>),
    CopyTexSubImage(Box<CopyTexSubImage>),
    Draw(Arc<ArrayDraw>),
    Primitives(Arc<Welded>),
    BeginQuery(u32, u32),
    EndQuery(u32),
}

impl Command {
    /// How many commands of the API it is.
    pub(crate) fn count(&self) -> usize {
        match self {
            Self::Vertices(run) => 1 + run.len(),
            Self::Primitives(of) => 3 + of.elements.len(),
            _ => 1,
        }
    }
}

/// A display list that is being compiled (`glNewList`).
#[derive(Debug)]
pub(crate) struct OpenList {
    pub(crate) name: u32,
    pub(crate) mode: u32,
    commands: Vec<Command>,
    /// What comes after the last command. Its memory may be another list's.
    run: Vertices,
    /// Commands of the API, but for those of the run.
    count: usize,
}

impl OpenList {
    /// An empty list; its vertices come first into the memory of `room`.
    pub(crate) fn new(name: u32, mode: u32, mut room: Vertices) -> Self {
        room.clear();
        Self { name, mode, commands: Vec::new(), run: room, count: 0 }
    }

    /// Appends a command. `GL_OUT_OF_MEMORY` if the list is too long.
    pub(crate) fn push(&mut self, command: Command) -> Result<(), u32> {
        if matches!(command, Command::End)
            && let Some(primitives) = self.welded()
        {
            // It takes the place of the `glBegin`.
            self.count -= 1;
            self.commands.pop();
            self.run.clear();
            return self.append(Command::Primitives(Arc::new(primitives)));
        }
        self.close_run()?;
        self.append(command)
    }

    /// Many primitives that are about to end, as one command, if vertices are repeated in them.
    fn welded(&self) -> Option<Welded> {
        let &Command::Begin(mode) = self.commands.last()? else { return None };
        // Fewer wait for others of their kind when the list is called, and are drawn with these.
        if mode > gl::POLYGON || self.run.len() < WAITING_VERTICES {
            return None;
        }
        welded(mode, &self.run)
    }

    fn append(&mut self, command: Command) -> Result<(), u32> {
        let count = self.count + command.count();
        if count > LIST_COMMANDS {
            return Err(gl::OUT_OF_MEMORY);
        }
        self.count = count;
        self.commands.push(command);
        Ok(())
    }

    /// Appends a vertex with the attributes of now.
    #[inline]
    pub(crate) fn vertex(&mut self, position: [f32; 4]) -> Result<(), u32> {
        if self.run.push_usual(position, PART_VERTICES - 1) {
            return Ok(());
        }
        self.run.push(position);
        if self.run.len() >= PART_VERTICES { self.close_run() } else { Ok(()) }
    }

    /// Sets an attribute of the next vertices.
    #[inline]
    pub(crate) fn set(&mut self, set: impl FnOnce(&mut Vertices)) -> Result<(), u32> {
        set(&mut self.run);
        Ok(())
    }

    /// Makes a command of vertices and attributes.
    fn close_run(&mut self) -> Result<(), u32> {
        if self.run.is_untouched() {
            return Ok(());
        }
        let mut run = std::mem::take(&mut self.run);
        run.shrink();
        self.append(Command::Vertices(Box::new(run)))
    }

    /// The commands of the list; and the memory of vertices for the next one.
    pub(crate) fn finish(mut self) -> (Result<List, u32>, Vertices) {
        let closed = self.close_run();
        let Self { commands, run, count, .. } = self;
        (closed.map(|()| List { commands: commands.into(), count }), run)
    }
}

/// A display list.
#[derive(Clone, Debug, Default)]
pub(crate) struct List {
    pub(crate) commands: Arc<[Command]>,
    /// Commands of the API.
    count: usize,
}

/// The lists of a context, and of those that share with it. An empty list is a name that is taken.
#[derive(Debug, Default)]
pub(crate) struct Lists {
    lists: BTreeMap<u32, List>,
    /// Commands of all lists.
    count: usize,
}

impl Lists {
    pub(crate) fn get(&self, name: u32) -> Option<Arc<[Command]>> {
        self.lists.get(&name).map(|list| Arc::clone(&list.commands))
    }

    pub(crate) fn has(&self, name: u32) -> bool {
        self.lists.contains_key(&name)
    }

    /// Takes a list in place of the one that had the name.
    pub(crate) fn put(&mut self, name: u32, list: List) -> Result<(), u32> {
        if self.count + list.count > LIST_COMMANDS {
            return Err(gl::OUT_OF_MEMORY);
        }
        self.count += list.count;
        if let Some(before) = self.lists.insert(name, list) {
            self.count -= before.count;
        }
        Ok(())
    }

    /// Names that nobody has, `count` of them one after the other; 0 if there are none.
    pub(crate) fn generate(&mut self, count: u32) -> u32 {
        let mut first: u32 = 1;
        for &taken in self.lists.keys() {
            if taken > first && taken - first >= count {
                break;
            }
            let Some(next) = taken.checked_add(1) else { return 0 };
            first = first.max(next);
        }
        // Names are as dear as lists: a program can't take four billion of them.
        if first.checked_add(count - 1).is_none()
            || self.lists.len() + count as usize > LIST_COMMANDS
        {
            return 0;
        }
        for name in first..=first + (count - 1) {
            self.lists.insert(name, List::default());
        }
        first
    }

    /// Deletes `count` names; those that nobody has are passed over.
    pub(crate) fn delete(&mut self, first: u32, count: u32) {
        let end = u64::from(first) + u64::from(count);
        let last = u32::try_from(end).unwrap_or(u32::MAX);
        let names: Vec<u32> = self.lists.range(first..last).map(|(name, _)| *name).collect();
        for name in names {
            self.count -= self.lists.remove(&name).map_or(0, |list| list.count);
        }
    }
}

/// The names in an array of `glCallLists`, as offsets to the list base.
///
/// `None` for a type that isn't one.
pub(crate) fn list_offsets(data_type: u32, bytes: &[u8]) -> Option<Vec<u32>> {
    fn each<const N: usize>(bytes: &[u8], of: impl Fn([u8; N]) -> u32) -> Vec<u32> {
        bytes.as_chunks::<N>().0.iter().map(|chunk| of(*chunk)).collect()
    }
    Some(match data_type {
        gl::BYTE => each(bytes, |[b]| i32::from(b as i8) as u32),
        gl::UNSIGNED_BYTE => each(bytes, |[b]| u32::from(b)),
        gl::SHORT => each(bytes, |b| i32::from(i16::from_ne_bytes(b)) as u32),
        gl::UNSIGNED_SHORT => each(bytes, |b| u32::from(u16::from_ne_bytes(b))),
        gl::INT | gl::UNSIGNED_INT => each(bytes, u32::from_ne_bytes),
        // Floor, as a signed number: names below the base exist, too.
        gl::FLOAT => each(bytes, |b| f32::from_ne_bytes(b).floor() as i64 as u32),
        gl::_2_BYTES => each(bytes, |b| u32::from(u16::from_be_bytes(b))),
        gl::_3_BYTES => each(bytes, |[a, b, c]| u32::from_be_bytes([0, a, b, c])),
        gl::_4_BYTES => each(bytes, u32::from_be_bytes),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn section_5_4_generated_names_are_contiguous_and_fill_gaps() {
        let mut lists = Lists::default();
        assert_eq!(lists.generate(3), 1);
        assert_eq!(lists.generate(2), 4);
        lists.delete(2, 2);
        assert_eq!(lists.generate(2), 2);
        lists.put(u32::MAX, List::default()).unwrap();
        assert_eq!(lists.generate(1), 6);
        lists.delete(0, u32::MAX);
        assert!(!lists.has(1) && lists.has(u32::MAX));
    }

    #[test]
    fn section_5_4_names_of_two_three_and_four_bytes_begin_with_the_highest() {
        assert_eq!(list_offsets(gl::_2_BYTES, &[1, 2, 3, 4]), Some(vec![0x102, 0x304]));
        assert_eq!(list_offsets(gl::_3_BYTES, &[1, 2, 3]), Some(vec![0x10203]));
        assert_eq!(list_offsets(gl::_4_BYTES, &[1, 2, 3, 4]), Some(vec![0x0102_0304]));
        assert_eq!(list_offsets(gl::BYTE, &[0xff]), Some(vec![u32::MAX]));
        let below = (-1.5_f32).to_ne_bytes();
        assert_eq!(list_offsets(gl::FLOAT, &below), Some(vec![(-2_i32) as u32]));
        assert_eq!(list_offsets(gl::RGBA, &[0]), None);
    }
}
