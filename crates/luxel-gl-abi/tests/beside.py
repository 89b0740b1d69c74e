#!/usr/bin/env python3
"""Runs programs twice, on Mesa's libOSMesa and on luxel's, and compares what they draw and say.

    crates/luxel-gl-abi/tests/beside.py LIBRARIES WORK PROGRAM...

LIBRARIES is the folder with luxel's libOSMesa.so.8; PROGRAMs are those of crates/luxel-gl-abi/tests/programs, compiled,
or Python scripts for PyOpenGL. Their words must be equal. Of their pictures each colour must be within 2 of 255 of the
other library's, but at edges, where it may be any of the pixels around: rules for samples on an edge leave libraries
some room. Pictures go to WORK.
"""

import os
import pathlib
import subprocess
import sys

TOLERANCE = 2
# The part of all pixels that may lie at edges and differ.
MOST_AT_EDGES = 0.01


def picture(path: pathlib.Path) -> tuple[int, int, bytes]:
    """Width, height and RGBA of a PAM file."""
    head, body = path.read_bytes().split(b"ENDHDR\n", 1)
    fields = dict(line.split(b" ", 1) for line in head.splitlines() if b" " in line)
    return int(fields[b"WIDTH"]), int(fields[b"HEIGHT"]), body


def differences(mesa: pathlib.Path, luxel: pathlib.Path) -> tuple[int, list[tuple[int, int]]]:
    """How many pixels differ at edges, and which ones elsewhere."""
    width, height, expected = picture(mesa)
    if (width, height) != picture(luxel)[:2]:
        raise SystemExit(f"{luxel}: another size than {mesa}")
    actual = picture(luxel)[2]
    at_edges, elsewhere = 0, []
    for y in range(height):
        row = 4 * width * y
        if expected[row : row + 4 * width] == actual[row : row + 4 * width]:
            continue
        for x in range(width):
            at = row + 4 * x
            if all(abs(expected[at + c] - actual[at + c]) <= TOLERANCE for c in range(4)):
                continue
            around = [
                4 * (width * v + u)
                for v in range(max(y - 1, 0), min(y + 2, height))
                for u in range(max(x - 1, 0), min(x + 2, width))
            ]
            inside = all(
                min(expected[p + c] for p in around) - TOLERANCE
                <= actual[at + c]
                <= max(expected[p + c] for p in around) + TOLERANCE
                for c in range(4)
            )
            if inside:
                at_edges += 1
            else:
                elsewhere.append((x, y))
    return at_edges, elsewhere


def run(program: pathlib.Path, output: pathlib.Path, libraries: str | None) -> str:
    """What the program says; its picture goes to `output`."""
    environment = dict(os.environ, PYOPENGL_PLATFORM="osmesa", LP_NUM_THREADS="2")
    if libraries is not None:
        environment["LD_LIBRARY_PATH"] = libraries
    command = [sys.executable, program] if program.suffix == ".py" else [program]
    result = subprocess.run([*command, output], env=environment, capture_output=True, text=True, timeout=300)
    if result.returncode != 0:
        return f"ends with {result.returncode}: {result.stderr.strip()}"
    return result.stdout


def main() -> int:
    libraries, work, programs = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
    work.mkdir(parents=True, exist_ok=True)
    failed = 0
    for program in (pathlib.Path(name).resolve() for name in programs):
        mesa, luxel = work / f"{program.stem}.mesa.pam", work / f"{program.stem}.luxel.pam"
        for path in (mesa, luxel):
            path.unlink(missing_ok=True)
        expected, actual = run(program, mesa, None), run(program, luxel, libraries)
        faults = []
        if expected != actual:
            lines = list(zip(expected.splitlines(), actual.splitlines()))
            unequal = [f"Mesa: {a} | luxel: {b}" for a, b in lines if a != b]
            if len(expected.splitlines()) != len(actual.splitlines()):
                unequal.append(f"Mesa has {len(expected.splitlines())} lines, luxel {len(actual.splitlines())}")
            faults += unequal[:20]
        note = "no pictures"
        if mesa.exists() and luxel.exists():
            at_edges, elsewhere = differences(mesa, luxel)
            note = f"{at_edges} pixels differ at edges"
            if elsewhere:
                faults.append(f"{len(elsewhere)} pixels differ elsewhere, the first at {elsewhere[0]}")
            if at_edges > MOST_AT_EDGES * picture(mesa)[0] * picture(mesa)[1]:
                faults.append("too many pixels differ at edges")
        elif mesa.exists() != luxel.exists():
            faults.append("one library drew no picture")
        print(f"{program.stem}: {'FAILED' if faults else 'equal'}, {note}", *faults, sep="\n    ")
        failed += bool(faults)
    return failed != 0


if __name__ == "__main__":
    sys.exit(main())
