"""The example of a data set: 12 views with layers of each model of a folder, by one machine or over Ray."""

import importlib.util
import json
import pathlib
import subprocess
import sys

import numpy as np
import pytest

EXAMPLE = pathlib.Path(__file__).parents[1] / "examples" / "dataset.py"


def draw(models: pathlib.Path, out: str, *flags: str) -> subprocess.CompletedProcess[str]:
    line = [sys.executable, str(EXAMPLE), str(models), out, "--size", "16x12", *flags]
    return subprocess.run(line, capture_output=True, text=True, check=False)


@pytest.fixture
def models(tmp_path: pathlib.Path) -> pathlib.Path:
    folder = tmp_path / "models"
    (folder / "more").mkdir(parents=True)
    (folder / "triangle.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    (folder / "more" / "square.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
    (folder / "readme.txt").write_text("no model")
    return folder


def test_the_example_leaves_views_or_layers_out(models, tmp_path):
    done = draw(models, str(tmp_path / "out"))
    assert done.returncode == 0, done.stderr
    manifest = json.loads((tmp_path / "out" / "manifest.json").read_bytes())
    expected = [
        (task, view, layer)
        for task in ("more/square.obj", "triangle.obj")
        for view in range(12)
        for layer in ("rgba", "z", "normal", "object", "triangle")
    ]
    assert [(output["task"], output["view"], output["layer"]) for output in manifest["outputs"]] == expected
    numbers = {output["layer"]: np.load(tmp_path / "out" / output["path"]) for output in manifest["outputs"][1:5]}
    assert numbers["normal"].shape == (12, 16, 3)
    assert np.isfinite(numbers["z"]).sum() == (numbers["object"] == 0).sum() > 20


def test_the_example_hides_a_model_that_can_not_be_read(models, tmp_path):
    (models / "broken.obj").write_text("v 0 0 0\nf 1 2 3\n")
    done = draw(models, str(tmp_path / "out"))
    assert done.returncode == 1
    assert "2 models" not in done.stdout and "3 models, 120 files, 1 failed" in done.stdout
    assert "broken.obj:2" in done.stderr


@pytest.mark.skipif(importlib.util.find_spec("ray") is None, reason="Ray is not installed")
def test_the_example_draws_other_files_over_ray(models, tmp_path):
    done = draw(models, str(tmp_path / "out"), "--ray", "--actors", "2")
    assert done.returncode == 0, done.stderr
    draw(models, str(tmp_path / "one"))
    one, many = (json.loads((tmp_path / out / "manifest.json").read_bytes()) for out in ("one", "out"))
    assert one == many
