//! Asking the terminal itself what pictures it shows, where its environment doesn't tell: over SSH, most
//! variables are lost on the way.

use super::graphics::Graphics;

/// A question of kitty's protocol, about a picture of one pixel that is not to be shown; then the
/// terminal's attributes (DA1 of DEC's VT100), which every terminal tells. Whoever tells the second
/// without having answered the first doesn't know kitty's protocol.
#[cfg(unix)]
const QUESTION: &[u8] = b"\x1b_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\x1b\\\x1b[c";

/// How long an answer may take: a round the world and back.
#[cfg(unix)]
const PATIENCE: std::time::Duration = std::time::Duration::from_millis(500);

/// What the terminal shows pictures by, as it says itself; `None`, if it says nothing of it. The
/// terminal is in its raw mode, and what is typed meanwhile is lost.
#[cfg(unix)]
pub(super) fn ask(out: &mut impl std::io::Write) -> Option<Graphics> {
    use rustix::event::{PollFd, PollFlags, Timespec, poll};
    let input = std::io::stdin();
    out.write_all(QUESTION).and_then(|()| out.flush()).ok()?;
    let begun = std::time::Instant::now();
    let mut heard = Vec::new();
    loop {
        let left = PATIENCE.checked_sub(begun.elapsed())?;
        let wait = Timespec::try_from(left).ok()?;
        let mut ready = [PollFd::new(&input, PollFlags::IN)];
        match poll(&mut ready, Some(&wait)) {
            Err(rustix::io::Errno::INTR) => continue,
            Err(_) | Ok(0) => return None,
            Ok(_) => {}
        }
        // Not by way of the standard library, which reads ahead what others are to read.
        let mut bytes = [0; 256];
        match rustix::io::read(&input, &mut bytes) {
            Ok(count @ 1..) => heard.extend_from_slice(&bytes[..count]),
            _ => return None,
        }
        if let Some(answer) = answer(&heard) {
            return answer;
        }
    }
}

/// Other systems have no such terminals.
#[cfg(not(unix))]
pub(super) fn ask(_: &mut impl std::io::Write) -> Option<Graphics> {
    None
}

/// What an answer says, once it is there with its end, the attributes.
fn answer(heard: &[u8]) -> Option<Option<Graphics>> {
    let text = String::from_utf8_lossy(heard);
    let attributes = text.split("\x1b[?").skip(1).find_map(|rest| {
        let (numbers, _) = rest.split_once('c')?;
        let is_it = numbers.bytes().all(|byte| byte.is_ascii_digit() || byte == b';');
        is_it.then(|| numbers.to_owned())
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
    fn answers_of_terminals_are_understood_once_they_are_whole() {
        let kitty = b"\x1b_Gi=31;OK\x1b\\\x1b[?62;c";
        for length in 0..kitty.len() {
            assert_eq!(answer(&kitty[..length]), None, "{length}");
        }
        for (heard, expected) in [
            (&kitty[..], Some(Graphics::Kitty)),
            // kitty's protocol without the medium that was asked for, and WezTerm with both.
            (b"\x1b_Gi=31;EINVAL:no\x1b\\\x1b[?62;4c", Some(Graphics::Sixel)),
            (b"\x1b_Gi=31;OK\x1b\\\x1b[?65;4;6;18;22c", Some(Graphics::Kitty)),
            // foot, xterm -ti vt340, xterm, the console of Linux.
            (b"\x1b[?62;4;22;28c", Some(Graphics::Sixel)),
            (b"\x1b[?63;1;2;4;6;9;15;22c", Some(Graphics::Sixel)),
            (b"\x1b[?64;1;2;6;9;15;16;17;18;21;22;28c", None),
            (b"\x1b[?6c", None),
            // Something was typed meanwhile.
            (b"qc\x1b[?1;2;4c", Some(Graphics::Sixel)),
        ] {
            assert_eq!(answer(heard), Some(expected), "{}", heard.escape_ascii());
        }
        assert_eq!(answer(b"c \x1b[A ?62;4c"), None);
    }
}
