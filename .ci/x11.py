#!/usr/bin/env python3
"""What other programs do with a window. `drop WINDOW FILE...` drops files onto it, as a file manager does:
the source's side of XDND, version 5 (https://www.freedesktop.org/wiki/Specifications/XDND/). `clipboard`
prints the text that is in the clipboard (ICCCM, section 2); `copy TEXT` offers one until it is asked for;
`look WINDOW` prints a number that tells what it shows from other things."""

import ctypes
import os
import pathlib
import sys
import time
import zlib

X = ctypes.CDLL("libX11.so.6")
ulong, long, c_int, pointer = ctypes.c_ulong, ctypes.c_long, ctypes.c_int, ctypes.c_void_p


class ClientMessage(ctypes.Structure):
    _fields_ = [
        ("type", c_int),
        ("serial", ulong),
        ("send_event", c_int),
        ("display", pointer),
        ("window", ulong),
        ("message_type", ulong),
        ("format", c_int),
        ("data", long * 5),
    ]


class SelectionRequest(ctypes.Structure):
    _fields_ = [
        ("type", c_int),
        ("serial", ulong),
        ("send_event", c_int),
        ("display", pointer),
        ("owner", ulong),
        ("requestor", ulong),
        ("selection", ulong),
        ("target", ulong),
        ("property", ulong),
        ("time", ulong),
    ]


class SelectionNotify(ctypes.Structure):
    _fields_ = [
        ("type", c_int),
        ("serial", ulong),
        ("send_event", c_int),
        ("display", pointer),
        ("requestor", ulong),
        ("selection", ulong),
        ("target", ulong),
        ("property", ulong),
        ("time", ulong),
    ]


class Event(ctypes.Union):
    _fields_ = [
        ("type", c_int),
        ("client", ClientMessage),
        ("request", SelectionRequest),
        ("notify", SelectionNotify),
        ("pad", long * 24),
    ]


CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31
X.XOpenDisplay.restype = pointer
X.XOpenDisplay.argtypes = [ctypes.c_char_p]
X.XDefaultRootWindow.restype = ulong
X.XDefaultRootWindow.argtypes = [pointer]
X.XCreateSimpleWindow.restype = ulong
X.XCreateSimpleWindow.argtypes = [pointer, ulong, c_int, c_int] + [ctypes.c_uint] * 3 + [ulong] * 2
X.XInternAtom.restype = ulong
X.XInternAtom.argtypes = [pointer, ctypes.c_char_p, c_int]
X.XSendEvent.argtypes = [pointer, ulong, c_int, long, ctypes.POINTER(Event)]
X.XSetSelectionOwner.argtypes = [pointer, ulong, ulong, ulong]
X.XChangeProperty.argtypes = [pointer, ulong, ulong, ulong, c_int, c_int, ctypes.c_char_p, c_int]
X.XPending.argtypes = X.XFlush.argtypes = [pointer]
X.XNextEvent.argtypes = [pointer, ctypes.POINTER(Event)]

X.XConvertSelection.argtypes = [pointer] + [ulong] * 5
X.XGetWindowProperty.argtypes = [pointer, ulong, ulong, long, long, c_int, ulong] + [pointer] * 5

display = X.XOpenDisplay(None)
if not display:
    sys.exit("no display")
root = X.XDefaultRootWindow(display)
own = X.XCreateSimpleWindow(display, root, 0, 0, 1, 1, 0, 0, 0)
NOW = 0


def atom(name):
    return X.XInternAtom(display, name.encode(), 0)


def events(seconds):
    """What happens, as long as that."""
    end = time.time() + seconds
    while time.time() < end:
        if not X.XPending(display):
            time.sleep(0.01)
            continue
        event = Event()
        X.XNextEvent(display, ctypes.byref(event))
        yield event


def hand_out(asked, data):
    """Answers who has asked for a selection."""
    X.XChangeProperty(display, asked.requestor, asked.property, asked.target, 8, 0, data, len(data))
    told = Event()
    told.notify.type = SELECTION_NOTIFY
    told.notify.display = display
    told.notify.requestor = asked.requestor
    told.notify.selection = asked.selection
    told.notify.target = asked.target
    told.notify.property = asked.property
    told.notify.time = asked.time
    X.XSendEvent(display, asked.requestor, 0, 0, ctypes.byref(told))
    X.XFlush(display)


