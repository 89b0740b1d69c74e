"""Findings equal those of the program."""

import json
import subprocess

import luxel
import pytest

KEYS = ("kind", "count", "severity", "pixels", "places")


def of_program(program: str, model: str) -> list[dict]:
    done = subprocess.run([program, "check", model, "--json"], capture_output=True)
    assert done.returncode in (0, 3), done.stderr
    return [{key: finding.get(key) for key in KEYS} for finding in json.loads(done.stdout)["findings"]]


def of_package(model: str) -> list[dict]:
    return [{key: finding[key] for key in KEYS} for finding in luxel.load(model).check()]


@pytest.mark.parametrize("name", [name for name in luxel.demos() if name != "blob"])
def test_demos_have_other_findings_than_in_the_program(program, name):
    assert json.loads(json.dumps(of_package(f"demo:{name}"))) == of_program(program, f"demo:{name}")


@pytest.mark.parametrize("name", ["suzanne.ply", "two_objects_ascii.stl", "Fox.glb", "teapot.obj", "cycloidal.ply"])
def test_models_have_other_findings_than_in_the_program(program, models, name):
    path = str(models / name)
    assert json.loads(json.dumps(of_package(path))) == of_program(program, path)


def test_a_sound_mesh_has_findings():
    assert luxel.load("demo:spheres").check((64, 64)) is not None
