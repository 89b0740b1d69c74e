#!/usr/bin/env python3
"""The view in a terminal, driven through a pseudo-terminal: keys and mouse change the picture, every way
to show pictures is well-formed, and the terminal is left as it was. Takes the program as argument."""

import base64
import fcntl
import os
import pty
import re
import select
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import time
import zlib

PROGRAM = os.path.realpath(sys.argv[1])
COLUMNS, ROWS = 60, 20


def fail(what):
    sys.exit(f"FAILED: {what}")


class Terminal:
    """The program in a terminal of its own."""

    def __init__(self, *flags, model="demo:plane", answer=b"\x1b[?64;1;2;6;22c", variables=()):
        """`answer` is what the terminal says of itself when it is asked; None is a silent one."""
        self.out = b""
        self.answer = answer
        self.asked = 0
        pid, self.fd = pty.fork()
        if pid == 0:
            os.environ["TERM"] = "xterm-256color"
            for name in ("DISPLAY", "TMUX", "KITTY_WINDOW_ID", "TERM_PROGRAM", "LC_TERMINAL", "KONSOLE_VERSION"):
                os.environ.pop(name, None)
            os.environ.update(variables)
            # Until the terminal has its size.
            time.sleep(0.2)
            os.execv(PROGRAM, [PROGRAM, "view", model, "--terminal", *flags])
        self.pid = pid
        self.before = termios.tcgetattr(self.fd)
        self.resize(COLUMNS, ROWS)

    def resize(self, columns, rows):
        size = struct.pack("HHHH", rows, columns, columns * 10, rows * 20)
        fcntl.ioctl(self.fd, termios.TIOCSWINSZ, size)

    def read(self, quiet=0.8, most=20.0):
        """What comes until nothing has come for a while."""
        text, end = b"", time.time() + most
        while time.time() < end:
            ready, _, _ = select.select([self.fd], [], [], quiet)
            if not ready:
                break
            try:
                piece = os.read(self.fd, 1 << 16)
            except OSError:
                break
            if not piece:
                break
            text += piece
            if b"\x1b[c" in text and not self.asked:
                self.asked += 1
                if self.answer is not None:
                    os.write(self.fd, self.answer)
        self.out += text
        return text

    def first(self):
        """The first picture, however long the program takes."""
        select.select([self.fd], [], [], 30)
        return self.read()

    def type(self, keys):
        os.write(self.fd, keys.encode())
        return self.read()

    def leave(self, keys="q"):
        os.write(self.fd, keys.encode())
        self.read()
        end = time.time() + 10
        while time.time() < end:
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            if pid:
                code = os.waitstatus_to_exitcode(status)
                if code != 0:
                    fail(f"{keys!r} leaves with status {code}")
                break
            self.read(quiet=0.1)
        else:
            os.kill(self.pid, signal.SIGKILL)
            fail(f"{keys!r} does not leave")
        for mode in (b"\x1b[?1049l", b"\x1b[?25h", b"\x1b[?1000l"):
            if mode not in self.out:
                fail(f"{mode!r} is not said at the end")
        if self.out.count(b"\x1b[?1049h") != 1:
            fail("the alternate screen is not entered once")


def blocks(text):
    """The picture of half blocks last shown: a pair of colours for each cell, by its row."""
    cells, color, row, column = {}, None, 0, 0
    for escape, letters in re.findall(r"(\x1b\[[0-9;?]*[A-Za-z])|([^\x1b]+)", text.decode("utf-8", "replace")):
        if escape.endswith("H"):
            numbers = escape[2:-1].split(";")
            row, column = int(numbers[0] or 1), int(numbers[1] if len(numbers) > 1 else 1)
        elif escape.endswith("m"):
            color = escape[2:-1]
        for letter in letters:
            if letter == "\u2580":
                cells[row, column] = color
            column += 1
    return cells


def png_size(data):
    if not data.startswith(b"\x89PNG\r\n\x1a\n"):
        fail("what is shown is no PNG")
    width, height = struct.unpack(">II", data[16:24])
    # All of it is there: every chunk by its checksum.
    at = 8
    while at < len(data):
        (length,) = struct.unpack(">I", data[at : at + 4])
        body = data[at + 4 : at + 8 + length]
        if zlib.crc32(body) != struct.unpack(">I", data[at + 8 + length : at + 12 + length])[0]:
            fail("a chunk of the PNG is damaged")
        at += 12 + length
    return width, height


# Half blocks: keys and mouse.
terminal = Terminal()
first = blocks(terminal.first())
if len(first) != COLUMNS * (ROWS - 1):
    fail(f"{len(first)} cells are shown, not {COLUMNS * (ROWS - 1)}")
if len(set(first.values())) < 50:
    fail("the first picture shows nothing")
if b"turntable" not in terminal.out:
    fail("the line at the bottom is missing")
front = blocks(terminal.type("1"))
if front == first or len(front) != len(first):
    fail("1 is no other view")
if blocks(terminal.type("7")) == front:
    fail("7 is no other view")
if blocks(terminal.type("1")) != front:
    fail("1 is not the view from the front again")
if blocks(terminal.type("d")) == front:
    fail("d moves nothing")
terminal.type("\x1b[H")
terminal.type("1")
# SGR mouse: down, drag, up.
dragged = blocks(terminal.type("\x1b[<0;20;8M\x1b[<32;30;10M\x1b[<32;34;12M\x1b[<0;34;12m"))
if dragged in (front, {}):
    fail("the mouse turns nothing")
