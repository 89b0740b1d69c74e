"""The program `luxel`, as `python -m luxel`: all of it but the window and the gallery."""

import signal
import sys

from ._luxel import run_program


def main() -> None:
    """Runs the program with the arguments of the process."""
    # The program handles interrupts itself, or ends by them.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    sys.exit(run_program([sys.executable, "-m", "luxel"], ["luxel", *sys.argv[1:]]))


if __name__ == "__main__":
    main()
