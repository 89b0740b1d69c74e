//! Scaling: smaller images have the mean of what each pixel covers, larger ones are interpolated linearly.

use super::{Image, ImageError};

/// What a pixel along one axis is made of: old places and weights, which add up to 1.
///
/// It is a box over the old pixels: as wide as the new pixel, but no narrower than an old one, which interpolates. Beyond
/// the image its edge goes on.
fn coverage(from: usize, to: usize, place: usize) -> Vec<(usize, f64)> {
    // In units in which an old pixel has the length 2 to and a new one 2 from, so that all ends are whole numbers.
    let (pixel, half) = (2 * to as i128, from.max(to) as i128);
    let center = (2 * place as i128 + 1) * from as i128;
    let (start, end) = (center - half, center + half);
    let covered = (start.div_euclid(pixel)..(end + pixel - 1).div_euclid(pixel)).map(|old| {
        let covered = end.min((old + 1) * pixel) - start.max(old * pixel);
        let inside = old.clamp(0, from as i128 - 1) as usize;
        (inside, covered as f64 / (2 * half) as f64)
    });
    covered.collect()
}

impl Image {
    /// The image in another size.
    ///
    /// # Errors
    ///
    /// [`ImageError::Value`] if a side is 0, [`ImageError::Memory`].
    pub fn scaled(&self, size: [usize; 3]) -> Result<Self, ImageError> {
        if size.contains(&0) || self.size.contains(&0) {
            return Err(ImageError::Value);
        }
        // One axis after the other.
        let mut image = self.clone();
        for axis in 0..3 {
            image = image.scaled_along(axis, size[axis])?;
        }
        Ok(image)
    }

    fn scaled_along(self, axis: usize, to: usize) -> Result<Self, ImageError> {
        let from = self.size[axis];
        if from == to {
            return Ok(self);
        }
        let mut size = self.size;
        size[axis] = to;
        let mut made = Self::zero(size, self.components)?;
        // Numbers between neighbours along the axis, and from a line of them to the next.
        let step = self.components * self.size[..axis].iter().product::<usize>();
        let covered: Vec<_> = (0..to).map(|place| coverage(from, to, place)).collect();
        let mut sums = vec![0.0; step];
        for (old, new) in
            self.values.chunks_exact(step * from).zip(made.values.chunks_exact_mut(step * to))
        {
            for (covered, means) in covered.iter().zip(new.chunks_exact_mut(step)) {
                sums.fill(0.0);
                for &(place, weight) in covered {
                    let line = &old[place * step..(place + 1) * step];
                    for (sum, &value) in sums.iter_mut().zip(line) {
                        *sum += weight * f64::from(value);
                    }
                }
                for (mean, &sum) in means.iter_mut().zip(&sums) {
                    *mean = sum as f32;
                }
            }
        }
        Ok(made)
    }
}
