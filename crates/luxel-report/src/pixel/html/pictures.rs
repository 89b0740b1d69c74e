//! The figures of the page that show where the pixel lies.

use super::escape::escaped;
use super::rays;
use crate::pixel::pictures::Pictures;
use crate::pixel::report::Report;
use luxel_scene::Size;

/// The whole picture, small, and the pixel's neighbourhood, large.
pub(super) fn figures(pictures: &Pictures, report: &Report<'_>) -> String {
    let ([x, y], size) = pictures.pixel;
    let percent = |at: u32, side: u32| (f64::from(at) + 0.5) / f64::from(side) * 100.0;
    let rays = rays::blocked(report);
    let (Size { width, height }, address) = &pictures.whole;
    let whole = format!(
        "<div class=\"pictures\">\n<figure><div class=\"stage\"><img src=\"{address}\" width=\"{width}\" \
         height=\"{height}\" alt=\"The picture of {}, with the pixel marked\"><b class=\"mark\" \
         style=\"left:{:.3}%;top:{:.3}%\"></b>{}</div><figcaption>The picture, {} by {} pixels; the \
         ring is the pixel{}.</figcaption></figure>\n",
        escaped(report.model),
        percent(x, size.width),
        percent(y, size.height),
        rays,
        size.width,
        size.height,
        if rays.is_empty() { "" } else { ", the line the way to a light, up to what is in it" }
    );
    let (Size { width, height }, address) = &pictures.around;
    let (width, height) = (*width, *height);
    let corner = pictures.corner;
    let [left, top] = [x - corner[0], y - corner[1]];
    let around = format!(
        "<figure><div class=\"stage\"><img class=\"pixels\" src=\"{address}\" width=\"{width}\" \
         height=\"{height}\" alt=\"The pixels around it\"><b class=\"cell\" \
         style=\"left:{:.4}%;top:{:.4}%;width:{:.4}%;height:{:.4}%\"></b></div><figcaption>Its \
         neighbourhood, {width} by {height} pixels from ({}, {}).</figcaption></figure>\n</div>\n",
        f64::from(left) / f64::from(width) * 100.0,
        f64::from(top) / f64::from(height) * 100.0,
        100.0 / f64::from(width),
        100.0 / f64::from(height),
        corner[0],
        corner[1]
    );
    whole + &around
}
