//! Paints the paths of an SVG document by a few lines of code, as any program would.

use luxel_scene::Size;

/// One path: closed outlines, a colour, an opacity.
pub(crate) struct Path {
    outlines: Vec<Vec<[f64; 2]>>,
    pub(crate) color: [f64; 3],
    opacity: f64,
}

fn attribute(line: &str, name: &str) -> Option<String> {
    let start = line.find(&format!(" {name}=\""))? + name.len() + 3;
    Some(line[start..].split('"').next().unwrap().to_owned())
}

/// Takes the filled paths of a document apart: of what `luxel` writes, no more.
pub(crate) fn paths(text: &str) -> Vec<Path> {
    let mut paths = Vec::new();
    for line in text.lines().filter(|line| !line.starts_with("<mask")) {
        let Some(fill) = attribute(line, "fill").filter(|fill| fill.starts_with('#')) else {
            continue;
        };
        let digits = &fill[1..];
        let channel = |at: usize| {
            let each = digits.len() / 3;
            let value = u32::from_str_radix(&digits[at * each..(at + 1) * each], 16).unwrap();
            f64::from(if each == 1 { value * 17 } else { value })
        };
        let opacity = attribute(line, "fill-opacity").map_or(1.0, |text| text.parse().unwrap());
        let outlines = if let Some(data) = attribute(line, "d") {
            outlines(&data)
        } else {
            let side = |name| attribute(line, name).unwrap().parse::<f64>().unwrap();
            let (width, height) = (side("width"), side("height"));
            vec![vec![[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]]]
        };
        paths.push(Path { outlines, color: [channel(0), channel(1), channel(2)], opacity });
    }
    paths
}

/// The lines of a document, with their width.
fn lines(text: &str) -> (Vec<Path>, f64) {
    let group = text.lines().find(|line| line.starts_with("<g fill=\"none\""));
    let width = group.map_or(0.0, |line| attribute(line, "stroke-width").unwrap().parse().unwrap());
    let lines = text.lines().filter(|line| line.starts_with("<path stroke"));
    (lines.flat_map(|line| paths(&line.replace("stroke=", "fill="))).collect(), width)
}

fn outlines(data: &str) -> Vec<Vec<[f64; 2]>> {
    let mut outlines: Vec<Vec<[f64; 2]>> = Vec::new();
    let (mut start, mut here) = ([0.0; 2], [0.0; 2]);
    let bytes = data.as_bytes();
    let (mut at, mut command) = (0, b'm');
    let number = |at: &mut usize| -> f64 {
        while bytes[*at] == b' ' {
            *at += 1;
        }
        let begin = *at;
        let mut point = false;
        while *at < bytes.len()
            && (bytes[*at].is_ascii_digit()
                || (bytes[*at] == b'-' && *at == begin)
                || (bytes[*at] == b'.' && !point))
        {
            point |= bytes[*at] == b'.';
            *at += 1;
        }
        data[begin..*at].parse().unwrap()
    };
    while at < bytes.len() {
        if bytes[at].is_ascii_alphabetic() {
            command = bytes[at];
            at += 1;
        }
        match command {
            b'z' => here = start,
            b'h' => here[0] += number(&mut at),
            b'v' => here[1] += number(&mut at),
            b'm' | b'l' => {
                here[0] += number(&mut at);
                here[1] += number(&mut at);
            }
            other => panic!("no command of ours: {}", char::from(other)),
        }
        match command {
            b'm' => {
                start = here;
                outlines.push(vec![here]);
                command = b'l';
            }
            b'z' => {}
            _ => outlines.last_mut().unwrap().push(here),
        }
    }
    outlines
}

impl Path {
    /// Whether a place lies inside, by the rule of nonzero winding.
    pub(crate) fn contains(&self, [x, y]: [f64; 2]) -> bool {
        let mut winding = 0;
        for outline in &self.outlines {
            for (at, &[ax, ay]) in outline.iter().enumerate() {
                let [bx, by] = outline[(at + 1) % outline.len()];
                if (ay <= y) != (by <= y) && x < ax + (bx - ax) * ((y - ay) / (by - ay)) {
                    winding += if by > ay { 1 } else { -1 };
                }
            }
        }
        winding != 0
    }