if blocks(terminal.type("t")) == {}:
    fail("t draws nothing")
terminal.resize(40, 12)
os.kill(terminal.pid, signal.SIGWINCH)
small = blocks(terminal.read())
if len(small) != 40 * 11:
    fail(f"after a change of size, {len(small)} cells are shown")
terminal.leave()

# Ctrl+C leaves, whatever it is bound to.
terminal = Terminal()
terminal.first()
terminal.leave("\x03")

# Ended from outside, it leaves the terminal as it was, too.
terminal = Terminal()
terminal.first()
os.kill(terminal.pid, signal.SIGTERM)
terminal.read()
if os.waitpid(terminal.pid, 0)[1] == 0:
    fail("ended from outside, it tells of no failure")
for mode in (b"\x1b[?1049l", b"\x1b[?25h", b"\x1b[?1000l"):
    if mode not in terminal.out:
        fail(f"{mode!r} is not said when it is ended from outside")
if termios.tcgetattr(terminal.fd)[3] != terminal.before[3]:
    fail("the terminal's modes are not as they were when it is ended from outside")

# The smallest terminals.
for columns, rows in [(20, 5), (1, 1)]:
    terminal = Terminal()
    terminal.resize(columns, rows)
    terminal.first()
    terminal.type("hd")
    terminal.leave()

# The protocols for pictures.
width, height = COLUMNS * 10, (ROWS - 1) * 20
terminal = Terminal("--graphics", "kitty")
text = terminal.first()
pieces = re.findall(rb"\x1b_G([^;]*);([^\x1b]*)\x1b\\", text)
if not pieces or b"f=100" not in pieces[0][0] or b"a=T" not in pieces[0][0]:
    fail("kitty gets no picture")
first_picture = []
for head, data in pieces:
    first_picture.append(data)
    if b"m=0" in head:
        break
size = png_size(base64.b64decode(b"".join(first_picture)))
if size != (width, height):
    fail(f"kitty gets {size}")
terminal.leave()
if b"\x1b_Ga=d" not in terminal.out:
    fail("kitty's picture is left behind")

terminal = Terminal("--graphics", "iterm2")
found = re.search(rb"\x1b\]1337;File=inline=1;[^:]*:([^\x07]*)\x07", terminal.first())
if not found or png_size(base64.b64decode(found.group(1))) != (width, height):
    fail("iTerm2 gets no picture")
terminal.leave()

terminal = Terminal("--graphics", "sixel")
found = re.search(rb'\x1bP0;1q"1;1;(\d+);(\d+)([^\x1b]*)\x1b\\', terminal.first())
if not found or (int(found.group(1)), int(found.group(2))) != (width, height):
    fail("no sixels come")
bands = found.group(3).count(b"-")
if bands != -(-height // 6):
    fail(f"{bands} bands of sixels for {height} rows")
terminal.leave()

# Who is not known by its environment is asked, and shows pictures by what it answers.
XTERM, VT340 = b"\x1b[?64;1;2;6;22c", b"\x1b[?63;1;2;4;6;9;15;22c"
KITTY, NO_KITTY = b"\x1b_Gi=31;OK\x1b\\", b"\x1b_Gi=31;EINVAL:no\x1b\\"
SHOWN = {
    "kitty": lambda text: b"a=T,f=100" in text,
    "iterm2": lambda text: b"\x1b]1337;File=" in text,
    "sixel": lambda text: b"\x1bP0;1q" in text,
    "blocks": lambda text: "\u2580".encode() in text,
}
for shown, answer, variables, is_asked in [
    ("kitty", KITTY + b"\x1b[?62;c", {}, True),
    ("kitty", KITTY + VT340, {}, True),
    ("sixel", VT340, {}, True),
    ("sixel", NO_KITTY + VT340, {}, True),
    ("blocks", XTERM, {}, True),
    ("blocks", None, {}, True),
    ("iterm2", XTERM, {"LC_TERMINAL": "iTerm2"}, False),
    ("iterm2", VT340, {"TERM_PROGRAM": "WezTerm"}, False),
    ("kitty", XTERM, {"KITTY_WINDOW_ID": "1"}, False),
    ("blocks", KITTY + VT340, {"TMUX": "/tmp/tmux"}, False),
]:
    terminal = Terminal(answer=answer, variables=variables)
    text = terminal.first()
    for how, is_there in SHOWN.items():
        if is_there(text) != (how == shown):
            fail(f"a terminal that answers {answer} with {variables} gets {how}, not {shown}")
    if bool(terminal.asked) != is_asked:
        fail(f"a terminal with {variables} is {'not ' if is_asked else ''}asked")
    # What it answered is no key: the picture stays until one is pressed.
    if terminal.read(quiet=0.4):
        fail(f"the answer {answer} does something")
    terminal.leave()
# A flag decides without asking.
terminal = Terminal("--graphics", "blocks", answer=KITTY + VT340)
if not SHOWN["blocks"](terminal.first()) or terminal.asked:
    fail("a terminal is asked in spite of --graphics")
terminal.leave()

# Without a terminal, it says so.
with tempfile.TemporaryFile() as said:
    done = subprocess.run(
        [PROGRAM, "view", "demo:plane", "--terminal"], stdin=subprocess.DEVNULL, stdout=said, stderr=subprocess.PIPE
    )
    if done.returncode != 1 or b"terminal" not in done.stderr:
        fail(f"without a terminal: {done.returncode} {done.stderr}")
print("the terminal: as promised")
