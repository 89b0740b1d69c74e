#!/usr/bin/env python3
"""Times calls.c on Mesa's libOSMesa and on luxel's, in turns, so that both meet the same machine.

    benches/rivals/gl/speed.py LIBRARIES CALLS [TURNS [THREADS]]

LIBRARIES is the folder with luxel's libOSMesa.so.8, CALLS the compiled program. Prints medians over all turns and their
quotient; only quotients of one run count.
"""

import os
import statistics
import subprocess
import sys


def run(program: str, libraries: str | None, threads: str) -> dict[str, float]:
    environment = dict(os.environ, LP_NUM_THREADS=threads, RAYON_NUM_THREADS=threads)
    if libraries is not None:
        environment["LD_LIBRARY_PATH"] = libraries
    output = subprocess.run([program], env=environment, capture_output=True, text=True, check=True).stdout
    pairs = (line.split() for line in output.splitlines())
    return {pair[0]: float(pair[1]) for pair in pairs if len(pair) == 2}


def main() -> None:
    libraries, program = sys.argv[1:3]
    turns = int(sys.argv[3]) if len(sys.argv) > 3 else 3
    threads = sys.argv[4] if len(sys.argv) > 4 else "2"
    mesa, luxel = [], []
    for _ in range(turns):
        mesa.append(run(program, None, threads))
        luxel.append(run(program, libraries, threads))
    print(f"{'ms, median':24} {'Mesa':>9} {'luxel':>9} {'luxel/Mesa':>11}")
    for name in mesa[0]:
        a = statistics.median(turn[name] for turn in mesa)
        b = statistics.median(turn[name] for turn in luxel)
        print(f"{name:24} {a:9.3f} {b:9.3f} {b / a if a else 0:11.2f}")


if __name__ == "__main__":
    main()
