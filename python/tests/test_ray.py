"""Lists of tasks over Ray Data; needs Ray, else it is skipped aloud."""

import json
import os
import pathlib
import signal
import threading

import luxel.batch
import pytest
from test_batch import tasks_in

ray = pytest.importorskip("ray")
pytest.importorskip("ray.data")


@pytest.fixture(scope="module")
def cluster():
    ray.init(num_cpus=8, log_to_driver=False, include_dashboard=False)
    yield
    ray.shutdown()


@pytest.mark.parametrize("actors", [1, 2, 8])
def test_the_root_depends_on_actors(cluster, tmp_path, actors):
    import luxel.ray

    tasks = tasks_in(tmp_path, 40)
    expected = luxel.batch.run(tasks, tmp_path / "one")
    manifest = luxel.ray.run(tasks, tmp_path / "many", actors=actors)
    assert manifest == expected
    assert json.loads((tmp_path / "many" / "manifest.json").read_bytes()) == expected
    assert not (tmp_path / "many" / ".parts").exists()
    assert luxel.batch.verify(tasks, tmp_path / "many", sample=5) == []
    # What is whole is not drawn again, and what is lost is.
    entry = next(pathlib.Path(tmp_path / "many" / "log").rglob("*.json"))
    entry.unlink()
    assert luxel.ray.run(tasks, tmp_path / "many", actors=actors) == expected


@pytest.mark.skipif(not pathlib.Path("/proc").exists(), reason="processes are found in /proc")
def test_a_killed_actor_loses_or_changes_outputs(cluster, tmp_path):
    import luxel.ray

    tasks = tasks_in(tmp_path, 1500)
    expected = luxel.batch.run(tasks, tmp_path / "one")
    killed: list[int] = []
    ended = threading.Event()

    def kill() -> None:
        while not ended.wait(0.3) and len(killed) < 3:
            if not (tmp_path / "many" / "log").exists():
                continue
            for status in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
                try:
                    is_actor = status.read_bytes().startswith(b"ray::MapWorker")
                    if is_actor:
                        killed.append(int(status.parent.name))
                        os.kill(killed[-1], signal.SIGKILL)
                        break
                except OSError:
                    continue

    killer = threading.Thread(target=kill)
    killer.start()
    try:
        manifest = luxel.ray.run(tasks, tmp_path / "many", actors=2)
    finally:
        ended.set()
        killer.join()
    assert killed, "no actor was killed"
    assert manifest == expected
    assert luxel.batch.verify(tasks, tmp_path / "many", sample=0) == []


def test_a_task_that_fails_ends_the_run(cluster, tmp_path):
    import luxel.ray

    tasks = tasks_in(tmp_path, 4)
    with open(tasks, "a") as file:
        file.write('\n{"id": "bad", "model": "missing.glb"}\n{no')
    manifest = luxel.ray.run(tasks, tmp_path / "out", actors=2)
    assert [task["id"] for task in manifest["failed"]] == ["bad", None]
    assert len(manifest["outputs"]) == 16
