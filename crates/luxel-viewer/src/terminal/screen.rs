//! The terminal as something to draw on: its size, its modes, the line at its bottom.

use super::graphics::{Graphics, GraphicsChoice};
use super::query::ask;
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

/// A cell in pixels, where the terminal does not tell.
const CELL: [u32; 2] = [8, 16];
/// More pixels a side are not sent to a terminal.
const MOST: u32 = 1600;

/// The terminal while a model is shown; when this goes away, it is as it was.
pub(super) struct Screen {
    out: Stdout,
    graphics: Graphics,
    /// Columns and rows.
    cells: [u32; 2],
    /// Pixels of the picture, above the line at the bottom.
    size: Size,
}

impl Screen {
    pub(super) fn open(choice: GraphicsChoice) -> std::io::Result<Self> {
        let out = stdout();
        if !out.is_terminal() || !std::io::stdin().is_terminal() {
            return Err(std::io::Error::other("this is no terminal"));
        }
        enable_raw_mode()?;
        IS_OPEN.store(true, Ordering::SeqCst);
        let size = Size { width: 1, height: 1 };
        let mut screen = Self { out, graphics: Graphics::Blocks, cells: [1; 2], size };
        execute!(screen.out, EnterAlternateScreen, Hide)?;
        // Before the mouse, so that its movements are not among the answers.
        let variable = |name: &str| std::env::var(name).ok();
        screen.graphics = choice.graphics(variable, || ask(&mut screen.out));
        execute!(screen.out, EnableMouseCapture, Clear(ClearType::All))?;
        screen.resized();
        Ok(screen)
    }

    /// The size of pictures.
    pub(super) fn size(&self) -> Size {
        self.size
    }

    /// The terminal may have another size now.
    pub(super) fn resized(&mut self) {
        let (columns, rows) = size().unwrap_or((80, 24));
        let cells = [u32::from(columns).max(1), u32::from(rows).max(2)];
        let told = window_size().ok().filter(|told| told.width > 0 && told.height > 0);
        let pixels = told.map(|told| [u32::from(told.width), u32::from(told.height)]);
        self.cells = cells;
        self.size = picture_size(self.graphics, cells, pixels);
        let _ = execute!(self.out, Clear(ClearType::All));
    }

    /// The place in the picture of the middle of a cell.
    pub(super) fn place(&self, column: u16, row: u16) -> DVec2 {
        let part = |at: u16, of: u32| (f64::from(at) + 0.5) / f64::from(of);
        DVec2::new(
            part(column, self.cells[0]) * f64::from(self.size.width),
            part(row, self.cells[1] - 1) * f64::from(self.size.height),
        )
    }

    /// Shows a picture of the size above, 0RGB.
    pub(super) fn show(&mut self, pixels: &[u32], size: Size) -> std::io::Result<()> {
        let cells = [self.cells[0], self.cells[1] - 1];
        let text = self.graphics.text(pixels, size, cells);
        queue!(self.out, BeginSynchronizedUpdate, MoveTo(0, 0))?;
        self.out.write_all(text.as_bytes())?;
        queue!(self.out, EndSynchronizedUpdate)?;
        self.out.flush()
    }

    /// Writes the line at the bottom.
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
        // Whoever has gone hears nothing of it.
        let _ = self.out.write_all(self.graphics.farewell().as_bytes());
        leave_terminal();
    }
}

/// Whether a terminal is not as it was.
static IS_OPEN: AtomicBool = AtomicBool::new(false);

/// Leaves the terminal as it was before [`view_in_terminal`](crate::view_in_terminal), for whoever ends
/// the program in the middle of that; without it, nothing.
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

/// The picture's size: two pixels a cell for blocks, else the terminal's own pixels, above its last
/// line.
fn picture_size(graphics: Graphics, [columns, rows]: [u32; 2], pixels: Option<[u32; 2]>) -> Size {
    let above = rows.saturating_sub(1).max(1);
    let side = |side: u32| side.clamp(1, MOST);
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
    fn the_last_line_is_left_to_words() {
        let blocks = picture_size(Graphics::Blocks, [80, 25], Some([800, 500]));
        assert_eq!(blocks, Size { width: 80, height: 48 });
        let told = picture_size(Graphics::Kitty, [80, 25], Some([800, 500]));
        assert_eq!(told, Size { width: 800, height: 480 });
        let guessed = picture_size(Graphics::Sixel, [80, 25], None);
        assert_eq!(guessed, Size { width: 640, height: 384 });
        let tiny = picture_size(Graphics::Blocks, [1, 1], None);
        assert_eq!(tiny, Size { width: 1, height: 2 });
    }
}