def drop(target, files):
    def send(name, *data):
        event = Event()
        event.client.type = CLIENT_MESSAGE
        event.client.display = display
        event.client.window = target
        event.client.message_type = atom(name)
        event.client.format = 32
        for at, value in enumerate((own,) + data):
            event.client.data[at] = value
        X.XSendEvent(display, target, 0, 0, ctypes.byref(event))
        X.XFlush(display)

    def answer_until(name):
        """Hands out the list of files until the window sends a message; its numbers."""
        for event in events(10):
            if event.type == CLIENT_MESSAGE and event.client.message_type == atom(name):
                return list(event.client.data)
            if event.type == SELECTION_REQUEST:
                hand_out(event.request, "".join(pathlib.Path(file).as_uri() + "\r\n" for file in files).encode())
        sys.exit(f"the window never sends {name}")

    X.XSetSelectionOwner(display, atom("XdndSelection"), own, NOW)
    send("XdndEnter", 5 << 24, atom("text/uri-list"), 0, 0)
    send("XdndPosition", 0, (200 << 16) | 200, NOW, atom("XdndActionCopy"))
    # Whether it takes them: the lowest bit.
    if not answer_until("XdndStatus")[1] & 1:
        sys.exit("the window takes no files")
    send("XdndDrop", 0, NOW)
    answer_until("XdndFinished")


def clipboard():
    name = atom("LUXEL_TEST")
    X.XConvertSelection(display, atom("CLIPBOARD"), atom("UTF8_STRING"), name, own, NOW)
    X.XFlush(display)
    for event in events(10):
        if event.type != SELECTION_NOTIFY:
            continue
        if not event.notify.property:
            sys.exit("the clipboard holds no text")
        kind, form, count, left, data = ulong(), c_int(), ulong(), ulong(), ctypes.c_char_p()
        places = [ctypes.byref(place) for place in (kind, form, count, left, data)]
        X.XGetWindowProperty(display, own, name, 0, 1 << 20, 0, 0, *places)
        return ctypes.string_at(data, count.value).decode()
    sys.exit("the clipboard's owner never answers")


def copy(text):
    X.XSetSelectionOwner(display, atom("CLIPBOARD"), own, NOW)
    X.XFlush(display)
    print("ready", flush=True)
    for event in events(20):
        if event.type == SELECTION_REQUEST:
            if event.request.target == atom("UTF8_STRING"):
                hand_out(event.request, text.encode())
                return
            # Only text, and only of this kind.
            event.request.property = 0
            hand_out(event.request, b"")
    sys.exit("nobody asks for the text")


class Image(ctypes.Structure):
    """The beginning of XImage."""

    _fields_ = [("width", c_int), ("height", c_int), ("offset", c_int), ("format", c_int), ("data", pointer)] + [
        (name, c_int) for name in ("byte_order", "unit", "bit_order", "pad", "depth", "bytes_per_line")
    ]


def look(window):
    X.XGetImage.restype = ctypes.POINTER(Image)
    X.XGetImage.argtypes = [pointer, ulong, c_int, c_int, ctypes.c_uint, ctypes.c_uint, ulong, c_int]
    X.XGetGeometry.argtypes = [pointer, ulong] + [pointer] * 7
    numbers = [ulong()] + [c_int() for _ in range(6)]
    X.XGetGeometry(display, window, *[ctypes.byref(number) for number in numbers])
    width, height = numbers[3].value, numbers[4].value
    z_pixmap = 2
    image = X.XGetImage(display, window, 0, 0, width, height, ~0 & 0xFFFFFFFF, z_pixmap).contents
    return zlib.crc32(ctypes.string_at(image.data, image.bytes_per_line * height))


if sys.argv[1] == "drop":
    drop(int(sys.argv[2]), [os.path.abspath(name) for name in sys.argv[3:]])
elif sys.argv[1] == "look":
    print(look(int(sys.argv[2])))
elif sys.argv[1] == "copy":
    copy(sys.argv[2])
else:
    print(clipboard())
