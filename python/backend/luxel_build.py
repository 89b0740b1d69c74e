"""Build backend: maturin, with a clear error if Rust is missing or too old.

maturin alone would download a compiler.
"""

import os
import re
import shutil
import subprocess
import sys

import maturin
from maturin import build_editable, build_sdist, build_wheel, get_requires_for_build_sdist

__all__ = [
    "build_editable",
    "build_sdist",
    "build_wheel",
    "get_requires_for_build_editable",
    "get_requires_for_build_sdist",
    "get_requires_for_build_wheel",
    "prepare_metadata_for_build_editable",
    "prepare_metadata_for_build_wheel",
]

# `rust-version` in Cargo.toml.
OLDEST = (1, 89)


def check_rust() -> None:
    """Exits with a message unless a Rust is installed that compiles luxel."""
    cargo = os.environ.get("CARGO", "cargo")
    found = "cargo was not found"
    if shutil.which(cargo):
        version = subprocess.run([cargo, "--version"], capture_output=True, text=True, check=False).stdout
        numbers = re.match(r"cargo (\d+)\.(\d+)", version)
        if numbers and (int(numbers[1]), int(numbers[2])) >= OLDEST:
            return
        found = f"found {version.strip() or 'a cargo that does not run'}"
    sys.exit(
        f"luxel: building from source requires Rust {OLDEST[0]}.{OLDEST[1]} or later; {found}.\n"
        "Install Rust from https://rustup.rs, or use a wheel, which needs no Rust: pip install --only-binary luxel luxel"
    )


def get_requires_for_build_wheel(config_settings=None):
    check_rust()
    return []


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    # Without build isolation, pip calls this one first.
    check_rust()
    return maturin.prepare_metadata_for_build_wheel(metadata_directory, config_settings)


get_requires_for_build_editable = get_requires_for_build_wheel
prepare_metadata_for_build_editable = prepare_metadata_for_build_wheel
