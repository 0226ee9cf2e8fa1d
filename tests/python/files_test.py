# SPDX-License-Identifier: MIT
"""Files of numbers and of molecules."""

import io
import json
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import orthoball
from orthoball import AlphaShapes, InputError


@pytest.fixture
def molecule(samples):
    return AlphaShapes(orthoball.read(samples / "bdna_dodecamer.pdb"))


def test_the_filtration_is_written_in_its_order(cloud, tmp_path):
    filtration = AlphaShapes(cloud).filtration(index=300)
    filtration.write(tmp_path / "filter.npz")
    archive = np.load(tmp_path / "filter.npz")
    for name in ("dimension", "vertices", "alpha2", "enters"):
        assert np.array_equal(archive[name], getattr(filtration, name))
    filtration.write(tmp_path / "filter.jsonl")
    lines = (tmp_path / "filter.jsonl").read_text().splitlines()
    assert [json.loads(line)["vertices"] for line in lines] == [list(s) for s, _ in filtration]
    assert filtration.to_bytes("csv").count(b"\n") == len(filtration) + 1
    with pytest.raises(InputError, match='"txt" is no format of this; there are csv, json and npz'):
        filtration.write(tmp_path / "filter.txt")


def test_signatures_are_written_as_they_are(cloud, tmp_path):
    shapes = AlphaShapes(cloud)
    some = (
        shapes.signatures,
        shapes.signatures_at(index=[0, 7, 3]),
        shapes.ball_signatures([-1, 0.5]),
    )
    for signatures in some:
        signatures.write(tmp_path / "signatures.npz")
        archive = np.load(tmp_path / "signatures.npz")
        assert list(archive) == list(signatures)
        for name, column in signatures.items():
            assert np.array_equal(archive[name], column), name
        rows = json.loads(signatures.to_bytes("json"))
        assert [row["index"] for row in rows] == signatures.index.tolist()
        assert signatures.to_bytes("csv").count(b"\n") == len(rows) + 1
        with pytest.raises(InputError, match="csv, json and npz"):
            signatures.to_bytes("ply")


def test_signatures_are_drawn(cloud):
    shapes = AlphaShapes(cloud)
    svg = shapes.signature_figure(title="A cloud").decode()
    assert svg.startswith("<svg") and "A cloud" in svg and "200 sites, weights: none" in svg
    assert shapes.signature_figure(range=(0.0, 0.1), axis="alpha2") != svg.encode()
    with pytest.raises(InputError, match="the first less than the second"):
        shapes.signature_figure(range=(0.1, 0.0))
    with pytest.raises(InputError, match='the axis is "r"'):
        shapes.signature_figure(axis="r")


def test_tables_of_balls_name_atoms(molecule, tmp_path):
    balls = molecule.balls(probe=1.4)
    for name, least in [
        ("per_atom", 486), ("per_residue", 24), ("contacts", 1000), ("residue_contacts", 24),
        ("derivatives", 486), ("voids", 0), ("pockets", 1), ("cells", 486),
    ]:  # fmt: skip
        balls.write(name, tmp_path / f"{name}.csv")
        lines = (tmp_path / f"{name}.csv").read_text().splitlines()
        assert len(lines) > least, name
        assert len(json.loads(balls.to_bytes(name, "json"))) == len(lines) - 1
    atoms = json.loads(balls.to_bytes("per_atom", "json"))
    assert [row["area"] for row in atoms] == balls.areas.tolist()
    assert atoms[0]["residue"] == "DC 1" and atoms[0]["chain"] == "A"
    with pytest.raises(InputError, match="'per_chain' is no table; there are per_atom"):
        balls.to_bytes("per_chain", "csv")
    for name in ("per_atom", "cells", "voids"):
        with pytest.raises(InputError, match='"npz" is no format of this'):
            balls.to_bytes(name, "npz")


@pytest.mark.partner
def test_tables_of_balls_are_data_frames(molecule):
    pytest.importorskip("pandas")
    balls = molecule.balls(probe=1.4)
    residues = balls.to_pandas("per_residue")
    assert residues["area"].sum() == pytest.approx(balls.area)
    assert residues["atoms"].sum() == len(balls.to_pandas()) == 486


def test_points_without_names_have_rows_alone(cloud):
    balls = AlphaShapes(cloud, radii=0.1).balls()
    assert json.loads(balls.to_bytes("per_atom", "json"))[7]["chain"] is None
    with pytest.raises(InputError, match="name no residues"):
        balls.to_bytes("per_residue", "csv")
    with pytest.raises(InputError, match="must be a PDB, mmCIF, PQR or XYZ file that was read"):
        balls.to_bytes("voids", "pml")
    fine, coarse = (balls.to_bytes("cells", "vtu", tolerance=part) for part in (0.01, 0.2))
    assert fine.startswith(b"<?xml") and len(fine) > len(coarse)
    assert b"\no row_0\n" in balls.to_bytes("cells", "obj")
    plane = AlphaShapes([[0, 0], [1, 0]], radii=1.0).balls()
    assert plane.to_bytes("voids", "ply").startswith(b"ply\n")


