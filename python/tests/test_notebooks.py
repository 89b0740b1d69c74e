"""The notebooks run from top to bottom, and are saved with what they show; skipped aloud without nbclient."""

import pathlib

import pytest

nbformat = pytest.importorskip("nbformat")
nbclient = pytest.importorskip("nbclient")
pytest.importorskip("ipykernel")

FOLDER = pathlib.Path(__file__).parents[1] / "notebooks"
NOTEBOOKS = sorted(FOLDER.glob("*.ipynb"))


def pictures(cell) -> list[str]:
    return [output.data["image/png"] for output in cell.get("outputs", []) if "image/png" in output.get("data", {})]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_does_not_run_or_is_saved_with_other_pictures(path, tmp_path):
    saved = nbformat.read(path, as_version=4)
    again = nbformat.read(path, as_version=4)
    nbformat.validate(saved)
    nbclient.NotebookClient(again, timeout=120, resources={"metadata": {"path": str(tmp_path)}}).execute()
    for number, (before, after) in enumerate(zip(saved.cells, again.cells, strict=True)):
        assert [text.strip() for text in pictures(before)] == [text.strip() for text in pictures(after)], f"cell {number}"
        if before.cell_type == "code":
            assert before.execution_count, f"cell {number} is saved without having run"


def test_a_notebook_is_missing_or_too_large():
    assert [path.stem for path in NOTEBOOKS] == [
        "check-a-folder-of-meshes", "dataset-of-masks", "picking-in-a-picture", "why-is-this-pixel-dark",
    ]  # fmt: skip
    for path in NOTEBOOKS:
        assert path.stat().st_size < 300_000, f"{path.name} is too large"
