"""The build from sources, as pip starts it."""

import os
import pathlib
import re
import subprocess
import sys

import pytest

BACKEND = pathlib.Path(__file__).parent.parent / "backend"
CALL = "import luxel_build; print(luxel_build.get_requires_for_build_wheel())"


@pytest.mark.parametrize(("answer", "found"), [(None, "cargo was not found"), ("cargo 1.70.0 (ec8a8a0ca)", "cargo 1.70.0"),
                                               ("cargo 1.89.0 (c24e10642)", None), ("cargo 2.0.0", None)])  # fmt: skip
def test_a_missing_or_old_rust_is_reported_with_its_remedy(tmp_path, answer, found):
    # In place of maturin, which isn't installed here.
    hooks = ["build_editable", "build_sdist", "build_wheel", "get_requires_for_build_sdist"]
    (tmp_path / "maturin.py").write_text("\n".join(f"def {hook}(*_): pass" for hook in hooks))
    cargo = tmp_path / "cargo"
    if answer:
        cargo.write_text(f"#!/bin/sh\necho '{answer}'\n")
        cargo.chmod(0o755)
    environment = os.environ | {"CARGO": str(cargo), "PYTHONPATH": f"{BACKEND}{os.pathsep}{tmp_path}"}
    run = subprocess.run([sys.executable, "-c", CALL], env=environment, capture_output=True, text=True, check=False)
    if found is None:
        assert (run.returncode, run.stdout) == (0, "[]\n")
    else:
        assert run.returncode == 1
        assert found in run.stderr and "https://rustup.rs" in run.stderr and "Traceback" not in run.stderr


def test_the_oldest_rust_is_the_manifest_s():
    manifest = (BACKEND.parent / "Cargo.toml").read_text()
    major, minor = re.search(r'rust-version = "(\d+)\.(\d+)"', manifest).groups()
    assert f"OLDEST = ({major}, {minor})" in (BACKEND / "luxel_build.py").read_text()
