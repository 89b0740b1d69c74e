"""The examples of docs/python.md run, in their order."""

import pathlib
import re


def test_examples_run(capsys):
    page = pathlib.Path(__file__).parents[2] / "docs" / "python.md"
    blocks = re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.S)
    assert len(blocks) > 5
    names: dict = {}
    for block in blocks:
        exec(compile(block, str(page), "exec"), names)  # noqa: S102
    said = capsys.readouterr().out
    assert "N.L" in said and names["mask"].any()
    assert names["why"].rgba == tuple(names["view"].render().rgba[240, 320])
    assert names["png"].startswith(b"\x89PNG") and names["html"].startswith("<!doctype html>")
