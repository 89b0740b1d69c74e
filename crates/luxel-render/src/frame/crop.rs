//! A part of a picture: only the tiles that it touches are drawn.

use super::error::RenderError;
use super::finished_tile::{FinishTile, Pixels};
use super::frame_needs::FrameNeeds;
use super::picture::Picture;
use super::renderer::Renderer;
use super::tiles::TilePixels;
use crate::resolve::{Bytes, Finish, empty_pixel};
use luxel_scene::Size;
use luxel_view::View;
use luxel_visibility::{Region, TILE};

impl Renderer {
    /// The bytes of a part of a view's picture, as they are in [`Renderer::rgba8`]: `part` pixels
    /// around `pixel`, which is in the middle unless the picture ends before. A part larger than the
    /// picture is the picture. Answers with the part's upper left corner, too.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible, or the pixel lies outside of it.
    pub fn rgba8_around(
        &self,
        view: &View,
        pixel: [u32; 2],
        part: Size,
    ) -> Result<([u32; 2], Picture<[u8; 4]>), RenderError> {
        let Size { width, height } = view.size;
        if pixel[0] >= width || pixel[1] >= height {
            return Err(RenderError::Outside(view.size));
        }
        let part = Size { width: part.width.min(width), height: part.height.min(height) };
        let corner = [
            pixel[0].saturating_sub(part.width / 2).min(width - part.width),
            pixel[1].saturating_sub(part.height / 2).min(height - part.height),
        ];
        let [x, y] = corner.map(|side| side as i32);
        let region = Region { x, y, ..Region::whole(part) };
        let needs = FrameNeeds { part: Some(region), ..FrameNeeds::PICTURE };
        let mut pixels = vec![[0; 4]; part.width as usize * part.height as usize];
        self.with_scene(view, &needs, |scene, cutouts| {
            let mut worker = self.worker(scene.frame.samples());
            let finish = Bytes(view.encoding);
            let background = finish.pixel(empty_pixel(scene));
            let mut drawn: Box<TilePixels<_>> = Box::new([[0; 4]; (TILE * TILE) as usize]);
            let tile = TILE as usize;
            let [across, _] = scene.frame.tiles();
            let [left, top] = corner.map(|side| side as usize);
            let (wide, high) = (part.width as usize, part.height as usize);
            if wide == 0 || high == 0 {
                return;
            }
            for row in top / tile..=(top + high - 1) / tile {
                for column in left / tile..=(left + wide - 1) / tile {
                    let number = row * across + column;
                    let mut kept = finish.tile(Pixels { pixels: &mut drawn, background });
                    self.draw_tile(scene, cutouts, number, &mut worker, &mut kept);
                    // The columns and rows of the picture that the tile and the part share.
                    let columns = left.max(column * tile)..(left + wide).min((column + 1) * tile);
                    for y in top.max(row * tile)..(top + high).min((row + 1) * tile) {
                        let from = (y - row * tile) * tile + (columns.start - column * tile);
                        let to = (y - top) * wide + (columns.start - left);
                        let count = columns.len();
                        pixels[to..to + count].copy_from_slice(&drawn[from..from + count]);
                    }
                }
            }
        })?;
        Ok((corner, Picture { size: part, pixels, encoding: view.encoding, ..Picture::default() }))
    }
}
