"""Programs and models that the tests compare with."""

import os
import pathlib
import subprocess

import pytest


@pytest.fixture(scope="session")
def program() -> str:
    """The program `luxel`, whose bytes are the measure."""
    path = os.environ.get("LUXEL_PROGRAM")
    if not path:
        pytest.skip("LUXEL_PROGRAM doesn't name the program luxel")
    return path


@pytest.fixture(scope="session")
def models() -> pathlib.Path:
    """A folder of models."""
    path = os.environ.get("LUXEL_TEST_MODELS")
    if not path:
        pytest.skip("LUXEL_TEST_MODELS doesn't name a folder")
    return pathlib.Path(path)


@pytest.fixture
def run(program, tmp_path):
    """Runs the program; what it wrote."""

    def run(*arguments: str, suffix: str | None = None) -> bytes:
        out = ["-o", str(tmp_path / f"out{suffix}")] if suffix else []
        done = subprocess.run([program, *arguments, *out], check=True, capture_output=True)
        return (tmp_path / f"out{suffix}").read_bytes() if suffix else done.stdout

    return run
