"""Builds the package from its sources by maturin, and says so where Rust is missing or too old.

maturin would fetch a compiler of its own instead.
"""

import os
import re
import shutil
import subprocess
import sys

from maturin import *  # noqa: F403
from maturin import build_editable as maturin_editable
from maturin import build_wheel as maturin_wheel
from maturin import prepare_metadata_for_build_wheel as maturin_metadata

OLDEST = (1, 89)


def check_rust() -> None:
    """Ends the program unless there is a Rust that compiles luxel."""
    cargo = os.environ.get("CARGO", "cargo")
    found = "there is none"
    if shutil.which(cargo):
        version = subprocess.run([cargo, "--version"], capture_output=True, text=True, check=False).stdout
        numbers = re.match(r"cargo (\d+)\.(\d+)", version)
        if numbers and (int(numbers[1]), int(numbers[2])) >= OLDEST:
            return
        found = f"there is {version.strip() or 'one that does not run'}"
    sys.exit(
        f"luxel: to build it from its sources takes Rust {OLDEST[0]}.{OLDEST[1]} or later with cargo; {found}.\n"
        "Install Rust from https://rustup.rs, or a wheel of luxel, which needs none: pip install --only-binary luxel luxel"
    )


def get_requires_for_build_wheel(config_settings=None):
    check_rust()
    return []


get_requires_for_build_editable = get_requires_for_build_wheel


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    check_rust()
    return maturin_metadata(metadata_directory, config_settings)


prepare_metadata_for_build_editable = prepare_metadata_for_build_wheel


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    check_rust()
    return maturin_wheel(wheel_directory, config_settings, metadata_directory)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    check_rust()
    return maturin_editable(wheel_directory, config_settings, metadata_directory)
