"""Lists of tasks from Python, into folders and stores: the same outputs as the program's."""

import json
import pathlib
import re
import subprocess
import sys

import luxel
import luxel.batch
import pytest

PAGE = pathlib.Path(__file__).parents[2] / "docs" / "batch.md"


def tasks_in(folder: pathlib.Path, count: int = 12) -> str:
    triangle = "\n".join(["v 0 0 0", "v 1 0 0", "v 0 1 0", "f 1 2 3"])
    (folder / "triangle.obj").write_text(triangle)
    lines = [
        json.dumps(
            {
                "id": f"task {number}",
                "model": "triangle.obj" if number % 2 else "demo:plane",
                "views": [{"azimuth": number}, {"azimuth": number, "elevation": 50, "name": "high"}],
                "size": "24x16",
                "layers": ["rgba", "z"],
            }
        )
        for number in range(count)
    ]
    (folder / "tasks.jsonl").write_text("\n".join(lines))
    return str(folder / "tasks.jsonl")


@pytest.fixture
def tasks(tmp_path: pathlib.Path) -> str:
    return tasks_in(tmp_path)


def test_a_folder_has_another_manifest_than_the_program_s(program, tasks, tmp_path):
    manifest = luxel.batch.run(tasks, tmp_path / "ours", workers=2)
    subprocess.run([program, "batch", tasks, "-o", str(tmp_path / "theirs"), "-q"], check=True)
    assert manifest == json.loads((tmp_path / "theirs" / "manifest.json").read_bytes())
    assert manifest["root"] == luxel.batch.root([output["sha256"] for output in manifest["outputs"]])
    assert luxel.batch.verify(tasks, tmp_path / "ours", sample=3) == []
    assert luxel.batch.run(tasks, tmp_path / "ours") == manifest


def test_a_store_has_other_outputs_than_a_folder(tasks, tmp_path):
    fsspec = pytest.importorskip("fsspec")
    expected = luxel.batch.run(tasks, tmp_path / "folder")
    done: list[int] = []
    stored = luxel.batch.run(tasks, "memory://outputs", workers=2, progress=done.append)
    assert stored == expected
    assert done == list(range(13))
    files = fsspec.filesystem("memory")
    for output in stored["outputs"]:
        same = (tmp_path / "folder" / output["path"]).read_bytes()
        assert files.cat_file(f"/outputs/{output['path']}") == same
    assert json.loads(files.cat_file("/outputs/manifest.json")) == expected
    # Nothing is drawn twice.
    luxel.batch.run(tasks, "memory://outputs", progress=done.append)
    assert done[13:] == [12]
    assert luxel.batch.run(tasks, (tmp_path / "url").as_uri()) == expected


def test_a_task_in_memory_has_other_bytes_than_in_a_folder(tasks, tmp_path):
    luxel.batch.run(tasks, tmp_path / "out")
    for line in pathlib.Path(tasks).read_text().splitlines()[:3]:
        drawn = luxel.batch.draw(line, tmp_path)
        assert len(drawn["outputs"]) == 4
        for output in drawn["outputs"]:
            assert (tmp_path / "out" / output["path"]).read_bytes() == output["data"]


def test_failures_are_lost_or_end_the_run(tasks, tmp_path):
    with open(tasks, "a") as file:
        file.write('\n{"id": "bad", "model": "missing.glb"}\n{"id": "odd", "model": "triangle.obj", "size": 7}\n{no')
    folder = luxel.batch.run(tasks, tmp_path / "out")
    assert [task["id"] for task in folder["failed"]] == ["bad", "odd", None]
    assert folder["failed"][1]["error"].startswith("tasks.jsonl:14: `size`: ")
    pytest.importorskip("fsspec")
    stored = luxel.batch.run(tasks, "memory://failures")
    assert stored["outputs"] == folder["outputs"]
    assert [task["id"] for task in stored["failed"]] == ["bad", "odd", None]
    assert stored["failed"][:2] == folder["failed"][:2]


def test_what_can_not_be_done_is_no_exception(tasks, tmp_path):
    with pytest.raises(luxel.Error, match="No such file"):
        luxel.batch.run(tmp_path / "none.jsonl", tmp_path / "out")
    (tmp_path / "file").write_text("")
    with pytest.raises(luxel.Error, match="can't be written"):
        luxel.batch.run(tasks, tmp_path / "file")
    with pytest.raises(luxel.Error, match="did you mean `size`"):
        luxel.batch.draw({"id": "a", "model": "demo:teapot", "sise": "8x8"})
    with pytest.raises(luxel.Error, match="manifest.json"):
        luxel.batch.verify(tasks, tmp_path / "empty")
    with pytest.raises(ValueError, match="SHA-256"):
        luxel.batch.root(["0"])


def test_the_page_s_root_is_wrong(tasks, tmp_path, monkeypatch):
    luxel.batch.run(tasks, tmp_path / "out")
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"```python\n(.*?)```", PAGE.read_text("utf-8"), re.S)
    names: dict = {}
    for block in blocks:
        exec(compile(block, str(PAGE), "exec"), names)  # noqa: S102
    import hashlib

    digests = [hashlib.sha256(letter).hexdigest() for letter in (b"a", b"b", b"c")]
    assert names["root"](digests) == luxel.batch.root(digests)
    assert luxel.batch.root(digests) in PAGE.read_text("utf-8")


def test_the_program_of_the_wheel_draws_other_bytes(run, tmp_path):
    line = ["render", "demo:spheres", "--size", "64x48"]
    out = tmp_path / "wheel.png"
    subprocess.run([sys.executable, "-m", "luxel", *line, "-o", str(out)], check=True, capture_output=True)
    assert out.read_bytes() == run(*line, suffix=".png")
    wrong = subprocess.run([sys.executable, "-m", "luxel", "render", "none.glb", "-o", "x.png"], capture_output=True)
    assert wrong.returncode == 1 and b"No such file" in wrong.stderr
