# SPDX-License-Identifier: MIT
"""Files, and what they say beyond numbers."""

import gzip

import pytest

import orthoball


def test_a_reading_tells_what_was_read(samples):
    reading = orthoball.read(samples / "two_balls.xyzr")
    assert reading.points.tolist() == [[0, 0, 0], [3, 0, 0]]
    assert reading.points.shape == (len(reading), reading.dimension) == (2, 3)
    assert reading.weights.tolist() == (reading.ball_radii**2).tolist()
    assert reading.decimals == 0
    assert reading.format == "xyzr"
    assert reading.file.endswith("two_balls.xyzr")
    assert reading.radii == "column 4"
    assert not reading.is_molecule
    assert reading.notes == [] and reading.warnings == []
    assert reading.labels["line"].tolist() == [1, 2]
    assert "2 sites, xyzr" in repr(reading)


def test_atoms_have_labels(samples):
    reading = orthoball.read(samples / "bdna_dodecamer.pdb", chains=["A"])
    assert reading.is_molecule
    assert set(reading.labels["chain"]) == {"A"}
    assert {len(column) for column in reading.labels.values()} == {len(reading)}
    assert reading.labels["element"][0] == "O"
    assert set(reading.labels) == {"line", "element", "atom", "residue", "residue_id", "chain"}


def test_decimal_text_is_exact(tmp_path):
    path = tmp_path / "points.csv"
    path.write_text("x,y\n0.1,0.2\n0.3,0.4\n")
    reading = orthoball.read(path)
    assert reading.decimals == 1
    assert reading.points.tolist() == [[0.1, 0.2], [0.3, 0.4]]
    shapes = orthoball.AlphaShapes(reading)
    assert shapes.decimals == 1
    assert shapes.points.tolist() == reading.points.tolist()
    # A quarter of (0.2^2 + 0.2^2), which no sum of doubles gives.
    assert shapes.spectrum.tolist() == [0, 0.02]


def test_options_are_those_of_the_program(tmp_path, samples):
    path = tmp_path / "table.txt.gz"
    path.write_bytes(gzip.compress(b"a 1 2 3 9\nb 4 5 7 16\nc 0 0 0 1\n"))
    by_weight = orthoball.read(path, format="table", columns=[2, 3], weight_column=5)
    assert by_weight.weights.tolist() == [9, 16, 1]
    by_radius = orthoball.read(path, format="table", columns=[2, 3, 4], radius_column="5")
    assert by_radius.ball_radii.tolist() == [9, 16, 1]
    assert "xyzr" in orthoball.input_formats()
    none = orthoball.read(samples / "bdna_dodecamer.pdb", radii="none")
    assert none.weights is None and none.ball_radii is None


def test_faults_name_what_python_calls_it(tmp_path):
    path = tmp_path / "points.what"
    path.write_text("1,2\n")
    with pytest.raises(orthoball.ParseError, match="name the format with format=: table, "):
        orthoball.read(path)
    empty = tmp_path / "points.csv"
    empty.write_text("x,y\n")
    with pytest.raises(orthoball.ParseError, match="allow_empty=True"):
        orthoball.read(empty)
    xyz = tmp_path / "unknown.xyz"
    xyz.write_text("1\n\nQq 0 0 0\n")
    with pytest.raises(orthoball.ParseError) as caught:
        orthoball.read(xyz)
    assert "--" not in str(caught.value)
    models = tmp_path / "models.pdb"
    atom = "ATOM      1  C   ALA A   1       1.000   2.000   3.000  1.00  0.00           C\n"
    models.write_text(f"MODEL        1\n{atom}ENDMDL\nMODEL        2\n{atom}ENDMDL\n")
    assert "model=N" in " ".join(orthoball.read(models).notes)


def test_faults_name_file_and_line(tmp_path):
    path = tmp_path / "points.csv"
    path.write_text("x,y\n0,1\n2,b\n")
    with pytest.raises(orthoball.ParseError, match=r"points.csv:3: ") as error:
        orthoball.read(path)
    assert (error.value.line, error.value.file) == (3, str(path))
    assert isinstance(error.value, ValueError)
    with pytest.raises(orthoball.ParseError) as error:
        orthoball.read(tmp_path / "missing.csv")
    assert error.value.line is None
    path.write_text("x,y\n")
    with pytest.raises(orthoball.ParseError):
        orthoball.read(path)
    assert len(orthoball.read(path, allow_empty=True)) == 0
    with pytest.raises(orthoball.InputError) as error:
        orthoball.read(path, radius_column=1, weight_column=2)
    assert error.value.row is None