def test_a_pdb_file_holds_values(molecule, tmp_path):
    balls = molecule.balls(probe=1.4)
    balls.write_pdb(tmp_path / "areas.pdb")
    again = orthoball.read(tmp_path / "areas.pdb")
    assert np.array_equal(again.points, molecule.points) and again.labels["atom"][0] == "O5'"
    written = [
        float(line[60:66]) for line in balls.pdb().decode().splitlines() if line[:4] == "ATOM"
    ]
    np.testing.assert_allclose(written, balls.areas, atol=0.00501)
    assert balls.pdb(np.arange(486) / 10).count(b" 48.50") >= 1
    with pytest.warns(UserWarning, match="2 values beyond what a B-factor can be"):
        balls.pdb(np.r_[np.zeros(484), 1e6, np.nan])
    with pytest.raises(InputError, match=r"values have the shape \(2,\)"):
        balls.pdb([1, 2])
    with pytest.raises(orthoball.LimitError, match="row 0"):
        AlphaShapes([[1e6, 0, 0]], radii=1).balls().pdb()


def test_scripts_open_the_molecule_from_where_they_are(molecule, samples, tmp_path, monkeypatch):
    balls = molecule.balls(probe=1.4)
    for ending, command in (("pml", "load"), ("cxc", "open")):
        balls.write("pockets", tmp_path / f"pockets.{ending}")
        script = (tmp_path / f"pockets.{ending}").read_text()
        assert command in script and str(samples / "bdna_dodecamer.pdb") in script
        assert "pocket_1" in script
    balls.write("pockets", tmp_path / "pockets.ply")
    assert (tmp_path / "pockets.ply").read_bytes().startswith(b"ply\n")
    monkeypatch.chdir(samples)
    relative = AlphaShapes(orthoball.read("bdna_dodecamer.pdb")).balls(probe=1.4)
    relative.write("voids", tmp_path / "voids.pml")
    assert "bdna_dodecamer.pdb" in (tmp_path / "voids.pml").read_text()
    assert b"bdna_dodecamer.pdb" in relative.to_bytes("voids", "pml")


def test_power_cells_are_written(plane, tmp_path):
    shapes = AlphaShapes(plane)
    box = [[0, 0], [1, 1]]
    shapes.write_power_cells(tmp_path / "cells.json", box)
    rows = json.loads((tmp_path / "cells.json").read_text())
    assert sum(row["volume"] for row in rows) == pytest.approx(1.0)
    assert np.allclose([row["volume"] for row in rows], shapes.power_cells(box).volumes)
    shapes.write_power_cells(tmp_path / "cells.obj")
    assert (tmp_path / "cells.obj").read_text().startswith("# ")
    with pytest.raises(InputError, match="csv, json, vtu and obj"):
        shapes.write_power_cells(tmp_path / "cells.ply")
    with pytest.raises(InputError, match="a box has two corners"):
        shapes.write_power_cells(tmp_path / "cells.csv", [[0, 0, 0], [1, 1, 1]])


@pytest.mark.partner
def test_where_points_are_is_a_table(plane):
    pandas = pytest.importorskip("pandas")
    shape = AlphaShapes(plane).shape(alpha=0.1)
    queries = np.r_[plane[:3], [[5.0, 5.0]]]
    table = shape.locate(queries).to_pandas()
    assert table["inside"].tolist() == shape.contains(queries).tolist()
    assert table["region"][3] is pandas.NA and table["simplex"][3] is None
    assert table["simplex"][0] == [0] and len(table["nearest"][3]) > 0
    assert np.allclose(table["distance"], shape.nearest(queries).distances)
    empty = AlphaShapes(plane).shape(index=0).locate(queries).to_pandas()
    assert empty["distance"].isna().all() and empty["nearest"].isna().all()


def test_voids_of_a_shape_are_its_holes(samples):
    shapes = AlphaShapes(orthoball.read(samples / "c60.xyz"))
    (hole,) = shapes.shape(alpha2=0).holes()
    (found,) = shapes.voids(alpha2=0)
    (of_balls,) = shapes.balls().voids
    assert found.volume == pytest.approx(hole.volume) and found.volume > of_balls.volume
    assert np.array_equal(found.rows, hole.rows)
    assert (found.born, found.dies, found.born_alpha2) == (
        of_balls.born, of_balls.dies, of_balls.born_alpha2,
    )  # fmt: skip


def test_a_shape_is_written_whole_or_not_at_all(cube, tmp_path):
    shape = AlphaShapes(cube).shape()
    shape.write(tmp_path / "cube.obj", roles=True)
    assert (tmp_path / "cube.obj").read_bytes() == shape.to_bytes("obj", roles=True)
    with pytest.raises(InputError, match='"step" is no format of shapes'):
        shape.write(tmp_path / "cube.step")
    assert [path.name for path in tmp_path.iterdir()] == ["cube.obj"]
    assert io.BytesIO(shape.to_bytes("stl")).getbuffer().nbytes == 84 + 50 * 12


def test_a_link_is_followed_and_permissions_stay(cloud, tmp_path):
    signatures = AlphaShapes(cloud).signatures
    there, link = tmp_path / "there.csv", tmp_path / "link.csv"
    there.write_text("old")
    there.chmod(0o600)
    link.symlink_to(there)
    signatures.write(link)
    assert link.is_symlink()
    assert there.read_bytes() == signatures.to_bytes("csv")
    assert there.stat().st_mode & 0o777 == 0o600
    assert sorted(tmp_path.iterdir()) == [link, there]


def test_a_missing_folder_is_named_as_given(cloud, tmp_path):
    path = tmp_path / "none" / "signatures.csv"
    with pytest.raises(FileNotFoundError) as caught:
        AlphaShapes(cloud).signatures.write(path)
    assert caught.value.filename == str(path)


def test_threads_may_write_one_file(cloud, tmp_path):
    signatures = AlphaShapes(cloud).signatures
    path = tmp_path / "signatures.csv"
    with ThreadPoolExecutor(4) as pool:
        list(pool.map(lambda _: signatures.write(path), range(40)))
    assert path.read_bytes() == signatures.to_bytes("csv")
