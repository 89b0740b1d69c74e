"""The examples of docs/python.md run, in their order."""

import pathlib
import re

import luxel
import luxel.pyrender
import pytest

PAGE = pathlib.Path(__file__).parents[2] / "docs" / "python.md"


def run(kind: str, names: dict) -> dict:
    """Runs the blocks of a kind; the names that are known then."""
    blocks = re.findall(rf"```{kind}\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.S)
    assert len(blocks) > 1
    for block in blocks:
        exec(compile(block, str(PAGE), "exec"), names)  # noqa: S102
    return names


def test_examples_run(capsys):
    names = run("python", {})
    said = capsys.readouterr().out
    assert "N.L" in said and names["mask"].any()
    assert names["why"].rgba == tuple(names["view"].render().rgba[240, 320])
    assert names["png"].startswith(b"\x89PNG") and names["html"].startswith("<!doctype html>")


def test_examples_with_trimesh_run():
    pytest.importorskip("trimesh")
    names = run("python trimesh", {"luxel": luxel, "pyrender": luxel.pyrender})
    assert names["places"].shape == (2, 3)
