//! The terminal as an output device: size, modes, picture and bottom line.

use super::graphics::{Graphics, GraphicsChoice};
use super::query::query_graphics;
use crossterm::cursor::{Hide, MoveTo, Show};
use crossterm::event::{DisableMouseCapture, EnableMouseCapture};
use crossterm::style::{Attribute, Print, SetAttribute};
use crossterm::terminal::{
    BeginSynchronizedUpdate, Clear, ClearType, EndSynchronizedUpdate, EnterAlternateScreen,
    LeaveAlternateScreen, disable_raw_mode, enable_raw_mode, size, window_size,
};
use crossterm::{execute, queue};
use luxel::scene::{DVec2, Size};
use std::io::{IsTerminal, Stdout, Write, stdout};
use std::sync::atomic::{AtomicBool, Ordering};

/// The assumed size of a cell in pixels, if the terminal doesn't report one.
const CELL: [u32; 2] = [8, 16];
/// The largest side of a picture, in pixels.
const MAX_SIDE: u32 = 1600;

/// The terminal while a model is shown; restored on drop.
pub(super) struct Screen {
    out: Stdout,
    graphics: Graphics,
    /// Columns and rows.
    cells: [u32; 2],
    /// The size of the picture above the bottom line, in pixels.
    size: Size,
}

impl Screen {
    pub(super) fn open(choice: GraphicsChoice) -> std::io::Result<Self> {
        let out = stdout();
        if !out.is_terminal() || !std::io::stdin().is_terminal() {
            return Err(std::io::Error::other("this is not a terminal"));
        }
        enable_raw_mode()?;
        IS_OPEN.store(true, Ordering::SeqCst);
        let size = Size { width: 1, height: 1 };
        let mut screen = Self { out, graphics: Graphics::Blocks, cells: [1; 2], size };
        execute!(screen.out, EnterAlternateScreen, Hide)?;
        // Queried before the mouse is captured, so that its movements don't mix with the answer.
        let variable = |name: &str| std::env::var(name).ok();
        screen.graphics = choice.graphics(variable, || query_graphics(&mut screen.out));
        execute!(screen.out, EnableMouseCapture, Clear(ClearType::All))?;
        screen.update_size();
        Ok(screen)
    }

    /// The size of pictures.
    pub(super) fn size(&self) -> Size {
        self.size
    }

    /// Updates the size.
    pub(super) fn update_size(&mut self) {
        let (columns, rows) = size().unwrap_or((80, 24));
        let cells = [u32::from(columns).max(1), u32::from(rows).max(2)];
        let reported = window_size().ok().filter(|size| size.width > 0 && size.height > 0);
        let pixels = reported.map(|size| [u32::from(size.width), u32::from(size.height)]);
        self.cells = cells;
        self.size = picture_size(self.graphics, cells, pixels);
        let _ = execute!(self.out, Clear(ClearType::All));
    }

    /// The position of a cell's centre in the picture.
    pub(super) fn cell_centre(&self, column: u16, row: u16) -> DVec2 {
        let part = |at: u16, of: u32| (f64::from(at) + 0.5) / f64::from(of);
        DVec2::new(
            part(column, self.cells[0]) * f64::from(self.size.width),
            part(row, self.cells[1] - 1) * f64::from(self.size.height),
        )
    }

    /// Shows a picture of this size, 0RGB.
    pub(super) fn show(&mut self, pixels: &[u32], size: Size) -> std::io::Result<()> {
        let cells = [self.cells[0], self.cells[1] - 1];
        let text = self.graphics.encode(pixels, size, cells);
        queue!(self.out, BeginSynchronizedUpdate, MoveTo(0, 0))?;
        self.out.write_all(text.as_bytes())?;
        queue!(self.out, EndSynchronizedUpdate)?;
        self.out.flush()
    }

    /// Writes the bottom line.
    pub(super) fn write_line(&mut self, text: &str) -> std::io::Result<()> {
        let width = self.cells[0] as usize;
        let short: String =
            text.chars().filter(|letter| !letter.is_control()).take(width).collect();
        let row = (self.cells[1] - 1).min(u32::from(u16::MAX)) as u16;
        queue!(
            self.out,
            MoveTo(0, row),
            Clear(ClearType::CurrentLine),
            SetAttribute(Attribute::Reset),
            Print(short),
        )?;
        self.out.flush()
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        // Errors are ignored: the terminal may be gone.
        let _ = self.out.write_all(self.graphics.cleanup().as_bytes());
        leave_terminal();
    }
}

/// Whether a terminal must be restored.
static IS_OPEN: AtomicBool = AtomicBool::new(false);

/// Restores the terminal if the program ends during [`view_in_terminal`](crate::view_in_terminal); no
/// effect otherwise.
pub fn leave_terminal() {
    if IS_OPEN.swap(false, Ordering::SeqCst) {
        let _ = execute!(
            stdout(),
            SetAttribute(Attribute::Reset),
            DisableMouseCapture,
            Show,
            LeaveAlternateScreen
        );
        let _ = disable_raw_mode();
    }
}

/// The picture's size: two pixels a cell for blocks, else the terminal's pixels, without its last line.
fn picture_size(graphics: Graphics, [columns, rows]: [u32; 2], pixels: Option<[u32; 2]>) -> Size {
    let above = rows.saturating_sub(1).max(1);
    let side = |side: u32| side.clamp(1, MAX_SIDE);
    if graphics == Graphics::Blocks {
        return Size { width: side(columns), height: side(2 * above) };
    }
    let [width, height] = pixels.unwrap_or([columns * CELL[0], rows * CELL[1]]);
    let (width, height) = (side(width), side(height * above / rows));
    Size { width, height }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_line_is_reserved_for_text() {
        let blocks = picture_size(Graphics::Blocks, [80, 25], Some([800, 500]));
        assert_eq!(blocks, Size { width: 80, height: 48 });
        let reported = picture_size(Graphics::Kitty, [80, 25], Some([800, 500]));
        assert_eq!(reported, Size { width: 800, height: 480 });
        let assumed = picture_size(Graphics::Sixel, [80, 25], None);
        assert_eq!(assumed, Size { width: 640, height: 384 });
        let tiny = picture_size(Graphics::Blocks, [1, 1], None);
        assert_eq!(tiny, Size { width: 1, height: 2 });
    }
}