    fn bounds(&self) -> [f64; 4] {
        let places = self.outlines.iter().flatten();
        places.fold([f64::MAX, f64::MAX, f64::MIN, f64::MIN], |[l, t, r, b], &[x, y]| {
            [l.min(x), t.min(y), r.max(x), b.max(y)]
        })
    }
}

/// Paints paths as programs do: one after another, each pixel covered by as much as `places` of it
/// lie inside. Colour multiplied by alpha, and alpha.
pub(crate) fn painted(paths: &[Path], size: Size, places: &[[f64; 2]]) -> Vec<[f64; 4]> {
    let mut pixels = vec![[0.0; 4]; size.width as usize * size.height as usize];
    over(&mut pixels, paths, size, places);
    pixels
}

/// Paints paths over what is there.
fn over(pixels: &mut [[f64; 4]], paths: &[Path], size: Size, places: &[[f64; 2]]) {
    let (width, height) = (size.width as usize, size.height as usize);
    for path in paths {
        let [left, top, right, bottom] = path.bounds();
        let columns = left.max(0.0) as usize..(right.ceil().max(0.0) as usize).min(width);
        for y in top.max(0.0) as usize..(bottom.ceil().max(0.0) as usize).min(height) {
            for x in columns.clone() {
                let inside = places
                    .iter()
                    .filter(|&&[dx, dy]| path.contains([x as f64 + dx, y as f64 + dy]));
                let cover = inside.count() as f64 / places.len() as f64 * path.opacity;
                if cover > 0.0 {
                    let pixel = &mut pixels[y * width + x];
                    for (channel, color) in pixel.iter_mut().zip(path.color) {
                        *channel += (color - *channel) * cover;
                    }
                    pixel[3] += (1.0 - pixel[3]) * cover;
                }
            }
        }
    }
}

/// Paints a whole document over nothing, its mask and its lines included.
pub(crate) fn painted_document(text: &str, size: Size, places: &[[f64; 2]]) -> Vec<[f64; 4]> {
    let masks: Vec<Path> = text
        .lines()
        .filter(|line| line.starts_with("<mask"))
        .flat_map(|line| paths(&line[line.find("<path").unwrap()..]))
        .collect();
    if masks.is_empty() {
        return painted(&paths(text), size, places);
    }
    let all = paths(text);
    let mut pixels = painted(&all[..1], size, places);
    let (lines, width) = lines(text);
    for Path { outlines, color, .. } in lines {
        for (number, pixel) in pixels.iter_mut().enumerate() {
            let corner = [number % size.width as usize, number / size.width as usize];
            let is_covered = |&&[dx, dy]: &&[f64; 2]| {
                let place = [corner[0] as f64 + dx, corner[1] as f64 + dy];
                let mut ways = outlines.iter().flat_map(|run| run.windows(2));
                ways.any(|way| distance([way[0], way[1]], place) <= width * 0.5)
            };
            let cover = places.iter().filter(is_covered).count() as f64 / places.len() as f64;
            for (channel, color) in pixel.iter_mut().zip(color) {
                *channel += (color - *channel) * cover;
            }
            pixel[3] += (1.0 - pixel[3]) * cover;
        }
    }
    over(&mut pixels, &all[1..], size, places);
    for (pixel, mask) in pixels.iter_mut().zip(painted(&masks, size, places)) {
        *pixel = pixel.map(|channel| channel * mask[3]);
    }
    pixels
}

fn distance([[ax, ay], [bx, by]]: [[f64; 2]; 2], [x, y]: [f64; 2]) -> f64 {
    let (dx, dy) = (bx - ax, by - ay);
    let part = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy).max(1e-12);
    let part = part.clamp(0.0, 1.0);
    (x - ax - dx * part).hypot(y - ay - dy * part)
}
