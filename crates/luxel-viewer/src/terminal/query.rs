//! Queries the terminal for its graphics protocol, where environment variables don't identify it: SSH
//! drops most of them.

use super::graphics::Graphics;

/// A query of kitty's protocol, for a picture of one pixel that isn't shown, then a request for the
/// terminal's attributes (DA1 of DEC's VT100), which every terminal answers. A terminal that answers only
/// the second doesn't support kitty's protocol.
#[cfg(unix)]
const QUERY: &[u8] = b"\x1b_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\x1b\\\x1b[c";

/// The longest wait for an answer: a round trip around the world.
#[cfg(unix)]
const TIMEOUT: std::time::Duration = std::time::Duration::from_millis(500);

/// The graphics protocol that the terminal reports; `None` if it reports none. The terminal is in raw
/// mode; input typed meanwhile is lost.
#[cfg(unix)]
pub(super) fn query_graphics(out: &mut impl std::io::Write) -> Option<Graphics> {
    use rustix::event::{PollFd, PollFlags, Timespec, poll};
    let input = std::io::stdin();
    out.write_all(QUERY).and_then(|()| out.flush()).ok()?;
    let start = std::time::Instant::now();
    let mut received = Vec::new();
    loop {
        let left = TIMEOUT.checked_sub(start.elapsed())?;
        let wait = Timespec::try_from(left).ok()?;
        let mut ready = [PollFd::new(&input, PollFlags::IN)];
        match poll(&mut ready, Some(&wait)) {
            Err(rustix::io::Errno::INTR) => continue,
            Err(_) | Ok(0) => return None,
            Ok(_) => {}
        }
        // The standard library's buffer would swallow input meant for others.
        let mut bytes = [0; 256];
        match rustix::io::read(&input, &mut bytes) {
            Ok(count @ 1..) => received.extend_from_slice(&bytes[..count]),
            _ => return None,
        }
        if let Some(answer) = answer(&received) {
            return answer;
        }
    }
}

/// Terminals of other systems have none of these protocols.
#[cfg(not(unix))]
pub(super) fn query_graphics(_: &mut impl std::io::Write) -> Option<Graphics> {
    None
}

/// Parses an answer; `None` until its end, the attributes, has been received.
#[cfg(any(unix, test))]
fn answer(received: &[u8]) -> Option<Option<Graphics>> {
    let text = String::from_utf8_lossy(received);
    let attributes = text.split("\x1b[?").skip(1).find_map(|rest| {
        let (numbers, _) = rest.split_once('c')?;
        let is_attributes = numbers.bytes().all(|byte| byte.is_ascii_digit() || byte == b';');
        is_attributes.then(|| numbers.to_owned())
    })?;
    let is_kitty = text.contains("\x1b_Gi=31;OK");
    // 4 is sixel graphics.
    let has_sixels = attributes.split(';').any(|number| number == "4");
    Some(if is_kitty { Some(Graphics::Kitty) } else { has_sixels.then_some(Graphics::Sixel) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_are_parsed_once_complete() {
        let kitty = b"\x1b_Gi=31;OK\x1b\\\x1b[?62;c";
        for length in 0..kitty.len() {
            assert_eq!(answer(&kitty[..length]), None, "{length}");
        }
        for (received, expected) in [
            (&kitty[..], Some(Graphics::Kitty)),
            // kitty's protocol without the requested medium, and WezTerm with both.
            (b"\x1b_Gi=31;EINVAL:no\x1b\\\x1b[?62;4c", Some(Graphics::Sixel)),
            (b"\x1b_Gi=31;OK\x1b\\\x1b[?65;4;6;18;22c", Some(Graphics::Kitty)),
            // foot, xterm -ti vt340, xterm, the console of Linux.
            (b"\x1b[?62;4;22;28c", Some(Graphics::Sixel)),
            (b"\x1b[?63;1;2;4;6;9;15;22c", Some(Graphics::Sixel)),
            (b"\x1b[?64;1;2;6;9;15;16;17;18;21;22;28c", None),
            (b"\x1b[?6c", None),
            // Input was typed meanwhile.
            (b"qc\x1b[?1;2;4c", Some(Graphics::Sixel)),
        ] {
            assert_eq!(answer(received), Some(expected), "{}", received.escape_ascii());
        }
        assert_eq!(answer(b"c \x1b[A ?62;4c"), None);
    }
}
